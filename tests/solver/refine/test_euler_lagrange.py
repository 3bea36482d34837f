"""Residuals of the Euler-Lagrange equation: what of them a rotation feels, derivatives at nodes, shares of a clip."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from small_problems import turning

from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.refine.euler_lagrange import NODES, Residual, residual


def test_the_shares_of_equal_parts_add_up_and_are_those_of_the_density_where_it_is_even(rng):
    edges = np.array([1.0, 1.3, 2.1, 2.2, 3.0])
    t, w = (each.reshape(4, -1) for each in gauss_nodes(edges, 8))
    even = Residual(t, w, np.full((4, 8, 3), 2.0))
    np.testing.assert_allclose(even.size, np.sqrt(12))
    np.testing.assert_allclose(even.deviation(), np.sqrt(12) * np.diff(edges))
    np.testing.assert_allclose(even.shares(10), np.sqrt(12) * 0.2)
    np.testing.assert_allclose(even.shares(), even.shares(10))
    any_of = Residual(t, w, rng.normal(size=(4, 8, 3)))
    np.testing.assert_allclose(any_of.shares(7).sum(), any_of.deviation().sum())
    halves = np.where(t < 2.0, 1.0, 0.0)[:, :, None]
    assert Residual(t, w, halves).shares(4)[[0, -1]] == pytest.approx([0.5, 0.0], abs=1e-9)


def test_the_residual_is_the_derivative_of_the_objective_along_variations_inside_a_span(rng):
    """∫ R·v dt = ∫ g₀·v + g₁·v' + g₂·v'' dt for v = c (t − a)² (b − t)², which vanishes with v' at the span's ends."""
    objective, timeline = turning([40.0, 80.0, 20.0], 1)
    path = path_of(timeline)
    strong, direction = residual(objective, path), rng.normal(size=path.rows.shape[1])
    gradients = objective.sample_gradients(objective.samples(path, gauss_nodes(timeline.times, NODES)[0]))
    for k, (a, b) in enumerate(pairwise(timeline.times)):
        bump = np.polynomial.Polynomial.fromroots([a, a, b, b])
        t, w, inside = strong.t[k], strong.weights[k], slice(k * NODES, (k + 1) * NODES)
        weak = sum(w @ (g[inside] @ direction * bump.deriv(order)(t)) for order, g in enumerate(gradients))
        assert w @ (strong.value[k] @ direction * bump(t)) == pytest.approx(weak, rel=1e-3)
