"""Loops whose root travels: C² across the seam for every x, shortest arcs of joints, and what a period carries on."""

from __future__ import annotations

import numpy as np
import pytest
from even_frames import evenly
from figures import TINY, figure_of
from hopping_loop import PERIOD, STRIDE, hop, loop, pose
from random_keys import mask_without

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns, raw_timeline


@pytest.mark.parametrize("turns", [0, 1])
@pytest.mark.parametrize("partial", [False, True])
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_travelling_loop_is_smooth_across_its_seam_for_every_x(rng, coordinates, partial, turns):
    figure = figure_of(TINY, coordinates)
    timeline = evenly(loop(figure, turns, partial=partial), 1)
    unknowns = Unknowns.of(figure, timeline)
    for x in (unknowns.start, unknowns.start + 0.1 * rng.normal(size=unknowns.size)):
        moved = timeline.with_rows(unknowns.rows(x))
        seam = Seam.of(figure, moved)
        np.testing.assert_allclose(seam.travel, STRIDE * np.eye(figure.width)[0], atol=1e-12)
        assert (seam.signs[3:7] < 0).all() == (turns == 1)
        assert seam.discontinuity(path_of(moved)).max() < 1e-9
        ends = np.array([0.0, PERIOD])
        y, y_d, y_dd = (path_of(moved).at(ends, order) for order in range(3))
        np.testing.assert_allclose(y[1] - y[0] * seam.signs, seam.travel, atol=1e-9)
        np.testing.assert_allclose(y_d[1], y_d[0] * seam.signs, atol=1e-9)
        np.testing.assert_allclose(y_dd[1], y_dd[0] * seam.signs, atol=1e-9)


def test_a_discontinuity_is_the_largest_jump_of_each_derivative():
    figure = figure_of(TINY)
    first, slope = np.array(figure.model.qpos0), np.array([[0, 1, 0], [0, 4, 0]]) @ np.eye(3, figure.width)
    path = path_of(raw_timeline(figure, [Frame.key(t, first) for t in (0.0, 0.5, 1.0)], "clamped", slope))
    seam = Seam.between(figure, first, first)
    np.testing.assert_allclose(seam.discontinuity(path), [0, 3, np.ptp(path.at([0.0, 1.0], 2)[:, 1])], atol=1e-12)


@pytest.mark.parametrize("free", [(), ("root x",), ("root x", "root y", "root z")])
def test_travel_given_is_met_whatever_the_ends_leave_free(rng, free):
    figure = figure_of(TINY)
    keys = hop()
    climb = pose(PERIOD) + 0.1 * np.eye(figure.width)[2]
    keys[-1] = Frame.key(PERIOD, climb, mask_without(figure, *free))
    timeline = raw_timeline(figure, keys, "periodic", travel=[STRIDE, 0, 0.1])
    unknowns = Unknowns.of(figure, evenly(timeline, 1))
    rows = unknowns.rows(rng.normal(size=unknowns.size))
    np.testing.assert_allclose(rows[-3, :3] - rows[0, :3], [STRIDE, 0, 0.1], atol=1e-12)
    np.testing.assert_allclose(rows[0, :3], pose(0)[:3], atol=1e-12)
    np.testing.assert_allclose(figure.to_qpos(rows[-3])[:3], climb[:3], atol=1e-12)


@pytest.mark.parametrize("partial", [False, True])
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_joints_turn_by_the_shortest_arcs_up_to_the_seam_though_the_whole_figure_nearly_turns_round(
    coordinates, partial
):
    figure = figure_of(TINY, coordinates)
    keys = []
    for time, heading, knee in ((0.0, 0, 0), (0.3, 120, -20), (0.5, 195, -40), (PERIOD, 360, 0)):
        root, shin = (quat.from_rotation_vector(np.radians([0, 0, angle])) for angle in (heading, knee))
        fixed = mask_without(figure, "knee") if partial and time in (0, PERIOD) else np.ones(figure.width, bool)
        keys.append(Frame.key(time, np.concatenate([[0, 0, 1], root, shin]), fixed))
    states = raw_timeline(figure, keys, "periodic").states
    root, shin = states[:, 3:7], states[:, 7:11]
    if coordinates == "world":
        shin = quat.product(quat.inverse(quat.product(root, figure.links[2].turn)), shin)
    assert np.all(np.sum(shin[1:] * shin[:-1], axis=1) > 0)
    np.testing.assert_allclose(root[-1], -root[0], atol=1e-12)


@pytest.mark.parametrize("turn", [0.0, 0.9])
def test_a_period_is_one_by_default_and_takes_what_hangs_from_the_root_with_it(turn, rng):
    figure = figure_of(TINY, "world")
    first = figure.to_state(pose(0.0))
    about = quat.from_rotation_vector(np.array([0, 0, turn]))
    last = np.array(first)
    last[:3] = quat.rotated(about, first[:3]) + np.array([0.5, -0.1, 0])
    last[3:7], last[7:] = quat.product(about, first[3:7]), quat.product(about, first[7:])
    seam = Seam.between(figure, first, last)
    np.testing.assert_allclose(seam.moved(first), last, atol=1e-12)
    np.testing.assert_allclose(seam.turn(), about, atol=1e-12)
    np.testing.assert_allclose(seam.turn(-1), quat.inverse(about), atol=1e-12)
    states = rng.normal(size=(4, figure.width))
    np.testing.assert_allclose(states @ seam.matrix().T, seam.linear(states), atol=1e-12)
    np.testing.assert_allclose(seam.linear(seam.linear(states)), seam.linear(states, 2), atol=1e-12)
    points = rng.normal(size=(4, 3))
    expected = quat.rotated(about, points) + np.array([0.5, -0.1, 0])
    np.testing.assert_allclose(seam.moved_points(figure, points), expected, atol=1e-12)
    back = seam.moved_points(figure, expected, -1)
    np.testing.assert_allclose(back, points, atol=1e-12)


def test_of_two_free_bodies_the_first_says_how_points_are_carried_and_by_how_much_a_period_turns(rng):
    one = '<body><freejoint/><geom size=".1"/></body>'
    figure = figure_of(f"<mujoco><worldbody>{one}{one}</worldbody></mujoco>")
    abouts = [quat.from_rotation_vector(np.array([0, 0, angle])) for angle in (0.4, -0.7)]
    first = np.array([1.0, 2, 3, 1, 0, 0, 0, -1, 0, 2, 1, 0, 0, 0])
    last = np.concatenate(
        [[*(quat.rotated(about, first[i : i + 3]) + i + 1), *about] for about, i in zip(abouts, (0, 7), strict=True)]
    )
    seam = Seam.between(figure, first, last)
    np.testing.assert_allclose(seam.turn(), abouts[0], atol=1e-12)
    points = rng.normal(size=(5, 3))
    np.testing.assert_allclose(seam.moved_points(figure, points), quat.rotated(abouts[0], points) + 1, atol=1e-12)


def test_a_loop_of_a_figure_without_a_free_body_carries_no_point_and_turns_nothing(rng):
    figure = figure_of('<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>')
    seam = Seam.between(figure, np.array([1.0, 0, 0, 0]), np.array([1.0, 0, 0, 0]))
    points = rng.normal(size=(5, 3))
    np.testing.assert_array_equal(seam.moved_points(figure, points), points)
    np.testing.assert_array_equal(seam.turn(3), [1, 0, 0, 0])
    assert not seam.turns
