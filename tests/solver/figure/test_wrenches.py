"""Wrenches on links and at a free root against MuJoCo's Jacobians, mj_inverse and the adjoint sweep."""

from __future__ import annotations

from unittest import mock

import mujoco
import numpy as np
import pytest
from closed_forms import assert_near
from figures import BALL_TREE, figure_of
from oracles import kinematics, mujoco_forces
from random_model import random_figure
from random_samples import random_samples
from taylor import taylor_slope

from dynsplines.solver import compiled
from dynsplines.solver.array import Index
from dynsplines.solver.figure.adjoint import Cotangent, Quantity
from dynsplines.solver.figure.dynamics import velocities
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.root_wrench import RootWrench, height, weight
from dynsplines.solver.figure.wrenches import Wrenches
from dynsplines.solver.penalty.curvature import jacobian

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


def check(figure: Figure, rng: np.random.Generator) -> None:
    """With the compiled kernel, if there is one, and without."""
    samples = random_samples(figure, rng)
    for names in (ALL, ("force",), ("torque",), ("force", "torque"), ("force_d", "torque_d"), ("torque_dd",)):
        given = some(figure, samples, rng, names)
        expected = by_adjoint(samples, given)
        if np.abs(expected).max() > 0.1:
            assert_near(given.rows(samples), expected, 1e-11)
            with mock.patch.object(compiled, "kernel", None):
                assert_near(given.rows(samples), expected, 1e-11)


def test_rows_are_those_of_the_adjoint_sweep(figure, rng):
    check(figure, rng)


def test_joined_wrenches_have_the_rows_of_all_parts(figure, rng):
    samples = random_samples(figure, rng)
    parts = [some(figure, samples, rng, names) for names in (("force", "torque"), ("force", "torque_d"))]
    rows = Wrenches.joined(parts).rows(samples)
    expected = [part.rows(samples) for part in parts]
    np.testing.assert_allclose(rows[:, 0], np.concatenate([part[:, 0] for part in expected]), atol=1e-12)
    np.testing.assert_allclose(rows[len(expected[0]) :], expected[1], atol=1e-12)
    assert not rows[: len(expected[0]), 1].any()


@pytest.mark.parametrize("coordinates", ["auto", "joint"])
@pytest.mark.parametrize("seed", range(8))
def test_rows_times_the_motion_are_what_mujoco_measures(seed, coordinates):
    """Places and turns change by J v, velocities and spins by J a + J' v."""
    figure, rng = random_figure(seed, coordinates)
    sample = random_samples(figure, rng, count=1)
    model, data = figure.model, mujoco.MjData(figure.model)
    data.qpos, (data.qvel, acceleration) = figure.to_qpos(sample.y)[0], (part[0] for part in velocities(sample))
    mujoco.mj_forward(model, data)
    given = some(figure, sample, rng, ("force", "torque", "force_d", "torque_d"))
    rows = given.rows(sample)
    found = rows[:, 0] @ sample.y_d[0] + rows[:, 1] @ sample.y_dd[0]
    expected = np.empty(given.at.size)
    first = np.zeros((2, 3, model.nv))
    for p, link in enumerate(given.link):
        body = figure.links[link].body if link else 0
        if body and model.body_jntnum[body] > 1:  # an intermediate link is no body of MuJoCo's
            expected[p] = found[p]
            continue
        mujoco.mj_jac(model, data, first[0], first[1], data.xpos[body], body)
        places, turns = first.copy()
        mujoco.mj_jacDot(model, data, first[0], first[1], data.xpos[body], body)
        linear, angular = places @ acceleration + first[0] @ data.qvel, turns @ acceleration + first[1] @ data.qvel
        force, torque, force_d, torque_d = (given.vectors[name][:, p] for name in ALL[:4])
        expected[p] = force @ places @ data.qvel + torque @ turns @ data.qvel + force_d @ linear + torque_d @ angular
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * np.abs(expected).max())


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
