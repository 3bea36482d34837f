"""Points of a figure, and the spheres that fill its geoms: inside them, as far out as they are, and close."""

import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT, MIXED, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from motions import raw_violations
from oracles import kinematics
from random_models import random_qpos
from scipy.spatial import ConvexHull
from texts import read_data

from dynsplines import Keyframe, build
from dynsplines.clip.build import Clip
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.surface import Ellipsoid, cover
from dynsplines.solver.surface.cover import covering_points, wide_points
from dynsplines.solver.surface.points import DIRECTIONS, Point, all_round, arrays_of, body_points, sets_places

LIMBS_OF_SHAPES = read_data("limbs_of_shapes.xml")


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
    figure = figure_of(LIMBS_OF_SHAPES)
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
    found = sets_places(figure, np.array([*told, np.ones(model.nq, bool)]), points)
    np.testing.assert_array_equal(found[:, -1], True)
    np.testing.assert_array_equal(found[:, :-1], ~np.array(moves).T)


SEEDS = st.integers(0, 10_000)
CORNERS = "0 0 0 .3 0 0 0 .2 0 0 0 .4 .3 .2 .1 .1 .1 .5"
ONE = """<mujoco><asset><mesh name="m" vertex="{corners}"/></asset><worldbody><body><freejoint/>
  <geom name="g" {geom}/></body><body mocap="true"><geom name="point" size="1e-6"/></body></worldbody></mujoco>"""

FLAT = """<mujoco><asset><mesh name="m" inertia="shell" vertex="0 0 0 1 0 0 0 1 0 1 1 0" face="0 1 2 1 3 2"/></asset>
  <worldbody><geom type="mesh" mesh="m" contype="0" conaffinity="0"/></worldbody></mujoco>"""


def one(kind: str, *size: float) -> mujoco.MjModel:
    shape = f'type="{kind}" ' + ('mesh="m"' if kind == "mesh" else f'size="{" ".join(map(str, size))}"')
    return mujoco.MjModel.from_xml_string(ONE.format(geom=shape, corners=CORNERS))


def spheres(kind: str, *size: float, gap: float = cover.GAP) -> tuple[Array, Array]:
    return cover.filling_spheres(one(kind, *size), 0, gap)


def cylinder_distance(radius: float, half: float, points: Array) -> Array:
    flat = np.column_stack([np.linalg.norm(points[:, :2], axis=1), points[:, 2]])
    over = np.abs(flat) - [radius, half]
    return np.linalg.norm(np.maximum(over, 0), axis=1) + np.minimum(over.max(axis=1), 0)


def uncovered(points: Array, centres: Array, radii: Array) -> Array:
    """How far points (n, 3) are from the nearest sphere, 0 in one, (n,) [m]."""
    apart = np.linalg.norm(points[:, None] - centres, axis=2) - radii
    return np.maximum(apart.min(axis=1), 0)


def on_ball(rng: np.random.Generator, count: int) -> Array:
    ways = rng.normal(size=(count, 3))
    return ways / np.linalg.norm(ways, axis=1, keepdims=True)


def test_what_encloses_nothing_is_filled_by_nothing():
    plane = mujoco.MjModel.from_xml_string('<mujoco><worldbody><geom type="plane" size="1 1 1"/></worldbody></mujoco>')
    centres, radii = cover.filling_spheres(plane, 0)
    assert centres.shape == (0, 3)
    assert radii.shape == (0,)
    flat = mujoco.MjModel.from_xml_string(FLAT)
    assert cover.filling_spheres(flat, 0)[0].shape == (0, 3)


SHAPES = [("sphere", (0.1,)), ("capsule", (0.05, 0.4)), ("cylinder", (0.1, 0.3)), ("cylinder", (0.3, 0.05))]
SHAPES += [("box", (0.1, 0.2, 0.3)), ("box", (0.3, 0.4, 0.02)), ("mesh", ())]


