"""Points of a figure: where MuJoCo has sites, spheres that reach as far as its shapes, what keyframes tell of them."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT, LEG, MIXED, figure_of
from oracles import kinematics
from random_models import random_qpos

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import (
    DIRECTIONS,
    Point,
    all_round,
    arrays_of,
    body_points,
    placed,
    places_of,
    site_points,
)

SHAPES = """
<mujoco><worldbody><body name="trunk" pos="0 0 1"><freejoint/>
  <geom name="ball" type="sphere" size=".12" pos="0 0 .5"/>
  <geom name="bone" type="capsule" size=".05" fromto="0 0 0 .1 0 .4"/>
  <geom name="chest" type="box" size=".2 .1 .15" pos="0 .1 .2" euler="20 30 10"/>
  <body name="arm" pos="0 .3 .3" quat=".9 .1 -.2 .3"><joint type="ball"/>
    <geom name="upper" type="capsule" size=".03" fromto="0 0 0 0 0 -.4"/>
    <body name="cuff" pos=".1 0 -.4" quat=".8 .1 .2 0"><geom name="cuff" type="box" size=".04 .05 .1"/></body></body>
</body></worldbody></mujoco>"""


def reach(model: mujoco.MjModel, figure: Figure, link: int, ways: Array) -> Array:
    """How far spheres, capsules and boxes of a link reach in directions (3, d) of the link's axes, in closed form."""
    found = np.full(ways.shape[1], -np.inf)
    for geom in range(model.ngeom):
        body = int(model.geom_bodyid[geom])
        if figure.body_link[body] != link:
            continue
        ends = np.vstack([model.geom_pos[geom], model.geom_pos[geom] + _matrix(model.geom_quat[geom]).T])
        middle, *tips = figure.point_on_link(body, ends)[1]
        across = np.abs((np.array(tips) - middle) @ ways)  # of the geom's own axes
        size, kind = model.geom_size[geom], model.geom_type[geom]
        more = {
            int(mujoco.mjtGeom.mjGEOM_SPHERE): size[0],
            int(mujoco.mjtGeom.mjGEOM_CAPSULE): size[0] + size[1] * across[2],
            int(mujoco.mjtGeom.mjGEOM_BOX): size @ across,
        }[int(kind)]
        found = np.maximum(found, middle @ ways + more)
    return found


def _matrix(quat: Array) -> Array:
    out = np.zeros(9)
    mujoco.mju_quat2Mat(out, quat)
    return out.reshape(3, 3)


def test_the_spheres_of_a_body_reach_as_far_as_its_shapes_in_every_direction():
    figure = figure_of(SHAPES)
    points = body_points(figure)
    for link in (1, 2):
        links, positions, radii = arrays_of([point for point in points if point.link == link])
        assert set(links.tolist()) == {link}
        ways = all_round(DIRECTIONS)
        np.testing.assert_allclose(np.linalg.norm(ways, axis=0), 1)
        own = (positions.T @ ways + radii[:, None]).max(axis=0)
        np.testing.assert_allclose(own, reach(figure.model, figure, link, ways), atol=1e-9)
        between = all_round(917)
        short = reach(figure.model, figure, link, between) - (positions.T @ between + radii[:, None]).max(axis=0)
        assert short.min() > -1e-9
        assert short.max() < 2e-3


ONE_SHAPE = """
<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom name="it" type="{}" size="{}" pos=".1 0 0"/></body></worldbody>
</mujoco>"""


@pytest.mark.parametrize("radius", [0.02, 0.1, 0.3])
def test_a_cylinders_rim_is_as_low_as_its_points_within_2_mm(radius, rng):
    points = body_points(figure_of(ONE_SHAPE.format("cylinder", f"{radius} .5")))
    places = np.array([point.position for point in points]) - [0.1, 0, 0]
    assert {point.radius for point in points} == {0}
    for direction in rng.normal(size=(200, 3)):
        direction /= np.linalg.norm(direction)
        support = radius * np.hypot(*direction[:2]) + 0.5 * abs(direction[2])
        assert support - 0.002 - 1e-9 <= (places @ direction).max() <= support + 1e-9


