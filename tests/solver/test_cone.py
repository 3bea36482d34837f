"""The part of vectors that cones cannot supply, against scipy's non-negative least squares and its own gradient."""

import numpy as np
import pytest
from scipy.optimize import nnls
from taylor import taylor_slope

from dynsplines.solver.array import Array
from dynsplines.solver.cone import projection, unsupplied


def pyramids(rng: np.random.Generator, points: int, count: int) -> Array:
    """Friction pyramids at points about a metre under the centre of mass, some of them missing: (6, 4 points, S)."""
    places = rng.normal(size=(3, points, 1, count)) * np.array([0.2, 0.2, 0.02])[:, None, None, None]
    places[2] -= 1
    angles = np.pi / 4 + np.pi / 2 * np.arange(4)
    edges = np.array([0.8 * np.cos(angles), 0.8 * np.sin(angles), np.ones(4)])
    forces = np.broadcast_to(edges[:, None, :, None], (3, points, 4, count))
    both = np.concatenate([forces, np.cross(places + 0 * forces, forces, axis=0)]).reshape(6, -1, count)
    return both * np.repeat(rng.random((points, count)) < 0.7, 4, axis=0)


@pytest.mark.parametrize("softness", [1e-2, 1e-4, 1e-8])
@pytest.mark.parametrize("points", [1, 4, 8])
def test_it_is_the_least_squares_over_shares_that_are_not_negative(rng, points, softness):
    edges, w = pyramids(rng, points, 60), rng.normal(size=(6, 60))
    w[2] += 1
    found = unsupplied(w, edges, softness)
    for s in range(60):
        matrix = np.vstack([edges[:, :, s], np.sqrt(softness) * np.eye(edges.shape[1])])
        shares, size = nnls(matrix, np.append(w[:, s], np.zeros(edges.shape[1])))
        np.testing.assert_allclose(found.value[s], size**2, atol=1e-12)
        np.testing.assert_allclose(found.rest[:, s], w[:, s] - edges[:, :, s] @ shares, atol=1e-7)
        np.testing.assert_allclose(found.shares[:, s], shares, atol=1e-5)


@pytest.mark.parametrize("softness", [1e-4, 1e-8])
def test_thousands_of_cones_meet_the_optimality_conditions(rng, softness):
    edges, w = pyramids(rng, 8, 2000), rng.normal(size=(6, 2000))
    w[2] += 1
    found = unsupplied(w, edges, softness)
    pull = np.einsum("nks,ns->ks", edges, found.rest)
    np.testing.assert_allclose(softness * found.shares, np.maximum(pull, 0), atol=1e-12)
    np.testing.assert_allclose(found.rest, w - np.einsum("nks,ks->ns", edges, found.shares), atol=1e-6)


def test_without_edges_all_of_it_is_left(rng):
    w = rng.normal(size=(6, 5))
    for edges in (np.zeros((6, 8, 5)), np.zeros((6, 0, 5))):
        found = unsupplied(w, edges, 1e-4)
        np.testing.assert_array_equal(found.rest, w)
        np.testing.assert_allclose(found.value, np.sum(w**2, axis=0), rtol=1e-14)
        np.testing.assert_array_equal(projection(found, edges, 1e-4), np.tile(np.eye(6), (5, 1, 1)))


def test_what_lies_in_the_cone_is_supplied(rng):
    edges = pyramids(rng, 3, 20)
    w = np.einsum("nks,ks->ns", edges, rng.random((12, 20)))
    assert unsupplied(w, edges, 1e-10).value.max() < 1e-8
    assert unsupplied(-w, edges, 1e-10).value.max() > 0.1


def test_the_rest_and_the_shares_are_the_gradient(rng):
    edges, w = pyramids(rng, 4, 30), rng.normal(size=(6, 30))
    found = unsupplied(w, edges, 1e-3)
    by_edges = -2 * found.rest[:, None] * found.shares[None]
    assert found.shares.any()

    def value(point: Array) -> float:
        return float(unsupplied(point[:, 0], point[:, 1:], 1e-3).value.sum())

    point = np.concatenate([w[:, None], edges], axis=1)
    gradient = np.concatenate([2 * found.rest[:, None], by_edges], axis=1)
    assert taylor_slope(value, point, gradient, rng) > 1.9


def test_the_projection_is_how_the_rest_moves_with_the_vector(rng):
    edges, w, h = pyramids(rng, 2, 20), rng.normal(size=(6, 20)), 1e-6
    found, direction = unsupplied(w, edges, 1e-3), rng.normal(size=(6, 20))
    after, before = (unsupplied(w + sign * h * direction, edges, 1e-3).rest for sign in (1, -1))
    moved = np.einsum("sij,js->is", projection(found, edges, 1e-3), direction)
    np.testing.assert_allclose((after - before) / (2 * h), moved, atol=1e-6)
