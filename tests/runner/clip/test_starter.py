"""`dynsplines new`: what it writes loads, solves and moves without an edit, for models of every kind of joint."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command import commanded
from oracles import kinematics

from dynsplines import recordings
from dynsplines.clip import load as clip
from dynsplines.clip.starter import starter
from dynsplines.clip.text import keyframe_tables
from dynsplines.errors import UserError
from dynsplines.measure.report import report
from dynsplines.solver.inbetween import inbetween

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
    return clip.load(str(target))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_model_of_any_joint_gets_a_clip_that_moves_within_its_ranges(kind, tmp_path):
    problem = written(f"<mujoco><worldbody>{KINDS[kind]}</worldbody></mujoco>", tmp_path)
    assert len(problem.keys) == 3
    found = report(problem, inbetween(problem.problem), 0.0)["after"]
    assert found["keyframe error"] <= 1e-12
    assert found["beyond joint range"].get("most", 0) < 0.5
    first, second, third = (key.state for key in problem.keys)
    assert np.abs(second - first).max() > 0.02
    np.testing.assert_allclose(third, first, atol=1e-6)
    assert all(key.fixed.all() for key in problem.keys)
    if kind == "limited hinge":
        assert "joints.swing" in problem.text and "hinge, degrees, -10 to 20" in problem.text
        assert tomllib.loads(problem.text)["figure"] == "models/it.xml"


@pytest.mark.parametrize(
    ("keys", "times", "values"),
    [
        ("<keyframe><key time='0.1' qpos='0.2'/><key time='0.7' qpos='-1.3'/></keyframe>", [0.1, 0.7], [0.2, -1.3]),
        (
            "<size nkey='9'/><keyframe><key qpos='0.2'/><key qpos='-1.3'/><key qpos='0'/></keyframe>",
            [0, 0.5, 1],
            [0.2, -1.3, 0],
        ),
        ("<keyframe><key name='home' qpos='0.2'/></keyframe>", [0, 0.5, 1], [0.2, None, 0.2]),
    ],
)
def test_the_models_own_keyframes_are_half_a_second_apart_without_times_and_one_gets_company(
    tmp_path, keys, times, values
):
    problem = written(f"{RADIANS}<worldbody>{ARM.format('')}</worldbody>{keys}</mujoco>", tmp_path)
    assert [key.time for key in problem.keys] == times
    for key, value in zip(problem.keys, values, strict=True):
        assert value is None or key.state[0] == pytest.approx(value, abs=1e-7)


@pytest.mark.slow
def test_a_second_free_body_is_placed_by_its_name_and_there_and_back_in_text(tmp_path):
    problem = written(f"<mujoco><worldbody>{KINDS['two free']}</worldbody></mujoco>", tmp_path)
    moved = problem.text.replace('roots."c d" = {position = [0, 0, ', 'roots."c d" = {position = [5, 0, ', 1)
    again = recordings.from_text(moved, name="it", folder=tmp_path)
    assert again.keys[0].state[7] == 5
    assert keyframe_tables(again.figure, again.keys)[0].roots["c d"].position[0] == 5
    with pytest.raises(UserError, match=r"roots: no free joint 'c'"):
        recordings.from_text(moved.replace('roots."c d"', "roots.c"), name="it", folder=tmp_path)


def test_a_free_figure_with_feet_is_put_on_the_floor(tmp_path):
    legs = "".join(
        f'<body pos="0 {y} 0"><joint axis="0 1 0"/><geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/></body>'
        for y in (-0.1, 0.1)
    )
    text = f'<body pos="0 0 3"><freejoint/><geom type="box" size=".1 .2 .05"/>{legs}</body>'
    problem = written(f"<mujoco><worldbody>{text}</worldbody></mujoco>", tmp_path)
    assert problem.keys[0].state[2] == pytest.approx(0.32)


@pytest.mark.slow
def test_what_stands_is_named_and_so_is_that_nothing_does(tmp_path):
    feet = '<site name="left_heel" pos=".1 0 -.1"/><body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>'
    for folder, inside, told in (("feet", feet, ":\n#   left_heel"), ("none", KINDS["limited hinge"], NO_FEET)):
        (tmp_path / folder).mkdir()
        body = BODY.format("<freejoint/>", inside) if inside is feet else inside
        text = written(f"<mujoco><worldbody>{body}</worldbody></mujoco>", tmp_path / folder).text
        assert f"# Sole points{told}\n" in text


@pytest.mark.parametrize(
    ("world", "words"),
    [
        ('<body><geom size=".1"/></body>', r"^it\.xml: the model has no joints: nothing can move$"),
        (BODY.format("<freejoint/>", ""), "the only moving body"),
        ('<flexcomp name="cloth" type="grid" count="3 3 1" spacing=".1 .1 .1" radius=".01" dim="2"/>', "'cloth'"),
    ],
)
def test_models_without_joints_free_bodies_alone_and_soft_bodies_are_refused(tmp_path, world, words):
    with pytest.raises(UserError, match=words):
        written(f"<mujoco><worldbody>{world}</worldbody></mujoco>", tmp_path)


PAIR = "".join(
    f'<body name="{side}" pos="0 {y} 0"><joint name="{side}_hip" axis="0 1 0"/>'
    '<geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/></body>'
    for side, y in (("l", 0.1), ("r", -0.1))
)
STOOL = '<geom name="stool" type="cylinder" size=".5 .1" pos="0 0 .1"/>'
TRUNK = '<body name="trunk" pos="0 0 .35"><freejoint/><geom type="box" size=".1 .2 .05"/>{}</body>'
REACH = '<geom type="capsule" size=".02" fromto="0 0 0 .3 0 0"/>'
ARMS = f'{PAIR}<body name="arm" pos="0 0 .1"><joint axis="0 1 0"/>{REACH}</body>'


@pytest.mark.slow
def test_a_figure_stands_on_its_own_pedestal_and_its_keyframes_out_of_the_floor(tmp_path):
    (tmp_path / "a").mkdir()
    problem = written(f"<mujoco><worldbody>{STOOL}{TRUNK.format(PAIR)}</worldbody></mujoco>", tmp_path / "a")
    assert problem.keys[0].state[2] == pytest.approx(0.2 + 0.32, abs=1e-5)
    key = "<keyframe><key qpos='0 0 .25 1 0 0 0 0 0'/><key qpos='0 0 .5 1 0 0 0 0 0'/></keyframe>"
    problem = written(f"<mujoco><worldbody>{TRUNK.format(PAIR)}</worldbody>{key}</mujoco>", tmp_path)
    np.testing.assert_allclose([key.state[2] for key in problem.keys], [0.32, 0.5], atol=1e-5)
    assert "its 2 keyframes. Raised by up to 70.0 mm, out of the floor or an obstacle.\n" in problem.text


@pytest.mark.slow
def test_positions_of_feet_and_hands_are_written_as_in_a_keyframe(tmp_path):
    problem = written(f"<mujoco><worldbody>{TRUNK.format(ARMS)}</worldbody></mujoco>", tmp_path)
    told = [line[4:] for line in problem.text.splitlines() if line.startswith(("#   sites.", "#   bodies."))]
    assert told == [
        "sites.l = [0, 0.1, 0.02]  # the middle of a ball of radius 0.02 m",
        "sites.r = [0, -0.1, 0.02]  # the middle of a ball of radius 0.02 m",
        "bodies.arm = {position = [0, 0, 0.42]}",
    ]
    said = "".join(
        f"[[keyframe]]\ntime = {t}\n" + "\n".join(told) + '\nothers = "rest"\nroot.position = [0, 0, 0.32]\n'
        for t in (0, 1)
    )
    again = recordings.from_text(f'figure = "models/it.xml"\n{said}', name="it", folder=tmp_path)
    np.testing.assert_allclose(again.keys[0].state, problem.keys[0].state, atol=1e-6)


@pytest.mark.slow
def test_a_model_of_which_nothing_collides_is_reported_as_solid_all_over(tmp_path):
    for folder, seen in (("all", ' contype="0" conaffinity="0"'), ("none", "")):
        (tmp_path / folder).mkdir()
        problem = written(
            f"<mujoco><worldbody>{ARM.format('').replace('<geom', '<geom' + seen)}</worldbody></mujoco>",
            tmp_path / folder,
        )
        assert ("# Nothing of this model collides" in problem.text) == bool(seen)


@pytest.mark.parametrize(
    ("bend", "keys", "expected"),
    [
        (0, "", [0, 0.05]),
        (0.1, '<keyframe><key qpos=".2 0"/><key time="1" qpos=".4 .09"/></keyframe>', [0.2, 0.07]),
    ],
)
def test_followers_begin_where_they_belong_and_are_not_named(tmp_path, bend, keys, expected):
    joints = '<joint name="knee" axis="0 1 0"/>', '<joint name="cap" type="slide" axis="0 0 1"/>'
    tie = f'<equality><joint joint1="cap" joint2="knee" polycoef=".05 {bend} 0 0 0"/></equality>'
    legs = BODY.format(joints[0], f'<body>{joints[1]}<geom size=".1"/></body>')
    problem = written(f"<mujoco><worldbody>{legs}</worldbody>{tie}{keys}</mujoco>", tmp_path)
    np.testing.assert_allclose(problem.keys[0].state, expected, atol=1e-8)
    assert "joints.cap                               slide, metres along z" in problem.text
    assert "\njoints.cap" not in problem.text
    assert ("# Joints that follow others have the values that these determine" in problem.text) == bool(keys)
    assert not [note for note in problem.notes if "off" in note]


LEG = """<mujoco><compiler angle="degree"/><worldbody>
  <body name="thigh" pos="0 0 1"><joint name="hip" axis="0 1 0"/>
    <geom type="capsule" fromto="0 0 0 0 0 -.4" size=".02"/>
    <body name="shin" pos="0 0 -.4"><joint name="knee" axis="0 1 0" range="{low} {high}"/>
      <geom type="capsule" fromto="0 0 0 0 0 -.4" size=".02" contype="0" conaffinity="0"/></body>
    <body name="rod" pos=".1 0 0"><joint name="rod" axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -.3" size=".01" contype="0" conaffinity="0"/></body></body></worldbody>
  <equality><{kind}/></equality></mujoco>"""
LOOP = 'connect name="loop" body1="rod" body2="shin" anchor="0 0 -.45"'


def noted(text: str, folder: Path) -> tuple[list[str], clip.Clip]:
    """What `new` reports, and the clip that it writes."""
    (folder / "it.xml").write_text(text, encoding="utf-8")
    notes: list[str] = []
    written = starter(str(folder / "it.xml"), folder / "it.toml", notes.append)
    comments = " ".join(line.removeprefix("# ") for line in written.splitlines())
    assert all(f"NOTE: {note}" in comments for note in notes)
    (folder / "it.toml").write_text(written, encoding="utf-8")
    return notes, clip.load(str(folder / "it.toml"))


def open_by(model: mujoco.MjModel, qpos) -> float:
    """[m] how far the anchors of a connect are apart, by MuJoCo's kinematics."""
    data = kinematics(model, qpos)
    ends = (int(model.eq_obj1id[0]), model.eq_data[0, :3]), (int(model.eq_obj2id[0]), model.eq_data[0, 3:6])
    one, two = (data.xpos[body] + data.xmat[body].reshape(3, 3) @ anchor for body, anchor in ends)
    return float(np.linalg.norm(one - two))


