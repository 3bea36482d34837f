"""Ball joints as three hinges, and recordings of robots, by MuJoCo and SciPy."""

from __future__ import annotations

import itertools

import mujoco
import numpy as np
import pytest
import wild
from figures import BALL_TREE
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.robot import Robot, configurations
from dynsplines.exchange.skeleton.hinge_joints import HingeLayout, HingeModel, angles, rates
from dynsplines.exchange.trajectory import SampledTrajectory
from dynsplines.scene.assets import Scene
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from tests.support.biped import BALL, CART, biped, joints, scene

ORDERS = ["".join(order) for order in itertools.permutations("xyz")]


@pytest.fixture(scope="module")
def take():
    return SampledTrajectory.of(wild.motion_of("human"))


def test_joints_carry_the_names_of_the_balls_and_their_axes_in_order(take):
    model = take.hinged.model
    names = [model.joint(i).name for i in range(model.njnt)]
    assert names[:5] == ["root", "spine_x", "spine_z", "spine_y", "left_shoulder_x"]
    assert names == take.hinged.layout.names
    np.testing.assert_array_equal(model.jnt_axis[1:4], [[1, 0, 0], [0, 0, 1], [0, 1, 0]])


@pytest.mark.parametrize("order", ORDERS)
def test_angles_of_every_order_are_intrinsic_rotations_in_it(order, rng):
    q = rng.normal(size=(40, 2, 4))
    angle = angles(q, order)
    own = Rotation.from_euler(order.upper(), angle.reshape(-1, 3)).as_matrix()
    np.testing.assert_allclose(own, Rotation.from_quat(q.reshape(-1, 4), scalar_first=True).as_matrix(), atol=1e-12)
    assert np.max(quat.angle_between(quat.from_euler(angle, order), q)) < 1e-12


@pytest.mark.parametrize("order", ORDERS)
def test_angles_continue_through_the_lock_and_beyond_whole_turns(order):
    t = np.linspace(0, 1, 401)[:, None]
    smooth = np.concatenate([8 * t, np.pi * t, 0.3 - 9 * t], 1)  # the middle one passes 90° in sample 200, exactly
    found = angles(quat.from_euler(smooth, order)[:, None], order)[:, 0]
    assert np.max(quat.angle_between(quat.from_euler(found, order), quat.from_euler(smooth, order))) < 1e-7
    np.testing.assert_allclose(found[:200], smooth[:200], atol=1e-7)
    np.testing.assert_allclose(found[:, 1], smooth[:, 1], atol=1e-6)
    assert np.max(np.abs(np.diff(found, axis=0))) < 0.06
    spin = quat.rotation_vector(
        quat.product(quat.inverse(quat.from_euler(smooth[99], order)), quat.from_euler(smooth[101], order))
    )
    np.testing.assert_allclose(rates(smooth[100], spin * 200, order), [8, np.pi, -9], rtol=2e-3)
    assert np.all(np.isfinite(rates(smooth[200], np.array([5.0, 6, 7]), order)))


def test_a_joint_near_the_lock_is_reported_and_one_far_off_is_not():
    model = mujoco.MjModel.from_xml_string(BALL_TREE)
    qpos = np.tile(model.qpos0, (3, 1))
    layout = HingeLayout(model)
    at = int(model.jnt_qposadr[model.joint("elbow").id])
    qpos[1, at : at + 4] = quat.from_rotation_vector(np.radians([0, 0, 85]))
    found = HingeModel.of(model, Scene(BALL_TREE), qpos, np.zeros((3, model.nv))).warning(np.array([0, 0.5, 1]))
    assert found is not None and found.startswith("'elbow' comes within 5° of gimbal lock at 0.50 s")
    qpos[1, at : at + 4] = quat.from_rotation_vector(np.radians([170, 0, 0]))
    assert HingeModel.of(model, Scene(BALL_TREE), qpos, np.zeros((3, model.nv))).warning(np.arange(3.0)) is None
    assert layout.balls == [1, 2, 3]


