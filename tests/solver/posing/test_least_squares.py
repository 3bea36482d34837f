"""Damped least squares: SciPy finds no less, with bounds or without, and many poses are solved like one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares, lsq_linear

from dynsplines.solver.posing import LeastSquares, Residuals


def moved(poses, step):
    return poses + step


def linear(rows, wanted, two_sided, steps=200):
    """|rows x - wanted|², of which all after the first `two_sided` residuals are one-sided."""

    def residuals(poses, which):
        return Residuals(poses @ rows.T - wanted, np.broadcast_to(rows, (len(poses), *rows.shape)), two_sided)

    return LeastSquares(residuals, moved, np.ones(rows.shape[1]), steps)


@pytest.mark.parametrize("size", [1.0, 1e5])  # the larger by an orthogonal factorisation
def test_a_linear_problem_is_solved_as_scipy_solves_it(size, rng):
    rows, wanted = rng.normal(size=(9, 5)), rng.normal(size=9)
    rows[:4] *= size
    wanted[:4] *= size
    poses, costs = linear(rows, wanted, 9).descended(np.zeros((1, 5)))
    expected = lsq_linear(rows, wanted)
    np.testing.assert_allclose(poses[0], expected.x, rtol=1e-6, atol=1e-9)
    assert costs[0] == pytest.approx(2 * expected.cost)


def test_stiff_one_sided_residuals_are_bounds(rng):
    """The solution is SciPy's with the same bounds, but for the little by which a spring yields."""
    for _ in range(20):
        rows, wanted = rng.normal(size=(8, 4)), 3 * rng.normal(size=8)
        stiff = 1e4 * np.concatenate([np.eye(4), -np.eye(4)])
        both = np.concatenate([rows, stiff]), np.append(wanted, 0.3e4 * np.ones(8))
        poses, _ = linear(*both, 8).descended(np.zeros((1, 4)))
        np.testing.assert_allclose(poses[0], lsq_linear(rows, wanted, bounds=(-0.3, 0.3)).x, atol=1e-5)


@given(st.integers(0, 10_000))
@settings(max_examples=30, deadline=None)
def test_curved_residuals_are_minimised_as_by_scipy(seed):
    """Rosenbrock's valley and its mirror images, from random poses, all at once; each costs no more than alone."""
    begin = np.random.default_rng(seed).uniform(-2, 2, (5, 2))

    def values(x, scale):
        return np.stack([scale * (x[..., 1] - x[..., 0] ** 2), 1 - x[..., 0]], axis=-1)

    scales = np.array([1.0, 10, -10, 3, 30])

    def residuals(poses, which):
        rows = np.zeros((len(poses), 2, 2))
        rows[:, 0, 0], rows[:, 0, 1], rows[:, 1, 0] = -2 * scales[which] * poses[:, 0], scales[which], -1
        return Residuals(values(poses, scales[which]), rows, 2)

    poses, costs = LeastSquares(residuals, moved, np.ones(2), 300, longest=0.5).descended(begin)
    for start, pose, cost, scale in zip(begin, poses, costs, scales, strict=True):
        expected = least_squares(values, start, args=(scale,))
        assert cost <= 2 * expected.cost + 1e-12
        np.testing.assert_allclose(pose, expected.x, atol=1e-5)


def test_nothing_to_move_stays(rng):
    poses, costs = LeastSquares(
        lambda poses, which: Residuals(np.ones((len(poses), 1)), np.zeros((len(poses), 1, 3)), 1),
        moved, np.ones(3), 10,
    ).descended(np.ones((4, 3)))  # fmt: skip
    np.testing.assert_array_equal(poses, np.ones((4, 3)))
    np.testing.assert_array_equal(costs, 1)
