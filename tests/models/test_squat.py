"""Partial keyframes: a lowered pelvis bends the knees, feet that stand stay, and nothing is told that is in doubt."""

from collections.abc import Sequence
from pathlib import Path

import figures
import numpy as np
import pytest
from figures import link_named
from oracles import kinematics

from dynsplines import recordings
from dynsplines.clip.build import Clip
from dynsplines.motion import samples_at
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Attachment, BendLimits, JointRange, Support, joint_ranges
from dynsplines.solver.surface.points import places_of

KNEES = ("left_knee", "right_knee")
ROUNDING = 0.1  # degrees beyond a range that a soft constraint leaves
REST = 'figure = "human"\n[[keyframe]]\ntime = 0\nothers = "rest"\n'
LAST = '[[keyframe]]\ntime = 4\nothers = "rest"\n'


def read(text: str) -> Clip:
    return recordings.from_text(text, name="c")


def between(*bodies: str) -> Clip:
    """Keyframes a second apart between two at rest."""
    keys = "".join(f"[[keyframe]]\ntime = {i}\n{body}\n" for i, body in enumerate(bodies, start=1))
    return read(REST + keys + LAST)


def told(problem: Clip, frame: Frame, joint: str) -> bool:
    """Whether a keyframe was posed at a joint."""
    link = link_named(problem.figure, joint)
    assert link is not None
    return frame.posed is not None and bool(frame.posed[problem.figure.links[link].columns].all())


def posed_feet(problem: Clip) -> list[str]:
    """The knees that keyframes pose, a letter each: "l", "r", "lr" or "", by keyframe."""
    return ["".join(knee[0] for knee in KNEES if told(problem, key, knee)) for key in problem.keys]


def soles(problem: Clip, k: int) -> Array:
    """(n, 3) [m] the sole points of keyframe k on the raw spline, by MuJoCo."""
    timeline = raw_timeline(problem.figure, list(problem.keys), problem.ends, np.zeros((2, problem.figure.width)))
    data = kinematics(problem.figure.model, problem.figure.to_qpos(timeline.states[k]))
    return np.array([data.site(point.name).xpos for point in problem.context.points])


def squat(height: float, place: str = "[0, 0, {}]", figure: str = "human") -> Clip:
    """The simplest squat: at rest, the root at a height, at rest again."""
    text = f"""figure = "{figure}"
        [[keyframe]]
        time = 0
        others = "rest"
        [[keyframe]]
        time = 1
        root.position = {place.format(height)}
        [[keyframe]]
        time = 2
        others = "rest"
        """
    return read(text)


def is_supported(problem: Clip) -> bool:
    """Whether forces that feet cannot supply cost anything."""
    return any(isinstance(penalty, Support) for penalty, _ in problem.penalties)


def assert_squat(problem: Clip, timeline: Timeline, sunk: float, moved: float, within_range: Sequence[str]) -> None:
    """That soles sink and slide by no more [m], joints are in their ranges, and no link whips, at 1 kHz."""
    path, figure = path_of(timeline), problem.figure
    first, last = path.span
    samples = samples_at(figure, path, np.linspace(first, last, round((last - first) * 1000) + 1))
    centres, _ = places_of(problem.context.points, samples)
    assert max(surface.inside(centres).max() for surface in problem.context.surfaces) <= sunk
    assert np.linalg.norm(centres - centres[:, :, :1], axis=0).max() <= moved
    ranges = JointRange(tuple(joint for joint in joint_ranges(figure) if joint.name in within_range))
    assert np.degrees(ranges.beyond(samples).max()) <= ROUNDING
    relative = np.linalg.norm(samples.links.alpha - samples.links.alpha[:, figure.tables.parents], axis=0)
    turning = [i for i, link in enumerate(figure.links) if i and link.kind in (JointKind.BALL, JointKind.HINGE)]
    assert relative[turning].max() <= 60
    for bends in (penalty for penalty, _ in problem.penalties if isinstance(penalty, BendLimits)):
        flexion, *others = np.degrees(bends.angles(samples))
        assert flexion.min() >= -0.5
        assert np.abs(others).max() <= 8.5


@pytest.mark.slow
def test_a_lowered_pelvis_is_a_squat():
    problem = squat(height := 0.7)
    assert not is_supported(problem)
    timeline = inbetween(problem.problem).timeline
    assert_squat(problem, timeline, 1e-3, 5e-3, KNEES)
    qpos = problem.figure.to_qpos(timeline.states[list(timeline.times).index(1.0)])
    assert qpos[2] == pytest.approx(height, abs=1e-9)
    assert quat.angle_between(qpos[3:7], problem.figure.model.qpos0[3:7]) < np.radians(15)


def test_a_robot_that_squats_and_may_move_stays_in_balance(tmp_path: Path):
    """Its legs bend least if it leans back by half their length."""
    (tmp_path / "its.xml").write_text(figures.BIPED, encoding="utf-8")
    problem = squat(0.45, '["free", "free", {}]', str(tmp_path / "its.xml"))
    data = kinematics(problem.figure.model, problem.figure.to_qpos(problem.problem.raw.states[1]))
    assert abs(data.subtree_com[1][0] - 0.04) < 0.65 * 0.1  # of the middle of the feet, 0.2 m long


