"""Signed distances to surfaces, static geoms, and what touches them."""

import mujoco
import numpy as np
import pytest
from gradients import taylor_slope
from oracles import distance_of_ball
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines.clip.load import obstacles
from dynsplines.clip.table import SceneTable
from dynsplines.scene.compose import compose
from dynsplines.solver.surface import (
    Box,
    Capsule,
    Cylinder,
    HeightField,
    Hull,
    Plane,
    Surface,
    hull_of,
    static_surfaces,
)
from dynsplines.solver.surface import heights as terrain
from dynsplines.solver.surface.static import DOWN
from dynsplines.solver.surface.surface import DEEP, GROUNDED
from dynsplines.solver.surface.touch import SCENERY, can_collide, counts_all, grounds, movers, overlapping_pairs, solids

SCENE = read_data("surfaces.xml")


@pytest.fixture(scope="module")
def scene() -> tuple[mujoco.MjModel, dict]:
    model = mujoco.MjModel.from_xml_string(SCENE)
    return model, {surface.name: surface for surface in static_surfaces(model)}


def mujoco_depth(model: mujoco.MjModel, name: str, centre: np.ndarray) -> float:
    """How deep the ball at this place is in the named geom, by MuJoCo; 0 outside."""
    return max(-distance_of_ball(model, name, centre), 0.0)


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


HAIR = 1e-5


WEDGE = "0 0 0  1 0 0  0 1 0  0 0 1"


def surfaces(*geoms: str, assets: str = "", floor: str = '<geom name="floor" type="plane" size="9 9 1"/>') -> dict:
    text = f"<mujoco><asset>{assets}</asset><worldbody>{floor}{''.join(geoms)}</worldbody></mujoco>"
    return {surface.name: surface for surface in static_surfaces(mujoco.MjModel.from_xml_string(text))}


def of(geom: str, **told: str) -> Surface:
    return surfaces(geom.replace("<geom", '<geom name="it"'), **told)["it"]


@pytest.mark.parametrize(("over", "buried"), [(GROUNDED - HAIR, True), (GROUNDED + HAIR, False), (-3.0, True)])
def test_a_box_is_buried_whose_lowest_corner_is_on_the_floor_or_below_and_so_is_a_mesh(over, buried):
    box = of(f'<geom type="box" size=".3 .2 .1" pos="0 0 {over + 0.1}"/>')
    assert isinstance(box, Box) and box.buried == buried
    turned = of(f'<geom type="box" size=".3 .4 .1" pos="0 0 {over + 0.5}" zaxis="0 .6 .8" />')
    lowest = 0.5 - np.abs(turned.axes[2]) @ [0.3, 0.4, 0.1]  # type: ignore[attr-defined]
    level = of(f'<geom type="box" size=".3 .4 .1" pos="0 0 {over + 0.5 - lowest}" zaxis="0 .6 .8" />')
    assert isinstance(level, Box) and level.buried == buried
    assets = '<mesh name="m" vertex="0 0 -1 1 0 0 0 1 0 -1 -1 0"/>'
    mesh = of(f'<geom type="mesh" mesh="m" pos="0 0 {over + 1}"/>', assets=assets)
    lift = mesh.corners[2].min() - over  # type: ignore[attr-defined]
    mesh = of(f'<geom type="mesh" mesh="m" pos="0 0 {over + 1 - lift}"/>', assets=assets)
    assert isinstance(mesh, Hull) and mesh.buried == buried


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("over", "stands"), [(GROUNDED - HAIR, True), (GROUNDED + HAIR, False), (-1.0, True)])
def test_a_cylinder_that_stands_on_the_floor_continues_below_it(over, stands, sign):
    found = of(f'<geom type="cylinder" size=".2 .5" pos="1 2 {over + 0.5}" zaxis="0 0 {sign}"/>')
    assert isinstance(found, Cylinder)
    top = found.centre + found.half * found.axis * (1 if stands else sign)
    np.testing.assert_allclose(top, [1, 2, over + 1], atol=1e-9)
    assert found.half == pytest.approx(0.5 + DOWN / 2 * stands)
    assert found.radius == 0.2


