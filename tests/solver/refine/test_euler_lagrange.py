"""Residuals of the Euler-Lagrange equation: what of them a rotation feels, derivatives at nodes, shares of a clip."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.refine.euler_lagrange import Residual, tangential


def test_a_rotation_feels_what_is_across_its_quaternion_whatever_its_length(rng):
    residual, q = rng.normal(size=(20, 4)), rng.normal(size=(20, 4))
    found = tangential(residual, q)
    np.testing.assert_allclose(np.sum(found * q, axis=1), 0, atol=1e-12)
    gone = residual - found
    np.testing.assert_allclose(
        np.abs(np.sum(gone * q, axis=1)), np.linalg.norm(gone, axis=1) * np.linalg.norm(q, axis=1)
    )
    np.testing.assert_allclose(tangential(residual, 3.0 * q), found, atol=1e-12)
    np.testing.assert_allclose(tangential(found, q), found, atol=1e-12)


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
