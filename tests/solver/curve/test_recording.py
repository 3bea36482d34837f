"""Recorded: the smoothing spline by dense least squares, noise as large as it was made, gaps, signs and outliers."""

import numpy as np
import pytest
from figures import TINY, figure_of
from scipy.spatial.transform import Rotation

from dynsplines.solver.curve.recording import LIVELINESS, Track, between
from dynsplines.solver.figure.figure import Figure

TIMES = np.linspace(0.3, 3.3, 181)


def swung(figure: Figure, rng: np.random.Generator, noise: float = 0.0) -> np.ndarray:
    """qpos (T, nq) of slow swings in every entry, quaternions of any sign."""
    phase = rng.uniform(0, 6, figure.width)
    qpos = figure.model.qpos0 + 0.2 * np.sin(2 * TIMES[:, None] + phase)
    qpos += rng.normal(0, noise, qpos.shape) if noise else 0
    for joint in range(figure.model.njnt):
        first, kind = int(figure.model.jnt_qposadr[joint]), int(figure.model.jnt_type[joint])
        if kind in (0, 1):
            at = first + (3 if kind == 0 else 0)
            qpos[:, at : at + 4] /= np.linalg.norm(qpos[:, at : at + 4], axis=1, keepdims=True)
            qpos[:, at : at + 4] *= rng.choice([-1, 1], (TIMES.size, 1))
    return qpos


def test_the_curve_is_the_least_squares_solution(figure, rng):
    recorded = Track.of(figure, TIMES, swung(figure, rng, 0.01))
    h = TIMES[1] - TIMES[0]
    second = (np.eye(TIMES.size)[:-2] - 2 * np.eye(TIMES.size)[1:-1] + np.eye(TIMES.size)[2:]) / h**2
    for columns in recorded.groups:
        first = columns[0]
        weight = recorded.trust[:, first] / recorded.noise[first] ** 2
        matrix = np.diag(weight) + h * second.T @ second / recorded.liveliness[first]
        wanted = np.linalg.solve(matrix, weight[:, None] * recorded.states[:, columns])
        np.testing.assert_allclose(recorded.bridged[:, columns], wanted, atol=2e-3)
        assert np.isclose(LIVELINESS, recorded.liveliness[first]).any()


def test_a_gap_is_bridged_and_what_is_in_it_does_not_matter(figure, rng):
    qpos = swung(figure, rng)
    known = np.ones((TIMES.size, 1))
    known[80:90] = 0
    whole = Track.of(figure, TIMES, qpos)
    holes = Track(figure, TIMES, np.where(known > 0, whole.states, 7.0), known * np.ones_like(whole.states))
    np.testing.assert_allclose(holes.bridged, whole.bridged, atol=0.03)
    assert np.all(holes.trust[80:90] == 0)


def test_a_sample_that_is_far_off_is_hardly_believed(figure, rng):
    qpos = swung(figure, rng, 0.005)
    recorded = Track.of(figure, TIMES, qpos)
    states = recorded.states.copy()
    states[60] += 0.5
    odd = Track(figure, TIMES, states, np.ones_like(states))
    assert odd.trust[60].max() < 0.2
    assert np.median(odd.trust) == 1
    np.testing.assert_allclose(odd.bridged[60], recorded.bridged[60], atol=0.05)


def test_a_joint_that_was_recorded_nowhere_is_no_recording(figure):
    states = figure.to_state(np.tile(figure.model.qpos0, (TIMES.size, 1)))
    with pytest.raises(ValueError, match="without two samples"):
        _ = Track(figure, TIMES, states, 0 * states).bridged


def test_a_recording_bent_by_its_way_to_another_is_that_and_goes_there_by_even_turns(figure, rng):
    """In what is known; half of the way is half of the turn, by SciPy's rotations."""
    one, other = (Track.of(figure, TIMES, swung(figure, rng)) for _ in range(2))
    known = np.ones(one.states.shape, bool)
    ways = between(figure, one.states, other.states, known)
    quaternions = figure.tables.quaternion_columns.T
    for share in (1.0, 0.5):
        bent = one.displace(share * ways).states
        for columns in quaternions:
            start, end, found = (
                Rotation.from_quat(np.roll(states[:, columns], -1, axis=1))
                for states in (one.states, other.states, bent)
            )
            wanted = start * Rotation.from_rotvec(share * (start.inv() * end).as_rotvec())
            assert (wanted.inv() * found).magnitude().max() < 1e-7
        rest = np.setdiff1d(np.arange(figure.width), np.concatenate([*quaternions, np.zeros(0, int)]).astype(int))
        wanted = one.states + share * (other.states - one.states)
        np.testing.assert_allclose(bent[:, rest], wanted[:, rest], atol=1e-12)
    nothing = between(figure, one.states, other.states, ~known)
    np.testing.assert_allclose(one.displace(nothing).states, one.states, atol=1e-12)


def test_what_fills_a_gap_turns_no_sign_about():
    """A root that walks back, about half a turn from what fills the gap."""
    figure = figure_of(TINY)
    times, half = np.linspace(0, 2, 41), np.radians(90 + np.linspace(-4, 4, 41))
    qpos = np.tile(figure.model.qpos0, (41, 1))
    qpos[:, 3:7] = np.column_stack([np.cos(half), 0 * half, 0 * half, np.sin(half)])
    known = np.ones((41, 1))
    known[15:26] = 0
    filled = np.where(known > 0, qpos, figure.model.qpos0)
    whole, torn = (Track.of(figure, times, rows, gaps) for rows, gaps in ((qpos, None), (filled, known)))
    seen = known[:, 0] > 0
    np.testing.assert_allclose(torn.states[seen], whole.states[seen], rtol=0, atol=1e-12)
    np.testing.assert_allclose(torn.bridged, whole.bridged, rtol=0, atol=0.05)
