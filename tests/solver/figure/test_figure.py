"""A figure as its model has it: orientations and places are MuJoCo's, names tell links, coordinates suit the joints."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, CHAIN, EVERY_JOINT, LEG, MIXED, TINY, figure_of, link_named
from oracles import kinematics
from random_keys import random_qpos

from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.figure.naming import geom_name, names_of_joints


@pytest.mark.parametrize("text", [BALL_TREE, EVERY_JOINT, MIXED, TINY, LEG])
def test_a_quaternion_in_world_coordinates_is_its_bodys_orientation_by_mujoco_and_any_length_of_it_the_same_pose(
    text, rng
):
    figure = figure_of(text, "auto")
    model = figure.model
    assert figure.coordinates == "world"
    qpos = random_qpos(figure, rng)
    data, state = kinematics(model, qpos), figure.to_state(qpos)
    stretched = np.array(state)
    for i, link in enumerate(figure.links[1:], start=1):
        columns = quaternion_columns(link)
        if columns is None:
            continue
        stretched[columns] *= rng.uniform(0.3, 3) * rng.choice([-1, 1])
        if figure.tables.in_world[i] and figure.body_link[link.body] == i:
            assert abs(state[columns] @ data.xquat[link.body]) == pytest.approx(1)
    again = kinematics(model, figure.to_qpos(stretched))
    np.testing.assert_allclose(again.xpos, data.xpos, atol=1e-9)
    np.testing.assert_allclose(again.xmat, data.xmat, atol=1e-9)
    two = figure.to_qpos(np.array([[state, stretched]]))
    np.testing.assert_allclose(two[0, 0], figure.to_qpos(state), atol=1e-12)
    np.testing.assert_allclose(figure.to_state(figure.to_qpos(state)), state, atol=1e-9)


UNDER_A_HINGE = """<mujoco><worldbody><body><joint/><geom size=".1"/>
  <body><joint type="ball"/><geom size=".1"/></body></body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("text", "coordinates"),
    [(CHAIN.format("hinge"), "world"), (CHAIN.format("ball"), "world"), (UNDER_A_HINGE, "joint")],
)
def test_orientations_in_the_world_are_the_state_where_a_ball_joint_has_one_of_its_own(text, coordinates):
    figure = figure_of(text)
    assert figure.coordinates == coordinates
    for i, link in enumerate(figure.links[1:], start=1):
        upright = all(figure.links[k].kind in (JointKind.FREE, JointKind.BALL) for k in _way(figure, i))
        assert figure.tables.in_world[i] == (upright and coordinates == "world" and link.kind is not JointKind.HINGE)


def _way(figure: Figure, link: int) -> list[int]:
    found = []
    while link:
        found.append(link)
        link = figure.links[link].parent
    return found


def test_a_link_is_called_by_its_joint_or_by_the_body_that_it_moves():
    figure = figure_of(EVERY_JOINT)
    names = [link.name for link in figure.links]
    for name in ("root", "yaw", "pitch", "reach", "wrist", "swing", "turn"):
        assert link_named(figure, name) == names.index(name)
    assert link_named(figure, "arm") == names.index("pitch")  # the last of its joints
    assert link_named(figure, "trunk") == 1
    assert link_named(figure, "world") is None
    assert link_named(figure, "nobody") is None


@pytest.mark.parametrize(
    ("given", "bodies", "names"),
    [
        ([""], [("world", 0), ("leg", 1)], ["leg"]),
        (["", "hip", ""], [("world", 0), ("leg", 3)], ["leg_1", "hip", "leg_2"]),
        (["", "a"], [("a", 1), ("b", 1)], ["joint 0", "a"]),
        (["", ""], [("", 1), ("b", 1)], ["joint 0", "b"]),
        (["", ""], [("b", 1), ("b", 1)], ["b", "joint 1"]),
    ],
)
def test_joints_without_a_name_have_one_all_the_same_and_no_two_the_same(given, bodies, names):
    assert names_of_joints(given, bodies) == names
    assert len(set(names)) == len(names)


def test_joints_cover_every_column_of_qpos_and_qvel_once():
    figure = figure_of(EVERY_JOINT)
    assert {link.kind for link in figure.links[1:]} == set(JointKind)
    columns, dofs = ([getattr(link, name) for link in figure.links[1:]] for name in ("columns", "dofs"))
    for slices, count in ((columns, figure.model.nq), (dofs, figure.model.nv)):
        assert [k for part in slices for k in range(part.start, part.stop)] == list(range(count))


def test_gravity_is_the_models_unless_it_is_switched_off():
    text = """<mujoco><option gravity="0 1 -3">{}</option><worldbody><body><joint/><geom size=".1"/></body></worldbody>
        </mujoco>"""
    np.testing.assert_array_equal(figure_of(text.format("")).gravity, [0, 1, -3])
    np.testing.assert_array_equal(figure_of(text.format('<flag gravity="disable"/>')).gravity, [0, 0, 0])
    np.testing.assert_array_equal(figure_of(text.format('<flag contact="disable"/>')).gravity, [0, 1, -3])


UNNAMED = """
<mujoco><worldbody><geom size="1"/>
  <body name="foot"><geom name="sole" size="1"/><geom size="1"/></body>
  <body name="leg"><geom size="1"/><geom size="1"/><geom name="leg 2" size="1"/></body>
  <body><geom size="1"/></body>
</worldbody></mujoco>"""


def test_a_geom_without_a_name_is_called_after_its_body_and_no_two_alike():
    model = mujoco.MjModel.from_xml_string(UNNAMED)
    found = [geom_name(model, geom) for geom in range(model.ngeom)]
    assert found == ["geom 0", "sole", "foot", "leg 1", "geom 4", "leg 2", "geom 6"]
