"""Residuals of the Euler-Lagrange equation: what of them a rotation feels, derivatives at nodes, shares of a clip."""

from __future__ import annotations

import numpy as np
import pytest
from figures import TINY, figure_of
from numpy.polynomial import Legendre
from random_keys import random_keys

from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.refine.displacement import _segment
from dynsplines.solver.refine.euler_lagrange import Residual, _differentiation_matrix, tangential
from dynsplines.solver.refine.subdivision import evenly


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


@pytest.mark.parametrize("count", [2, 5, 8])
def test_polynomials_through_nodes_are_differentiated_exactly(count, rng):
    x = np.polynomial.legendre.leggauss(count)[0]
    matrix = _differentiation_matrix(x)
    for degree in range(count):
        through = Legendre(rng.normal(size=degree + 1))
        np.testing.assert_allclose(matrix @ through(x), through.deriv()(x), atol=1e-10)


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


@pytest.mark.parametrize("variable", [0, 1, 3])
def test_a_segment_begins_as_the_path_is_there(variable, rng):
    figure = figure_of(TINY)
    path = path_of(evenly(raw_timeline(figure, random_keys(figure, rng)), 1))
    first, last = np.asarray(path.spline.times)[[2, 3]]
    local = _segment(path, float(first), float(last), variable)
    assert local.variable_count == variable
    np.testing.assert_allclose(local.times, np.linspace(first, last, variable + 2))
    t = np.linspace(first, last, 21)
    np.testing.assert_allclose(path_of(local).motion(t), path.motion(t), atol=1e-8)