def volume(hull: Hull) -> float:
    """By the divergence theorem: positive if triangles look outward."""
    a, b, c = (hull.corners[:, hull.faces[:, k]] for k in range(3))
    return float(np.sum(a * np.cross(b, c, axis=0)) / 6)


@pytest.mark.parametrize("collides", ["", 'contype="0" conaffinity="0"'])
def test_a_mesh_becomes_its_hull_where_it_is_with_all_triangles_outward_whether_or_not_mujoco_has_made_one(collides):
    """A wedge and a point inside it; its first vertex is where the body is, turned a quarter about z."""
    found = of(
        f'<geom type="mesh" mesh="m" pos="3 0 2" euler="0 0 90" {collides}/>',
        assets=f'<mesh name="m" inertia="exact" vertex="{WEDGE} .1 .1 .1"/>',
        floor='<geom name="other" size=".1" contype="0" conaffinity="0"/>' if collides else "",
    )
    assert isinstance(found, Hull)
    assert found.corners.shape == (3, 4)
    assert found.faces.shape == (4, 3)
    assert volume(found) == pytest.approx(1 / 6, rel=1e-5)
    np.testing.assert_allclose(sorted(np.ptp(found.corners, axis=1)), [1, 1, 1], atol=1e-6)
    assert found.distance(found.corners.mean(axis=1)[:, None])[0] < 0


def test_a_mesh_in_a_plane_is_no_surface():
    flat = '<mesh name="m" inertia="shell" vertex="0 0 0 1 0 0 0 1 0 1 1 0" face="0 1 2 1 3 2"/>'
    assert not surfaces('<geom type="mesh" mesh="m" contype="0" conaffinity="0"/>', assets=flat, floor="")


RADIUS, DIGIT = 1.25, 2.0**-50  # the last of what the sums of radius and size can tell


CUBE = np.array([[x, y, z] for x in (-1.0, 1) for y in (-1.0, 1) for z in (-1.0, 1)])


CORNERS = hull_of(CUBE)


assert CORNERS is not None


ROUND = np.array([2.25, 0, 0]), np.array([-1.0, 0, 0])


RIM = np.array([1.75, 0, 2]), np.array([-0.6, 0, -0.8])  # 3 : 4 : 5 from an edge at x = z = 1


