"""Which geoms are solid or bolted together; what just touches a surface is not in it: no depth and no gradient."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from dynsplines.clip.obstacles import obstacles
from dynsplines.clip.table import SceneTable
from dynsplines.scene.compose import compose
from dynsplines.solver.surface import (
    Box,
    Capsule,
    Cylinder,
    HeightField,
    Hull,
    Plane,
    Sphere,
    Surface,
    hull_of,
    static_surfaces,
)
from dynsplines.solver.surface.heights import DEEP, FAR, heights
from dynsplines.solver.surface.touch import SCENERY, bolted, counts_all, grounds, movers, solids

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
    "sphere": (Sphere("s", np.zeros(3), 1.0), *ROUND),
    "capsule": (Capsule("c", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *ROUND),
    "cylinder": (Cylinder("y", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *RIM),
    "hull": (Hull("h", *CORNERS), *RIM),
    "height field": (HeightField("f", np.array([0, 0, 1.0]), np.eye(3), np.ones(2), np.zeros((3, 3))), *RIM),
}


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


EDGE = 1.0 + DIGIT
OVER: dict[str, tuple[Surface, tuple[float, float], tuple[float, float], float]] = {
    # two places over its edge, and how high it is there; every number is exact in binary
    "box": (Box("b", np.zeros(3), np.eye(3), np.ones(3)), (1.0, -0.5), (0.25, 1.0), 1.0),
    "sunk box": (Box("b", np.zeros(3), np.eye(3), np.ones(3), buried=True), (-1.0, 0.5), (0.25, -1.0), 1.0),
    "hull": (Hull("h", *CORNERS), (1.0, -0.5), (0.25, -1.0), 1.0),
    "upright cylinder": (Cylinder("y", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), (1.0, 0.0), (0.0, -1.0), 1.0),
    "height field": (
        HeightField("f", np.array([0, 0, 1.0]), np.eye(3), np.ones(2), np.zeros((3, 3))), (1.0, 0.5), (-0.5, -1.0), 1.0,
    ),
    "upright capsule": (Capsule("c", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), (1.0, 0.0), (0.0, -1.0), 1.0),
    "sphere": (Sphere("s", np.zeros(3), 1.0), (1.0, 0.0), (0.0, -1.0), 0.0),
}  # fmt: skip


@pytest.mark.parametrize("name", OVER)
def test_over_the_edge_of_a_surface_is_over_it_and_a_last_digit_farther_out_is_not(name):
    surface, *places, top = OVER[name]
    for place in places:
        x, y = place
        at = np.array([[[x]], [[y]], [[3.0]]])
        np.testing.assert_allclose(surface.height(at), 3.0 - top, atol=1e-12)
        beside = at.copy()
        axis = int(np.argmax(np.abs(place)))
        beside[axis] *= EDGE
        assert np.isinf(surface.height(beside)).all()


@pytest.mark.parametrize("buried", [False, True])
def test_in_a_box_one_is_below_its_top_as_far_as_its_bottom_and_in_one_that_is_buried_however_deep(buried):
    box = Box("b", np.array([0.0, 0, 3]), np.diag([1.0, -1.0, -1.0]), np.array([0.5, 0.75, 0.25]), buried=buried)
    for z, over in ((3.5, True), (2.75 + DIGIT * 2, True), (2.75, buried), (2.0, buried)):
        found = box.height(np.array([[[0.5]], [[-0.75]], [[z]]])).item()
        assert found == (z - 3.25 if over else np.inf)


def test_along_a_lying_bar_one_is_over_it_up_to_its_ends_and_across_it_up_to_its_radius():
    for bar, end in (
        (Cylinder("y", np.zeros(3), np.array([1.0, 0, 0]), 1.0, 0.5), (1.0, 0.5)),
        (Capsule("c", np.zeros(3), np.array([1.0, 0, 0]), 1.0, 0.5), (1.5, 0.0)),
    ):
        for x, y, high in ((0.0, 0.0, 0.5), (1.0, 0.0, 0.5), (-1.0, 0.0, 0.5), (0.5, 0.5, 0.0), (0.5, -0.5, 0.0)):
            np.testing.assert_allclose(bar.height(np.array([[[x]], [[y]], [[3.0]]])), 3 - high, atol=1e-7)
        assert np.isfinite(bar.height(np.array([[[end[0]]], [[0.0]], [[3.0]]]))).all()
        assert np.isinf(bar.height(np.array([[[end[0] + 1e-9]], [[0.0]], [[3.0]]]))).all()
        assert np.isinf(bar.height(np.array([[[0.5]], [[0.5 + 1e-9]], [[3.0]]]))).all()


def test_of_two_surfaces_as_high_as_each_other_the_first_is_the_nearest_and_deep_below_is_neither():
    floors = [Plane(name, np.zeros(3), np.array([0.0, 0, 1])) for name in ("one", "other")]
    for z, height, nearest in ((0.5, 0.25, 0), (0.25 - DEEP, -DEEP, 0), (0.25 - DEEP - DIGIT, FAR, -1)):
        found, which = heights(floors, np.array([[[0.0]], [[0.0]], [[z]]]), np.array([0.25]))
        assert (found.item(), which.item()) == (height, nearest)


ARM = """
<mujoco><asset><mesh name="rock" vertex="0 0 0 .1 0 0 0 .1 0 0 0 .1 .1 .1 .1"/></asset>
<worldbody>
  <geom name="floor" type="plane" size="1 1 1"/><geom name="wall" type="box" size=".1 1 1" pos="2 0 0"/>
  <body name="base"><geom name="base" type="cylinder" size=".1 .05"/>
    <geom name="cover" type="mesh" mesh="rock" contype="0" conaffinity="0"/>
    <body name="one" pos="0 0 .04"><joint name="yaw" axis="0 0 1"/><geom name="one" type="capsule" size=".05"
      fromto="0 0 0 0 0 .3"/><geom name="look" type="mesh" mesh="rock" contype="0" conaffinity="0"/>
      <body name="two" pos="0 0 .3"><joint name="pitch" axis="0 1 0"/><geom name="two" type="mesh" mesh="rock"/></body>
    </body></body>
  <body name="mark" mocap="true" pos="0 0 3"><geom name="mark" size=".1" contype="0" conaffinity="0"/></body>
  <body name="cart" pos="0 1 .1"><joint name="rail" type="slide" axis="1 0 0"/><geom name="cart" size=".15"/></body>
  <body name="lift" pos="0 -1 .1"><joint name="lift" type="slide" axis="0 0 1"/><geom name="lift" size=".15"/></body>
  <body name="die" pos="1 0 0"><freejoint/><geom name="die" size=".1"/></body>
