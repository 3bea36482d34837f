"""Mistakes in clips are reported in one line with their place and what to write instead, before meshes are read."""

import tomllib
from pathlib import Path

import mujoco
import pytest
from figures import FIGURES
from problems import CLIP, FIGURE, HINGE, changed, written
from texts import read_data

from dynsplines import recordings
from dynsplines.clip.parse import parse
from dynsplines.errors import UserError
from dynsplines.scene.compose import spec_joint_names
from dynsplines.solver.figure.figure import joint_names

TABLE = tomllib.loads(read_data("clip_mistakes.toml"))


@pytest.mark.parametrize(("base", "change", "words"), TABLE["cases"])
def test_a_mistake_in_a_clip_is_reported_in_one_line_that_says_where(tmp_path, base, change, words):
    text = TABLE["bases"].get(base, CLIP)
    for old, new in [(text, text + change)] if isinstance(change, str) else change:
        text = changed(old, new, text)
    path = written(tmp_path, text, "c.toml")
    (tmp_path / "robot.xml").write_text(read_data("round_legs.xml"))
    with pytest.raises(UserError) as caught:
        recordings.load(str(path))
    told = str(caught.value)
    assert told.startswith("c.toml: ") and "\n" not in told
    assert not [each for each in words if each not in told], told


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize(("text", "words"), TABLE["syntax"])
def test_invalid_toml_is_reported_with_its_line_and_a_remedy(text, words, ending):
    with pytest.raises(UserError) as caught:
        parse(f'figure = "human"\n{text}'.replace("\n", ending), "c", "c.toml")
    told = str(caught.value)
    assert told.startswith("c.toml: line ") and "\n" not in told
    assert not [each for each in words if each not in told], told


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
        recordings.load(str(folder / "tiny.toml"))


def test_a_clip_without_mistakes_continues_to_its_model(folder):
    with pytest.raises(AssertionError, match="the model was compiled"):
        recordings.load(str(folder / "tiny.toml"))


@pytest.mark.parametrize("name", TEXTS)
def test_joints_are_called_the_same_before_their_model_is_compiled(name):
    spec = mujoco.MjSpec.from_string(TEXTS[name])
    assert spec_joint_names(spec) == joint_names(mujoco.MjModel.from_xml_string(TEXTS[name]))
