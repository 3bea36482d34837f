"""Invalid TOML and misspelt keys are reported with their place and what to write instead, before meshes are read."""

from __future__ import annotations

from pathlib import Path

import mujoco
import pytest
from figures import FIGURES
from problems import FIGURE, HINGE, changed, written

from dynsplines.clip import load as clip
from dynsplines.clip.parse import parse
from dynsplines.errors import UserError
from dynsplines.scene.compose import spec_joint_names
from dynsplines.solver.figure.figure import joint_names

KEY = "[[keyframe]]\ntime = 0\n"  # lines 2 and 3, after the figure
SINGLE = "[keyframe] is a single table, and there are several; write [[keyframe]]"
MISTAKES = {
    "single tables": ("[keyframe]\ntime = 0\n\n[keyframe]\ntime = 1", f"line 2: {SINGLE}"),
    "a single table first": ("[keyframe]\ntime = 0\n\n[[keyframe]]\ntime = 1", f"line 2: {SINGLE}"),
    "a single table last": (f"{KEY}\n [ keyframe ] # the second\ntime = 1", f"line 5: {SINGLE}"),
    "single obstacles": ("[scene.box]\n[scene.box]", "line 2: [scene.box] is a single table"),
    "a table of which there is one": ("[scene]\n[solve]\n[scene]", "line 4: a second table [scene]; write its keys"),
    "a text without quotes": (f"{KEY}others = rest", "line 4: 'others = rest' is not valid TOML"),
    "which text": (f"{KEY}others = rest  # all", '; texts need quotes: "rest"'),
    "in a list": (f"{KEY}root.position = [0, free, 0]", '; texts need quotes: "free"'),
    "in an inline table": (f"{KEY}root = {{rotation = free}}", '; texts need quotes: "free"'),
    "a text of two words": (f"{KEY}name = my clip", '; texts need quotes: "my clip"'),
    "a capital truth": (f"{KEY}bodies.left_foot = {{flat = True}}", "invalid value; true and false are lower case"),
    "typographic quotes": ("name = “clip”", "; put texts in straight quotes"),
    "a text without an end": (f'{KEY}others = "rest\n', "; close the text with a quote"),
    "a decimal comma": ("[[keyframe]]\ntime = 0,5", "line 3: 'time = 0,5' is .*; numbers have a point, not a comma"),
    "no digit before the point": ("[[keyframe]]\ntime = .5", "; numbers have a digit before the point: 0.5"),
    "no value": (f"{KEY}others =  # rest", "; write a value after ="),
    "a key twice": (f"{KEY}time = 1", "line 4: 'time = 1' is .*: cannot overwrite a value; give each key once"),
    "a colon": ("[[keyframe]]\ntime: 0", "; write key = value"),
    "a list in parentheses": (f"{KEY}root.position = (0, 0, 1)", "; lists have square brackets"),
    "a list without commas": (f"{KEY}root.position = [0 0 1]", "; put commas between the values of a list"),
    "an inline table in two lines": (f"{KEY}joints = {{a = 1,\nb = 2}}", "line 4: .*; write {} tables in one line"),
    "a path of Windows": ('name = "C:\\Users"', "; write paths with /"),
    "the end of a text": ('name = """', "line 2: "),
}  # fmt: skip


ROTATIONS = {
    "joints.left_elbow = {}": "joints.left_elbow: give exactly one of rotvec, euler, quat, not none (",
    "root.rotation = {}": "root.rotation: give exactly one of rotvec, euler, quat, not none (a root, a body or",
    "joints.left_elbow = {rotvec = [0, 0, 0], quat = [1, 0, 0, 0]}": "joints.left_elbow: give exactly one of",
    "joints.left_elbow = {quat = [0, 0, 0, 0]}": "joints.left_elbow: the quaternion is zero",
    'root.rotation = {euler = [1, 2], order = "xyz"}': "root.rotation: euler has 2 angles",
    "joints.left_elbow = {rotvec = [0, 1]}": "joints.left_elbow.rotvec must be three angles",
    "joints.left_elbow = {rot = [0, 1]}": "joints.left_elbow: no key 'rot'",
    "sites.left_hand = {}": "'sites.left_hand.position' is missing",
}


