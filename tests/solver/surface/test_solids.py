"""Spheres, capsules, cylinders, ellipsoids, boxes, meshes and height fields against MuJoCo's distances and rays."""

import mujoco
import numpy as np
import pytest
from gradients import taylor_slope
from motions import raw_violations
from oracles import distance_of_ball, kinematics, tells_height_fields
from scipy.optimize import nnls
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import Keyframe, build
from dynsplines.solver.array import Array, Index
from dynsplines.solver.surface import Box, HeightField, Hull, Surface, hull, hull_of, static_surfaces
from dynsplines.solver.surface.height_field import from_triangle
from dynsplines.solver.surface.solid import Solid
from dynsplines.solver.surface.surface import DEEP

rough = np.random.default_rng(3)
ELEVATION = " ".join(f"{z:.3f}" for z in rough.uniform(0, 1, 42))
CLOUD = " ".join(f"{x:.3f}" for x in rough.normal(size=90) * np.tile([0.3, 0.2, 0.25], 30))
WEDGE = "-.4 -.3 0 .4 -.3 0 .4 .3 0 -.4 .3 0 .4 -.3 .3 .4 .3 .3"

SCENE = read_data("solids.xml").format(CLOUD=CLOUD, WEDGE=WEDGE, ELEVATION=ELEVATION)
MODEL = mujoco.MjModel.from_xml_string(SCENE)
SURFACES: dict[str, Surface] = {surface.name: surface for surface in static_surfaces(MODEL)}
CONVEX = [name for name in SURFACES if name != "ground"]
SOLIDS = [name for name in SURFACES if name != "crate"]
GROUND = SURFACES["ground"]


def about(name: str, rng: np.random.Generator, count: int) -> Array:
    """Points (3, count, 1) about a geom, inside and outside."""
    box = MODEL.geom_aabb[MODEL.geom(name).id]
    data = kinematics(MODEL)
    local = box[:3] + rng.uniform(-1.4, 1.4, (count, 3)) * box[3:]
    world = data.geom(name).xpos + local @ data.geom(name).xmat.reshape(3, 3).T
    return world.T[:, :, None]


def signed(surface: Surface, points: Array) -> Array:
    """Signed distance of points (3, n, 1) through the depth of spheres that reach them all, (n,)."""
    radius = np.full(points.shape[1], 5.0)
    return 5.0 - surface.depth(points, radius)[0][:, 0]


@pytest.mark.parametrize("name", CONVEX)
def test_distances_inside_and_outside_are_mujocos_and_the_cheap_bound_is_no_longer(name, rng):
    points = about(name, rng, 60)
    expected = np.array([0.15 + distance_of_ball(MODEL, name, p) for p in points[:, :, 0].T])
    assert expected.min() < -0.01
    assert expected.max() > 0.01
    surface = SURFACES[name]
    inside = surface.inside(points)[:, 0]
    if name == "crate":  # whose depth counts sides four times
        np.testing.assert_allclose(inside, np.maximum(-expected, 0), atol=2e-6)
        return
    found = signed(surface, points)
    shallow = expected > -0.1  # what MuJoCo says of the depth of an ellipsoid is good to millimetres
    np.testing.assert_allclose(found[shallow], expected[shallow], atol=2e-6)
    np.testing.assert_allclose(found, expected, atol=3e-3 if name == "egg" else 2e-6)
    np.testing.assert_allclose(inside, np.maximum(-found, 0), atol=1e-12)
    assert isinstance(surface, Solid)
    assert np.all(surface.least(points[:, :, 0]) <= found + 1e-12)


@pytest.mark.parametrize("name", SOLIDS)
def test_the_gradient_of_depth_has_taylor_slope_two_and_length_one(name, rng):
    points = about(name, rng, 24)
    radius, surface = rng.uniform(0.2, 0.6, 24), SURFACES[name]
    depth, gradient = surface.depth(points, radius)
    assert np.count_nonzero(depth) > 8
    np.testing.assert_allclose(np.linalg.norm(gradient, axis=0), depth > 0, atol=1e-9)
    for k in np.flatnonzero(depth[:, 0] > 0.01):
        slope = taylor_slope(
            lambda p, k=k: float(surface.depth(p, radius[k : k + 1])[0][0, 0]),
            points[:, k : k + 1],
            gradient[:, k : k + 1],
            rng,
        )
        assert slope > 1.9


@pytest.mark.parametrize("name", SOLIDS)
def test_a_height_is_that_over_the_top_which_a_ray_finds(name, rng):
    points = about(name, rng, 250)
    found = SURFACES[name].height(points)[:, 0]
    data, geom = kinematics(MODEL), MODEL.geom(name).id
    hits = 0
    for point, height in zip(points[:, :, 0].T, found, strict=True):
        down, up = (_ray(data, geom, np.array([*point[:2], z]), side) for z, side in ((9.0, -1.0), (-9.0, 1.0)))
        top, bottom = 9 - down, -9 + up
        if down > 0 and (name == "ground" or point[2] > max(bottom, top - DEEP)):
            assert height == pytest.approx(point[2] - top, abs=1e-5)
            hits += 1
        else:
            assert height == np.inf
    assert hits > 20


