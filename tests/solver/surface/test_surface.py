"""Depths in planes and boxes against mj_geomDistance, their gradients, and every face from both sides."""

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from taylor import taylor_slope

from dynsplines.solver.surface import Box, Plane, static_surfaces

SCENE = """
<mujoco><worldbody>
  <geom name="floor" type="plane" size="0 0 1" pos="0 0 -.1"/>
  <geom name="ramp" type="plane" size="5 5 1" pos="1 2 .3" euler="20 30 10"/>
  <body name="platform" pos="0 0 .5" quat=".9 .1 .2 .1">
    <geom name="crate" type="box" size=".5 .6 .4" pos=".2 .1 .3" euler="10 0 20"/></body>
  <geom name="step" type="box" size="1 1 .2" pos="4 0 .1"/>
  <geom name="sunk" type="box" size="1 1 .2" pos="4 0 -.5"/>
  <body name="ball" pos="0 0 3"><freejoint/><geom name="ball" type="sphere" size=".15"/>
    <geom type="box" size=".1 .1 .1"/></body>
</worldbody></mujoco>"""


@pytest.fixture(scope="module")
def scene() -> tuple[mujoco.MjModel, dict]:
    model = mujoco.MjModel.from_xml_string(SCENE)
    return model, {surface.name: surface for surface in static_surfaces(model)}


def mujoco_depth(model: mujoco.MjModel, name: str, centre: np.ndarray) -> float:
    """How deep the ball at this place is in the named geom, by MuJoCo; 0 outside."""
    return max(-mujoco_distance(model, name, centre), 0.0)


def mujoco_distance(model: mujoco.MjModel, name: str, centre: np.ndarray) -> float:
    data = mujoco.MjData(model)
    data.qpos[:3] = centre
    mujoco.mj_forward(model, data)
    return mujoco.mj_geomDistance(model, data, model.geom("ball").id, model.geom(name).id, 10, None)


def depth_at(surface, centre: np.ndarray, radius: float = 0.15) -> float:
    return float(surface.depth(np.reshape(centre, (3, 1, 1)), np.array([radius]))[0][0, 0])


@pytest.mark.parametrize("name", ["floor", "ramp"])
@pytest.mark.parametrize("height", [-0.7, 0.149, 0.151])
def test_depth_in_a_plane_is_mujocos(scene, name, height, rng):
    model, surfaces = scene
    plane = surfaces[name]
    along = np.cross(plane.normal, rng.normal(size=3))
    centre = plane.point + along + height * plane.normal
    np.testing.assert_allclose(depth_at(plane, centre), mujoco_depth(model, name, centre), atol=1e-9)
    assert (depth_at(plane, centre) > 0) == (height < 0.15)


@pytest.mark.parametrize("name", ["crate", "step"])
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("sign", [1, -1])
def test_shallow_depth_in_a_box_is_mujocos_up_to_the_faces_factor_and_zero_outside(scene, name, axis, sign):
    model, surfaces = scene
    box = surfaces[name]
    normal = sign * box.axes[:, axis]
    face = box.centre + box.half[axis] * normal
    factor = 1.0 if normal[2] > 0.7 else 4.0
    for gap in (1e-9, 1e-3, 0.5):
        outside = face + (0.15 + gap) * normal
        depth, gradient = box.depth(outside[:, None, None], np.array([0.15]))
        assert not depth.any()
        assert not gradient.any()
    for direction in (1e-6, 1e-3, 0.01):
        inside = face + (0.15 - direction) * normal
        depth, gradient = box.depth(inside[:, None, None], np.array([0.15]))
        if box.buried and normal[2] < -0.7:
            assert depth[0, 0] > 0.1  # no way out through the floor
            assert gradient[:, 0, 0] @ normal > 0
            continue
        by_mujoco = mujoco_depth(model, name, inside)
        np.testing.assert_allclose(by_mujoco, direction, atol=1e-6)
        np.testing.assert_allclose(depth[0, 0], factor * by_mujoco, rtol=0.01, atol=5e-6)
        np.testing.assert_allclose(gradient[:, 0, 0], -factor * normal, atol=0.05 * factor)


