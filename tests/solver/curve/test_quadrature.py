"""Nodes and weights of the integral over a clip: what they integrate exactly, how many there are, and where."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from dynsplines.solver.curve.quadrature import LEAST_PER_SPAN, MOST_SAMPLES, Quadrature, gauss_nodes

TIMES = np.array([1.0, 1.25, 2.0, 4.0])


@pytest.mark.parametrize("points", [1, 2, 5])
def test_gausss_points_integrate_polynomials_of_twice_their_number_less_one_in_every_span_and_no_higher(points, rng):
    t, w = Quadrature(points=points).nodes(TIMES)
    assert t.size == w.size == 3 * points
    for k, (a, b) in enumerate(pairwise(TIMES)):
        own = slice(k * points, (k + 1) * points)
        assert a < t[own][0] and np.all(np.diff(t[own]) > 0) and t[own][-1] < b
        for degree, exact in ((2 * points - 1, True), (2 * points, False)):
            f = Polynomial(np.append(rng.normal(size=degree), 1))
            whole = (f.integ()(1) - f.integ()(-1)) * (b - a) / 2  # of the span as if it went from −1 to 1
            seen = f((2 * t[own] - a - b) / (b - a))
            assert (w[own] @ seen == pytest.approx(whole, rel=1e-11, abs=1e-11)) == exact
    np.testing.assert_array_equal(gauss_nodes(TIMES, points)[0], t)


def test_cuts_divide_panels_unless_they_are_at_their_edges_or_outside():
    quadrature = Quadrature(points=2, longest=0.5, cuts=(3.25, 1.1, 2.5003, 2.0, 0.5, 4.5))
    np.testing.assert_allclose(quadrature.panels(TIMES), [1, 1.1, 1.25, 1.625, 2, 2.5, 3, 3.25, 3.5, 4])
    t, w = quadrature.nodes(TIMES)
    f = Polynomial([1, -2, 0.5, 3])
    assert w @ f(t) == pytest.approx(f.integ()(4) - f.integ()(1), rel=1e-12)


def test_even_samples_lie_in_the_middles_of_equal_cells():
    t, w = Quadrature("uniform", 60).nodes(TIMES)
    np.testing.assert_allclose(t, 1.025 + 0.05 * np.arange(60), rtol=1e-12)
    np.testing.assert_allclose(w, np.full(60, 0.05), rtol=1e-12)


def test_of_even_samples_there_are_four_in_the_shortest_span_at_least():
    """A span of a quarter of a second in three seconds: a twelfth, of which four make 48."""
    assert LEAST_PER_SPAN == 4
    for points, count in ((1, 48), (48, 48), (49, 49)):
        assert Quadrature("uniform", points).nodes(TIMES)[0].size == count
    assert Quadrature("uniform", 1).nodes(np.array([0.0, 0.1, 0.3]))[0].size == 12
    assert Quadrature("uniform", 1).nodes(np.array([0.0, 0.1, 0.301]))[0].size == 13


def test_so_many_even_samples_that_they_would_fill_the_memory_are_refused():
    short = LEAST_PER_SPAN / MOST_SAMPLES
    assert Quadrature("uniform", 1).nodes(np.array([0.0, short, 1.0]))[0].size == MOST_SAMPLES
    with pytest.raises(ValueError, match=f"would take {MOST_SAMPLES + 1} samples; use 'gauss'"):
        Quadrature("uniform", 1).nodes(np.array([0.0, short / (1 + 0.5 / MOST_SAMPLES), 1.0]))


def test_spans_that_are_too_long_are_cut_into_equal_panels_and_no_more_of_them_than_need_be():
    np.testing.assert_array_equal(Quadrature().panels(TIMES), TIMES)
    np.testing.assert_array_equal(Quadrature(longest=2.0).panels(TIMES), TIMES)
    np.testing.assert_allclose(Quadrature(longest=1.0).panels(TIMES), [1, 1.25, 2, 3, 4])
    np.testing.assert_allclose(Quadrature(longest=0.5).panels(TIMES), [1, 1.25, 1.625, 2, 2.5, 3, 3.5, 4])
    np.testing.assert_allclose(Quadrature(longest=0.499).panels(TIMES), [1, 1.25, 1.625, 2, 2.4, 2.8, 3.2, 3.6, 4])
    np.testing.assert_allclose(Quadrature(longest=0.1).panels(np.array([0, 0.3])), [0, 0.1, 0.2, 0.3], atol=1e-15)
    t, w = Quadrature(points=2, longest=1.0).nodes(TIMES)
    np.testing.assert_array_equal((t, w), gauss_nodes(np.array([1, 1.25, 2, 3, 4]), 2))


def test_what_makes_no_sense_is_refused():
    for kind in ("gauss", "uniform"):
        assert Quadrature(kind, 1, 1e-300).points == 1
    with pytest.raises(ValueError, match="kind = 'simpson' is not one of 'gauss', 'uniform'"):
        Quadrature("simpson")
    for points, longest in ((0, 1.0), (1, 0.0), (1, np.nan), (0, 0.0)):
        with pytest.raises(ValueError, match="points and longest must be positive"):
            Quadrature(points=points, longest=longest)
