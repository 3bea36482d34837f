"""Hulls, boxes, cylinders and capsules against closed forms, least squares over corners and Qhull's half spaces."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array, Index
from dynsplines.solver.surface import Box, Capsule, Cylinder, Ellipsoid, Hull, hull, hull_of
from dynsplines.solver.surface.solid import Solid

SEEDS = st.integers(0, 10_000)
CUBE_CORNERS = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]).T


def of_points(vertices: Array, buried: bool = False) -> Hull:
    """The hull of points (n, 3)."""
    found = hull_of(vertices)
    assert found is not None
    return Hull("rock", *found, buried)


CUBE, SUNK = of_points(CUBE_CORNERS.T), of_points(CUBE_CORNERS.T, buried=True)


def rock(seed: int) -> tuple[Hull, Array, np.random.Generator]:
    """A hull of random points, those points (n, 3), and what else is random."""
    rng = np.random.default_rng(seed)
    vertices = rng.normal(size=(int(rng.integers(4, 14)), 3)) * rng.uniform(0.3, 1.5, 3)
    return of_points(vertices), vertices, rng


def away_from(vertices: Array, point: Array) -> float:
    """Distance of a point (3,) to all mixtures of points (n, 3): their weights are not negative and add up to one."""
    heavy = 1e4
    weights, _ = nnls(np.vstack([vertices.T, np.full(len(vertices), heavy)]), np.append(point, heavy))
    return float(np.linalg.norm(vertices.T @ weights - point))


def one(hull: Hull, *place: float) -> tuple[float, Array]:
    distance, outward = hull.distance(np.reshape(place, (3, 1)).astype(float))
    return float(distance[0]), outward[:, 0]


@settings(deadline=None, max_examples=15)
@given(SEEDS)
def test_outside_the_distance_is_that_to_the_nearest_mixture_of_corners(seed):
    hull, vertices, rng = rock(seed)
    points = rng.normal(size=(3, 25)) * 2
    distance, _ = hull.distance(points)
    expected = np.array([away_from(vertices, p) for p in points.T])
    np.testing.assert_allclose(np.maximum(distance, 0), expected, atol=2e-6)


def test_over_the_middle_of_every_edge_the_distance_is_that_to_the_edge(rng):
    vertices = rng.normal(size=(60, 3))
    vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    oracle = ConvexHull(vertices)
    points = []
    for simplex, normal, neighbours in zip(oracle.simplices, oracle.equations[:, :3], oracle.neighbors, strict=True):
        for opposite, neighbour in enumerate(neighbours):
            outward = normal + oracle.equations[neighbour, :3]
            points.append(vertices[np.delete(simplex, opposite)].mean(axis=0) + 0.1 * outward / np.linalg.norm(outward))
    np.testing.assert_allclose(of_points(vertices).distance(np.array(points).T)[0], 0.1, atol=1e-6)


@settings(deadline=None, max_examples=15)
@given(SEEDS)
def test_inside_the_distance_is_that_to_the_nearest_half_space_of_qhulls(seed):
    hull, vertices, rng = rock(seed)
    inner = rng.dirichlet(np.ones(len(vertices)), 25) @ vertices
    planes = ConvexHull(vertices).equations
    distance, outward = hull.distance(inner.T)
    over = planes[:, :3] @ inner.T + planes[:, 3:]
    np.testing.assert_allclose(distance, over.max(axis=0), atol=2e-6)
    second = np.sort(np.where(over > over.max(axis=0) - 1e-6, -np.inf, over), axis=0)[-1]
    clear = over.max(axis=0) - second > 1e-4  # else two ways out are as good as each other
    np.testing.assert_allclose(outward[:, clear], planes[np.argmax(over, axis=0), :3].T[:, clear], atol=1e-4)


@settings(deadline=None, max_examples=20)
@example(1153, False)  # a splinter, whose planes say less than its box
@given(SEEDS, st.booleans())
def test_the_cheap_bound_is_never_above_the_distance_and_is_the_distance_inside(seed, buried):
    free, _, rng = rock(seed)
    hull = Hull("rock", free.corners, free.faces, buried)
    points = rng.normal(size=(3, 60)) * rng.choice([0.2, 1.0, 8.0], 60)
    distance, least = hull.distance(points)[0], hull.least(points)
    assert np.all(least <= distance + 1e-9)
    np.testing.assert_allclose(least[distance < 0], distance[distance < 0], atol=1e-9)
    if not buried:
        assert np.all(least >= (distance - hull._size) / np.sqrt(3)), "far away, a bound by its box would do"
        np.testing.assert_array_equal(least < 0, distance < 0)


@settings(deadline=None, max_examples=12)
@given(SEEDS)
def test_a_vertical_line_is_inside_between_both_ends_of_its_span_and_nowhere_else(seed):
    hull, _, rng = rock(seed)
    points = rng.normal(size=(3, 12))
    bottom, top = hull.span(points)
    heights = np.linspace(hull.corners[2].min() - 0.1, hull.corners[2].max() + 0.1, 400)
    for place, low, high in zip(points[:2].T, bottom, top, strict=True):
        line = np.vstack([np.repeat(place[:, None], heights.size, axis=1), heights])
        inside = hull.distance(line)[0] < 0
        if np.isnan(low):
            assert np.isnan(high)
            assert not inside.any()
        else:
            sure = np.minimum(abs(heights - low), abs(heights - high)) > 1e-6
            np.testing.assert_array_equal(inside[sure], ((heights > low) & (heights < high))[sure])


def test_what_is_buried_has_no_way_out_below_but_has_them_at_the_sides():
    for depth in (0.05, -0.5, -30.0):
        distance, direction = one(SUNK, 0.5, 0.8, depth)
        assert distance == pytest.approx(-0.2, abs=1e-7)
        np.testing.assert_allclose(direction, [0, 1, 0], atol=1e-9)
        assert SUNK.least(np.array([[0.5], [0.8], [depth]]))[0] == pytest.approx(-0.2, abs=1e-7)
    assert one(SUNK, 0.5, 0.5, 0.9)[0] == pytest.approx(-0.1, abs=1e-7)
    bottom, top = SUNK.span(np.array([[0.5], [0.5], [0.2]]))
    assert (bottom[0], top[0]) == (-np.inf, pytest.approx(1))


@pytest.mark.parametrize("lift", [0.0, 0.008, 0.012, 0.3])
def test_only_a_face_that_lies_on_the_floor_is_buried_not_one_that_rises_from_it(lift):
    corners = CUBE_CORNERS.copy()
    corners[2, 0] += lift  # the bottom is two triangles from here on, one of which leaves the floor
    found = of_points(corners.T, buried=True)
    below, _ = one(found, 0.02, 0.02, 0.0)
    assert (below > 0) == (lift > 0.01)


def test_triangles_without_an_area_are_no_faces():
    flat: Index = np.vstack([CUBE.faces, [[0, 0, 1], [2, 2, 2]]])
    found = Hull("cube", CUBE.corners, flat)
    assert one(found, 0.5, 0.5, 3)[0] == pytest.approx(2)
    assert one(found, 2, 3, -2)[0] == pytest.approx(3)


def test_a_crowd_of_points_is_measured_in_parts_and_all_the_same(monkeypatch, rng):
    solid, _, _ = rock(3)
    points = rng.normal(size=(3, 50)) * 3
    distance, outward = solid.distance(points)
    for most in (1, 7 * len(solid._edges), 10**6):
        monkeypatch.setattr(hull, "AT_ONCE", most)
        again, direction = solid.distance(points)
        np.testing.assert_array_equal(again, distance)
        np.testing.assert_array_equal(direction, outward)


def test_points_in_a_plane_have_no_hull_and_a_hull_of_few_corners_has_no_more():
    assert hull_of(CUBE_CORNERS.T * [1, 1, 0]) is None
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    drum = np.array([[np.cos(a), np.sin(a), z] for a in turn for z in (0, 1)])
    whole, few = hull_of(drum), hull_of(drum, 12)
    assert whole is not None and few is not None
    assert whole[0].shape == (3, 80)
    assert few[0].shape[1] <= 12


HALF = np.array([0.3, 0.5, 0.2])
TILTS = [np.zeros(3), np.array([0.4, -0.3, 0.8]), np.array([np.pi / 2, 0, 0]), np.array([2.0, 1.0, -0.5])]


def tilted(turn: Array, *, buried: bool) -> Box:
    return Box("box", np.array([0.2, -0.1, 0.4]), Rotation.from_rotvec(turn).as_matrix(), HALF, buried)


@pytest.mark.parametrize("buried", [False, True])
@pytest.mark.parametrize("turn", TILTS)
def test_a_point_inside_a_box_is_as_deep_as_its_nearest_face_is_far_but_for_those_that_look_down_into_the_ground(
    turn, buried, rng
):
    box = tilted(turn, buried=buried)
    share = rng.uniform(-1.3, 1.3, size=(3, 200))
    points = box.centre[:, None] + box.axes @ (share * HALF[:, None])
    gaps = np.concatenate([HALF[:, None] * (1 - share), HALF[:, None] * (1 + share)])
    rise = np.concatenate([box.axes[2], -box.axes[2]])
    usable = gaps[(rise > -0.7) | (not buried)]
    inside = np.abs(share).max(axis=0) < 1
    assert 0 < inside.sum() < inside.size
    np.testing.assert_allclose(box.inside(points), np.where(inside, usable.min(axis=0), 0.0), atol=1e-12)
    np.testing.assert_allclose(box.inside(points[:, :, None])[:, 0], box.inside(points))


@pytest.mark.parametrize("turn", TILTS)
def test_the_height_over_a_box_is_that_over_its_uppermost_face_along_its_normal(turn, rng):
    for buried in (False, True):
        box = tilted(turn, buried=buried)
        top = int(np.argmax(np.abs(box.axes[2])))
        sign = np.sign(box.axes[2, top])
        share = rng.uniform(-1.2, 1.2, size=(3, 100))
        share[top] = sign * rng.uniform(-2.9, 3.0, size=100)
        points = box.centre[:, None] + box.axes @ (share * HALF[:, None])
        over = np.abs(np.delete(share, top, axis=0)).max(axis=0) <= 1
        over &= buried | (sign * share[top] > -1)
        expected = np.where(over, HALF[top] * (sign * share[top] - 1), np.inf)
        np.testing.assert_allclose(box.height(points), expected, atol=1e-12)
        np.testing.assert_allclose(box.up(points), np.tile(sign * box.axes[:, [top]], 100))


def shapes(turn: Array) -> dict[str, tuple[Solid, int, list[float]]]:
    """By name a solid, its MuJoCo type and sizes; its axis is z turned."""
    matrix = Rotation.from_rotvec(turn).as_matrix()
    centre, axis = np.array([0.2, -0.1, 0.4]), matrix[:, 2]
    geom = mujoco.mjtGeom
    return {
        "cylinder": (Cylinder("post", centre, axis, 0.5, 0.2), geom.mjGEOM_CYLINDER, [0.2, 0.5, 0]),
        "capsule": (Capsule("pole", centre, axis, 0.5, 0.2), geom.mjGEOM_CAPSULE, [0.2, 0.5, 0]),
        "ellipsoid": (Ellipsoid("egg", centre, matrix, HALF), geom.mjGEOM_ELLIPSOID, HALF.tolist()),
    }


def rays(kind: int, size: list[float], turn: Array, points: Array) -> tuple[Array, Array]:
    """Where vertical lines through points (3, p) enter a geom from below and leave it, z, by MuJoCo; NaN: nowhere."""
    x, y, z, w = Rotation.from_rotvec(turn).as_quat()
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=kind, size=size, pos=[0.2, -0.1, 0.4], quat=[w, x, y, z])
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    found = np.full((2, points.shape[1]), np.nan)
    for i, (px, py) in enumerate(points[:2].T):
        for side, (start, way) in enumerate(((-9.0, 1.0), (9.0, -1.0))):
            there = np.zeros(1, np.int32)
            far = mujoco.mj_ray(model, data, np.array([px, py, start]), np.array([0, 0, way]), None, 1, -1, there)
            if far >= 0:
                found[side, i] = start + way * far
    return found[0], found[1]


@pytest.mark.parametrize("name", ["cylinder", "capsule", "ellipsoid"])
@pytest.mark.parametrize("turn", [*TILTS, np.array([0, np.pi / 2, 0])])
def test_a_vertical_line_is_in_a_solid_where_rays_from_below_and_above_meet_it(name, turn, rng):
    surface, kind, size = shapes(turn)[name]
    points = np.array([0.2, -0.1, 0.4])[:, None] + rng.uniform(-0.75, 0.75, size=(3, 150))
    bottom, top = rays(kind, size, turn, points)
    found = surface.span(points)
    assert 0 < np.isnan(bottom).sum() < bottom.size
    np.testing.assert_allclose(found[0], bottom, atol=1e-6)
    np.testing.assert_allclose(found[1], top, atol=1e-6)
    height = surface.height(points)
    over = points[2] >= bottom
    np.testing.assert_allclose(height[over], (points[2] - top)[over], atol=1e-6)
    assert np.all(np.isinf(height[~over]))
    np.testing.assert_array_equal(surface.height(points[:, :, None])[:, 0], height)
