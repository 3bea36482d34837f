"""The wrench at a free root against mj_inverse, and its adjoint."""

import numpy as np
import pytest
from figures import BALL_TREE, figure_of
from oracles import kinematics, mujoco_forces
from random_samples import random_samples
from taylor import taylor_slope

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.root_wrench import RootWrench, height, weight


def test_force_and_moment_are_those_of_mj_inverse_at_the_root(figure, rng):
    samples = random_samples(figure, rng)
    wrench = RootWrench(samples, 1)
    expected = mujoco_forces(samples)[:, :6]
    rotation, root = samples.links.rotation[:, :, 1], samples.links.x[:, 1]
    at_root = wrench.moment + np.cross(wrench.centre - root, wrench.force, axis=0)
    scale = np.abs(expected).max()
    np.testing.assert_allclose(wrench.force.T, expected[:, :3], atol=1e-11 * scale)
    np.testing.assert_allclose(np.einsum("ijs,is->sj", rotation, at_root), expected[:, 3:], atol=1e-11 * scale)


def test_the_centre_and_the_mass_are_mujocos(figure, rng):
    samples = random_samples(figure, rng)
    wrench = RootWrench(samples, 1)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        np.testing.assert_allclose(wrench.centre[:, i], kinematics(figure.model, qpos).subtree_com[1], atol=1e-12)
    np.testing.assert_allclose(wrench.mass, figure.model.body_subtreemass[1])
    np.testing.assert_allclose(weight(figure, 1), np.linalg.norm(figure.gravity) * figure.model.body_subtreemass[1])


def test_a_slender_rod_is_as_high_as_it_is_long():
    text = """<mujoco><worldbody><body><freejoint/><inertial pos="1 2 3" mass="6" diaginertia="2 2 1e-9"/></body>
    </worldbody></mujoco>"""
    assert height(figure_of(text), 1) == pytest.approx(2)


def test_the_adjoint_has_taylor_slope_two(figure, rng):
    samples = random_samples(figure, rng)
    bars = rng.normal(size=(3, 3, samples.count))
    cotangent = Cotangent(samples)
    RootWrench(samples, 1).pull_back(cotangent, *bars)

    def value(point: np.ndarray) -> float:
        wrench = RootWrench(Samples(figure, *point), 1)
        return float(np.sum(bars * np.array([wrench.force, wrench.moment, wrench.centre])))

    gradients = np.stack(cotangent.gradients())
    assert taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), gradients, rng) > 1.95


def test_without_gravity_the_weight_is_still_a_unit():
    text = BALL_TREE.replace('gravity="0 0 -9.81"', 'gravity="0 0 0"')
    figure = figure_of(text)
    assert weight(figure, 1) == pytest.approx(9.81 * figure.model.body_subtreemass[1])
