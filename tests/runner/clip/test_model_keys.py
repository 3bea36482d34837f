"""A keyframe whose others are as in a <key> of the model: every joint and the root, to the last digit."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest
from command import commanded

from dynsplines import Keyframe, build, inbetween, load, load_motion, recordings
from dynsplines.clip.mirror import mirrored_keyframe
from dynsplines.clip.table import KeyframeTable
from dynsplines.errors import UserError
from dynsplines.solver.curve.mirror import Mirror

ROBOT = """<mujoco><worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/><geom size=".1"/>
    <body name="left_leg" pos="0 .1 0"><joint name="left_hip" axis="0 1 0"/><geom size=".05" pos="0 0 -.3"/></body>
    <body name="right_leg" pos="0 -.1 0"><joint name="right_hip" axis="0 1 0"/><geom size=".05" pos="0 0 -.3"/>
    </body></body></worldbody><keyframe>
    <key name="home" qpos="0 .123456789012345 .4 2 0 0 0 .31 .31"/><key qpos="0 0 .5 1 0 0 0 0 0"/>
    <key name="step &amp; go" qpos=".5 0 .4 1 0 0 0 .2 -.7"/><key name="short"/></keyframe></mujoco>"""
HOME = [0, 0.123456789012345, 0.4, 1, 0, 0, 0, 0.31, 0.31]
CLIP = """figure = "robot.xml"
[solve]
evaluations = 2
frames = 1
{more}
[[keyframe]]
time = 0
others = "key:home"
[[keyframe]]
time = 1
joints.left_hip = 45
root.position = [0.1, 0, "free"]
others = "key:step & go"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot.xml").write_text(ROBOT)
    (tmp_path / "clip.toml").write_text(CLIP.format(more=""))
    return tmp_path


def test_what_a_keyframe_does_not_name_is_as_in_the_key(folder: Path):
    first, second = load(folder / "clip.toml").keys
    np.testing.assert_array_equal(first.state, HOME)
    assert first.is_key
    np.testing.assert_allclose(np.delete(second.state, 2), [0.1, 0, 1, 0, 0, 0, np.pi / 4, -0.7], atol=1e-15)
    assert second.fixed.tolist() == [True, True, False] + [True] * 6


def test_a_key_without_numbers_is_the_rest_and_a_hold_continues_from_a_key():
    keys = [Keyframe(0, others="key:short"), Keyframe(1, others="key:home"), Keyframe(2, others="previous")]
    made = build(ROBOT, keys)
    np.testing.assert_array_equal(made.keys[0].state, made.figure.model.qpos0)
    np.testing.assert_array_equal(made.keys[2].state, HOME)


def test_obstacles_with_bodies_of_their_own_are_at_rest(folder: Path):
    box = '[[scene.box]]\nname = "crate"\nbody = "crate"\nposition = [0, 0, 1]\nsize = [0.4, 0.4, 0.4]\n'
    (folder / "clip.toml").write_text(CLIP.format(more=box))
    (first, _) = load(folder / "clip.toml").keys
    np.testing.assert_array_equal(first.state[:9], HOME)


@pytest.mark.parametrize(
    ("others", "words"),
    [
        (
            "key:hom",
            r"keyframe 1 \(t = 0 s\): others: no key 'hom'; did you mean 'home'\? Keys: home, step & go, short",
        ),
        ("key:", "others must be 'free', 'rest', 'previous' or 'key:NAME', a <key> of the model, not 'key:'"),
        ("home", "others must be 'free', 'rest', 'previous' or 'key:NAME', a <key> of the model, not 'home'"),
    ],
)
def test_an_unknown_key_is_refused_with_those_that_there_are(folder: Path, others: str, words: str):
    text = (folder / "clip.toml").read_text().replace("key:home", others)
    with pytest.raises(UserError, match=words):
        recordings.from_text(text, name="clip", folder=folder)


def test_a_key_of_another_length_is_refused(folder: Path):
    text = ROBOT.replace("2 0 0 0 .31 .31", "2 0 0 0 .31")
    with pytest.raises(UserError):
        build(text, [Keyframe(0, others="key:home"), Keyframe(1, others="key:short")])


def test_a_saved_motion_is_written_as_a_clip_that_still_has_its_keys(folder: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(folder)
    inbetween("clip.toml").save("motion.npz")
    Path("robot.xml").unlink()
    load_motion("motion.npz").save("again.toml")
    assert 'others = "key:home"' in Path("again.toml").read_text()
    np.testing.assert_array_equal(load("again.toml").keys[0].state, HOME)
    model = mujoco.MjModel.from_xml_path("again.xml")
    np.testing.assert_array_equal(model.key("home").qpos, HOME)


def test_the_mirror_keeps_a_symmetric_key_and_refuses_another(folder: Path):
    text = (folder / "clip.toml").read_text().replace(".123456789012345", "0")
    (folder / "robot.xml").write_text(ROBOT.replace(".123456789012345", "0"))
    made = recordings.from_text(text, name="clip", folder=folder)
    mirror = Mirror.of(made.figure)
    assert mirrored_keyframe(KeyframeTable(time=0.0, others="key:home"), made.figure, mirror).others == "key:home"
    with pytest.raises(UserError, match="the model's key 'step & go' is not symmetric"):
        mirrored_keyframe(KeyframeTable(time=0.0, others="key:step & go"), made.figure, mirror)


def test_an_edit_that_names_another_key_has_it(folder: Path):
    text = (folder / "clip.toml").read_text()
    made = recordings.from_text(text, name="clip", folder=folder)
    other = recordings.from_text(text.replace("key:home", "key:short"), name="clip", folder=folder, like=made)
    np.testing.assert_array_equal(other.keys[0].state, other.figure.model.qpos0)


def test_an_export_has_the_motions_keys_alone(folder: Path, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    run = commanded(monkeypatch, capsys)
    assert run("solve", "clip.toml", "-o", "m.npz").code == 0
    assert run("export", "m.npz", "--to", "mjcf", "-o", "m.keys.xml").code == 0
    model = mujoco.MjModel.from_xml_path("m.keys.xml")
    assert {model.key(i).name.rsplit("_", 1)[0] for i in range(model.nkey)} == {"clip"}
