"""Shortest arcs and spins between keyframes, all choices tried by hand, and SciPy's SLERP for every joint."""

import itertools

import numpy as np
import pytest
from even_frames import evenly
from figures import BALL, figure_of
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from oracles import aligned, by_scipy
from random_keys import TIMES, closed, distance_from_key, partial_keys, random_keys
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.curve.arcs import straight, straightened
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.curve.winding import NEARLY_HALF, signs
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.refine.subdivision import split


def turned_by(angles: list[float], axis: tuple[float, float, float] = (0, 0, 1)) -> np.ndarray:
    """(K, 4) a body turned to these angles [degrees] about an axis, all on one half of the quaternions."""
    q = quat.from_rotation_vector(np.radians(angles)[:, None] * np.array(axis))
    return q * np.where(q[:, :1] < 0, -1, 1)


def arcs(track: np.ndarray) -> np.ndarray:
    """The arcs [degrees] that a track of quaternions with signs turns by, up to 360."""
    return np.degrees(2 * np.arccos(np.clip(np.sum(track[1:] * track[:-1], axis=1), -1, 1)))


def wound(angles: list[float], *, spins: bool) -> np.ndarray:
    track = turned_by(angles)
    return arcs(track * signs(np.arange(len(angles), dtype=float), track, spins=spins)[:, None])


@pytest.mark.parametrize("spins", [False, True])
def test_arcs_under_150_degrees_are_the_shortest(spins):
    np.testing.assert_allclose(wound([0, 140, 0, -140, 70, 200], spins=spins), [140, 140, 140, 150, 130], atol=1e-4)


def test_a_spin_continues_past_a_half_turn():
    np.testing.assert_allclose(wound([0, 100, 287, 387], spins=True), [100, 187, 100], atol=1e-4)


def test_a_joint_does_not():
    np.testing.assert_allclose(wound([0, 100, 287, 387], spins=False), [100, 173, 100], atol=1e-4)
    np.testing.assert_allclose(wound([0, 0, 170, 0, 0], spins=False), [0, 170, 170, 0], atol=1e-4)


@pytest.mark.slow
@settings(deadline=None)
@given(st.lists(st.floats(-175, 175), min_size=2, max_size=6), st.integers(0, 100))
@example([0.0, 150.001, 11.0], 0)
def test_the_choice_is_the_best_of_all(turns, seed):
    rng = np.random.default_rng(seed)
    rotations = [Rotation.identity()]
    for turn in turns:
        axis = rng.normal(size=3)
        rotations.append(rotations[-1] * Rotation.from_rotvec(np.radians(turn) * axis / np.linalg.norm(axis)))
    track = np.array([np.roll(r.as_quat(), 1) for r in rotations])
    times = np.append(0, np.cumsum(rng.uniform(0.2, 2, len(turns))))
    steps = np.array([(a.inv() * b).as_rotvec() for a, b in itertools.pairwise(rotations)])
    angle = np.linalg.norm(steps, axis=1)
    assume(np.all(np.abs(angle - NEARLY_HALF) > 1e-9))  # on the bound itself rounding decides

    def cost(ways: tuple[bool, ...]) -> float:
        rates = [s * (1 - 2 * np.pi / a if w else 1) for s, a, w in zip(steps, angle, ways, strict=True)]
        rates = np.array(rates) / np.diff(times)[:, None]
        return float(np.sum(np.sum(np.diff(rates, axis=0) ** 2, axis=1) * 2 / (times[2:] - times[:-2])))

    choices = itertools.product(*[(False, True) if a > NEARLY_HALF else (False,) for a in angle])
    best = min(cost(ways) for ways in choices)
    chosen = arcs(track * signs(times, track, spins=True)[:, None]) > 180 + 1e-9
    assert cost(tuple(chosen)) <= best * (1 + 1e-9) + 1e-9


@pytest.mark.parametrize("turn", [120.0, 160.0, 178.0])
def test_a_limb_goes_with_a_body_that_turns_far(turn):
    """Root and hip turn the same way: the thigh turns by the sum in the world, not by the rest of the circle."""
    figure = figure_of(models.figure_text("human"))
    hip = next(link for link in figure.links if link.name == "left_hip")
    keys = []
    for i in range(2):
        qpos = np.array(figure.model.qpos0)
        qpos[3:7] = quat.from_rotation_vector(np.radians([0, 0, i * turn]))
        qpos[hip.qpos : hip.qpos + 4] = quat.from_rotation_vector(np.radians([0, 0, i * 100.0]))
        keys.append(Frame.key(float(i), qpos))
    states = raw_timeline(figure, keys).states
    np.testing.assert_allclose(arcs(states[:, hip.qpos : hip.qpos + 4]), [turn + 100], atol=1e-4)


GRID = np.linspace(TIMES[0], TIMES[-1], 53)


def apart(figure: Figure, a: Array, b: Array) -> float:
    """The largest entry by which configurations differ, quaternions up to their signs."""
    return float(np.abs(aligned(figure, a, b) - b).max())


def key_rows(timeline: Timeline) -> Index:
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
    found, told = straightened(figure, first), key_rows(first)
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
    found, first = straightened(figure, before), key_rows(before)[0]
    np.testing.assert_array_equal(found.rows[:first], before.rows[:first])
    assert not np.array_equal(found.rows[first:-2], before.rows[first:-2])