@pytest.mark.parametrize("name", SOLIDS)
def test_the_way_up_is_the_gradient_of_the_height(name, rng):
    surface, h = SURFACES[name], 1e-6
    points = about(name, rng, 400)[:, :, 0]
    points[2] += 5.0

    def height(moved: Array) -> Array:
        return surface.height(moved[:, :, None])[:, 0]

    ways = np.eye(3)[:, :, None]
    points = points[
        :, np.all([np.isfinite(height(points + 1e-3 * direction)) for direction in (*ways, *-ways)], axis=0)
    ]
    slopes, wider = (
        np.array(
            [(height(points + step * direction) - height(points - step * direction)) / (2 * step) for direction in ways]
        )
        for step in (h, 100 * h)
    )
    smooth = np.all(np.abs(slopes - wider) < 1e-3, axis=0) & (np.linalg.norm(slopes, axis=0) < 5)
    assert smooth.sum() > 15
    np.testing.assert_allclose(surface.up(points[:, smooth]), slopes[:, smooth], atol=1e-5)


def _ray(data: mujoco.MjData, geom: int, start: Array, side: float) -> float:
    direction = np.array([0, 0, side])
    kind = MODEL.geom_type[geom]
    if kind == mujoco.mjtGeom.mjGEOM_HFIELD:
        return mujoco.mj_rayHfield(MODEL, data, geom, start, direction)
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        return mujoco.mj_rayMesh(MODEL, data, geom, start, direction)
    return mujoco.mju_rayGeom(data.geom_xpos[geom], data.geom_xmat[geom], MODEL.geom_size[geom], start, direction, kind)


@tells_height_fields
def test_spheres_whose_centres_are_over_a_height_field_are_as_deep_as_mujoco_computes(rng):
    points = about("ground", rng, 600)
    over = GROUND.height(points)[:, 0]
    points = points[:, np.isfinite(over) & (over > 0)]
    expected = [0.15 + distance_of_ball(MODEL, "ground", p, reach=0.4) for p in points[:, :, 0].T]
    np.testing.assert_allclose(np.minimum(signed(GROUND, points), 0.55), expected, atol=1e-6)
    assert np.count_nonzero(np.array(expected) < 0.15) > 40


def test_under_a_height_field_the_nearest_triangle_or_wall_is_the_way_out(rng):
    assert isinstance(GROUND, HeightField)
    points = about("ground", rng, 300)
    local = GROUND.axes.T @ (points[:, :, 0] - GROUND.centre[:, None])
    over, wall = GROUND.height(points)[:, 0], np.max(np.abs(local[:2]) - GROUND.half[:, None], axis=0)
    rows, columns = GROUND.elevation.shape
    nearest = np.full(300, np.inf)
    for r in range(rows - 1):
        for c in range(columns - 1):
            for corners in GROUND._triangles(np.full(300, c), np.full(300, r)):
                nearest = np.minimum(nearest, np.linalg.norm(from_triangle(local, *corners), axis=0))
    below = over < 0
    assert np.count_nonzero(below) > 40
    np.testing.assert_allclose(GROUND.inside(points)[below, 0], np.minimum(nearest, -wall)[below], atol=1e-9)
    assert not GROUND.inside(points)[~below].any()