@pytest.mark.parametrize(("kind", "size"), SHAPES)
def test_the_spheres_of_a_geom_are_inside_it_and_touch_it_from_there(kind, size):
    """MuJoCo computes the distances of their centres, and those of points at edges."""
    model, gaps = one(kind, *size), []
    centres, radii = spheres(kind, *size)
    data, (point, geom) = mujoco.MjData(model), (model.geom(name).id for name in ("point", "g"))
    mujoco.mj_kinematics(model, data)
    turn, place = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
    for centre, radius in zip(centres, radii, strict=True):
        data.mocap_pos[0] = place + turn @ centre
        mujoco.mj_kinematics(model, data)
        gaps.append(mujoco.mj_geomDistance(model, data, point, geom, 1, None) + 1e-6 + radius)
    assert max(gaps) < 2e-6
    assert np.count_nonzero(np.abs(gaps) < 2e-6) >= min(8, len(gaps))


@pytest.mark.parametrize("radius", [0.06, 0.1, 0.25])
def test_a_rail_anywhere_in_a_barrel_meets_its_spheres(radius, rng):
    half = rng.uniform(0.6, 1.5) * radius
    centres, radii = spheres("cylinder", radius, half)
    points = rng.uniform(-1, 1, (20_000, 3)) * [radius, radius, half]
    deep = points[cylinder_distance(radius, half, points) < -0.012]  # [m]
    gaps = [(np.linalg.norm(part[:, None] - centres, axis=2) - radii).min(axis=1) for part in np.array_split(deep, 20)]
    assert np.concatenate(gaps).max() < 0.012 and len(deep) > 5000


@settings(deadline=None, max_examples=50)
@given(st.floats(0.05, 0.3), st.floats(0.05, 0.3), st.floats(0.05, 0.3), SEEDS)
def test_no_line_parallel_to_an_edge_of_a_box_slips_through_it(a, b, c, seed):
    """A line of no thickness, 2 cm inside the box or deeper."""
    half, rng = np.array([a, b, c]), np.random.default_rng(seed)
    centres, radii = spheres("box", *half)
    axis = rng.integers(3)
    others = np.delete(np.arange(3), axis)
    place = rng.uniform(-1, 1, 2) * (half[others] - 0.02)
    assert np.min(np.linalg.norm(centres[:, others] - place, axis=1) - radii) < 0


EGGS = [(0.1, 0.5, 0.2), (0.3, 0.3, 0.02), (0.2, 0.2, 0.2), (0.05, 0.06, 0.4), (0.5, 0.1, 0.11)]


@pytest.mark.parametrize("half", EGGS)
def test_an_ellipsoids_spheres_touch_it_from_inside_and_leave_little_more_than_the_gap(half, rng):
    centres, radii = spheres("ellipsoid", *half)
    egg = Ellipsoid("egg", np.zeros(3), np.eye(3), np.array(half))
    np.testing.assert_allclose(-egg.distance(centres.T)[0], radii, atol=1e-9)
    assert np.all(np.abs(centres).min(axis=1) < 1e-12), "all of them are in the plane of its two longer axes"
    assert min(half) - radii.max() < cover.GAP
    a, _, c = sorted(half, reverse=True)
    assert np.abs(centres).max() == pytest.approx((a**2 - c**2) / a, rel=0.01, abs=1e-12)
    shell = on_ball(rng, 3000)
    middle = np.abs(shell[:, np.argsort(half)[1:]]).max(axis=1) < 1 / 3  # its ends are thinner, and as sparse
    assert uncovered(np.array(half) * shell[middle], centres, radii).max() <= 2.2 * cover.GAP


def mesh(vertices: Array) -> mujoco.MjModel:
    text = " ".join(map(str, np.round(vertices, 6).ravel()))
    return mujoco.MjModel.from_xml_string(ONE.format(geom='type="mesh" mesh="m"', corners=text))


def cuboid(*half: float) -> Array:
    return np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T * half


