"""Inverse dynamics against mj_inverse; figures of all joints and adjoints are in test_any_model."""

import mujoco
import numpy as np
from figures import BALL_TREE
from oracles import mujoco_forces
from random_samples import random_samples

from dynsplines.solver.figure.dynamics import body_forces, generalised_forces
from dynsplines.solver.figure.figure import Figure


def test_net_forces_on_the_bodies_add_up_to_the_root_wrench_of_mj_inverse(figure, rng):
    samples = random_samples(figure, rng)
    forces = body_forces(samples)
    tables = figure.tables
    root = tables.free_links[0]
    inside = tables.path[:, root] > 0
    moment = (
        np.cross((forces.centre - samples.links.x[:, root : root + 1])[:, inside], forces.force[:, inside], axis=0)
        + (forces.torque[:, inside])
    )
    expected = mujoco_forces(samples)[:, :6]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(forces.force[:, inside].sum(axis=1).T, expected[:, :3], atol=1e-11 * scale)
    local = np.einsum("ijs,is->sj", samples.links.rotation[:, :, root], moment.sum(axis=1))
    np.testing.assert_allclose(local, expected[:, 3:], atol=1e-11 * scale)


def test_without_gravity_nothing_has_weight(rng):
    model = mujoco.MjModel.from_xml_string(
        BALL_TREE.replace("<option ", '<option><flag gravity="disable"/></option><option ')
    )
    samples = random_samples(Figure(model), rng)
    expected = mujoco_forces(samples)
    np.testing.assert_allclose(generalised_forces(samples), expected, atol=1e-10 * np.abs(expected).max())
