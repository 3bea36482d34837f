"""Violations of a motion are reported: every kind on a motion that has it and nothing else, worst first."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from paper.penetration import penetration
from processes import quiet

from dynsplines import Keyframe, build, inbetween, load, load_motion, motion, recordings, solving
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.edit import edits
from dynsplines.measure import violation
from dynsplines.measure.bounds import BOUNDS, WHIP_SHARE
from dynsplines.measure.violation import Violation
from dynsplines.motion import sampled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.search.minimum import Stop

REST = '\n[[keyframe]]\ntime = {}\nothers = "rest"\n'
HIGH = REST + "root.position = [0, 0, 3]\n"  # above all floors
SQUAT = 'figure = "human"\n' + REST.format(0) + REST.format(1) + "root.position = [0, 0, 0.73]\n" + REST.format(2)

BALL = """<mujoco><worldbody><body name="ball" pos="0 0 1"><freejoint name="root"/>
  <geom name="ball" type="sphere" size=".1" mass="1"/><site name="mark" pos="0 0 0"/></body></worldbody></mujoco>"""
ARM = """<mujoco><compiler angle="degree" autolimits="true"/><worldbody>
  <body name="rail" pos="0 0 2"><joint name="slide" type="slide" axis="1 0 0" range="-1 1"/><geom size=".05" mass="1"/>
    <body name="upper" pos="0 .2 0"><joint name="swing" type="hinge" axis="0 1 0" range="-90 90"/>
      <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/><site name="tip" pos="0 0 -.3"/></body></body>
  {more}</worldbody>{equality}</mujoco>"""
TWIN = """<body name="twin" pos="0 .4 2"><joint name="twin" type="hinge" axis="0 1 0"/>
  <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/></body>"""
TRUNK = """<mujoco><compiler angle="degree"/><worldbody><body name="trunk" pos="0 0 2"><freejoint name="root"/>
  <geom name="trunk" type="capsule" size=".1" fromto="0 0 -.2 0 0 .2" mass="9"/>
  <body name="arm" pos="0 .3 .2"><joint name="shoulder" type="ball"/>
    <geom name="arm" type="capsule" size=".03" fromto="0 0 -.02 0 0 -.1" mass="1"/>
    <body name="hand" pos="0 0 -.2"><joint name="wrist" type="ball"/>
      <geom name="hand" type="capsule" size=".04" fromto="0 0 0 0 0 -.15" mass="1"/></body></body>