def test_what_acts_on_ball_joints_goes_and_anchors_and_damping_stay():
    text = BALL_TREE.replace('name="hip" type="ball"', 'name="hip" type="ball" damping="0.5" range="0 1"').replace(
        "</mujoco>",
        '<actuator><motor joint="elbow"/></actuator><sensor><ballquat joint="hip"/><framepos objtype="body" '
        'objname="leg"/></sensor><keyframe><key time="1"/></keyframe></mujoco>',
    )
    model = mujoco.MjModel.from_xml_string(text)
    variant = mujoco.MjModel.from_xml_string(HingeLayout(model).mjcf(text))
    assert (variant.nu, variant.nsensor, variant.nkey) == (0, 1, 0)
    hips = [variant.joint(f"hip_{axis}") for axis in "xzy"]
    assert all(joint.damping[0] == 0.5 and not variant.jnt_limited[joint.id] for joint in hips)
    np.testing.assert_array_equal([joint.pos for joint in hips], [[0.01, 0.02, 0.03]] * 3)


def test_joints_without_a_name_have_in_the_variant_the_name_that_a_reader_with_the_figure_expects():
    text = """<mujoco><worldbody><body><freejoint/><geom size=".1"/><body><joint type="ball"/><geom size=".1"/>
    <body><joint axis="0 1 0"/><geom size=".1"/></body></body></body></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    hinged = HingeModel.of(model, Scene(text), model.qpos0[None], np.zeros((1, model.nv)))
    assert Robot.of(hinged.model, "mjlab").joint_names == HingeLayout(model).names[1:]


def test_a_figure_of_hinges_stays_as_it_is_and_a_name_twice_is_refused(tmp_path):
    (tmp_path / "robot.xml").write_text(wild.ROBOT)
    take = SampledTrajectory.of(wild.motion_of(str(tmp_path / "robot.xml")))
    assert take.hinged.model is take.model and not take.hinged.is_other
    np.testing.assert_array_equal(take.hinged.qpos, take.qpos)
    text = BALL_TREE.replace('name="elbow"', 'name="hip_x" type="hinge"/><joint name="elbow"')
    model = mujoco.MjModel.from_xml_string(text)
    with pytest.raises(UserError, match="two joints 'hip_x'"):
        _ = HingeLayout(model).names


T = 50
FIGURE = scene(CART, biped(), BALL)


def recorded() -> tuple[Array, Array, Array]:
    """Places (T, 3), quaternions (T, 4) and six hinges (T, 6) of a robot that turns once round and leans."""
    t = np.linspace(0, 1, T)
    position = np.stack([t, 0.3 * np.sin(t), 0.8 - 0.1 * t], axis=1)
    angles = np.stack([2 * np.pi * t, 0.2 * np.sin(5 * t), 0.3 * t], axis=1)
    rotation = Rotation.from_euler("ZYX", angles).as_quat(scalar_first=True)
    return position, rotation, 0.3 * np.sin(t[:, None] + np.arange(6))


def poses(xml: str, qpos: Array) -> tuple[Array, Array]:
    """(T, 3, 3) [m] and (T, 3, 9) of pelvis and feet."""
    model = mujoco.MjModel.from_xml_string(xml)
    bodies = [model.body(name).id for name in ("pelvis", "left_foot", "right_foot")]
    seen = [kinematics(model, row) for row in qpos]
    return np.array([data.xpos[bodies] for data in seen]), np.array([data.xmat[bodies] for data in seen])


def test_a_recording_moves_the_robot_alone() -> None:
    plain, model = scene(biped()), mujoco.MjModel.from_xml_string(FIGURE)
    expected = poses(plain, configurations(mujoco.MjModel.from_xml_string(plain), "gmr", "f", *recorded()))
    qpos = configurations(model, "gmr", "f", *recorded())
    for one, other in zip(poses(FIGURE, qpos), expected, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-6)
    at = model.joint("cart_free").qposadr[0]
    np.testing.assert_array_equal(qpos[:, at : at + 7], np.tile(model.qpos0[at : at + 7], (T, 1)))


def test_a_figure_on_slides_is_refused() -> None:
    model = mujoco.MjModel.from_xml_string(scene(biped(joints(("tx", "tz", "ry")))))
    with pytest.raises(UserError, match="f: the format 'gmr' is for one figure with a free joint"):
        configurations(model, "gmr", "f", *recorded())
