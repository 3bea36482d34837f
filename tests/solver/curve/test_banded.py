"""Banded Cholesky factors and a basis of the splines that are zero at held rows, against dense matrices and SciPy."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import null_space

from dynsplines.solver.curve import banded
from dynsplines.solver.curve.elimination import Elimination
from dynsplines.solver.curve.spline import Sampling, Spline

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


@settings(max_examples=100)
@given(
    st.lists(st.floats(0.01, 1), min_size=2, max_size=12),
    st.sampled_from(["free", "periodic"]),
    st.randoms(use_true_random=False),
)
def test_its_functions_span_the_splines_whose_held_rows_are_zero(gaps, ends, random):
    spline = Spline(np.append(0.0, np.cumsum(gaps)), ends)
    held = np.array([random.random() < 0.5 for _ in range(spline.size)])
    held[int(random.random() * spline.size)] = False
    basis = Elimination(spline, held)
    matrix, rows = basis.matrix.toarray(), spline.states_and_slopes(np.eye(spline.size))
    scale = np.abs(matrix).max()
    np.testing.assert_allclose(rows[held] @ matrix, 0, atol=1e-9 * scale * np.abs(rows).max())
    constraints = rows[held] / np.linalg.norm(rows[held], axis=1, keepdims=True)
    freedoms = np.asarray(null_space(constraints)).shape[1] if held.any() else held.size
    assert np.linalg.matrix_rank(matrix) == basis.count == freedoms
    np.testing.assert_array_equal(basis.transposed.toarray(), matrix.T)


@pytest.mark.parametrize("held", [[0], [0, 2, 3, 5], [0, 1, 2, 3, 4, 5, 6], [0, 3, 6, 7, 8]], ids=str)
def test_at_samples_four_of_its_functions_are_nonzero(rng, held):
    spline = Spline(np.cumsum(rng.uniform(0.1, 1, 7)))
    basis = Elimination(spline, np.isin(np.arange(spline.size), held))
    sampling = Sampling.of(spline, np.sort(rng.uniform(*spline.times[[0, -1]], 50)))
    for ours, theirs in zip(basis.sampled(sampling).bases, sampling.bases, strict=True):
        np.testing.assert_allclose(ours.toarray(), theirs.toarray() @ basis.matrix.toarray(), atol=1e-9)


def test_a_square_of_rows_is_the_upper_triangle_of_their_product(rng):
    rows = rng.normal(size=(5, 3))
    np.testing.assert_allclose(banded.squared(rows), np.triu(rows.T @ rows), rtol=1e-12)
    np.testing.assert_allclose(banded.squared(rows, -2.0), np.triu(-2 * rows.T @ rows), rtol=1e-12)