</body></worldbody></mujoco>"""


def read(text: str, figure: str = "", folder: Path | None = None) -> Clip:
    """A clip from text, its figure in a file called it.xml."""
    if folder is not None:
        (folder / "it.xml").write_text(figure, encoding="utf-8")
        text = 'figure = "it.xml"\n' + text
    return recordings.from_text(text, name="it", folder=folder)


def wrong(problem: Clip, timeline: Timeline | None = None, stop: Stop = Stop.CONVERGED) -> tuple[Violation, ...]:
    """With the raw spline, or with another timeline through its keyframes; figures here may hang in the air."""
    raw = solving.unsolved(problem).motion.raw
    found = violation.violations(problem, timeline or raw, raw, stop)
    return tuple(each for each in found if each.kind != "aloft")


def unposed(problem: Clip) -> Clip:
    """The clip as if nobody had posed what its keyframes leave to the search."""
    return problem.with_problem(keys=tuple(replace(key, posed=None) for key in problem.keys))


def kinds(found: Sequence[Violation]) -> set[str]:
    return {each.kind for each in found}


def with_frame(problem: Clip, at: float, change: np.ndarray) -> Timeline:
    """The raw spline with one more frame, in which the state is another."""
    raw = solving.unsolved(problem).motion.raw
    return raw.inserted([Frame.variable(at, path_of(raw).at(np.array([at]))[0] + change)])


# what is said


def test_a_keyframe_in_the_floor_is_to_blame_itself_and_the_path_to_it_is_not():
    found = wrong(read(SQUAT))
    assert kinds(found) == {"penetration"}
    assert {each.keyframe for each in found} == {2}
    assert found[0].text in (
        "keyframe 2 itself: left_heel is 200 mm in the floor at 1.00 s",
        "keyframe 2 itself: right_heel is 200 mm in the floor at 1.00 s",
    )
    assert found[0].amount == pytest.approx(0.2, abs=1e-4)
    assert (found[0].time, found[0].unit, found[0].bound) == (1.0, "m", BOUNDS["penetration"].most)


def test_a_path_that_goes_deeper_than_the_keyframes_next_to_it_is_to_blame_too():
    problem = read(SQUAT)
    down = np.zeros(problem.figure.width)
    down[2] = -0.3
    found = wrong(problem, with_frame(problem, 0.8, down))
    path = [each for each in found if each.keyframe is None and each.name.endswith(("heel", "toe"))]
    assert {each.kind for each in path} >= {"penetration"}
    assert path[0].text.startswith(f"{path[0].name} is ")
    assert path[0].amount > 0.3
    assert any(each.keyframe == 2 for each in found)


def test_between_frames_a_path_in_the_floor_is_found_as_deep_as_it_is(tmp_path):
    rows = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [0, 0, {z}], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        for t, z in ((0, 1), (0.5, 0.11), (1, 0.11), (1.5, 1))
    )
    problem = read(rows, BALL, tmp_path)
    found = next(each for each in wrong(problem) if each.kind == "penetration")
    run = sampled(problem.figure, solving.unsolved(problem).motion.raw, 1000.0)
    seen = penetration(problem.figure.model, run.time, run.qpos)
    assert found.amount == pytest.approx(seen.deepest, abs=1e-4)
    assert found.time == pytest.approx(0.75, abs=0.01)
    assert found.text == f"ball is {1000 * seen.deepest:.0f} mm in the floor at {found.time:.2f} s"


def test_a_joint_that_swings_in_a_hold_is_reported(tmp_path):
    arm = '<mujoco><worldbody><body pos="0 0 2"><joint name="arm"/><geom size=".1"/></body></worldbody></mujoco>'
    keys = ((0, 0), (1, 0), (1.3, 120), (2.3, 120))
    rows = "".join(f"[[keyframe]]\ntime = {t}\njoints.arm = {angle}\n" for t, angle in keys)
    problem = read(rows, arm, tmp_path)
    first, second = sorted(wrong(problem), key=lambda each: each.time or 0.0)
    raw = np.degrees(problem.figure.to_qpos(path_of(problem.problem.raw).at(np.linspace(0, 1, 1001))))
    assert (first.kind, first.name, second.kind) == ("overshoot", "arm", "overshoot")
    assert first.amount == pytest.approx(np.abs(raw).max(), abs=0.01)
    assert "away from its values in the keyframes at 0 and 1 s" in first.text
    assert solving.solve(problem, quiet()).violations == ()


@pytest.mark.slow
def test_depths_are_mujocos():
    problem = clip.load("jump_over_box")
    raw = solving.unsolved(problem).motion.raw
    found = [each for each in wrong(problem) if each.kind == "penetration"]
    run = sampled(problem.figure, raw, 240.0)
    seen = penetration(problem.figure.model, run.time, run.qpos)
    assert seen.deepest > 0.02
    assert found[0].amount == pytest.approx(seen.deepest, abs=0.002)
    assert f"in the {seen.worst().split(' in ')[1].split()[0]} " in found[0].text


def test_a_figure_that_goes_through_a_box_is_reported_though_its_keyframes_are_out_of_it(tmp_path):
    box = '[[scene.box]]\nname = "crate"\nposition = [0, 0, 1]\nsize = [0.4, 0.4, 0.4]\n'
    rows = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [{x}, 0.05, 1], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        for t, x in ((0, -1), (1, 1))
    )
    (found,) = wrong(read(box + rows, BALL, tmp_path))
    assert (found.kind, found.name, found.keyframe) == ("penetration", "ball", None)
    assert found.amount == pytest.approx(0.25, abs=0.01)  # 0.15 m to the nearest face, and the ball's radius
    assert "ball is 250 mm in the crate at " in found.text
    assert found.time == pytest.approx(0.5, abs=0.1)


def test_bends_that_a_clip_does_not_want_are_not_reported():
    text = 'figure = "human"\n[[penalty]]\nkind = "limits"\nweight = {bend = 0}\n' + HIGH.format(0) + HIGH.format(1)
    assert wrong(read(text + "joints.left_knee = {rotvec = [0, -20, 0]}\n")) == ()


TWO = "[[keyframe]]\ntime = 0\njoints = {{slide = 0, swing = 0{}}}\n[[keyframe]]\ntime = 1\njoints = {{{}}}\n"
FOLLOWS = '<equality><joint joint1="twin" joint2="swing" polycoef="0 1 0 0 0"/></equality>'
TIED = '<equality><connect name="bolt" body1="upper" body2="twin" anchor="0 0 -.3"/></equality>'
KNEE = 'figure = "human"\n' + HIGH.format(0) + HIGH.format(1) + "joints.left_knee = {{rotvec = {}}}\n" + HIGH.format(2)
ALONE = ARM.format(more="", equality="")
OF_KEYFRAMES = {  # clip, figure, text
    "backward": (KNEE.format([0, -20, 0]), "", "left_knee is bent 20° backward at 1.00 s"),
    "sideways": (KNEE.format([20, 0, 0]), "", "left_knee bends 12° sideways beyond its limit at 1.00 s"),
    "twist": (KNEE.format([0, 0, 20]), "", "left_knee is twisted 12° beyond its limit at 1.00 s"),
    "range": (TWO.format("", "slide = 0, swing = 98"), ALONE, "swing is 8° beyond its range at 1.00 s"),
    "travel": (TWO.format("", "slide = 1.02, swing = 0"), ALONE, "slide is 20 mm beyond its range at 1.00 s"),
    "coupled": (
        TWO.format(", twin = 0", "slide = 0, swing = 30, twin = 24"), ARM.format(more=TWIN, equality=FOLLOWS),
        "twin is 6° off what it follows at 1.00 s"),
    "torn": (  # by 2 · 0.3 m · sin 3°
        TWO.format(", twin = 0", "slide = 0, swing = 20, twin = 14"),
        ARM.format(more=TWIN.replace("0 .4 2", "0 .2 2"), equality=TIED),
        "the loop of bolt is torn by 31 mm at 1.00 s"),
}  # fmt: skip


@pytest.mark.parametrize("kind", OF_KEYFRAMES)
def test_joints_of_a_keyframe_out_of_their_bounds_are_one_violation(tmp_path, kind):
    clip_text, figure, text = OF_KEYFRAMES[kind]
    (found,) = wrong(read(clip_text, figure, tmp_path if figure else None))
    assert (found.kind, found.keyframe, found.text) == (kind, 2, f"keyframe 2 itself: {text}")


def standing(*places: float) -> str:
    """A clip of a figure that stands at places along x [m], one a second."""
    key = '[[keyframe]]\ntime = {}\nroot.position = [{}, 0, 0.93]\nothers = "rest"\n'
    return 'figure = "human"\n' + "".join(key.format(t, x) for t, x in enumerate(places))


STANDING = standing(0, 0, 0.4)


def test_a_contact_that_moves_and_its_worst_moment():
    contact = '[[contact]]\npoint = "right_toe"\nfrom = 1.2\nto = 1.8\n'
    problem = read(STANDING + contact)
    found = [each for each in wrong(problem) if each.kind == "contact"]
    raw = path_of(solving.unsolved(problem).motion.raw)
    x = raw.at(np.array([1.2, 1.5, 1.8]))[:, 0]
    assert [(each.name, each.keyframe) for each in found] == [("right_toe", None)]
    assert found[0].amount == pytest.approx(max(x[1] - x[0], x[2] - x[1]), abs=1e-3)
    assert found[0].time in (1.2, 1.8)
    assert found[0].text.startswith("contact right_toe is ")
    assert " from the place where it should rest at " in found[0].text


def test_a_contact_that_is_up_in_the_air():
    contact = '[[contact]]\npoint = "right_toe"\nfrom = 0.4\nto = 0.6\n'
    problem = read(STANDING.replace("0.93", "1.03") + contact)
    (found,) = [each for each in wrong(problem) if each.kind in ("hover", "contact")]
    assert found.kind == "hover"
    assert found.text.startswith("contact right_toe is 100 mm above its surface")


def test_a_foot_that_keyframes_leave_standing_slides():
    problem = read(standing(0, 0, 0))
    assert wrong(problem) == ()
    aside = np.zeros(problem.figure.width)
    aside[1] = 0.05
    found = wrong(problem, with_frame(problem, 0.5, aside))
    assert kinds(found) == {"stance"}
    assert len(found) == 2  # a foot each
    assert found[0].amount == pytest.approx(0.05, abs=0.005)
    assert "between keyframes with the same position at 0.5" in found[0].text


def test_keyframes_that_move_a_contact_are_to_blame_themselves():
    contact = '[[contact]]\npoint = "right_toe"\nfrom = 0\nto = 1\n'
    (found,) = [each for each in wrong(read(standing(0, 0.03, 0.03) + contact)) if each.kind == "contact"]
    assert (found.keyframe, found.amount) == (2, pytest.approx(0.03, abs=1e-6))
    assert found.text == (
        "keyframe 2 itself: right_toe should rest, but is 30 mm from its position in the previous keyframe at 1.00 s"
    )


@pytest.mark.parametrize(("step", "reported"), [(0.1, set()), (1.0, {"stance"})])
def test_a_foot_moves_between_samples_of_a_recording_unless_they_are_far_apart(step, reported):
    """A sole on the ground in two neighbouring samples, 25 mm apart, lands or slides between them."""
    standing_still = read(standing(0, 0))
    qpos = np.tile(standing_still.keys[0].state, (4, 1))
    qpos[2:, 0] += 0.025
    recorded = clip.from_qpos("it", standing_still.scene, step * np.arange(4), qpos, 30.0, "it")
    assert kinds(wrong(recorded)) == reported


def test_a_point_off_the_place_that_the_search_was_to_find(tmp_path):
    rows = "[[keyframe]]\ntime = 0\njoints = {slide = 0, swing = 0}\n"
    rows += '[[keyframe]]\ntime = 1\nsites.tip = {position = [0.05, 0.2, 1.7], by = "search"}\n'
    problem = unposed(read(rows, ARM.format(more="", equality=""), tmp_path))
    (found,) = wrong(problem)
    assert (found.kind, found.name, found.keyframe) == ("placement", "tip", None)
    assert found.text == "tip is 50 mm off its place at 1.00 s"
    assert wrong(problem, solving.solve(problem, quiet()).motion.timeline) == ()


def swinging(*turns: float) -> str:
    """Keyframes of TRUNK, one a second, that swing its arm by angles [degrees] with the hand beside the trunk."""
    return "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [0, 0, 2], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        f"joints = {{shoulder = {{rotvec = [-40, {turn}, 0]}}, wrist = {{rotvec = [0, 0, 0]}}}}\n"
        for t, turn in enumerate(turns)
    )


def deepest(problem: Clip, rate: float) -> float:
    """[m] of any pair of geoms that MuJoCo lets collide, by its distances, along the raw spline."""
    model, data = problem.figure.model, mujoco.MjData(problem.figure.model)
    run = sampled(problem.figure, solving.unsolved(problem).motion.raw, rate)
    depth = 0.0
    for qpos in run.qpos:
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        for one, two in data.contact.geom.tolist():
            depth = max(depth, -mujoco.mj_geomDistance(model, data, one, two, 1.0, None))
    return depth


PENALTY = "[[penalty]]\nkind = 'collision'\nself = true\nweight = {self = 1}\nmargin = 0.01\n"


@pytest.mark.parametrize("penalty", ["", PENALTY])
def test_limbs_in_each_other_are_reported_whatever_the_clip_penalizes(tmp_path, penalty):
    problem = read(swinging(40, -40) + penalty, TRUNK, tmp_path)
    (found,) = wrong(problem)
    assert (found.kind, found.keyframe) == ("self", None)
    assert found.amount == pytest.approx(deepest(problem, 500), abs=0.002)
    assert found.text.startswith("trunk and hand are 7")


@pytest.mark.parametrize(
    ("one", "other", "count"),
    [
        ('geom name="trunk"', 'geom name="trunk" contype="0" conaffinity="2"', 0),
        ('geom name="trunk"', 'geom name="trunk" contype="2" conaffinity="0"', 0),
        ('geom name="trunk"', 'geom name="trunk" contype="0" conaffinity="1"', 1),
        ("</worldbody>", '</worldbody><contact><exclude body1="trunk" body2="hand"/></contact>', 0),
        ("</worldbody>", '</worldbody><contact><exclude body1="trunk" body2="arm"/></contact>', 1),
        ("<geom ", '<geom contype="0" conaffinity="0" ', 1),
    ],
)
def test_bodies_collide_as_mujoco_has_it_or_all_of_them_if_none_would(tmp_path, one, other, count):
    problem = read(swinging(40, -40), TRUNK.replace(one, other), tmp_path)
    assert [each.kind for each in wrong(problem)] == ["self"] * count
    assert (deepest(problem, 60) > 0.01) == (count > 0 and 'contype="0" conaffinity="0"' not in other)


@pytest.mark.parametrize(("between", "texts"), [(1, []), (2, ["ball and c are 30 mm deeper in each other"])])
def test_bodies_that_overlap_at_rest_count_by_how_much_deeper_they_are_unless_they_are_joined(tmp_path, between, texts):
    names = "ab"[:between]
    chain = '<body name="c" pos=".12 0 0"><joint name="c" type="slide"/><geom size=".05" mass="1"/></body>'
    for name in names:
        inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
        chain = f'<body name="{name}"><joint name="{name}"/>{inertia}{chain}</body>'
    model = BALL.replace('<site name="mark" pos="0 0 0"/>', chain.replace('type="slide"', 'type="slide" axis="1 0 0"'))
    rows = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [0, 0, 2], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        f"joints = {{c = {-0.03 * t}, {', '.join(f'{name} = 0' for name in names)}}}\n"
        for t in (0, 1)
    )
    found = wrong(read(rows, model, tmp_path))
    assert [each.text for each in found] == [f"keyframe 2 itself: {text} at 1.00 s" for text in texts]


def test_keyframes_with_limbs_in_each_other_are_one_line(tmp_path):
    (found,) = wrong(read(swinging(2, 0, 3), TRUNK, tmp_path))
    assert found.keyframe == 2
    assert found.text.startswith("keyframe 2 itself: trunk and hand are ")
    assert found.text.endswith(" in each other at 1.00 s, and in 2 other keyframes")


def test_forearms_in_the_head_and_in_each_other_are_reported_as_deep_as_mujoco_has_them():
    arm = "joints.{0}_shoulder = {{{{rotvec = [{1}, -140, {2}]}}}}\njoints.{0}_elbow = {{{{rotvec = [0, -130, 0]}}}}\n"
    arms = arm.format("left", 20, -60) + arm.format("right", -20, 60)
    arms = arms.replace("{{", "{").replace("}}", "}")
    problem = read('figure = "human"\n' + HIGH.format(0) + HIGH.format(1) + arms + HIGH.format(2))
    found = {each.text.split(" are ")[0]: each.amount for each in wrong(problem) if each.keyframe == 2}
    model = problem.figure.model
    data = kinematics(model, problem.keys[1].state)
    bodies = {model.body(body).name: model.body(body).id for body in range(model.nbody)}
    geoms = {name: np.flatnonzero(model.geom_bodyid == body).tolist() for name, body in bodies.items()}
    for pair in ("chest and left_forearm", "chest and right_forearm", "left_forearm and right_forearm"):
        one, two = pair.split(" and ")
        both = itertools.product(geoms[one], geoms[two])
        depth = max(-mujoco.mj_geomDistance(model, data, first, last, 1.0, None) for first, last in both)
        assert found[f"keyframe 2 itself: {pair}"] == pytest.approx(depth, abs=1e-4) and depth > 0.03


def test_joints_faster_than_their_limit(tmp_path):
    rows = "".join(f"[[keyframe]]\ntime = {t}\njoints = {{slide = 0, swing = {80 * t}}}\n" for t in (0, 1))
    limit = '[[penalty]]\nkind = "limits"\nspeed = {}\n'
    (found,) = wrong(read(rows + limit.format(50), ARM.format(more="", equality=""), tmp_path))
    assert (found.kind, found.name, found.unit, found.keyframe) == ("speed", "swing", "degrees/s", None)
    assert found.amount == pytest.approx(30, abs=0.5)
    assert found.text.startswith("swing turns 30 degrees/s faster than its limit of 50 degrees/s at ")
    assert wrong(read(rows + limit.format(75), ARM.format(more="", equality=""), tmp_path)) == ()


def test_a_foot_is_one_line_in_an_interval_and_not_one_for_each_of_its_points():
    contact = '[[contact]]\npoint = "right_{}"\nfrom = {}\nto = {}\n'
    text = STANDING + contact.format("toe", 1.2, 1.8) + contact.format("heel", 1.1, 1.7)
    (found,) = [each for each in wrong(read(text)) if each.kind == "contact"]
    alone = [each for each in wrong(read(STANDING + contact.format("toe", 1.2, 1.8))) if each.kind == "contact"]
    assert found.amount >= alone[0].amount
    apart = STANDING + contact.format("toe", 1.1, 1.4) + contact.format("heel", 1.5, 1.8)
    assert len([each for each in wrong(read(apart)) if each.kind == "contact"]) == 2


def test_a_limb_that_whips():
    problem = read('figure = "human"\n' + HIGH.format(0) + HIGH.format(1))
    raw = solving.unsolved(problem).motion.raw
    elbow = next(link for link in problem.figure.links if link.name == "left_elbow")
    assert problem.figure.is_world
    state = path_of(raw).at(np.array([0.5]))[0]
    turned = state.copy()
    turned[elbow.qpos : elbow.qpos + 4] = quat.product(
        quat.from_rotation_vector(np.array([0, -1.0, 0])), state[elbow.qpos : elbow.qpos + 4]
    )
    frames = [Frame.variable(0.45, state), Frame.variable(0.5, turned), Frame.variable(0.55, state)]
    found = [each for each in wrong(problem, raw.inserted(frames)) if each.kind == "whip"]
    assert found[0].name == "left_elbow"
    assert found[0].text.startswith("left_elbow whips: ")
    assert found[0].time == pytest.approx(0.5, abs=0.06)


def test_a_quaternion_far_from_length_one(tmp_path):
    rows = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [0, 0, 2], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        for t in (0, 1)
    )
    problem = read(rows, BALL, tmp_path)
    (found,) = wrong(problem, with_frame(problem, 0.5, np.array([0, 0, 0, -0.7, 0, 0, 0])))
    assert (found.kind, found.name) == ("length", "root")
    assert found.amount == pytest.approx(0.7, abs=0.02)


BARREL = """
<mujoco><worldbody>
  <body name="barrel" pos="0 0 .5"><freejoint name="root"/><geom name="barrel" type="box" size=".25 .25 .25"/>
    <body name="arm" pos="0 .3 0"><joint name="swing" axis="0 1 0"/>
      <geom type="capsule" size=".04" fromto="0 0 0 0 0 -.2"/></body></body>