HILL = """<mujoco><asset><hfield name="hill" nrow="9" ncol="9" size="2 2 .3 .1" elevation="{elevation}"/>
  <mesh name="cube" vertex="{corners}"/></asset><worldbody><geom name="hill" type="hfield" hfield="hill"/>
  <body name="cube" pos="0 0 1"><freejoint name="root"/><geom name="cube" {shape}/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("shape", ['type="mesh" mesh="cube"', 'type="box" size=".1 .1 .1"'])
def test_a_cube_in_a_hill_is_a_violation_as_deep_as_the_hill_is_high_over_its_bottom(shape):
    """MuJoCo measures the height of the hill with a ray."""
    heights = np.exp(-np.add.outer(np.linspace(-1, 1, 9) ** 2, np.linspace(-1, 1, 9) ** 2) / 0.2)
    corners = 0.1 * np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
    elevation, text = (" ".join(map(str, np.round(values, 4).ravel())) for values in (heights, corners))
    keyframes = [Keyframe(t, roots={"root": {"position": [x, 0, 0.2]}}) for t, x in ((0, -1.4), (0.5, 0), (1, 1.4))]
    clip = build(HILL.format(elevation=elevation, corners=text, shape=shape), keyframes)
    model, data = clip.figure.model, kinematics(clip.figure.model)
    top = 1 - mujoco.mj_rayHfield(model, data, model.geom("hill").id, np.array([0, 0, 1.0]), np.array([0, 0, -1.0]))
    listed = [each for each in raw_violations(clip) if each.kind == "penetration"]
    assert [violation.name for violation in listed] == ["cube"]
    assert listed[0].amount == pytest.approx(top - 0.1, rel=0.05)


@pytest.mark.parametrize("along", [0, 1])
def test_over_a_slope_of_uneven_cells_a_sphere_is_deep_as_soon_as_it_reaches_the_plane(along, rng):
    """Cells are 2 m by 0.2 m, and the ground rises 1 m a cell along either: by hand a plane of slope 1/2, or 5."""
    rise, slope = (np.arange(4.0)[:, None], 5.0) if along else (np.arange(5.0), 0.5)
    field = HeightField("slope", np.zeros(3), np.eye(3), np.array([4.0, 0.3]), np.broadcast_to(rise, (4, 5)))
    foot = rng.uniform(-0.6, 0.6, (2, 40)) * field.half[:, None]
    ground = np.array([*foot, rise.max() / 2 + slope * foot[along]])
    normal = np.array([*(-slope * np.eye(2)[along]), 1.0]) / np.hypot(1, slope)
    away = rng.uniform(0.01, 0.1, 40)
    points = (ground + away * normal[:, None])[:, :, None]
    depth, gradient = field.depth(points, away + 0.001)
    np.testing.assert_allclose(depth, 0.001, atol=1e-9)
    np.testing.assert_allclose(gradient[:, :, 0], np.repeat(-normal[:, None], 40, axis=1), atol=1e-9)
    assert field.near(points, (away + 0.001)[:, None]).all()
    assert not field.depth(points, away - 0.001)[0].any()


def test_a_sphere_whose_centre_is_on_level_ground_is_pushed_up_by_its_radius():
    field = HeightField("level", np.zeros(3), np.eye(3), np.ones(2), np.full((3, 3), 0.5))
    depth, gradient = field.depth(np.array([[[0.1]], [[0.2]], [[0.5]]]), np.array([0.3]))
    np.testing.assert_allclose(depth, 0.3)
    np.testing.assert_allclose(gradient[:, 0, 0], [0, 0, -1])


def test_the_way_from_a_triangle_is_that_from_the_nearest_mixture_of_its_corners(rng):
    corners, points = rng.normal(size=(3, 3, 200)), 2 * rng.normal(size=(3, 200))
    points[:, ::7] = corners[0][:, ::7]  # at a corner itself there is no way
    found = from_triangle(points, *corners)
    for k in range(200):
        sides = corners[:, :, k].T
        far = 1e4  # what the shares of the corners weigh that are not 1 in all
        shares, _ = nnls(np.vstack([sides, far * np.ones(3)]), np.append(points[:, k], far))
        np.testing.assert_allclose(found[:, k], points[:, k] - sides @ shares / shares.sum(), atol=1e-5)
    kinds = [np.count_nonzero(np.abs(found[:, k] @ (corners[1] - corners[0])[:, k]) < 1e-9) for k in range(200)]
    assert 10 < sum(kinds) < 190  # some are over the inside, some beyond an edge


CUBE_CORNERS = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]).T


def of_points(vertices: Array, buried: bool = False) -> Hull:
    """The hull of points (n, 3)."""
    found = hull_of(vertices)
    assert found is not None
    return Hull("rock", *found, buried)


CUBE, SUNK = of_points(CUBE_CORNERS.T), of_points(CUBE_CORNERS.T, buried=True)


def one(hull: Hull, *place: float) -> tuple[float, Array]:
    distance, outward = hull.distance(np.reshape(place, (3, 1)).astype(float))
    return float(distance[0]), outward[:, 0]


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
    points = rng.normal(size=(3, 50)) * 3
    distance, outward = CUBE.distance(points)
    for most in (1, 100, 10**6):
        monkeypatch.setattr(hull, "ENTRIES_AT_ONCE", most)
        again, direction = CUBE.distance(points)
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


@pytest.mark.parametrize("turn", [[0, 0, 0], [0.4, -0.3, 0.8], [np.pi / 2, 0, 0], [2.0, 1.0, -0.5]])
def test_the_height_over_a_box_is_that_over_its_uppermost_face_along_its_normal(turn, rng):
    for buried in (False, True):
        box = Box("box", np.array([0.2, -0.1, 0.4]), Rotation.from_rotvec(turn).as_matrix(), HALF, buried)
        top = int(np.argmax(np.abs(box.axes[2])))
        sign = np.sign(box.axes[2, top])
        share = rng.uniform(-1.2, 1.2, size=(3, 100))
        share[top] = sign * rng.uniform(-2.9, 3.0, size=100)
        points = box.centre[:, None] + box.axes @ (share * HALF[:, None])
        over = np.abs(np.delete(share, top, axis=0)).max(axis=0) <= 1
        over &= buried | (sign * share[top] > -1)
        height = HALF[top] * (sign * share[top] - 1)
        expected = np.where(over & (height >= -DEEP), height, np.inf)
        np.testing.assert_allclose(box.height(points), expected, atol=1e-12)
        np.testing.assert_allclose(box.up(points), np.tile(sign * box.axes[:, [top]], 100))
