"""The model as links, kinematics and forces, against MuJoCo."""

import itertools
from unittest import mock

import figures
import mujoco
import numpy as np
import pytest
from figures import OBJECT_BALL as BALL
from figures import assert_near, figure_of
from gradients import jacobian
from oracles import kinematics, mujoco_forces
from random_models import random_figure, random_qpos, random_samples

from dynsplines.solver import compiled
from dynsplines.solver.array import Index
from dynsplines.solver.figure.adjoint import Cotangent, Quantity
from dynsplines.solver.figure.dynamics import RootWrench, height, velocities, weight
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import boxes, geom_name, names_of_joints
from dynsplines.solver.figure.root import has_fixed_base, root_of, sliding_joints
from dynsplines.solver.figure.wrenches import Wrenches


@pytest.mark.parametrize("text", [figures.BALL_TREE, figures.EVERY_JOINT, figures.MIXED, figures.TINY, figures.LEG])
def test_a_quaternion_in_world_coordinates_is_its_bodys_orientation_by_mujoco_and_any_length_of_it_the_same_pose(
    text, rng
):
    figure = figures.figure_of(text, "auto")
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


def test_a_link_is_called_by_its_joint_or_by_the_body_that_it_moves():
    figure = figures.figure_of(figures.EVERY_JOINT)
    names = [link.name for link in figure.links]
    for name in ("root", "yaw", "pitch", "reach", "wrist", "swing", "turn"):
        assert figures.link_named(figure, name) == names.index(name)
    assert figures.link_named(figure, "arm") == names.index("pitch")  # the last of its joints
    assert figures.link_named(figure, "trunk") == 1
    assert figures.link_named(figure, "world") is None
    assert figures.link_named(figure, "nobody") is None


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


def test_gravity_is_the_models_unless_it_is_switched_off():
    text = """<mujoco><option gravity="0 1 -3">{}</option><worldbody><body><joint/><geom size=".1"/></body></worldbody>
        </mujoco>"""
    np.testing.assert_array_equal(figures.figure_of(text.format("")).gravity, [0, 1, -3])
    np.testing.assert_array_equal(figures.figure_of(text.format('<flag gravity="disable"/>')).gravity, [0, 0, 0])
    np.testing.assert_array_equal(figures.figure_of(text.format('<flag contact="disable"/>')).gravity, [0, 1, -3])


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


PLANAR = figures.biped(figures.joints(("tx", "tz", "ry")))


ARM = '<body><joint axis="0 0 1"/><geom size=".1"/><body pos=".2 0 0"><joint/><geom size=".1"/></body></body>'


RAIL = '<body><joint type="slide" axis="1 0 0"/><joint type="slide"/><geom size=".1"/></body>'


def root_bodies(xml: str) -> tuple[str, str] | None:
    """The root's body and joint, by name."""
    model = mujoco.MjModel.from_xml_string(xml)
    root = root_of(model)
    if root is None:
        return None
    return model.body(root.body).name, model.joint(root.joint).name


@pytest.mark.parametrize("order", list(itertools.permutations(range(3))))
@pytest.mark.parametrize("objects", [(figures.BOX, BALL), (figures.CART, figures.DOOR), (figures.BOX, figures.DRAWER)])
def test_objects_may_be_listed_before_and_after_the_robot(objects: tuple[str, str], order: tuple[int, ...]) -> None:
    bodies = (figures.biped(), *objects)
    assert root_bodies(figures.scene(*(bodies[i] for i in order))) == ("pelvis", "root")


@pytest.mark.parametrize(
    ("bodies", "root", "sliding", "is_fixed"),
    [
        ((PLANAR, figures.BOX), None, 3, False),
        (
            (PLANAR, figures.DRAWER, figures.biped(prefix="b_", root='<freejoint name="b"/>')),
            ("b_pelvis", "b"),
            3,
            False,
        ),
        ((ARM,), None, 0, True),
        ((ARM, RAIL, figures.BOX), ("box", "box_free"), 0, True),
        ((RAIL,), None, 0, False),
        ((figures.BOX,), ("box", "box_free"), 0, False),
    ],
)
def test_slides_and_hinges_are_no_root(
    bodies: tuple[str, ...], root: tuple[str, str] | None, sliding: int, is_fixed: bool
) -> None:
    assert root_bodies(figures.scene(*bodies)) == root
    model = mujoco.MjModel.from_xml_string(figures.scene(*bodies))
    assert (len(sliding_joints(model)), has_fixed_base(model)) == (sliding, is_fixed)


SEEDS = range(24)


COORDINATES = ("auto", "world", "joint")