TOUCHES: dict[str, tuple[Surface, np.ndarray, np.ndarray]] = {
    # where a sphere touches, and which way it goes deeper; every number is exact in binary
    "plane": (Plane("p", np.zeros(3), np.array([0.0, 0, 1])), np.array([0, 0, 1.25]), np.array([0, 0, -1.0])),
    "box": (Box("b", np.zeros(3), np.eye(3), np.ones(3), sideways=1.0), np.array([0, 0, 2.25]), np.array([0, 0, -1.0])),
    "sphere": (Capsule("s", np.zeros(3), np.eye(3)[2], 0.0, 1.0), *ROUND),
    "capsule": (Capsule("c", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *ROUND),
    "cylinder": (Cylinder("y", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *RIM),
    "hull": (Hull("h", *CORNERS), *RIM),
    "height field": (HeightField("f", np.array([0, 0, 1.0]), np.eye(3), np.ones(2), np.zeros((3, 3))), *RIM),
}


def test_the_pairs_that_can_collide_are_those_that_mujoco_finds(rng):
    for _ in range(20):
        masks = rng.integers(0, 4, (6, 2))
        bodies = "".join(
            f'<body name="b{i}"><freejoint/><geom name="g{i}" size="1" contype="{a}" conaffinity="{b}"/></body>'
            for i, (a, b) in enumerate(masks)
        )
        one, other, three, four = rng.permutation(6)[:4]
        rules = f'<exclude body1="b{one}" body2="b{other}"/><pair geom1="g{three}" geom2="g{four}"/>'
        model = mujoco.MjModel.from_xml_string(
            f"<mujoco><worldbody>{bodies}</worldbody><contact>{rules}</contact></mujoco>"
        )
        data, found = mujoco.MjData(model), np.zeros((6, 6), bool)
        mujoco.mj_forward(model, data)
        found[tuple(data.contact.geom.T)] = True
        expected = can_collide(model)
        np.testing.assert_array_equal(found | found.T, expected & ~np.eye(6, dtype=bool))


@pytest.mark.parametrize("name", TOUCHES)
def test_what_just_touches_is_not_in_it_and_what_is_any_nearer_is(name):
    surface, centre, way = TOUCHES[name]
    where = centre.reshape(3, 1, 1)
    depth, gradient = surface.depth(where, np.array([RADIUS]))
    assert not depth.any() and not gradient.any()
    depth, gradient = surface.depth(where, np.array([RADIUS + DIGIT]))
    assert 0 < depth[0, 0] < 1e-15
    np.testing.assert_allclose(gradient[:, 0, 0], way, atol=1e-12)
    if name != "height field":  # which tells a bound alone
        for radius, near in ((RADIUS, False), (RADIUS + DIGIT, True)):
            assert surface.near(where, np.array([radius])).all() == near


def test_of_two_surfaces_as_high_as_each_other_the_first_is_the_nearest_and_a_floor_is_below_at_any_depth():
    floors = [Plane(name, np.zeros(3), np.array([0.0, 0, 1])) for name in ("one", "other")]
    for z in (0.5, -3.0):
        found, which = terrain.heights(floors, np.array([[[0.0]], [[0.0]], [[z]]]), np.array([0.25]))
        assert (found.item(), which.item()) == (z - 0.25, 0)


def test_a_point_deep_in_a_box_came_from_beside_it_and_is_above_what_the_box_stands_on():
    half = np.array([0.5, 0.5, 0.5])
    floor, block = Plane("floor", -half, np.array([0.0, 0, 1])), Box("block", np.zeros(3), np.eye(3), half)
    for deep, height, nearest in ((DEEP - 0.01, 0.01 - DEEP, 1), (DEEP + 0.01, 1 - DEEP - 0.01, 0)):
        found, which = terrain.heights([floor, block], np.array([[[0.0]], [[0.0]], [[0.5 - deep]]]), np.zeros(1))
        assert which.item() == nearest and found.item() == pytest.approx(height, abs=1e-12)


ARM = read_data("meshed_arm.xml")


def named(model: mujoco.MjModel, geoms: list[int]) -> list[str]:
    return [model.geom(g).name for g in geoms]


def test_what_is_only_to_be_seen_and_what_a_programme_moves_do_not_count():
    model = mujoco.MjModel.from_xml_string(ARM)
    assert named(model, solids(model)) == ["floor", "wall", "base"]
    assert named(model, movers(model)) == ["one", "two", "cart", "lift", "die"]
    assert [surface.name for surface in static_surfaces(model)] == ["floor", "wall", "base"]


MOCAP = read_data("mocap.xml")


def test_colliding_mocap_bodies_are_obstacles_unless_they_are_handles_of_the_figure():
    model = mujoco.MjModel.from_xml_string(MOCAP.format(seen='contype="0" conaffinity="0"'))
    assert named(model, solids(model)) == ["top", "vase", "base"]
    assert named(model, movers(model)) == ["arm", "ball"]
    touching = {(model.body(body).name, model.geom(geom).name) for body, geom in overlapping_pairs(model)}
    assert touching == {("arm", "base")}


def test_floors_are_the_planes_that_no_programme_moves_and_that_face_up():
    plane = '<geom name="{}" type="plane" size="1 1 1" euler="{} 0 0"/>'
    turned = {"floor": 0, "ramp": 7, "steep": 9, "wall": 90, "ceiling": 180}
    planes = "".join(plane.format(name, angle) for name, angle in turned.items())
    mark = f'<body mocap="true">{plane.format("mark", 0)}</body>'
    box = '<geom name="box" type="box" size="1 1 1"/>'
    model = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{planes}{box}{mark}</worldbody></mujoco>")
    assert named(model, grounds(model)) == ["floor", "ramp"]  # 8 degrees lie between


def test_limbs_are_bolted_to_what_they_are_in_at_rest_unless_they_can_leave_it():
    model = mujoco.MjModel.from_xml_string(ARM)
    found = {(model.body(body).name, model.geom(geom).name) for body, geom in overlapping_pairs(model)}
    # the arm's first limb turns in its socket and reaches into the floor, the cart cannot leave it; lift and die can
    assert found == {("one", "base"), ("one", "floor"), ("cart", "floor")}


def test_a_clips_obstacle_is_bolted_to_the_first_limb_alone():
    """An arm stands on a table that a clip adds; its hand at rest on the table may leave it."""
    arm = """<mujoco><worldbody><geom name="table" type="box" size="1 1 .5" contype="0" conaffinity="{}"/>
      <body name="upper" pos="0 0 .52"><joint axis="0 0 1"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0"/>
        <body name="hand" pos=".3 0 0"><joint axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0"/>
      </body></body></worldbody></mujoco>"""
    for bit, bodies in ((1, {"upper", "hand"}), (1 | SCENERY, {"upper"})):
        model = mujoco.MjModel.from_xml_string(arm.format(bit))
        assert {model.body(body).name for body, _ in overlapping_pairs(model)} == bodies


ROOM = read_data("room.xml")


SEEN = 'contype="0" conaffinity="0"'


ALL = ["bone", "skin", "nail"]
ROOMS = {  # what of hull, bench and skin collides, or a pair that may touch; obstacles, and geoms kept clear of them
    "bench, skin": (["ground", "bench"], ["skin"]),
    "skin": (["ground"], ["skin"]),
    "bench": (["ground", "bench"], ALL),
    "": (["ground", "hull", "bench"], ALL),
    "pair": (["ground", "bench"], ["skin"]),
}


@pytest.mark.parametrize("colliding", ROOMS)
def test_where_something_collides_that_alone_is_an_obstacle_or_kept_clear_of_them(colliding):
    pair = '<contact><pair geom1="bench" geom2="skin"/></contact>' if colliding == "pair" else ""
    looks = {name: "" if name in colliding else SEEN for name in ("hull", "bench", "skin")}
    model = mujoco.MjModel.from_xml_string(ROOM.format(**looks, more=pair))
    assert (named(model, solids(model)), named(model, movers(model))) == ROOMS[colliding]
    assert counts_all(model) == (not colliding)


def test_what_a_clip_adds_is_in_the_way_whether_or_not_anything_else_collides():
    for skin in (SEEN, ""):
        text = ROOM.format(hull=SEEN, bench=SEEN, skin=skin, more="")
        ball = {"name": "ball", "radius": 0.1, "position": [1, 0, 0.1]}
        table = SceneTable.model_validate({"step": {"x": 1.0, "height": 0.2}, "sphere": [ball]})
        model = compose(mujoco.MjSpec.from_string(text), obstacles(table)).model()
        assert {"ground", "step", "ball"} <= set(named(model, solids(model)))
        assert ("hull" in named(model, solids(model))) == (skin == SEEN)


UP = np.array([0.0, 0, 1])


FLOOR = Plane("floor", np.zeros(3), UP)


BOX = Box("box", np.array([0.0, 0.0, 0.2]), np.eye(3), np.array([0.5, 0.5, 0.2]))


TILT = np.array([np.sin(0.4), 0, np.cos(0.4)])


REACH = 0.1


def test_within_reach_of_an_edge_it_is_the_nearer_of_both(rng):
    """Over a box and its floor: the top's where a point is over it or within 7 cm of it, in any direction; what lies
    between that and 10 cm depends on the direction."""
    points = np.vstack([rng.uniform(-0.8, 0.8, (2, 1, 400)), rng.uniform(0.0, 0.7, (1, 1, 400))])
    found, where = terrain.heights_nearby([FLOOR, BOX], points, np.array([0.05]), REACH)
    beyond = np.maximum(np.abs(points[:2]) - 0.5, 0).max(axis=0)[0]
    z = points[2, 0] - 0.05
    top_is_nearer, on_top, on_floor = np.abs(z - 0.4) + 0.05 < np.abs(z), beyond == 0, beyond > REACH
    reached = top_is_nearer & (beyond < 0.7 * REACH) & ~on_top & (z > 0.26)
    assert reached.sum() > 10
    np.testing.assert_allclose(found[0, reached], z[reached] - 0.4, atol=1e-12)
    np.testing.assert_allclose(found[0, on_floor], z[on_floor], atol=1e-12)
    high = on_top & (beyond == 0) & (np.abs(points[:2]).max(axis=0)[0] < 0.5 - REACH) & (z > 0.26)
    np.testing.assert_allclose(found[0, high], z[high] - 0.4, atol=1e-12)
    np.testing.assert_allclose(terrain.height_over([FLOOR, BOX], where, np.array([0.05]))[0], found, atol=1e-12)
    np.testing.assert_array_less(np.linalg.norm((where - points)[:, 0], axis=0), REACH + 1e-12)


@pytest.mark.parametrize("normal", [UP, TILT])
def test_the_ground_of_a_point_is_the_plane_below_it(normal, rng):
    plane = Plane("plane", rng.normal(size=3), normal)
    point = plane.point + 0.04 * normal + np.cross(normal, rng.normal(size=3))
    found = terrain.ground_at([plane], point, 0.03, REACH)
    assert found is not None
    np.testing.assert_allclose(found.normal, normal, atol=1e-12)
    elsewhere = rng.normal(size=(3, 5))
    np.testing.assert_allclose(found.height(elsewhere), plane.height(elsewhere), atol=1e-12)


ONE_BOX = """<mujoco><worldbody><geom type="box" size=".5 .3 .2" pos=".1 .2 .2" euler="0 0 40"/>
<body mocap="true"><geom size="1e-6"/></body></worldbody></mujoco>"""


def test_clearances_are_distances_by_mujoco_for_points_above_the_top_of_a_box(rng):
    """The floor is nearer for some of the points, and the gradients are those of the values."""
    model = mujoco.MjModel.from_xml_string(ONE_BOX)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    box = Box("box", data.geom_xpos[0].copy(), data.geom_xmat[0].reshape(3, 3).copy(), model.geom_size[0].copy())
    bottoms = rng.uniform([-1, -1, 0.4], [1, 1, 0.9], (200, 3))
    expected = np.empty(len(bottoms))
    for i, place in enumerate(bottoms):
        data.mocap_pos[0] = place
        mujoco.mj_kinematics(model, data)
        expected[i] = min(mujoco.mj_geomDistance(model, data, 0, 1, 9.0, None) + 1e-6, place[2])
    points = (bottoms + 0.05 * UP).T[:, None]
    found, origin = terrain.clearances([FLOOR, box], points, np.array([0.05]))
    gradient = terrain.clearance_gradients([FLOOR, box], origin[0], points[:, 0], np.full(200, 0.05))
    np.testing.assert_allclose(found[0], expected, atol=1e-9)
    step, h = rng.normal(size=points.shape), 1e-6
    rise = [terrain.clearances([FLOOR, box], points + s * step, np.array([0.05]))[0] for s in (-h, h)]
    np.testing.assert_allclose((rise[1] - rise[0]) / (2 * h), np.einsum("is,ins->ns", gradient, step), atol=1e-4)
