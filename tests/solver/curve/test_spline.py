"""Splines, quadrature and banded matrices, against SciPy and NumPy."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import Polynomial
from scipy.interpolate import BSpline, CubicSpline
from scipy.linalg import null_space

from dynsplines.solver.curve import banded
from dynsplines.solver.curve.elimination import Elimination
from dynsplines.solver.curve.quadrature import LEAST_PER_SPAN, MOST_SAMPLES, Quadrature, gauss_nodes
from dynsplines.solver.curve.spline import Spline, natural_end_slopes

TIMES = np.array([-0.3, 0.2, 0.25, 1.4, 2.0, 3.7])


def inside(times: np.ndarray, count: int = 41) -> np.ndarray:
    return np.linspace(times[0], times[-1], count)


@pytest.mark.parametrize("order", [0, 1, 2, 3])
@pytest.mark.parametrize("times", [TIMES, TIMES[:3], TIMES[:2]], ids=len)
def test_free_and_clamped_splines_are_scipys_clamped_cubic(rng, order, times):
    rows = rng.normal(size=(times.size + 2, 3))
    slopes: Any = ((1, rows[-2]), (1, rows[-1]))
    expected = CubicSpline(times, rows[:-2], bc_type=slopes)
    for ends in ("free", "clamped"):
        np.testing.assert_allclose(
            Spline(times, ends).evaluate(rows, inside(times), order),
            expected(inside(times), order),
            rtol=1e-9,
            atol=1e-9 * 10 ** (2 * order),
        )


@pytest.mark.parametrize("order", [0, 1, 2, 3])
def test_a_periodic_spline_is_scipys(rng, order):
    states = rng.normal(size=(TIMES.size, 2))
    states[-1] = states[0]
    rows = np.vstack([states, np.zeros((2, 2))])
    t = inside(TIMES)[:-1]  # at the end SciPy gives the third derivative of the start
    expected = CubicSpline(TIMES, states, bc_type="periodic")(t, order)
    got = Spline(TIMES, "periodic").evaluate(rows, t, order)
    np.testing.assert_allclose(got, expected, rtol=1e-9, atol=1e-9 * 10 ** (2 * order))


UNEVEN = np.cumsum([0.0, 1.0, 1e-5, 3.0, 2e-4, 1e-4, 40.0, 1.0])


@pytest.mark.parametrize("times", [TIMES, TIMES[:3], TIMES[:2], UNEVEN], ids=len)
def test_the_local_values_are_those_of_the_basis_which_is_scipys(times):
    spline = Spline(times)
    t = np.concatenate([inside(times), times, (times[1:] + times[:-1]) / 2])
    first, values = spline.local(t)
    each = BSpline(spline.knots, np.eye(spline.size), 3)
    for order in range(3):
        dense = each.derivative(order)(t) if order else each(t)
        np.testing.assert_allclose(spline.basis(t, order).toarray(), dense, atol=1e-10 * np.abs(dense).max())
        expected = np.take_along_axis(dense, first[:, None] + np.arange(4), axis=1)
        np.testing.assert_allclose(values[:, order], expected, rtol=0, atol=1e-12 * np.abs(dense).max())


@pytest.mark.parametrize("times", [TIMES, TIMES[:3], TIMES[:2], UNEVEN], ids=len)
@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_states_and_slopes_are_the_inverse_of_coefficients_and_have_their_transpose(rng, times, ends):
    spline = Spline(times, ends)
    rows, gradient = rng.normal(size=(2, spline.size, 3))
    c = spline.coefficients(rows)
    np.testing.assert_allclose(spline.states_and_slopes(c), rows, atol=1e-9)
    back = spline.states_and_slopes_transposed(gradient)
    np.testing.assert_allclose(np.sum(back * c), np.sum(gradient * rows), rtol=1e-9)


MANY = np.cumsum(10.0 ** np.random.default_rng(3).uniform(-3, 0, 450))  # farther than both ends are felt


@pytest.mark.parametrize("times", [TIMES, TIMES[:3], TIMES[:2], UNEVEN, MANY], ids=len)
def test_the_natural_end_slopes_are_those_of_the_natural_spline(rng, times):
    states = rng.normal(size=(times.size, 3))
    expected = CubicSpline(times, states, bc_type="natural")(times[[0, -1]], 1)
    np.testing.assert_allclose(natural_end_slopes(times, states), expected, rtol=1e-9, atol=1e-9)


KNOTS = np.array([1.0, 1.25, 2.0, 4.0])


@pytest.mark.parametrize("points", [1, 2, 5])
def test_gausss_points_integrate_polynomials_of_twice_their_number_less_one_in_every_span_and_no_higher(points, rng):
    t, w = Quadrature(points=points).nodes(KNOTS)
    assert t.size == w.size == 3 * points
    for k, (a, b) in enumerate(pairwise(KNOTS)):
        own = slice(k * points, (k + 1) * points)
        assert a < t[own][0] and np.all(np.diff(t[own]) > 0) and t[own][-1] < b
        for degree, exact in ((2 * points - 1, True), (2 * points, False)):
            f = Polynomial(np.append(rng.normal(size=degree), 1))
            whole = (f.integ()(1) - f.integ()(-1)) * (b - a) / 2  # of the span as if it went from −1 to 1
            seen = f((2 * t[own] - a - b) / (b - a))
            assert (w[own] @ seen == pytest.approx(whole, rel=1e-11, abs=1e-11)) == exact
    np.testing.assert_array_equal(gauss_nodes(KNOTS, points)[0], t)


SHORT = LEAST_PER_SPAN / MOST_SAMPLES


@pytest.mark.parametrize(
    ("longest", "cuts", "edges"),
    [
        (2.0, (), [1, 1.25, 2, 4]),
        (1.0, (), [1, 1.25, 2, 3, 4]),
        (0.5, (), [1, 1.25, 1.625, 2, 2.5, 3, 3.5, 4]),
        (0.499, (), [1, 1.25, 1.625, 2, 2.4, 2.8, 3.2, 3.6, 4]),
        (0.5, (3.25, 1.1, 2.5003, 2.0, 0.5, 4.5), [1, 1.1, 1.25, 1.625, 2, 2.5, 3, 3.25, 3.5, 4]),
    ],
)
def test_long_spans_are_cut_into_the_fewest_equal_panels_and_cuts_divide_panels(longest, cuts, edges):
    quadrature = Quadrature(points=2, longest=longest, cuts=cuts)
    np.testing.assert_allclose(quadrature.panels(KNOTS), edges)
    np.testing.assert_allclose(quadrature.nodes(KNOTS), gauss_nodes(np.array(edges), 2))


def test_what_makes_no_sense_is_refused():
    for kind in ("gauss", "uniform"):
        assert Quadrature(kind, 1, 1e-300).points == 1
    with pytest.raises(ValueError, match="kind = 'simpson' is not one of 'gauss', 'uniform'"):
        Quadrature("simpson")
    for points, longest in ((0, 1.0), (1, 0.0), (1, np.nan), (0, 0.0)):
        with pytest.raises(ValueError, match="points and longest must be positive"):
            Quadrature(points=points, longest=longest)
    with pytest.raises(ValueError, match=f"would take {MOST_SAMPLES + 1} samples; use 'gauss'"):
        Quadrature("uniform", 1).nodes(np.array([0.0, SHORT / (1 + 0.5 / MOST_SAMPLES), 1.0]))


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
    factor, half = banded.cholesky(stored(dense, width)), np.linalg.cholesky(dense)
    assert factor is not None
    np.testing.assert_allclose(banded.solve(factor, right), np.linalg.solve(dense, right), rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(banded.half_solved(factor, right), np.linalg.solve(half, right), rtol=1e-8, atol=1e-10)
    other = banded.other_half_solved(factor, right)
    np.testing.assert_allclose(other, np.linalg.solve(half.T, right), rtol=1e-8, atol=1e-10)
    np.testing.assert_array_equal(right, kept)
    dense[n // 2, n // 2] = -1.0
    assert banded.cholesky(stored(dense, width)) is None


@settings(max_examples=30)
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