@pytest.mark.slow
@pytest.mark.parametrize(("name", "height"), [("BIPED", figures.BIPED_HEIGHT), ("QUADRUPED", figures.QUADRUPED_HEIGHT)])
def test_legs_of_hinges_bend_too(name, height, tmp_path: Path):
    (tmp_path / "its.xml").write_text(getattr(figures, name), encoding="utf-8")
    problem = squat(0.8 * height, figure=str(tmp_path / "its.xml"))
    joints = [link.name for link in problem.figure.links[2:]]
    assert_squat(problem, inbetween(problem.problem).timeline, 2e-3, 10e-3, joints)


@pytest.mark.slow
def test_what_was_posed_stays_free_and_is_where_the_search_and_the_raw_spline_begin():
    problem = squat(0.7)
    key = problem.keys[1]
    assert np.flatnonzero(key.fixed).tolist() == [0, 1, 2]
    assert posed_feet(problem) == ["", "lr", ""]
    assert not told(problem, key, "left_elbow")
    raw = raw_timeline(problem.figure, list(problem.keys))
    assert key.posed is not None
    there = problem.figure.to_qpos(raw.states[1])
    for joint in KNEES:
        link = link_named(problem.figure, joint)
        assert link is not None
        columns = problem.figure.links[link].columns
        assert quat.angle_between(there[columns], key.state[columns]) < 1e-9
        assert quat.rotation_vector(there[columns])[1] > np.radians(40)
    np.testing.assert_allclose(soles(problem, 1), soles(problem, 0), atol=1e-6)
    planted = next(penalty for penalty, _ in problem.penalties if isinstance(penalty, Attachment))
    assert {(stance.point.name, stance.first, stance.last) for stance in planted.contacts} == {
        (point.name, first, first + 1.0) for point in problem.context.points for first in (0.0, 1.0)
    }


@pytest.mark.slow
def test_what_is_held_is_posed_again_where_the_pelvis_has_gone():
    problem = between("root.position = [0, 0, 0.7]", 'root.position = [0.05, 0, 0.6]\nothers = "previous"')
    assert posed_feet(problem) == ["", "lr", "lr", ""]
    np.testing.assert_allclose(soles(problem, 2), soles(problem, 0), atol=1e-6)


def test_a_leg_that_a_keyframe_sets_and_feet_that_are_elsewhere_before_and_after_are_left_alone():
    raised = "root.position = [0, 0, 0.9]\njoints.left_hip = {rotvec = [0, -60, 0]}"
    assert posed_feet(between(raised)) == ["", "r", ""]
    text = REST + (
        '[[keyframe]]\ntime = 1\nroot.position = [0.2, 0, 0.8]\n[[keyframe]]\ntime = 2\nothers = "rest"\n'
        "root.position = [0.4, 0, 0.93]\n"
    )
    assert posed_feet(read(text)) == ["", "", ""]


@pytest.mark.slow
def test_a_foot_that_goes_elsewhere_leaves_the_other_where_it_stands():
    feet = "bodies.right_foot = {flat = true}\nbodies.left_foot = {flat = true}"
    sites = "sites.right_heel = [-0.055, -0.09, 0]\nsites.left_heel = [0.25, 0.09, 0]"
    step = f'others = "rest"\nroot.position = [0.1, 0, 0.86]\n{feet}\n{sites}'
    assert posed_feet(between("root.position = [0.05, 0, 0.85]", step))[1] == "r"


@pytest.mark.slow
@pytest.mark.parametrize("ends", ["free", "periodic"])
def test_a_clip_or_a_loop_may_begin_and_end_in_a_squat(ends):
    low = "root.position = [0, 0, 0.65]"
    keys = "".join(f"[[keyframe]]\ntime = {i}\n{body}\n" for i, body in enumerate((low, 'others = "rest"', low)))
    problem = read(f'figure = "human"\n[solve]\nends = "{ends}"\n{keys}')
    assert posed_feet(problem)[:: 1 if ends == "free" else 3] == (["lr", "", "lr"] if ends == "free" else ["lr"])
    for k in (0, 2):
        np.testing.assert_allclose(soles(problem, k), soles(problem, 1), atol=1e-6)


@pytest.mark.slow
def test_a_contact_specifies_the_position_of_a_foot_without_one_in_keyframes():
    places = {"left_heel": [0.1, 0.15, 0], "left_toe": [0.325, 0.15, 0]}
    text = REST + "[[keyframe]]\ntime = 1\nroot.position = [0, 0, 0.8]\n[[keyframe]]\ntime = 2\n"
    for point, place in places.items():
        text += f'[[contact]]\npoint = "{point}"\nfrom = 0.5\nto = 1.5\nposition = {place}\n'
    problem = read(text)
    names = [point.name for point in problem.context.points]
    for point, place in places.items():
        np.testing.assert_allclose(soles(problem, 1)[names.index(point)], place, atol=2e-3)