@pytest.mark.parametrize("buried", [True, False])
def test_the_gradients_of_depth_have_taylor_slope_two(buried, rng):
    axes = Rotation.from_euler("xyz", [0.2, -0.1, 1.0]).as_matrix()
    box = Box("b", np.array([0.1, 0.2, 0.3]), axes, np.array([0.5, 0.7, 0.4]), buried)
    plane = Plane("p", np.array([0.1, 0.2, 0.9]), np.array([0.6, 0, 0.8]))
    radius = np.array([0.0, 0.1, 0.05])
    local = rng.uniform(-0.7, 0.7, size=(3, 3, 4)) * box.half[:, None, None]
    points = box.centre[:, None, None] + np.tensordot(axes, local, 1)
    weights = rng.normal(size=(3, 4))
    for surface in (box, plane):
        depth, gradient = surface.depth(points, radius)
        assert np.all(depth > 0)

        def value(p: np.ndarray, surface=surface) -> float:
            return float(np.sum(weights * surface.depth(p, radius)[0]))

        assert taylor_slope(value, points, weights * gradient, rng) > 1.95


@pytest.mark.parametrize("name", ["crate", "step", "ramp"])
def test_within_a_margin_spheres_outside_have_negative_depths(scene, name, rng):
    model, surfaces = scene
    surface, radius = surfaces[name], np.array([0.15])
    centre = surface.point if name == "ramp" else surface.centre
    found = 0
    for place in centre + rng.normal(scale=0.7, size=(300, 3)):
        at = place.reshape(3, 1, 1)
        depth, gradient = (np.squeeze(part, axis=(-2, -1)) for part in surface.depth(at, radius, 0.2))
        inside, slope = (np.squeeze(part, axis=(-2, -1)) for part in surface.depth(at, radius))
        if inside > 0:
            assert depth == inside
            np.testing.assert_array_equal(gradient, slope)
        elif np.isfinite(depth):
            found += 1
            assert 0 <= -depth / np.linalg.norm(gradient) <= mujoco_distance(model, name, place) + 1e-6
        else:
            assert not gradient.any()
            below = name == "step" and place[2] < surface.centre[2] - surface.half[2]  # no exit downwards
            assert below or mujoco_distance(model, name, place) > 0.2 - 1e-6
    assert found > 20


def test_a_sphere_beyond_an_edge_of_a_box_is_free_to_pass_the_nearer_face(scene):
    _, surfaces = scene
    step, radius = surfaces["step"], np.array([0.0])
    edge = step.centre + step.half
    depth, gradient = step.depth(np.add(edge, [0.02, -0.5, 0.005]).reshape(3, 1, 1), radius, 0.03)
    np.testing.assert_allclose(depth[0, 0], -4 * 0.02)
    np.testing.assert_allclose(gradient[:, 0, 0], [-4, 0, 0], atol=1e-12)
    depth, gradient = step.depth(np.add(edge, [0.005, -0.5, 0.02]).reshape(3, 1, 1), radius, 0.03)
    np.testing.assert_allclose(depth[0, 0], -0.02)
    np.testing.assert_allclose(gradient[:, 0, 0], [0, 0, -1], atol=1e-12)


def test_a_box_counts_as_up_the_face_that_looks_up_however_it_lies():
    axes = Rotation.from_euler("x", 90, degrees=True).as_matrix()
    box = Box("b", np.zeros(3), axes, np.array([1.0, 0.3, 1.0]), buried=False)
    np.testing.assert_allclose(depth_at(box, np.array([0, 0, 0.29]), 0.0), 0.01, rtol=1e-2)
    np.testing.assert_allclose(depth_at(box, np.array([0, 0, -0.29]), 0.0), 0.04, rtol=1e-2)
    np.testing.assert_allclose(box.height(np.array([0, 0, 1.0])), 0.7, atol=1e-12)


@pytest.mark.parametrize("buried", [True, False])
def test_spheres_are_near_where_they_have_a_depth(buried, rng):
    axes = Rotation.from_euler("xyz", [0.2, -0.1, 1.0]).as_matrix()
    box = Box("b", np.array([0.1, 0.2, 0.3]), axes, np.array([0.5, 0.7, 0.4]), buried)
    plane = Plane("p", np.array([0.1, 0.2, 0.3]), np.array([0.6, 0, 0.8]))
    points, radius = rng.normal(size=(3, 40, 5)), rng.uniform(0, 0.3, 40)
    radius[:3] = -np.inf
    for surface in (box, plane):
        near = surface.near(points, radius[:, None])
        np.testing.assert_array_equal(near, surface.depth(points, radius)[0] > 0)
        assert near.any()
        assert not near[:3].any()