</worldbody></mujoco>"""


def recorded(folder: Path, *places: Sequence[float]) -> None:
    """A motion of the barrel in the folder, through places at rest, as rec.npz."""
    (folder / "barrel.xml").write_text(BARREL, encoding="utf-8")
    keys = [Keyframe(float(t), root={"position": place}, others="rest") for t, place in enumerate(places)]
    inbetween(build(str(folder / "barrel.xml"), keys)).save(folder / "rec.npz")


def test_an_obstacle_inside_a_body_that_follows_a_recording_is_reported(tmp_path):
    recorded(tmp_path, (0, 0, 0.5), (0, 0.3, 0.5), (0, 0, 0.5))
    rail = '[[scene.capsule]]\nname = "rail"\nfrom = [0.15, -2, 0.55]\nto = [0.15, 2, 0.55]\nradius = 0.02\n'
    text = f'figure = "barrel.xml"\n[recording]\nfile = "rec.npz"\n{rail}[[keyframe]]\ntime = 1\njoints.swing = 20\n'
    (tmp_path / "follow.toml").write_text(text, encoding="utf-8")
    (found,) = [v for v in inbetween(load(str(tmp_path / "follow.toml"))).violations if v.kind == "penetration"]
    assert found.name == "barrel" and found.amount == pytest.approx(0.12, abs=0.008)  # from the rail's far side


def test_a_frame_of_a_recording_is_no_keyframe_at_fault(tmp_path):
    recorded(tmp_path, (0, 0, 1.5), (0.1, 0, 1.5))
    text = 'figure = "barrel.xml"\n[recording]\nfile = "rec.npz"\n[[keyframe]]\ntime = 0.5\njoints.swing = 20\n'
    (tmp_path / "follow.toml").write_text(text, encoding="utf-8")
    found = inbetween(load(str(tmp_path / "follow.toml"))).violations
    assert [v.kind for v in found] == ["aloft"] and found[0].keyframe is None and "itself" not in found[0].text


@pytest.mark.parametrize("stop", Stop)
def test_a_search_that_ended_early(stop):
    found = wrong(read(standing(0, 0)), stop=stop)
    assert kinds(found) == ({"search"} if stop in (Stop.MAX_EVALUATIONS, Stop.NO_PROGRESS) else set())
    for each in found:
        assert each.time is None
        assert each.text == f"the search ended early: {stop.value}"


# in what order, how many, how fast


def test_the_worst_comes_first_by_how_many_times_its_bound_it_is():
    text = SQUAT.replace(
        'time = 2\nothers = "rest"\n', 'time = 2\nothers = "rest"\njoints.left_knee = {rotvec = [0, -20, 0]}\n'
    )
    text += '[[contact]]\npoint = "right_toe"\nfrom = 0.3\nto = 0.9\n'
    found = wrong(read(text), stop=Stop.MAX_EVALUATIONS)
    assert len(kinds(found)) >= 4
    severities = [each.amount / each.bound for each in found]
    assert severities == sorted(severities, reverse=True) == [each.severity for each in found]
    assert all(severity >= 1 for severity in severities)
    for one, two in itertools.pairwise(found):
        assert one != two


def test_of_many_lines_the_worst_are_reported_and_the_rest_counted():
    many = [
        Violation("range", f"joint {i}", 0.1, 20.0 - i, "degrees", 2.0, None, f"joint {i} is off") for i in range(14)
    ]
    lines = violation.lines(many, "it.npz")
    assert lines[:2] == ["violation: joint 0 is off", "violation: joint 1 is off"]
    assert lines[10:] == ["... and 4 more: dynsplines report it.npz"]
    assert violation.lines(many[:10]) == lines[:10]
    assert violation.lines([]) == []


def test_limbs_that_one_keyframe_sinks_are_one_line():
    found = wrong(read(SQUAT))
    (line,) = violation.lines(found)
    assert line == f"violation: {found[0].text}; {len(found) - 1} more like it there"
    assert len(found) == 4


# of motions in files


@pytest.fixture(scope="module")
def walked() -> motion.Saved:
    """A motion with a contact that moves and a place that is missed."""
    contact = '[[contact]]\npoint = "right_toe"\nfrom = 1.2\nto = 1.8\n'
    site = 'sites.left_hand = {position = [0.5, 0.4, 1.2], by = "search"}\n'
    return solving.unsolved(unposed(read(STANDING + site + contact))).saved(quiet(), with_report=False)


def said(saved: motion.Saved) -> set[tuple[str, str]]:
    return {(each.kind, each.name) for each in solving.Solved.of(saved).violations}


@pytest.mark.slow
def test_edited_motions_are_looked_at_as_what_they_are(walked):
    """Without the contacts and targets of the clip."""
    assert said(walked) >= {("contact", "right_toe"), ("placement", "left_hand")}
    for edited in (edits.mirrored(walked), edits.retimed(walked, 2.0), edits.trimmed(walked, 1.1, 2.0)):
        kinds = {kind for kind, _ in said(edited)}
        assert "penetration" in kinds or kinds
        assert not {"contact", "placement"} & kinds


def test_a_text_that_is_unreadable_is_no_reason_not_to_look(walked):
    assert isinstance(solving.Solved.of(replace(walked, text="figure = ")).violations, tuple)


@pytest.mark.slow
def test_why_the_search_ended_is_in_the_file(tmp_path):
    keys = [Keyframe(0, others="rest"), Keyframe(0.8, root={"position": [0.7, 0, 1.2]}, others="rest")]
    found = inbetween(build("human", keys, scene={"step": {"x": 0.4, "height": 0.27}}, solve={"evaluations": 2}))
    assert [each.kind for each in found.violations].count("search") == 1
    found.save(tmp_path / "m.npz")
    assert motion.load(tmp_path / "m.npz").report == {}
    again = load_motion(tmp_path / "m.npz")
    assert [each.text for each in again.violations] == [each.text for each in found.violations]
    assert again.report()["evaluations"] == found.saved.search["evaluations"] > 0
    assert found.saved.search["seconds"] > 0
    assert "seconds" not in again.report()  # a file knows no clock
    assert again.report()["stopped because"] == Stop.MAX_EVALUATIONS.value
    assert [each["text"] for each in again.report()["violations"]] == [each.text for each in found.violations]
    assert str(again.report()).splitlines()[0].startswith("violation: ")
    again.save(tmp_path / "measured.npz")
    assert motion.load(tmp_path / "measured.npz").report["keyframes"] == 2


def test_the_bounds_of_the_page_are_those_of_the_code():
    """A row for every bound, or one for two of the same size."""
    page = (Path(__file__).parents[3] / "docs" / "violations.md").read_text(encoding="utf-8")
    told = {}
    for names, most in re.findall(r"^\| (`[^|]+`) \| ([^|]+) \|", page, flags=re.MULTILINE):
        told |= dict.fromkeys(re.findall(r"`([^`]+)`", names), most)
    spoken = {"m": lambda most: f"{1000 * most:g} mm", "degrees": lambda most: f"{most:g}°"}
    said = {
        kind: spoken.get(bound.unit, lambda most, unit=bound.unit: f"{most:g} {unit}".strip())(bound.most)
        for kind, bound in BOUNDS.items()
    }
    assert told == said | {"search": "–"}
    assert f"{WHIP_SHARE:g} times the largest one of all limbs in the raw spline" in page


@pytest.mark.parametrize("offset", [0.0, 0.002, 0.004, 0.006])
def test_hands_that_pass_fast_through_each_other_are_reported(offset, tmp_path):
    """Two balls of 80 mm meet at 0.25 s + offset with 8 m/s: they overlap by more than 10 mm for 17 ms."""
    ball = '<body pos="{} 0 1"><joint name="{}" type="slide" axis="1 0 0"/><geom size=".04" mass="1"/></body>'
    figure = f"<mujoco><worldbody>{ball.format(0, 'a')}{ball.format(1, 'b')}</worldbody></mujoco>"
    ends = ((0.0, -1 - 4 * offset), (0.5, 1 - 4 * offset))
    text = "".join(f"[[keyframe]]\ntime = {t}\njoints = {{a = {x}, b = {-x - 1}}}\n" for t, x in ends)
    (overlap,) = [each for each in wrong(read(text, figure, tmp_path)) if each.kind == "self"]
    assert 0.04 < overlap.amount < 0.081
    assert overlap.time == pytest.approx(0.25 + offset, abs=0.005)


DECK = """<mujoco><worldbody><body name="cart" pos="0 0 .5"><freejoint name="root"/>
  <geom name="deck" type="box" size=".3 .3 .1" mass="1"/></body></worldbody></mujoco>"""
ROD = """<mujoco><worldbody><body name="arm" pos="0 0 1"><joint name="lift" axis="0 1 0"/>
  <geom name="rod" type="cylinder" size=".04 .5" pos=".5 0 0" euler="0 90 0" mass="1"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("above", [0.0, 0.02])  # [m]: on the floor, an obstacle counts as a step
