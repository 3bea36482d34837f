"""`dynsplines new`: its clips load and solve without an edit, for models of every kind of joint."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from dynsplines import recordings
from dynsplines.clip import load as clip
from dynsplines.clip.starter import starter
from dynsplines.clip.text import keyframe_tables
from dynsplines.errors import UserError
from dynsplines.measure.report import report
from dynsplines.solver.inbetween import inbetween
from dynsplines.solving import motion_of

BODY = '<body name="b" pos="0 0 1">{}<geom type="capsule" size=".05" fromto="0 0 0 .3 0 0"/>{}</body>'
ARM = BODY.format('<joint name="swing" axis="0 1 0" {}/>', "")
KINDS = {
    "limited hinge": ARM.format('range="-10 20" limited="true"'),
    "hinge off zero of an odd name": ARM.format('range="30 80" limited="true" ref="10"').replace(
        '"swing"', '"robot0:swing joint"'
    ),
    "ball": BODY.format('<joint type="ball" range="0 40" limited="true"/>', ""),
    "free not first": BODY.format(
        "", ""
    ).replace('name="b"', 'name="post"') + ARM.format("").replace('"b"', '"arm"') + BODY.format("<freejoint/>", ""),
    "two free": BODY.format("<freejoint/>", "") + BODY.format("<freejoint/>", "").replace('"b"', '"c d"') + ARM.replace(
        '"b"', '"e"').format(""),
    "free body alone": BODY.format("<freejoint/>", ""),
    "nothing to see": '<body><joint axis="0 1 0"/><inertial mass="1" pos=".1 0 0" diaginertia=".1 .1 .1"/></body>',
    "mixed": BODY.format(
        "<freejoint/>",
        '<body><joint name="n" type="ball"/><geom size=".1"/><body pos="0 0 .2"><joint axis="0 1 0"/><geom size=".1"/>'
        '<body pos="0 0 .2"><joint name="w" type="ball"/><geom size=".1"/></body></body></body>',
    ),
}  # fmt: skip
NO_FEET = ": none were found; add sites with names such as left_heel and left_toe"
RADIANS = '<mujoco><compiler angle="radian"/>'


def written(text: str, folder: Path) -> clip.Clip:
    (folder / "models").mkdir()
    (folder / "models" / "it.xml").write_text(text, encoding="utf-8")
    target = folder / "it.toml"
    target.write_text(starter(str(folder / "models" / "it.xml"), target), encoding="utf-8")
    return recordings.load(str(target))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_model_with_any_kind_of_joint_gets_a_clip_at_rest(kind, tmp_path):
    problem = written(f"<mujoco><worldbody>{KINDS[kind]}</worldbody></mujoco>", tmp_path)
    measures = report(problem, motion_of(problem, inbetween(problem.problem)))["after"]
    assert measures["keyframe error"] <= 1e-12
    assert measures["largest"].get("range", {"amount": 0.0})["amount"] < 0.5
    first, second = (key.state for key in problem.keys)
    np.testing.assert_allclose(second, first, atol=1e-6)
    assert all(key.fixed.all() for key in problem.keys)
    if kind == "limited hinge":
        assert "joints.swing" in problem.text and "hinge, degrees about y, -10 to 20" in problem.text
        assert tomllib.loads(problem.text)["figure"] == "models/it.xml"


@pytest.mark.parametrize(
    ("keys", "value", "row"),
    [
        ("<key name='home' qpos='0.2'/><key name='away' qpos='-1.3'/>", 0.2, 'others = "key:home"'),
        ("<key time='0.1' qpos='0.2'/>", 0.2, "joints.swing = 11.459156"),
        ("<key name='home'/>", 0.0, 'others = "key:home"'),
    ],
)
def test_a_clip_begins_with_the_first_key_of_the_model(tmp_path, keys, value, row):
    text = f"{RADIANS}<size nkey='9'/><worldbody>{ARM.format('')}</worldbody><keyframe>{keys}</keyframe></mujoco>"
    problem = written(text, tmp_path)
    assert [key.time for key in problem.keys] == [0, 0.5]
    np.testing.assert_allclose([key.state[0] for key in problem.keys], value, atol=1e-7)
    assert row in problem.text and ": its first key.\n" in problem.text


@pytest.mark.slow
def test_a_second_free_body_is_placed_by_its_name_and_there_and_back_in_text(tmp_path):
    problem = written(f"<mujoco><worldbody>{KINDS['two free']}</worldbody></mujoco>", tmp_path)
    moved = problem.text.replace('roots."c d" = {position = [0, 0, ', 'roots."c d" = {position = [5, 0, ', 1)
    again = recordings.from_text(moved, name="it", folder=tmp_path)
    assert again.keys[0].state[7] == 5
    assert keyframe_tables(again.figure, again.keys)[0].roots["c d"].position[0] == 5
    with pytest.raises(UserError, match=r"roots: no free joint 'c'"):
        recordings.from_text(moved.replace('roots."c d"', "roots.c"), name="it", folder=tmp_path)


@pytest.mark.slow
def test_what_stands_is_named_and_so_is_that_nothing_does(tmp_path):
    feet = '<site name="left_heel" pos=".1 0 -.1"/><body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>'
    for folder, inside, told in (("feet", feet, ":\n#   left_heel"), ("none", KINDS["limited hinge"], NO_FEET)):
        (tmp_path / folder).mkdir()
        body = BODY.format("<freejoint/>", inside) if inside is feet else inside
        text = written(f"<mujoco><worldbody>{body}</worldbody></mujoco>", tmp_path / folder).text
        assert f"# Sole points{told}\n" in text and "world" not in text


@pytest.mark.parametrize(
    ("world", "words"),
    [
        ('<body><geom size=".1"/></body>', r"^it\.xml: the model has no joints: nothing can move$"),
        ('<flexcomp name="cloth" type="grid" count="3 3 1" spacing=".1 .1 .1" radius=".01" dim="2"/>', "'cloth'"),
    ],
)
def test_models_without_joints_and_soft_bodies_are_refused(tmp_path, world, words):
    with pytest.raises(UserError, match=words):
        written(f"<mujoco><worldbody>{world}</worldbody></mujoco>", tmp_path)


PAIR = "".join(
    f'<body name="{side}" pos="0 {y} 0"><joint name="{side}_hip" axis="0 1 0"/>'
    '<geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/></body>'
    for side, y in (("l", 0.1), ("r", -0.1))
)
TRUNK = '<body name="trunk" pos="0 0 .35"><freejoint/><geom type="box" size=".1 .2 .05"/>{}</body>'
REACH = '<geom type="capsule" size=".02" fromto="0 0 0 .3 0 0"/>'
ARMS = f'{PAIR}<body name="arm" pos="0 0 .1"><joint axis="0 1 0"/>{REACH}</body>'


@pytest.mark.parametrize(("height", "raised"), [(0.25, " Raised by up to 70.0 mm, out of the floor."), (0.5, "")])
def test_a_key_in_the_floor_is_raised(tmp_path, height, raised):
    key = f"<keyframe><key name='home' qpos='0 0 {height} 1 0 0 0 0 0'/></keyframe>"
    problem = written(f"<mujoco><worldbody>{TRUNK.format(PAIR)}</worldbody>{key}</mujoco>", tmp_path)
    assert problem.keys[0].state[2] == pytest.approx(max(height, 0.32), abs=1e-5)
    assert f"its first key.{raised}\n" in problem.text


@pytest.mark.slow
def test_positions_of_feet_and_hands_are_written_as_in_a_keyframe(tmp_path):
    problem = written(f"<mujoco><worldbody>{TRUNK.format(ARMS)}</worldbody></mujoco>", tmp_path)
    told = [line[4:] for line in problem.text.splitlines() if line.startswith(("#   sites.", "#   bodies."))]
    assert told == [
        "sites.l = [0, 0.1, 0.02]  # centre of a sphere of radius 0.02 m",
        "sites.r = [0, -0.1, 0.02]  # centre of a sphere of radius 0.02 m",
        "bodies.arm = {position = [0, 0, 0.42]}",
    ]
    said = "".join(
        f"[[keyframe]]\ntime = {t}\n" + "\n".join(told) + '\nothers = "rest"\nroot.position = [0, 0, 0.32]\n'
        for t in (0, 1)
    )
    again = recordings.from_text(f'figure = "models/it.xml"\n{said}', name="it", folder=tmp_path)
    np.testing.assert_allclose(again.keys[0].state, problem.keys[0].state, atol=1e-6)


@pytest.mark.parametrize(
    ("bend", "keys", "expected"),
    [(0, "", [0, 0.05]), (0.1, '<keyframe><key name="home" qpos=".2 0"/></keyframe>', [0.2, 0.07])],
)
def test_followers_begin_where_they_belong_and_are_not_named(tmp_path, bend, keys, expected):
    joints = '<joint name="knee" axis="0 1 0"/>', '<joint name="cap" type="slide" axis="0 0 1"/>'
    tie = f'<equality><joint joint1="cap" joint2="knee" polycoef=".05 {bend} 0 0 0"/></equality>'
    legs = BODY.format(joints[0], f'<body>{joints[1]}<geom size=".1"/></body>')
    problem = written(f"<mujoco><worldbody>{legs}</worldbody>{tie}{keys}</mujoco>", tmp_path)
    np.testing.assert_allclose(problem.keys[0].state, expected, atol=1e-8)
    assert "joints.cap                               slide, metres along z" in problem.text
    assert "\njoints.cap" not in problem.text
    assert not [note for note in problem.notes if "off" in note]


@pytest.mark.parametrize(
    ("turn", "axis", "words"),
    [
        ("0 0 0", "0 -1 0", "-y"),
        ("0 0 90", "1 0 0", "y"),
        ("30 0 0", "0 2 0", "[0, 0.87, 0.5]"),
        ("0 0 180", "0 1 0", "-y"),
    ],
)
def test_axes_of_hinges_are_those_in_the_world_at_rest(tmp_path, turn, axis, words):
    joint = f'<body><joint name="bend" axis="{axis}"/><geom size=".1"/></body>'
    problem = written(f'<mujoco><worldbody><body euler="{turn}">{joint}</body></worldbody></mujoco>', tmp_path)
    assert f"hinge, degrees about {words}\n" in problem.text