def test_a_loop_that_closes_away_from_the_rest_is_closed(tmp_path):
    notes, made = noted(LEG.format(low=100, high=300, kind=LOOP), tmp_path)
    qpos = made.keys[0].state
    assert open_by(made.figure.model, qpos) < 1e-5
    assert np.degrees(qpos[1]) >= 100 - 1e-6
    (note,) = notes
    assert note.startswith("keyframe 1: moved onto the model's equality constraints, ")
    assert "constraint 'loop' was open by" in note


def test_a_loop_that_no_pose_closes_is_reported(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("it.xml").write_text(LEG.format(low=30, high=120, kind=LOOP))
    done = commanded(monkeypatch, capsys)("new", "it.xml")
    made = clip.load("it.toml")
    apart = open_by(made.figure.model, made.keys[0].state)
    notes = (
        "keyframe 1: no pose within the joints' ranges was found that meets the model's equality constraints",
        f"keyframe 1: equality constraint 'loop' open by {1000 * apart:.3g} mm",
    )
    assert all(f"note: {note}\n" in done.err for note in notes)


def test_the_models_keyframes_are_moved_onto_welds_tendons_and_joints(tmp_path):
    tendon = LEG.replace(
        "<equality>",
        """<tendon><fixed name="both"><joint joint="hip" coef="1"/>
        <joint joint="knee" coef="1"/></fixed></tendon><equality>""",
    )
    key = '<keyframe><key qpos=".3 .8 .1"/></keyframe></mujoco>'
    for kind in ('joint name="e" joint1="rod" joint2="knee" polycoef=".1 .5 0 0 0"', 'tendon name="e" tendon1="both"'):
        text = tendon.format(low=-90, high=90, kind=kind).replace("</mujoco>", key)
        _, made = noted(text, tmp_path)
        model, data = made.figure.model, mujoco.MjData(made.figure.model)
        data.qpos[:] = made.keys[0].state
        mujoco.mj_fwdPosition(model, data)
        rows = data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
        assert rows.any()
        np.testing.assert_allclose(data.efc_pos[rows], 0, atol=1e-6)


def test_what_hangs_sinks_or_bends_too_far_is_reported(tmp_path):
    robot = """<mujoco><compiler angle="degree"/><worldbody><geom type="plane" size="1 1 1"/>
      <body name="trunk" pos="0 0 .5"><freejoint/><geom size=".1"/>
        <body name="arm" pos=".3 0 0"><joint name="swing" axis="0 1 0" range="-10 20"/><geom size=".1"/>
          <body name="hand" pos="0 0 .3"><joint name="wrist" axis="0 1 0"/><geom size=".1" pos="0 0 0"/></body></body>
        <body name="tail" pos="-.4 0 0"><joint name="wag" axis="0 1 0"/><geom size=".1" pos="0 0 {dip}"/></body>
      </body></worldbody><keyframe><key qpos="0 0 1.2 1 0 0 0 {swing} 0 {wag}"/></keyframe></mujoco>"""
    assert noted(robot.format(dip=0, swing=0, wag=0).replace("0 0 1.2", "0 0 .1"), tmp_path)[0] == []
    notes, _ = noted(robot.format(dip=0, swing=0.5, wag=0), tmp_path)
    assert notes == [
        "keyframe 1: lowest point 1.10 m above the floor",
        f"keyframe 1: joint 'swing' {np.degrees(0.5) - 20:.3g}° beyond its range",
    ]
    notes, _ = noted(robot.format(dip=-0.75, swing=0, wag=-1.5708).replace("0 0 1.2", "0 0 .1"), tmp_path)
    assert len(notes) == 1
    assert re.fullmatch(r"keyframe 1: bodies '(arm|hand)' and 'tail' 1\d\d mm in each other", notes[0])


def test_what_a_mocap_body_holds_stays_on_it(tmp_path):
    text = """<mujoco><worldbody><geom type="plane" size="1 1 1"/><body name="mark" mocap="true" pos="0 0 .9"/>
      <body name="base" pos="0 0 .5"><joint name="x" type="slide" axis="1 0 0"/>
        <joint name="z" type="slide" axis="0 0 1"/><geom size=".1"/>
        <body name="leg" pos="0 0 -.2"><joint name="knee" axis="0 1 0"/><geom name="foot" size=".1"/></body></body>
      </worldbody>
      <equality><weld body1="mark" body2="base" relpose="0 0 -.1 1 0 0 0"/></equality></mujoco>"""
    notes, made = noted(text, tmp_path)
    model = made.figure.model
    data = kinematics(model, made.keys[0].state)
    assert data.body("base").xpos[2] == pytest.approx(0.8, abs=1e-6)
    assert not any(line.startswith("keyframe 1: equality") for line in notes)
    assert "keyframe 1: lowest point 0.50 m above the floor" in notes