</worldbody></mujoco>"""


def named(model: mujoco.MjModel, geoms: list[int]) -> list[str]:
    return [model.geom(g).name for g in geoms]


def test_what_is_only_to_be_seen_and_what_a_programme_moves_do_not_count():
    model = mujoco.MjModel.from_xml_string(ARM)
    assert named(model, solids(model)) == ["floor", "wall", "base"]
    assert named(model, movers(model)) == ["one", "two", "cart", "lift", "die"]
    assert [surface.name for surface in static_surfaces(model)] == ["floor", "wall", "base"]


MOCAP = """
<mujoco><worldbody>
  <body name="table" mocap="true"><geom name="top" type="box" size="1 1 .1"/>
    <body name="vase" pos="0 0 .2"><geom name="vase" size=".1"/><geom name="look" size=".2" {seen}/></body></body>
  <body name="base" mocap="true" pos="2 0 0"><geom name="base" size=".1"/>
    <body name="arm" pos="0 0 .5"><joint name="elbow"/><geom name="arm" size=".1"/></body></body>
  <body name="pull" mocap="true" pos="3 0 0"><geom name="pull" size=".1"/></body>
  <body name="grip" mocap="true" pos="4 0 0"><geom name="grip" size=".1"/><site name="grip"/></body>
  <body name="ball" pos="0 0 1"><freejoint/><geom name="ball" size=".1"/><site name="ball"/></body>
