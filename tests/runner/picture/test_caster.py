"""Rays meet the same things however they are cast: one by one by mj_ray, from one point, or in a batch."""

import mujoco
import numpy as np
import pytest

from dynsplines.picture.caster import VISIBLE_GROUPS, Batched, Caster, Single, caster, has_batch

SCENE = """
<mujoco>
  <asset><mesh name="wedge" vertex="0 0 0 .4 0 0 0 .4 0 0 0 .4"/></asset>
  <worldbody>
    <geom type="plane" size="0 0 1"/>
    <geom type="box" size=".2 .1 .3" pos="1 0 .4" euler="20 30 0"/>
    <geom type="mesh" mesh="wedge" pos="-.6 -.6 .3"/>
    <geom type="sphere" size="5" group="4"/>
    <body pos="0 0 1"><freejoint/>
      <geom type="ellipsoid" size=".4 .2 .3"/>
      <geom type="capsule" size=".1 .2" pos=".1 .6 0" euler="40 0 10"/>
      <geom type="cylinder" size=".1 .2" pos="-.5 .3 .1" euler="0 70 10"/></body>
  </worldbody>
</mujoco>
"""
EYE = np.array([0.3, -2.5, 1.4])
HERE = np.array([0.1, 0.2, 0.9, 0.9, 0.1, -0.3, 0.2])
MODEL = mujoco.MjModel.from_xml_string(SCENE)


def ways() -> list[type]:
    return [Single, Batched] if has_batch() else [Single]


@pytest.fixture(params=ways())
def cast(request: pytest.FixtureRequest) -> Caster:
    out = request.param(MODEL)
    out.pose(HERE)
    return out


@pytest.fixture
def directions(rng) -> np.ndarray:
    """(600, 3) from the eye to where the figure and the things around it are."""
    out = rng.uniform([-1.2, -1, 0], [1.2, 1, 1.6], (600, 3)) - EYE
    return out / np.linalg.norm(out, axis=1)[:, None]


def one_by_one(origins, directions, *, static):
    """Distances and geoms by mj_ray, and the body's pose."""
    data = mujoco.MjData(MODEL)
    data.qpos[:] = HERE
    mujoco.mj_kinematics(MODEL, data)
    geom, out = np.zeros((1, 1), np.int32), []
    for origin, direction in zip(origins, directions, strict=True):
        distance = mujoco.mj_ray(MODEL, data, origin, direction, VISIBLE_GROUPS, static, -1, geom)
        out.append((distance, int(geom[0, 0]) if distance >= 0 else -1))
    distance, geoms = np.array(out).T
    return distance, geoms.astype(int)


@pytest.mark.parametrize("static", [True, False])
def test_rays_from_one_point_meet_what_mujoco_says(cast, directions, static):
    distance, geom = one_by_one(np.tile(EYE, (600, 1)), directions, static=static)
    found = cast.cast(EYE, directions, static=static)
    np.testing.assert_array_equal(found.geom, geom)
    np.testing.assert_allclose(found.distance, distance, atol=1e-9)
    assert len(set(geom)) == (7 if static else 4)


def test_normals_are_those_of_the_surface(cast, directions):
    found = cast.cast(EYE, directions, static=True)
    point = EYE + found.distance[:, None] * directions
    on = found.geom == 0
    np.testing.assert_allclose(np.abs(found.normal[on]), np.tile([0, 0, 1], (on.sum(), 1)), atol=1e-6)
    data = mujoco.MjData(MODEL)
    data.qpos[:] = HERE
    mujoco.mj_kinematics(MODEL, data)
    on = found.geom == 4
    axes = data.geom_xmat[4].reshape(3, 3)
    slope = (point[on] - data.geom_xpos[4]) @ axes / MODEL.geom_size[4] ** 2 @ axes.T
    slope /= np.linalg.norm(slope, axis=1)[:, None]
    cosine = np.abs(np.sum(slope * found.normal[on], axis=1))
    assert np.median(cosine) > 1 - 1e-8
    assert cosine.min() > 0.99  # at the very rim a ray beside it misses
    met = found.geom >= 0
    np.testing.assert_allclose(np.linalg.norm(found.normal[met], axis=1), 1, atol=1e-9)


@pytest.mark.parametrize("lamp", ["sun", "bulb"])
def test_shadows_are_those_of_rays_from_every_point(cast, rng, lamp):
    start = rng.uniform([-1, -1, 0.01], [1, 1, 0.02], (400, 3))
    if lamp == "sun":
        towards, reach = np.tile(np.array([0.3, -0.2, 1.0]) / np.sqrt(1.13), (400, 1)), np.full(400, np.inf)
    else:
        away = np.array([0.2, 0.1, 0.95]) - start  # inside the figure, which some of its own geoms hide
        reach = np.linalg.norm(away, axis=1)
        towards = away / reach[:, None]
    distance, _ = one_by_one(start, towards, static=False)
    expected = (distance >= 0) & (distance < reach)
    found = cast.blocked(start, towards, reach, static=False)
    assert (found != expected).mean() <= (0.01 if lamp == "sun" else 0.05)  # the sun is 10 km away
    assert expected.mean() > 0.05
    assert not cast.blocked(start[:0], towards[:0], reach[:0], static=False).size


def test_the_batch_is_used_where_there_is_one():
    assert isinstance(caster(MODEL), Batched if has_batch() else Single)