@pytest.mark.parametrize("is_penalized", [True, False])
@pytest.mark.parametrize(
    ("model", "row", "box"),
    [
        (DECK, "root.position = [1, 0, 0.5]", "size = [0.06, 0.06, 1.2]\nposition = [1, 0, {}]"),
        (ROD, "joints.lift = 20", "size = [0.04, 1, 0.9]\nposition = [0.6, 0, {}]"),
    ],
)
def test_a_narrow_obstacle_inside_a_wide_geom_is_reported(model, row, box, above, is_penalized, tmp_path):
    (tmp_path / "model.xml").write_text(model)
    keys = "".join(f"[[keyframe]]\ntime = {t}\n{row}\n" for t in (0, 1))
    scene = f"[[scene.box]]\nname = 'post'\n{box.format(above + (0.6 if model is DECK else 0.45))}\n"
    off = "" if is_penalized else "[[penalty]]\nkind = 'collision'\nweight = 0\n"
    solved = inbetween(
        recordings.from_text('figure = "model.xml"\n' + scene + off + keys, folder=tmp_path, name="post")
    )
    data = kinematics(solved.model, solved.at(0.0))
    geoms = [solved.model.geom(name).id for name in ("deck" if model is DECK else "rod", "post")]
    assert mujoco.mj_geomDistance(solved.model, data, *geoms, 0.1, None) < -0.02
    assert any(v.kind == "penetration" and v.amount > 0.02 for v in solved.violations)
