"""The torque penalty against mj_inverse, and its gradient."""

import mujoco
import numpy as np
import pytest
from figures import with_armature
from oracles import mujoco_forces
from random_samples import random_samples

from dynsplines.solver.penalty import Torque


@pytest.mark.parametrize("armature", [False, True])
def test_it_is_the_sum_of_squares_of_mj_inverses_joint_entries(figure, rng, armature):
    figure = with_armature(figure, rng) if armature else figure
    samples = random_samples(figure, rng)
    joints = np.array([figure.model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE for j in figure.model.dof_jntid])
    expected = np.sum(mujoco_forces(samples)[:, joints] ** 2, axis=1)
    np.testing.assert_allclose(Torque().evaluate(samples), expected, rtol=1e-9)