@pytest.mark.parametrize("entry", ROTATIONS)
def test_an_error_names_the_keys_of_the_file_alone(entry):
    with pytest.raises(UserError) as caught:
        parse(f'figure = "human"\n{KEY}{entry}', "c", "c.toml")
    assert str(caught.value).startswith(f"c.toml: keyframe 1 (t = 0 s): {ROTATIONS[entry]}")


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize("mistake", MISTAKES)
def test_invalid_toml_is_reported_with_its_line_and_a_remedy(mistake, ending):
    text, words = MISTAKES[mistake]
    start, _, end = words.partition(".*")
    with pytest.raises(UserError) as caught:
        parse(f'figure = "human"\n{text}'.replace("\n", ending), "c", "c.toml")
    told = str(caught.value)
    assert told.startswith("c.toml: line ") and "\n" not in told
    assert start in told and end in told


def test_a_long_line_is_shortened():
    with pytest.raises(UserError, match=r"^c\.toml: line 1: 'name = x{50}\.\.\.' is not valid TOML"):
        parse(f"name = {'x' * 200}", "c", "c.toml")


MESHED = FIGURE.replace("<worldbody>", '<asset><mesh name="hat" file="nowhere.obj"/></asset><worldbody>', 1)
NAMELESS = """<mujoco><worldbody><frame pos="0 0 1"><body name="hip"><joint type="hinge"/><joint axis="1 0 0"/>
  <geom size=".1"/><frame><body name="knee"><joint type="ball"/><geom size=".1"/></body></frame>
  <body><joint/><geom size=".1"/></body></body></frame>
  <body name="cart"><joint name="hip_2" type="slide"/><geom size=".1"/></body></worldbody></mujoco>"""
TEXTS = {"nameless": NAMELESS, "hinge": HINGE.format(keys=""), **{name: text for name, (text, _) in FIGURES.items()}}
KNEE = "joints.left_knee = {rotvec = [0, 40, 0]}"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """With the tiny clip's figure, whose mesh cannot be read, and nothing that would read it."""

    def never(*_: object, **__: object) -> None:
        raise AssertionError("the model was compiled")

    monkeypatch.setattr("dynsplines.scene.compose.compose", never)
    written(tmp_path)
    (tmp_path / "tiny.xml").write_text(MESHED, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        (changed("left_knee = {rotvec = [0, 40", "left_kne = {rotvec = [0, 40"), "no joint 'left_kne'; did you mean"),
        (changed("[solve]", '[[penalty]]\nkind = "colision"\n[solve]'), "no penalty 'colision'; did you mean"),
        (changed("[solve]", '[[penalty]]\nkind = "torque"\nreach = 1\n[solve]'), "'reach' is not for kind 'torque'"),
        (changed("[solve]", '[solve]\ncriterion = "weka"'), "no criterion 'weka'; did you mean 'weak'"),
        (changed("[solve]", '[solve]\noptimiser = "newtn"'), "no optimiser 'newtn'"),
        (changed(KNEE, 'joints.left_knee = {euler = [0, 4], order = "xw"}'), "order = 'xw'"),
        (changed("time = 0.2", "time = -0.2"), "keyframe 2 .* is not after keyframe 1"),
        (changed(KNEE, "joint.left_knee = 4"), "no key 'joint'; did you mean 'joints'"),
    ],
)
def test_an_error_is_reported_before_meshes_are_read(folder, text, complaint):
    (folder / "tiny.toml").write_text(text, encoding="utf-8")
    with pytest.raises(UserError, match=rf"^tiny\.toml: .*{complaint}"):
        clip.load(str(folder / "tiny.toml"))


def test_a_clip_without_mistakes_continues_to_its_model(folder):
    with pytest.raises(AssertionError, match="the model was compiled"):
        clip.load(str(folder / "tiny.toml"))


@pytest.mark.parametrize("name", TEXTS)
def test_joints_are_called_the_same_before_their_model_is_compiled(name):
    spec = mujoco.MjSpec.from_string(TEXTS[name])
    assert spec_joint_names(spec) == joint_names(mujoco.MjModel.from_xml_string(TEXTS[name]))
