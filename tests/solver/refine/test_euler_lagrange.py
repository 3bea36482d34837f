"""Residuals of the Euler-Lagrange equation: what of them a rotation feels, derivatives at nodes, shares of a clip."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.refine.euler_lagrange import Residual


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