MESHES = {
    "wedge": np.array(CORNERS.split(), float).reshape(-1, 3),
    "plate": cuboid(0.3, 0.2, 0.01),
    "cube": cuboid(0.1, 0.1, 0.1),
    "sheet": cuboid(0.1, 0.05, 0.002),
    "cloud": np.random.default_rng(5).normal(size=(300, 3)) * [0.1, 0.06, 0.03],
    "ball": 0.2 * on_ball(np.random.default_rng(6), 500),
}


@pytest.mark.parametrize("name", MESHES)
def test_spheres_in_a_mesh_are_inside_its_convex_hull_and_cover_it(name):
    """SciPy computes the hull. Coverage: every point on the hull is near a sphere."""
    model = mesh(MESHES[name])
    vertices = np.array(model.mesh_vert, float)
    hull, size = ConvexHull(vertices), np.linalg.norm(np.ptp(vertices, axis=0))
    centres, radii = cover.filling_spheres(model, 0)
    over = centres @ hull.equations[:, :3].T + hull.equations[:, 3]
    assert np.max(over.max(axis=1) + radii) < 1e-5
    rng, pace = np.random.default_rng(3), max(cover.CLOSEST, size / cover.FINEST)
    corners = vertices[hull.simplices[rng.integers(len(hull.simplices), size=500)]]
    spots = np.einsum("sk,ski->si", rng.dirichlet(np.ones(3), 500), corners)
    assert uncovered(spots, centres, radii).max() <= 0.8 * pace
    assert np.median(uncovered(spots, centres, radii)) <= 0.01 * size
    assert len(centres) < 2000


PLATE = """<mujoco><asset><mesh name="plate" vertex="{corners}"/></asset><worldbody>
  <geom name="floor" type="plane" size="0 0 1"/>
  <geom name="pole" type="capsule" size=".02" fromto="{x} {y} 0 {x} {y} .6"/>
  <body name="plate" pos="0 0 1"><joint name="height" type="slide" axis="0 0 1"/>
  <geom name="plate" type="mesh" mesh="plate"/></body></worldbody></mujoco>"""


def depths(clip: Clip, geom: str, obstacle: str) -> tuple[float, float]:
    """The depth [m] of a geom in an obstacle in the second keyframe by MuJoCo, and that of the only violation."""
    model = clip.figure.model
    data = kinematics(model, clip.figure.to_qpos(clip.keys[1].state[None])[0])
    (violation,) = (each for each in raw_violations(clip) if each.kind == "penetration")
    assert violation.name == geom
    distance = mujoco.mj_geomDistance(model, data, model.geom(geom).id, model.geom(obstacle).id, 1, None)
    return -distance, violation.amount


@pytest.mark.parametrize(("half", "x", "y"), [((0.3, 0.2, 0.01), 0.07, 0.07), ((0.3, 0.3, 0.1), 0.0, 0.0)])
def test_a_pole_in_a_mesh_plate_is_a_violation_as_deep_as_mujoco_computes(half, x, y):
    corners = " ".join(map(str, cuboid(*half).ravel()))
    heights = (0.2, half[2] - 0.4 - 0.01 + 0.02 - 0.005, 0.2)
    keyframes = [Keyframe(t, joints={"height": z}) for t, z in zip((0, 0.5, 1), heights, strict=True)]
    expected, reported = depths(build(PLATE.format(corners=corners, x=x, y=y), keyframes), "plate", "pole")
    assert 0.01 < expected < 0.02
    assert expected - 0.006 < reported < expected + 0.001