def test_a_small_meshs_points_are_its_vertices():
    vertices = np.array([[0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.4], [0.3, 0.2, 0.4]])
    asset = f'<asset><mesh name="it" vertex="{" ".join(map(str, vertices.ravel()))}"/></asset>'
    geom = '<geom type="mesh" mesh="it" pos=".1 0 0" euler="0 0 90"/>'
    text = f"<mujoco>{asset}<worldbody><body><freejoint/>{geom}</body></worldbody></mujoco>"
    _, positions, radii = arrays_of(body_points(figure_of(text)))
    expected = vertices @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]) + [0.1, 0, 0]
    np.testing.assert_allclose(np.unique(positions.T.round(6), axis=0), np.unique(expected, axis=0), atol=1e-6)
    assert not radii.any()


LIMB = """
<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom name="limb" type="capsule" size=".03" fromto="0 0 .1 0 0 -.3"/>
  <geom name="lump" type="sphere" size="{size}" pos="0 0 {z}"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("size", "z", "both"), [(0.01, -0.1, True), (0.2, -0.3, False), (0.2, 0.1, False), (0.5, -0.1, None)]
)
def test_along_a_capsule_whose_ends_both_stick_out_are_spheres_closer_than_their_radius_and_along_others_none(
    size, z, both
):
    points = [point for point in body_points(figure_of(LIMB.format(size=size, z=z))) if point.name == "limb"]
    if not both:
        assert len(points) == (0 if both is None else 1)
        return
    assert {point.radius for point in points} == {0.03}
    own = np.array([point.position for point in points])
    along = np.sort(own[:, 2])
    np.testing.assert_allclose(along[[0, -1]], [-0.3, 0.1], atol=1e-12)
    np.testing.assert_allclose(own[:, :2], 0, atol=1e-12)
    gaps = np.diff(along)
    np.testing.assert_allclose(gaps, gaps[0])
    assert 0.75 * 0.03 <= gaps[0] < 0.8 * 0.03


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_points_at_sites_are_where_mujoco_has_the_sites(coordinates, rng):
    figure = figure_of(LEG, coordinates)
    points = site_points(figure, ["toe", "heel"])
    assert [point.name for point in points] == ["toe", "heel"]
    with pytest.raises(KeyError, match=r"heel.*toe"):
        site_points(figure, ["knee"])
    qpos = np.array([random_qpos(figure, rng) for _ in range(4)])
    state = figure.to_state(qpos)
    samples = Samples(figure, state, 0 * state, 0 * state)
    links, positions, radii = arrays_of(points)
    _, arms = samples.links.points(links, positions)
    centres, sizes = places_of(points, samples)
    np.testing.assert_array_equal(sizes, radii)
    for k, pose in enumerate(qpos):
        data = kinematics(figure.model, pose)
        np.testing.assert_allclose(centres[:, :, k].T, [data.site(name).xpos for name in ("toe", "heel")], atol=1e-9)
        origins = centres[:, :, k] - arms[:, :, k]
        np.testing.assert_allclose(
            origins.T, kinematics(figure.model, pose).xpos[[figure.links[i].body for i in links]], atol=1e-9
        )


@pytest.mark.parametrize("text", [MIXED, EVERY_JOINT])
def test_a_keyframe_specifies_where_a_point_is_if_it_tells_all_that_moves_it(text, rng):
    """Whatever is not told may be anything: the point moves with it, by MuJoCo's Jacobian, unless all of it is told."""
    figure = figure_of(text, "joint")
    model = figure.model
    data = kinematics(model, random_qpos(figure, rng))
    last = [i for i, link in enumerate(figure.links) if i and figure.body_link[link.body] == i]
    points = [Point(figure.links[i].name, i, rng.normal(size=3)) for i in last]
    sizes = {mujoco.mjtJoint.mjJNT_FREE: (7, 6), mujoco.mjtJoint.mjJNT_BALL: (4, 3)}
    told, moves = [], []
    for joint in range(model.njnt):
        columns, dofs = sizes.get(mujoco.mjtJoint(model.jnt_type[joint]), (1, 1))
        mask = np.ones(model.nq, bool)
        mask[model.jnt_qposadr[joint] + rng.integers(columns)] = False
        told.append(mask)
        own = model.jnt_dofadr[joint] + np.arange(dofs)
        row = []
        for point in points:
            turn, way = np.zeros((2, 3, model.nv))
            mujoco.mj_jacBody(model, data, way, turn, figure.links[point.link].body)
            row.append(bool(way[:, own].any() or turn[:, own].any()))
        moves.append(row)
    found = placed(figure, np.array([*told, np.ones(model.nq, bool)]), points)
    np.testing.assert_array_equal(found[:, -1], True)
    np.testing.assert_array_equal(found[:, :-1], ~np.array(moves).T)
