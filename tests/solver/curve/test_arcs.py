"""The straight way between keyframes: SciPy's SLERP for every joint, lines for positions, keyframes as they were."""

import numpy as np
import pytest
from even_frames import evenly
from figures import BALL, figure_of
from oracles import by_scipy
from random_keys import TIMES, closed, distance_from_key, partial_keys, random_keys

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.curve.arcs import straight, straightened
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.refine.subdivision import split

GRID = np.linspace(TIMES[0], TIMES[-1], 53)


def apart(figure: Figure, a: Array, b: Array) -> float:
    """The largest entry by which configurations differ, quaternions up to their signs."""
    a = a.copy()
    for columns in figure.tables.quaternion_columns.T:
        a[:, columns] *= np.sign(np.sum(a[:, columns] * b[:, columns], axis=1))[:, None]
    return float(np.abs(a - b).max())


def given(timeline: Timeline) -> Index:
    return np.flatnonzero(timeline.fixed.any(axis=1))


def test_joints_turn_by_slerp_in_their_parents_axes_and_all_else_goes_along_lines(figure, rng):
    raw = raw_timeline(figure, random_keys(figure, rng))
    ways = figure.to_qpos(straight(figure, raw.times, raw.states, GRID))
    expected = by_scipy(figure, raw.times, figure.to_qpos(raw.states), GRID)
    assert apart(figure, ways, expected) < 1e-12
    assert apart(figure, figure.to_qpos(path_of(raw).at(GRID)), expected) > 0.01


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_variable_frames_are_moved_and_what_keyframes_fix_stays_even_partly(figure, rng, ends):
    keys = partial_keys(figure, rng)
    keys = closed(keys) if ends == "periodic" else keys
    first = evenly(raw_timeline(figure, keys, ends, rng.normal(size=(2, figure.width))), 2)
    found, told = straightened(figure, first), given(first)
    assert told.size == len(keys)
    np.testing.assert_array_equal(found.rows[told], first.rows[told])
    np.testing.assert_array_equal(found.fixed, first.fixed)
    inner = np.setdiff1d(np.arange(len(first.frames)), told)
    expected = by_scipy(figure, first.times[told], figure.to_qpos(first.states[told]), first.times[inner])
    assert apart(figure, figure.to_qpos(found.states[inner]), expected) < 1e-12
    assert apart(figure, figure.to_qpos(first.states[inner]), expected) > 0.01
    for key, state in zip(keys, path_of(found).at(TIMES), strict=True):
        assert distance_from_key(figure, state, key) < 1e-11


def test_free_ends_start_along_the_path_and_clamped_ones_as_specified(figure, rng):
    keys, slope = random_keys(figure, rng), rng.normal(size=(2, figure.width))
    free = straightened(figure, evenly(raw_timeline(figure, keys), 1))
    t, states = free.times, free.states
    np.testing.assert_allclose(free.rows[-2], (states[1] - states[0]) / (t[1] - t[0]))
    np.testing.assert_allclose(free.rows[-1], (states[-1] - states[-2]) / (t[-1] - t[-2]))
    clamped = evenly(raw_timeline(figure, keys, "clamped", slope), 1)
    np.testing.assert_array_equal(straightened(figure, clamped).rows[-2:], clamped.rows[-2:])


def test_a_body_in_a_spin_goes_the_longer_way_round_where_its_signs_say_so():
    figure = figure_of(BALL)
    angles, times = np.array([0.0, 100, 300, 400]), np.arange(4.0)
    turns = quat.from_rotation_vector(np.radians(angles)[:, None] * [0.0, 0, 1])
    raw = raw_timeline(figure, [Frame.key(t, [0, 0, 1, *q]) for t, q in zip(times, turns, strict=True)])
    t = np.linspace(0, 3, 31)
    wanted = quat.from_rotation_vector(np.radians(np.interp(t, times, angles))[:, None] * [0.0, 0, 1])
    ways = straight(figure, raw.times, raw.states, t)[:, 3:]
    assert quat.angle_between(ways, wanted).max() < 1e-7
    backwards = straight(figure, raw.times, raw.states * np.array([[1], [1], [-1], [-1]]), t)[:, 3:]
    assert np.degrees(quat.angle_between(backwards, wanted)[15]) == pytest.approx(180, abs=1e-6)


def test_unspecified_entries_stay_unchanged(figure, rng):
    keys = random_keys(figure, rng)
    nothing = Frame.variable(-0.5, np.array(keys[0].state))
    alone = split(raw_timeline(figure, [nothing, keys[0]]), np.array([-0.2]))
    assert straightened(figure, alone) is alone
    before = evenly(raw_timeline(figure, [nothing, *keys]), 1)
    found, first = straightened(figure, before), given(before)[0]
    np.testing.assert_array_equal(found.rows[:first], before.rows[:first])
    assert not np.array_equal(found.rows[first:-2], before.rows[first:-2])
