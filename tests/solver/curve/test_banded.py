"""Banded Cholesky factors and solves, against dense matrices."""

import numpy as np
import pytest

from dynsplines.solver.curve import banded

SHAPES = [(1, 1), (6, 1), (9, 3), (20, 7), (5, 5), (4, 6)]  # the last: wider than the matrix is high


def positive(rng: np.random.Generator, n: int, width: int) -> np.ndarray:
    """A dense symmetric positive definite matrix with `width` − 1 diagonals below the main one."""
    lower = np.tril(np.triu(rng.normal(size=(n, n)), 1 - width))
    return lower @ lower.T + 0.5 * np.eye(n)


def stored(dense: np.ndarray, width: int) -> np.ndarray:
    """Row i: the entries of column i from the diagonal down; rubbish where the matrix has ended."""
    n = len(dense)
    band = np.full((n, width), 1e6)
    for column in range(n):
        for k in range(min(width, n - column)):
            band[column, k] = dense[column + k, column]
    return band


@pytest.mark.parametrize(("n", "width"), SHAPES)
@pytest.mark.parametrize("sides", [1, 3])
def test_solves_are_those_with_the_dense_matrix_and_its_two_halves(rng, n, width, sides):
    dense = positive(rng, n, width)
    right = rng.normal(size=(n, sides))
    kept = right.copy()
    factor, half = banded.factored(stored(dense, width)), np.linalg.cholesky(dense)
    assert factor is not None
    np.testing.assert_allclose(banded.solved(factor, right), np.linalg.solve(dense, right), rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(banded.half_solved(factor, right), np.linalg.solve(half, right), rtol=1e-8, atol=1e-10)
    other = banded.other_half_solved(factor, right)
    np.testing.assert_allclose(other, np.linalg.solve(half.T, right), rtol=1e-8, atol=1e-10)
    np.testing.assert_array_equal(right, kept)


@pytest.mark.parametrize("at", [0, 4, 8])
def test_a_matrix_that_is_not_positive_has_no_factor(rng, at):
    dense = positive(rng, 9, 3)
    dense[at, at] = -1.0
    assert banded.factored(stored(dense, 3)) is None
    assert banded.factored(stored(np.zeros((9, 9)), 3)) is None


@pytest.mark.parametrize("n", [3, 4, 9])
def test_a_tridiagonal_solves_with_itself_and_its_transpose(rng, n):
    lower, diagonal, upper = rng.normal(size=n - 1), rng.normal(size=n), rng.normal(size=n - 1)
    dense = np.diag(lower, -1) + np.diag(diagonal) + np.diag(upper, 1)
    factor, right = banded.Tridiagonal(lower, diagonal, upper), rng.normal(size=(n, 2))
    np.testing.assert_allclose(dense @ factor.solved(right), right, atol=1e-9)
    np.testing.assert_allclose(dense.T @ factor.solved(right, transposed=True), right, atol=1e-9)


def test_a_tridiagonal_without_an_inverse_is_refused():
    with pytest.raises(ArithmeticError):
        banded.Tridiagonal(np.zeros(2), np.zeros(3), np.zeros(2))
