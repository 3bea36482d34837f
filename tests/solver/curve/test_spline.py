"""The spline against SciPy's, its exactness under insertion and its transpose."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline, CubicSpline

from dynsplines.solver.curve.spline import Path, Sampling, Spline, natural_end_slopes

TIMES = np.array([-0.3, 0.2, 0.25, 1.4, 2.0, 3.7])
ENDS = ["free", "clamped", "periodic"]


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


@pytest.mark.parametrize("times", [TIMES, TIMES[:2]], ids=len)
def test_jumps_of_minus_one_make_a_spline_that_comes_back_as_its_negative_smooth(rng, times):
    states = rng.normal(size=(times.size, 2))
    states[-1] = -states[0]
    spline = Spline(times, "periodic")
    shares = spline.jumps_of(-1)
    assert not shares.imag.any()
    rows = np.vstack([states, shares.real @ states])
    np.testing.assert_allclose(spline.evaluate(rows, times), states, atol=1e-12)
    twice = CubicSpline(
        np.concatenate([times, times[1:] + times[-1] - times[0]]), np.vstack([states, -states[1:]]), bc_type="periodic"
    )
    for order in range(3):
        np.testing.assert_allclose(
            spline.evaluate(rows, inside(times), order), twice(inside(times), order), atol=1e-9 * 10**order, rtol=1e-9
        )


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


@pytest.mark.slow
@settings(deadline=None, max_examples=50)
@given(st.sampled_from(ENDS), st.floats(0.002, 0.998), st.integers(0, 10**6))
def test_a_frame_inserted_on_the_curve_leaves_the_curve_unchanged(ends, share, seed):
    rows = np.random.default_rng(seed).normal(size=(TIMES.size + 2, 2))
    tau = TIMES[0] + share * (TIMES[-1] - TIMES[0])
    if np.abs(TIMES - tau).min() < 1e-4:
        return
    before = Path(Spline(TIMES, ends), rows)
    times = np.sort(np.append(TIMES, tau))
    place = int(np.searchsorted(TIMES, tau))
    after = Path(Spline(times, ends), np.insert(rows, place, before.at(tau)[0], axis=0))
    for order in range(3):
        size = np.abs(before.at(inside(TIMES), order)).max()
        np.testing.assert_allclose(
            after.at(inside(TIMES), order), before.at(inside(TIMES), order), atol=1e-9 * size, rtol=0
        )


@pytest.mark.parametrize("ends", ENDS)
def test_pulled_back_is_the_transpose_of_samples(rng, ends):
    sampling = Sampling.of(Spline(TIMES, ends), rng.uniform(TIMES[0], TIMES[-1], 30))
    rows = rng.normal(size=(TIMES.size + 2, 3))
    gradients = [rng.normal(size=(30, 3)) for _ in range(3)]
    forth = sum(np.sum(g * s) for g, s in zip(gradients, sampling.samples(rows), strict=True))
    np.testing.assert_allclose(np.sum(sampling.pulled_back(gradients) * rows), forth, rtol=1e-11)
