"""Inverse dynamics against mj_inverse; figures of all joints and adjoints are in test_any_model."""

import numpy as np
from oracles import mujoco_forces
from random_samples import random_samples

from dynsplines.solver.figure.dynamics import body_forces


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
