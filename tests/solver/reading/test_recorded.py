"""Recorded: the smoothing spline by dense least squares, noise as large as it was made, gaps, signs and outliers."""

import numpy as np
import pytest

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.reading.recorded import LIVELINESS, Recorded

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
    recorded = Recorded.of(figure, TIMES, swung(figure, rng, 0.01))
    h = TIMES[1] - TIMES[0]
    second = (np.eye(TIMES.size)[:-2] - 2 * np.eye(TIMES.size)[1:-1] + np.eye(TIMES.size)[2:]) / h**2
    for columns in recorded.groups:
        first = columns[0]
        weight = recorded.trust[:, first] / recorded.noise[first] ** 2
        matrix = np.diag(weight) + h * second.T @ second / recorded.liveliness[first]
        wanted = np.linalg.solve(matrix, weight[:, None] * recorded.states[:, columns])
        np.testing.assert_allclose(recorded.bridged[:, columns], wanted, atol=2e-3)
        assert np.isclose(LIVELINESS, recorded.liveliness[first]).any()


def test_the_noise_is_as_large_as_it_was_made(figure, rng):
    for noise in (0.02, 0.04):
        found = Recorded.of(figure, TIMES, swung(figure, rng, noise))
        assert 0.5 * noise < np.median(found.noise) < 1.3 * noise  # quaternions were longer than one
        clean = Recorded.of(figure, TIMES, swung(figure, np.random.default_rng(3)))
        assert np.median(clean.noise) < 0.4 * noise


def test_smoothing_brings_a_noisy_motion_nearer_to_the_true_one(figure):
    true = Recorded.of(figure, TIMES, swung(figure, np.random.default_rng(5)))
    rng = np.random.default_rng(5)
    noisy = Recorded.of(figure, TIMES, swung(figure, rng, 0.03))
    same = np.where(np.sum(true.states * noisy.states, axis=0) < 0, -1, 1)
    before, after = (np.linalg.norm(same * states - true.states) for states in (noisy.states, noisy.bridged))
    assert after < 0.6 * before


def test_what_comes_with_either_sign_is_the_same_curve(figure):
    one, other = (Recorded.of(figure, TIMES, swung(figure, np.random.default_rng(s))) for s in (7, 7))
    flipped = np.array(other.figure.to_qpos(other.states))
    again = Recorded.of(figure, TIMES, flipped)
    np.testing.assert_allclose(np.abs(again.bridged), np.abs(one.bridged), atol=1e-9)
    assert np.all(np.abs(np.diff(again.states, axis=0)) < 0.3)


def test_a_gap_is_bridged_and_what_is_in_it_does_not_matter(figure, rng):
    qpos = swung(figure, rng)
    known = np.ones((TIMES.size, 1))
    known[80:90] = 0
    whole = Recorded.of(figure, TIMES, qpos)
    holes = Recorded(figure, TIMES, np.where(known > 0, whole.states, 7.0), known * np.ones_like(whole.states))
    np.testing.assert_allclose(holes.bridged, whole.bridged, atol=0.03)
    assert np.all(holes.trust[80:90] == 0)


def test_a_sample_that_is_far_off_is_hardly_believed(figure, rng):
    qpos = swung(figure, rng, 0.005)
    recorded = Recorded.of(figure, TIMES, qpos)
    states = recorded.states.copy()
    states[60] += 0.5
    odd = Recorded(figure, TIMES, states, np.ones_like(states))
    assert odd.trust[60].max() < 0.2
    assert np.median(odd.trust) == 1
    np.testing.assert_allclose(odd.bridged[60], recorded.bridged[60], atol=0.05)


def test_a_joint_that_was_recorded_nowhere_is_no_recording(figure):
    states = figure.to_state(np.tile(figure.model.qpos0, (TIMES.size, 1)))
    with pytest.raises(ValueError, match="without two samples"):
        _ = Recorded(figure, TIMES, states, 0 * states).bridged