FOOT = """<mujoco><asset><mesh name="foot" vertex="{corners}"/></asset><worldbody>
  <geom name="floor" type="plane" size="0 0 1"/><body name="foot" pos="0 0 1"><freejoint name="root"/>
  <geom name="foot" {shape}/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(("half", "depth"), [((0.1, 0.045, 0.045), 0.08), ((0.1, 0.045, 0.03), 0.025)])
@pytest.mark.parametrize("shape", ['type="mesh" mesh="foot"', 'type="box" size="{size}"'])
def test_the_edge_of_a_step_in_a_foot_between_its_corners_is_a_violation(half, depth, shape):
    """A foot pitched by 45°, with the edge across the middle of its sole, as deep in it as MuJoCo computes."""
    corners, size = (" ".join(map(str, values)) for values in (cuboid(*half).ravel(), half))
    at = np.array([0.5, 0, 0.3]) + np.array([-1, 0, 1]) * np.sqrt(0.5) * (half[2] - depth)
    away, turn = np.array([-0.3, 0, 0.6]), {"rotvec": [0, -45, 0]}
    keyframes = [
        Keyframe(t, roots={"root": {"position": list(place), "rotation": turn}})
        for t, place in ((0, at + away), (0.5, at), (1, at + away))
    ]
    xml = FOOT.format(corners=corners, shape=shape.format(size=size))
    clip = build(xml, keyframes, scene={"step": {"x": 0.5, "height": 0.3}})
    expected, reported = depths(clip, "foot", "step")
    assert expected == pytest.approx(depth, abs=1e-3)
    assert 0.6 * expected < reported < expected + 0.001


@pytest.mark.parametrize(
    ("kind", "half", "count"),
    [
        ("box", (0.019, 0.0205, 0.01), "none"),  # length plus width of the largest face: 0.079 m
        ("box", (0.0205, 0.01, 0.021), "few"),
        ("box", (0.021, 0.0205, 0.009), "none"),  # too thin
        ("box", (0.08, 0.069, 0.03), "few"),  # 0.298 m
        ("box", (0.03, 0.08, 0.071), "all"),
        ("box", (0.08, 0.071, 0.009), "all"),
        ("cylinder", (0.015, 0.0245), "none"),
        ("cylinder", (0.015, 0.026), "few"),
        ("cylinder", (0.0205, 0.015), "few"),
        ("cylinder", (0.05, 0.101), "all"),
        ("capsule", (0.2, 0.5), "none"),
    ],
)
def test_an_edge_may_enter_wide_shapes_anywhere_and_smaller_ones_by_5_mm(kind, half, count):
    points = wide_points(figure_of(ONE_SHAPE.format(kind, " ".join(map(str, half)))))
    centres, radii = spheres(kind, *half, gap={"all": cover.GAP}.get(count, cover.STEP_GAP))
    expected = centres[radii >= (0 if count == "all" else cover.THIN)] + [0.1, 0, 0]
    positions = np.array([point.position for point in points]).reshape(-1, 3)
    assert len(positions) == (0 if count == "none" else len(np.unique(expected, axis=0)))
    assert all(np.abs(expected - place).max(axis=1).min() < 1e-9 for place in positions)


PAIR = read_data("mesh_pair.xml")


def test_the_points_of_a_figure_are_the_spheres_of_its_geoms_where_mujoco_has_them(rng):
    model = mujoco.MjModel.from_xml_string(PAIR)
    figure, data = Figure(model), kinematics(model, rng.normal(size=model.nq))
    points = covering_points(figure)
    assert {point.name for point in points} == {"trunk", "pack", "arm", "hand"}, "inner is inside, others no part"
    trunk, arm = ("trunk", "trunk"), ("arm", "shoulder")
    for name, (body, joint) in {"trunk": trunk, "pack": trunk, "arm": arm, "hand": arm}.items():
        geom = model.geom(name).id
        centres, _ = cover.filling_spheres(model, geom)
        expected = data.geom_xpos[geom] + centres @ data.geom_xmat[geom].reshape(3, 3).T
        own = [point for point in points if point.name == name]
        assert {figure.links[point.link].name for point in own} == {joint}
        link = model.body(body).id
        found = np.array([data.xpos[link] + data.xmat[link].reshape(3, 3) @ point.position for point in own])
        assert len(found) > 2
        apart = np.linalg.norm(found[:, None] - expected, axis=2)
        assert apart.min(axis=1).max() < 1e-9
