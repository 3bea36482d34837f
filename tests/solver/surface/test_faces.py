"""Boxes, cylinders and capsules by their faces and outlines: ways out, lines upward, at any tilt, by closed forms."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.surface import Box, Capsule, Cylinder, Ellipsoid
from dynsplines.solver.surface.solid import Solid

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
