"""What is told of a clip before the meshes of its model are read: an edit's mistakes come back at once."""

from __future__ import annotations

from pathlib import Path

import mujoco
import pytest
from figures import FIGURES
from tiny import FIGURE, HINGE, changed, written

from dynsplines import models
from dynsplines.clip import load as clip
from dynsplines.errors import UserError
from dynsplines.scene.compose import figure_spec, spec_joint_names
from dynsplines.solver.figure.figure import joint_names

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


def test_so_are_those_of_figures_that_ship():
    for name in models.figures():
        spec = figure_spec(name)
        assert spec_joint_names(spec) == joint_names(spec.compile())


def test_the_early_error_is_the_late_one(tmp_path):
    text = changed("left_knee = {rotvec = [0, 40", "left_kne = {rotvec = [0, 40")
    with pytest.raises(UserError) as late:
        clip.load(str(written(tmp_path, text)))
    (tmp_path / "tiny.xml").write_text(MESHED, encoding="utf-8")
    with pytest.raises(UserError) as early:
        clip.load(str(tmp_path / "tiny.toml"))
    assert str(early.value) == str(late.value)