</worldbody><equality><connect body1="ball" body2="pull" anchor="0 0 0"/><weld site1="grip" site2="ball"/></equality>
</mujoco>"""


def test_colliding_mocap_bodies_are_obstacles_unless_they_are_handles_of_the_figure():
    model = mujoco.MjModel.from_xml_string(MOCAP.format(seen='contype="0" conaffinity="0"'))
    assert named(model, solids(model)) == ["top", "vase", "base"]
    assert named(model, movers(model)) == ["arm", "ball"]
    touching = {(model.body(body).name, model.geom(geom).name) for body, geom in bolted(model)}
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
    found = {(model.body(body).name, model.geom(geom).name) for body, geom in bolted(model)}
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
        assert {model.body(body).name for body, _ in bolted(model)} == bodies


ROOM = """
<mujoco><worldbody>
  <geom name="ground" type="plane" size="1 1 1" contype="0" conaffinity="0"/>
  <geom name="hull" type="box" size="4 4 3" {hull}/><geom name="bench" type="box" size=".1 1 .2" pos="2 0 0" {bench}/>
  <body name="leg" pos="0 0 1"><freejoint/><geom name="bone" type="capsule" size=".05 .2" contype="0" conaffinity="0"/>
    <geom name="skin" type="capsule" size=".06 .2" {skin}/>
    <body name="toe"><joint/><geom name="nail" size=".01" contype="0" conaffinity="0"/></body></body>
</worldbody>{more}</mujoco>"""
SEEN = 'contype="0" conaffinity="0"'


def room(hull: str = SEEN, bench: str = SEEN, skin: str = SEEN, more: str = "") -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(ROOM.format(hull=hull, bench=bench, skin=skin, more=more))


def test_where_something_collides_the_hull_of_a_room_is_no_obstacle_and_bones_are_not_kept_clear():
    model = room(bench="", skin="")
    assert named(model, solids(model)) == ["ground", "bench"]
    assert named(model, movers(model)) == ["skin"]
    assert not counts_all(model)
    alone = room(skin="")  # planes are grounds whatever they say
    assert named(alone, solids(alone)) == ["ground"]


def test_a_pair_of_geoms_that_may_touch_makes_both_collide():
    model = room(more='<contact><pair geom1="bench" geom2="skin"/></contact>')
    assert named(model, solids(model)) == ["ground", "bench"]
    assert named(model, movers(model)) == ["skin"]


def test_a_model_of_which_nothing_collides_is_looked_at_with_all_of_its_geoms():
    model = room()
    assert counts_all(model)
    assert named(model, solids(model)) == ["ground", "hull", "bench"]
    assert named(model, movers(model)) == ["bone", "skin", "nail"]


def test_a_figure_that_collides_with_nothing_in_a_room_that_does_is_kept_clear_with_all_of_its_geoms():
    model = room(bench="")
    assert named(model, solids(model)) == ["ground", "bench"]
    assert named(model, movers(model)) == ["bone", "skin", "nail"]


def test_what_a_clip_adds_is_in_the_way_whether_or_not_anything_else_collides():
    for skin in (SEEN, ""):
        text = ROOM.format(hull=SEEN, bench=SEEN, skin=skin, more="")
        ball = {"name": "ball", "radius": 0.1, "position": [1, 0, 0.1]}
        table = SceneTable.model_validate({"step": {"x": 1.0, "height": 0.2}, "sphere": [ball]})
        model = compose(mujoco.MjSpec.from_string(text), obstacles(table)).model()
        assert {"ground", "step", "ball"} <= set(named(model, solids(model)))
        assert ("hull" in named(model, solids(model))) == (skin == SEEN)
