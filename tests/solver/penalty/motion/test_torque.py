"""The torque penalty against mj_inverse, and its gradient."""

import mujoco
import numpy as np
import pytest
from figures import with_armature
from oracles import mujoco_forces
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Torque


@pytest.mark.parametrize("armature", [False, True])
def test_it_is_the_sum_of_squares_of_mj_inverses_joint_entries(figure, rng, armature):
    figure = with_armature(figure, rng) if armature else figure
    samples = random_samples(figure, rng)
    joints = np.array([figure.model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE for j in figure.model.dof_jntid])
    expected = np.sum(mujoco_forces(samples)[:, joints] ** 2, axis=1)
    np.testing.assert_allclose(Torque().evaluate(samples), expected, rtol=1e-9)


@pytest.mark.parametrize("armature", [False, True])
def test_the_gradient_has_taylor_slope_two(figure, rng, armature):
    figure = with_armature(figure, rng) if armature else figure
    assert penalty_slope(Torque(), random_samples(figure, rng), rng) > 1.95


def test_a_pendulum_held_out_level_bears_its_weight_times_its_arm():
    model = mujoco.MjModel.from_xml_string(
        """<mujoco><option gravity="0 0 -10"/><worldbody><body pos="0 0 2"><joint type="hinge" axis="0 1 0"/>
        <inertial mass="3" pos="0.5 0 0" diaginertia="1 1 1"/></body></worldbody></mujoco>"""
    )
    figure = Figure(model)
    level = np.zeros((1, 1))
    np.testing.assert_allclose(Torque().evaluate(Samples(figure, level, level, level)), 15.0**2)
    down = np.full((1, 1), np.pi / 2)
    np.testing.assert_allclose(Torque().evaluate(Samples(figure, down, level, level)), 0, atol=1e-25)
