"""Loops that turn: C² across the seam for every x, exact gradients, and the middle of many periods on a circle."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, TINY, figure_of
from gradients import SMOOTH, assert_dense, smooth_problem
from oracles import aligned, kinematics
from problems import HOP_TERMS as TERMS
from problems import PERIOD, TIMES, assert_exact_gradient, assert_splits_keep_the_curve
from problems import pose as straight
from random_models import evenly, mask_without

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns, raw_timeline
from dynsplines.solver.edit.retime import repeated, retimed
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Problem, Settings

TURN = np.radians(50)  # a period, about a centre 0.7 m to the left
CENTRE = np.array([0.1, 0.7, 0.0])
UP = np.array([0.0, 0.0, 1.0])


def turned(qpos: Array, angle: float) -> Array:
    """A configuration turned about the vertical through the centre."""
    out, turn = qpos.copy(), quat.from_rotation_vector(angle * UP)
    out[:3] = CENTRE + quat.rotated(turn, qpos[:3] - CENTRE)
    out[3:7] = quat.product(turn, qpos[3:7])
    return out


def pose(time: float) -> Array:
    """qpos of the body that hops, its shin swinging, round a circle."""
    still = straight(time)
    still[0] -= 0.6 * time / PERIOD
    return turned(still, TURN * time / PERIOD)


def circle(periods: int = 1) -> list[Frame]:
    """Keyframes of some periods."""
    return [Frame.key(t, pose(t)) for t in [0.0] + [t + PERIOD * k for k in range(periods) for t in TIMES[1:]]]


def loop(figure: Figure, *, partial: bool = False) -> Timeline:
    keys = circle()
    if partial:
        keys[1] = Frame.key(TIMES[1], keys[1].state, mask_without(figure, "root turn", "root x"))
        keys[-1] = Frame.key(PERIOD, keys[-1].state, mask_without(figure, "root z", "knee"))
    return raw_timeline(figure, keys, "periodic")


@pytest.mark.parametrize("partial", [False, True])
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_turning_loop_is_smooth_across_its_seam_for_every_x(rng, coordinates, partial):
    figure = figure_of(TINY, coordinates)
    timeline = evenly(loop(figure, partial=partial), 1)
    unknowns = Unknowns.of(figure, timeline)
    np.testing.assert_allclose(unknowns.rows(unknowns.start), timeline.rows, atol=1e-11)
    for x in (unknowns.start, unknowns.start + 0.1 * rng.normal(size=unknowns.size)):
        moved = timeline.with_rows(unknowns.rows(x))
        path, seam = path_of(moved), Seam.of(figure, moved)
        np.testing.assert_allclose(seam.headings, TURN, atol=1e-12)
        assert seam.discontinuity(path).max() < 1e-9
        # by another way than the seam's own: velocities in the world turn with the figure
        (y, y_end), (v, v_end), (a, a_end) = (path.at([0.0, PERIOD], order) for order in range(3))
        turn = quat.from_rotation_vector(TURN * UP)
        np.testing.assert_allclose(y_end[:3], CENTRE + quat.rotated(turn, y[:3] - CENTRE), atol=1e-9)
        for end, start in ((v_end, v), (a_end, a)):
            np.testing.assert_allclose(end[:3], quat.rotated(turn, start[:3]), atol=1e-9)
            np.testing.assert_allclose(end[3:7], quat.product(turn, start[3:7]), atol=1e-9)
            knee = quat.product(turn, start[7:]) if coordinates == "world" else start[7:]
            np.testing.assert_allclose(end[7:], knee, atol=1e-9)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_the_gradient_through_a_turning_seam_is_exact(rng, coordinates):
    figure = figure_of(TINY, coordinates)
    assert_exact_gradient(loop(figure, partial=True), figure, rng)


@pytest.mark.parametrize("partial", [False, True])
def test_the_step_of_the_search_is_the_dense_gauss_newton_step(rng, partial):
    figure = figure_of(TINY)
    problem, x = smooth_problem(loop(figure, partial=partial), figure, rng)
    assert_dense(problem, SMOOTH, x, rtol=1e-3)


def test_frames_inserted_into_a_turning_loop_leave_its_curve():
    assert_splits_keep_the_curve(loop(figure_of(TINY)))


@pytest.mark.slow
def test_a_turning_loop_is_the_middle_of_the_same_motion_round_many_periods():
    figure = figure_of(TINY)
    settings = Settings(variable=2, frames=0, tolerance=1e-12, renormalise=False)
    found = inbetween(Problem(figure, circle(), TERMS, settings, ends="periodic"))
    t = np.linspace(0, PERIOD, 40)
    errors = []
    for periods in (3, 7):
        middle = periods // 2
        run = inbetween(Problem(figure, circle(periods), TERMS, settings)).at(t + PERIOD * middle)
        wanted = np.array([turned(qpos, TURN * middle) for qpos in found.at(t)])
        errors.append(np.abs(aligned(figure, run, wanted) - wanted).max())
    assert errors[0] < 5e-3
    assert errors[1] < 1e-5  # what the ends do fades


@pytest.mark.parametrize("periods", [-2, 3, 8])
def test_some_periods_later_all_bodies_stand_turned_about_the_centre(periods):
    """Eight periods of 50 degrees are more than a full turn. MuJoCo says where the bodies are."""
    figure = figure_of(TINY)
    timeline = loop(figure)
    moved = figure.to_qpos(Seam.of(figure, timeline).moved(timeline.states[1], periods))
    seen = [kinematics(figure.model, qpos) for qpos in (moved, timeline_qpos(figure))]
    later, now = (data.xpos[1:] for data in seen)
    later_axes, axes = (data.xmat[1:].reshape(-1, 3, 3) for data in seen)
    turn = quat.from_rotation_vector(periods * TURN * UP)
    np.testing.assert_allclose(later, CENTRE + quat.rotated(turn, now - CENTRE), atol=1e-9)
    matrix = np.stack([quat.rotated(turn, e) for e in np.eye(3)], axis=1)
    np.testing.assert_allclose(later_axes, matrix @ axes, atol=1e-9)


def timeline_qpos(figure: Figure) -> Array:
    return figure.to_qpos(loop(figure).states[1])


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_turning_loop_played_three_times_is_its_own_curve_turned_on(coordinates):
    figure = figure_of(TINY, coordinates)
    timeline = evenly(loop(figure), 1)
    many = repeated(figure, timeline, 3)
    t = np.linspace(0, PERIOD, 30)
    seam = Seam.of(figure, timeline)
    for number in range(3):
        at = path_of(many).at(t + number * PERIOD)
        np.testing.assert_allclose(at, seam.moved(path_of(timeline).at(t), number), atol=1e-9)
    assert Seam.of(figure, many).discontinuity(path_of(many)).max() < 1e-8
    fast = retimed(timeline, 2.0)
    assert Seam.of(figure, fast).discontinuity(path_of(fast)).max() < 1e-8


def test_the_mirror_image_of_a_turning_loop_turns_the_other_way():
    figure = figure_of(BALL)
    raw = raw_timeline(figure, [Frame.key(key.time, key.state[:7]) for key in circle()], "periodic")
    mirrored = Mirror.of(figure).timeline(evenly(raw, 1))
    seam = Seam.of(figure, mirrored)
    np.testing.assert_allclose(seam.headings, -TURN, atol=1e-12)
    assert seam.discontinuity(path_of(mirrored)).max() < 1e-9


def test_a_turn_given_is_met_where_the_last_keyframe_leaves_the_rotation_free(rng):
    figure = figure_of(TINY)
    keys = circle()
    keys[-1] = Frame.key(PERIOD, 0 * keys[-1].state + np.eye(11)[3] + np.eye(11)[7], np.zeros(11, bool))
    way = pose(PERIOD)[:3] - pose(0)[:3]
    timeline = raw_timeline(figure, keys, "periodic", travel=way, turn=TURN)
    unknowns = Unknowns.of(figure, evenly(timeline, 1))
    rows = unknowns.rows(rng.normal(size=unknowns.size))
    seam = Seam.between(figure, rows[0], rows[-3])
    np.testing.assert_allclose(seam.headings, TURN, atol=1e-12)
    np.testing.assert_allclose(seam.travel[:3], way, atol=1e-12)
    np.testing.assert_allclose(figure.to_qpos(rows[-3])[:3], pose(PERIOD)[:3], atol=1e-12)


def test_turns_that_make_no_sense_are_refused():
    figure, keys = figure_of(TINY), circle()
    with pytest.raises(TimelineError, match=r"a loop may travel, and turn about the vertical, here by 40 degrees"):
        raw_timeline(figure, keys, "periodic", turn=np.radians(40))
    with pytest.raises(TimelineError, match="turn is for ends = 'periodic', not 'free'"):
        raw_timeline(figure, keys, turn=TURN)
    loose = [
        Frame.key(key.time, key.state, mask_without(figure, "root y")) if key.time in (0, PERIOD) else key
        for key in keys
    ]
    with pytest.raises(TimelineError, match="a loop that turns needs x and y of 'root' in its first or its last"):
        raw_timeline(figure, loose, "periodic")
    ball = figure_of('<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>')
    still = [Frame.key(t, [1.0, 0, 0, 0]) for t in (0.0, 1.0)]
    with pytest.raises(TimelineError, match="no free joint, so no root to turn"):
        raw_timeline(ball, still, "periodic", turn=TURN)
