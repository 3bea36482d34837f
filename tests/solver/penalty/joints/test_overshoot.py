"""Held joints: which keyframes hold, bounds against SciPy, gradients, and a spline that keeps to them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from figures import figure_of
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import (
    CovariantAcceleration,
    Holds,
    JointRange,
    OvershootPenalty,
    RootAcceleration,
    UnitMagnitude,
)
from dynsplines.solver.problem import Problem, Settings

HINGE = '<mujoco><worldbody><body><joint name="hinge"/><geom size=".1"/></body></worldbody></mujoco>'
CHAIN = """<mujoco><worldbody><body><freejoint name="root"/><geom size=".1"/>
<body pos="0 .2 0"><joint name="slide" type="slide"/><geom size=".1"/>
<body pos="0 .2 0"><joint name="hinge"/><geom size=".1"/>
<body pos="0 .2 0" quat=".8 .1 .5 0"><joint name="ball" type="ball"/><geom size=".1"/></body></body></body></body>
</worldbody></mujoco>"""


def hinged(times: Sequence[float], degrees: Sequence[float], ends: str = "free") -> tuple[Figure, Timeline]:
    """A hinge through keyframes."""
    figure = figure_of(HINGE)
    keys = [Frame.key(t, [np.radians(angle)]) for t, angle in zip(times, degrees, strict=True)]
    return figure, raw_timeline(figure, keys, ends)


def bounds(times: Sequence[float], degrees: Sequence[float], *, repeats: bool = False) -> dict[float, float]:
    """By how many degrees a hinge may leave its value, by the time at which each hold begins [s]."""
    figure, keys = hinged(times, degrees, "periodic" if repeats else "free")
    penalty = OvershootPenalty.of(figure, Holds.of(figure, keys, repeats=repeats), keys.times)
    joints = penalty.joints if penalty is not None else ()
    return {joint.first: round(float(np.degrees(joint.high - joint.low)) / 2, 9) for joint in joints}


def test_values_that_neighbouring_keyframes_share_are_held_tightly_where_the_raw_spline_swings() -> None:
    assert bounds([0, 1, 1.3, 2.3], [0, 0, 90, 90]) == {0: 1, 1.3: 1}
    assert bounds([0, 1, 2, 3], [0, 90, 90, 0]) == {1: 1}
    assert bounds([0, 1, 2, 3], [0, 5, 5, 0]) == {}  # by a degree
    assert bounds([0, 1, 2, 3], [40, 40, 40, 40]) == {}
    assert bounds([0, 0.1, 0.2, 0.3], [0, 90, 90, 0]) == {}  # passed in a tenth of a second
    assert bounds([0, 0.1, 0.3, 0.4], [0, 90, 90, 0]) == {0.1: 1}
    assert bounds([0, 0.125, 0.3125, 0.4375], [0, 90, 90, 0]) == {0.125: 1}  # exactly 1.5 times as long as the others


def test_turning_points_of_what_repeats_itself_are_no_holds() -> None:
    oscillation = [-30, 30, 30, -30, -30]
    assert bounds([0, 0.5, 1, 1.5, 2], oscillation, repeats=True) == {}
    assert bounds([0, 0.5, 1, 1.5, 2], oscillation) == {0.5: 1, 1.5: 1}
    assert bounds([0, 0.2, 1.2, 1.4, 2.4], [0, 90, 90, 0, 0], repeats=True) == {0.2: 1, 1.4: 1}  # long beside the rest
    assert bounds([0, 0.5, 1, 1.5, 2], [0, 0, 90, -90, 0], repeats=True) == {0.0: 1}  # no turning point: it goes on


FREE = '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>'


def test_the_height_of_a_root_is_not_held_in_a_flight() -> None:
    figure = figure_of(FREE)
    states = [[0, 0, z, 1, 0, 0, 0] for z in (0.5, 1, 1, 0.5)]
    keys = raw_timeline(figure, [Frame.key(t, state) for t, state in enumerate(states)])
    held = [joint for joint in Holds.of(figure, keys).swinging if joint.home is None]
    assert {joint.column for joint in held if joint.first == 1.0} == {0, 1, 2}
    assert Holds.of(figure, keys, aloft=[(1.0, 2.0)]).swinging == ()


@pytest.mark.parametrize("degrees", [0.2, 12.0, 19.0, 21.0])
def test_a_root_of_similar_rotations_has_a_range_around_their_middle(degrees: float) -> None:
    figure, axis = figure_of(FREE), np.array([0.6, 0, 0.8])
    rotations = [Rotation.from_rotvec(angle * axis, degrees=True) for angle in (30.0, 30 + degrees)]
    states = [[0, 0, 1, *rotation.as_quat(scalar_first=True)] for rotation in rotations]
    keys = raw_timeline(figure, [Frame.key(t, state) for t, state in enumerate(states)])
    turns = tuple(joint for joint in Holds.of(figure, keys).roots if joint.home is not None)
    if degrees > 20:
        assert not turns
        return
    samples = Samples.still(figure, figure.to_state(np.array(states)), t=np.array([0.0, 1.0]))
    np.testing.assert_allclose(JointRange(turns).beyond(samples), 0, atol=1e-6)
    assert np.degrees(turns[0].high) == pytest.approx(degrees / 2)


def test_a_root_has_a_range_around_its_two_positions_except_in_flights() -> None:
    figure = figure_of(FREE)
    states = [[x, y, 1, 1, 0, 0, 0] for x, y in ((0, 0), (0.3, -0.4), (0.3, 0.6))]
    keys = raw_timeline(figure, [Frame.key(t, state) for t, state in zip((0.0, 0.25, 1.25), states, strict=True)])
    ranges = [joint for joint in Holds.of(figure, keys, aloft=[(0.3, 0.5)]).roots if joint.home is None]
    bounds_of = {(joint.first, joint.column): (joint.low, joint.high) for joint in ranges}
    assert bounds_of.keys() == {(0.0, 0), (0.0, 1)}
    np.testing.assert_allclose(bounds_of[0.0, 0], (-0.05, 0.35), atol=1e-9)
    np.testing.assert_allclose(bounds_of[0.0, 1], (-0.45, 0.05), atol=1e-9)
    assert {joint.home is None for joint in Holds.of(figure, keys, grasped=[1]).roots} == {False}


def turned_off(home: Array, qpos: Array) -> Array:
    """(T,) [rad] how far quaternions (T, 4) are from one."""
    rotations = Rotation.from_quat(home, scalar_first=True).inv() * Rotation.from_quat(qpos, scalar_first=True)
    return np.asarray(rotations.magnitude())


def swings(first: Array, last: Array) -> tuple[Array, Array]:
    """How far a chain of every joint leaves two values (nq,) that are held for a second, 0.3 s apart: the root's place,
    slide [m], hinge, ball and the root's rotation [rad]; of the raw spline, and with the holds."""
    figure = figure_of(CHAIN)
    keys = [Frame.key(t, q) for t, q in zip((0, 1, 1.3, 2.3), (first, first, last, last), strict=True)]
    raw = raw_timeline(figure, keys)
    held = OvershootPenalty.of(figure, Holds.of(figure, raw), raw.times)
    assert held is not None
    motion = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0)]
    solution = inbetween(Problem(figure, keys, [*motion, (held, 10.0)], Settings(frames=20, tolerance=1e-3)))

    def off(timeline: Timeline) -> Array:
        out = np.zeros(5)
        for home, times in ((first, np.linspace(0, 1, 200)), (last, np.linspace(1.3, 2.3, 200))):
            qpos = figure.to_qpos(path_of(timeline).at(times))
            apart = qpos - home
            rows = [np.linalg.norm(apart[:, :3], axis=1), np.abs(apart[:, 7]), np.abs(apart[:, 8])]
            rows += [turned_off(home[some], qpos[:, some]) for some in (slice(9, 13), slice(3, 7))]
            out = np.maximum(out, np.max(rows, axis=1))
        return out

    return off(raw), off(solution.timeline)


def test_slides_hinges_balls_and_the_root_are_held_alike() -> None:
    first = np.array([0, 0, 1, 1, 0, 0, 0, 0, 0, 1.0, 0, 0, 0])
    turned = Rotation.from_rotvec([0, 1.7, 0]).as_quat(scalar_first=True)
    last = np.array([0.8, 0, 1, *turned, 0.6, 1.9, *Rotation.from_rotvec([1.2, 0, 0.9]).as_quat(scalar_first=True)])
    raw, held = swings(first, last)
    assert np.all(raw > [0.2, 0.15, 0.5, 0.3, 0.4])
    assert np.all(held < [0.025, 0.025, 0.06, 0.06, 0.06])