@pytest.mark.parametrize("coordinates", COORDINATES)
@pytest.mark.parametrize("seed", SEEDS[:10])
def test_bodies_are_where_mujoco_has_them_and_its_forces_are_found(seed, coordinates):
    figure, rng = random_figure(seed, coordinates)
    samples = random_samples(figure, rng, 3)
    data = mujoco.MjData(figure.model)
    qpos = figure.to_qpos(samples.y)
    np.testing.assert_allclose(figure.to_qpos(figure.to_state(qpos)), qpos, atol=1e-12)
    qvel, _ = velocities(samples)
    for i in range(3):
        data.qpos[:], data.qvel[:] = qpos[i], qvel[i]
        mujoco.mj_fwdPosition(figure.model, data)
        mujoco.mj_fwdVelocity(figure.model, data)
        spin = np.zeros(6)
        for body in range(1, figure.model.nbody):
            link, place = figure.point_on_link(body, np.zeros(3))
            where, offset = samples.links.points(np.array([link]), place[:, None])
            np.testing.assert_allclose(where[:, 0, i], data.xpos[body], atol=1e-11)
            mujoco.mj_objectVelocity(figure.model, data, mujoco.mjtObj.mjOBJ_XBODY, body, spin, 0)
            np.testing.assert_allclose(samples.links.omega[:, link, i], spin[:3], atol=1e-9)
            velocity = samples.links.x_d[:, link, i] + np.cross(spin[:3], offset[:, 0, i])
            np.testing.assert_allclose(velocity, spin[3:], atol=1e-8)


@pytest.mark.parametrize("direction", ["accumulate", "buffer"])
def test_a_gradient_with_respect_to_nothing_that_there_is_is_refused(figure, rng, direction):
    cotangent = Cotangent(random_samples(figure, rng))
    with pytest.raises(ValueError, match=r"'spin'; there are: y, y_d, .*omega"):
        getattr(cotangent, direction)("spin", *([] if direction == "buffer" else [np.zeros(3)]))


def test_boxes_are_around_the_vertices_of_a_turned_mesh(rng):
    vertices = " ".join(f"{x:.6f}" for x in rng.exponential(size=24))
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><asset><mesh name="stone" vertex="{vertices}"/></asset><worldbody><body pos="1 2 3">'
        '<freejoint/><geom type="mesh" mesh="stone" quat=".9 .1 -.2 .3"/></body></worldbody></mujoco>'
    )
    data = kinematics(model, model.qpos0)
    centre, half = boxes(model, data, np.array([0]))
    corners = model.mesh_vert @ data.geom_xmat[0].reshape(3, 3).T + data.geom_xpos[0]
    assert np.all(np.abs(corners - centre) <= half + 1e-6)


ALL = ("force", "torque", "force_d", "torque_d", "torque_dd")


BUFFERS: dict[str, Quantity] = {
    "force": "x",
    "torque": "turn",
    "force_d": "x_d",
    "torque_d": "omega",
    "torque_dd": "alpha",
}


def some(figure: Figure, samples: Samples, rng: np.random.Generator, names: tuple[str, ...] = ALL) -> Wrenches:
    """On every link, in any order, at any sample."""
    link = rng.permutation(np.tile(np.arange(len(figure.links)), 3))
    vectors = {name: rng.normal(size=(3, link.size)) for name in names}
    return Wrenches(rng.integers(0, samples.count, link.size), link, **vectors)


def by_adjoint(samples: Samples, given: Wrenches) -> np.ndarray:
    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        here = np.arange(rows.size)
        for name, buffer in BUFFERS.items():
            vectors = getattr(given, name)
            if vectors is not None:
                cotangent.buffer(buffer)[:, given.link[rows], here] += vectors[:, rows]

    return jacobian(samples, given.at, seeded)[:, : given.orders]


def test_rows_are_those_of_the_adjoint_sweep_with_the_compiled_kernel_and_without(figure, rng):
    samples = random_samples(figure, rng)
    for names in (ALL, ("force",), ("torque",), ("force", "torque"), ("force_d", "torque_d"), ("torque_dd",)):
        given = some(figure, samples, rng, names)
        expected = by_adjoint(samples, given)
        if np.abs(expected).max() > 0.1:
            assert_near(given.rows(samples), expected, 1e-11)
            with mock.patch.object(compiled, "kernel", None):
                assert_near(given.rows(samples), expected, 1e-11)


def test_force_moment_centre_and_mass_are_mujocos_at_the_root(figure, rng):
    samples = random_samples(figure, rng)
    wrench = RootWrench(samples, 1)
    expected = mujoco_forces(samples)[:, :6]
    rotation, root = samples.links.rotation[:, :, 1], samples.links.x[:, 1]
    at_root = wrench.moment + np.cross(wrench.centre - root, wrench.force, axis=0)
    scale = np.abs(expected).max()
    np.testing.assert_allclose(wrench.force.T, expected[:, :3], atol=1e-11 * scale)
    np.testing.assert_allclose(np.einsum("ijs,is->sj", rotation, at_root), expected[:, 3:], atol=1e-11 * scale)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        np.testing.assert_allclose(wrench.centre[:, i], kinematics(figure.model, qpos).subtree_com[1], atol=1e-12)
    np.testing.assert_allclose(wrench.mass, figure.model.body_subtreemass[1])


def test_a_slender_rod_is_as_high_as_it_is_long_and_has_a_weight_without_gravity():
    text = """<mujoco><worldbody><body><freejoint/><inertial pos="1 2 3" mass="6" diaginertia="2 2 1e-9"/></body>
    </worldbody></mujoco>"""
    assert height(figure_of(text), 1) == pytest.approx(2)
    floating = text.replace("<worldbody>", '<option gravity="0 0 0"/><worldbody>')
    assert weight(figure_of(floating), 1) == pytest.approx(9.81 * 6)
