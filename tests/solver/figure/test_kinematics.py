"""Kinematics, wrenches and torques against MuJoCo and differences."""

from __future__ import annotations

from unittest import mock

import mujoco
import numpy as np
import pytest
from figures import assert_near, figure_of, with_armature
from gradients import jacobian, taylor_slope
from oracles import kinematics, mujoco_forces
from random_models import random_figure, random_samples

from dynsplines.solver import compiled
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.adjoint import Cotangent, Quantity
from dynsplines.solver.figure.dynamics import RootWrench, height, weight
from dynsplines.solver.figure.effort_rows import Pushes, joint_rows, wrench_rows
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import boxes
from dynsplines.solver.figure.wrenches import Wrenches
from dynsplines.solver.penalty import Torque


@pytest.mark.parametrize("name", ["x", "x_d", "x_dd", "omega", "alpha", "rotation"])
def test_the_adjoint_of_each_quantity_has_taylor_slope_two(figure, rng, name):
    samples = random_samples(figure, rng)
    weights = rng.normal(size=getattr(samples.links, name).shape)
    cotangent = Cotangent(samples)
    if name == "rotation":
        cotangent.accumulate("turn", np.cross(samples.links.rotation, weights, axis=0).sum(axis=1))
    else:
        cotangent.accumulate(name, weights)
    gradients = cotangent.gradients()

    def value(point: np.ndarray) -> float:
        return float(np.sum(weights * getattr(Samples(figure, *point).links, name)))

    assert taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng) > 1.95


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


SEEDS = range(12)


def some_pushes(samples: Samples, root: int, rng: np.random.Generator) -> Pushes:
    """On links of one root's tree, two at one sample and link."""
    link = rng.choice(np.flatnonzero(samples.figure.tables.path[:, root]), 7)
    at = np.sort(rng.integers(0, samples.count, 7))
    link[1], at[1] = link[0], at[0]
    return Pushes(at, link, rng.normal(0, 0.1, (3, 7)), rng.normal(0, 50, (3, 7)))


def swept(samples: Samples, root: int, pushes: Pushes | None) -> Array:
    """The wrench's rows by one adjoint sweep each, (S, 6, 3, N)."""
    at = np.repeat(np.arange(samples.count), 6)

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        bars = np.zeros((2, 3, rows.size))
        bars[rows % 6 // 3, rows % 3, np.arange(rows.size)] = 1.0
        wrench = RootWrench(copies, root)
        if pushes is None:
            wrench.pull_back(cotangent, bars[0], bars[1])
            return
        push, copy = np.nonzero(pushes.at[:, None] == at[rows])  # every row's own copy gets its sample's
        own = Pushes(copy, pushes.link[push], pushes.offset[:, push], pushes.force[:, push])
        own.pull_back(wrench, cotangent, bars[0], bars[1])

    return jacobian(samples, at, seeded).reshape(samples.count, 6, 3, -1)


def check_wrench(figure: Figure, rng: np.random.Generator) -> int:
    """Compares those of every free root; how many there are."""
    samples, roots = random_samples(figure, rng), figure.tables.free_links
    for root in roots:
        for pushes in (None, some_pushes(samples, root, rng)):
            wrench = RootWrench(samples, root)
            found = wrench_rows(wrench, pushes)
            assert_near(found, swept(samples, root, pushes), 1e-10)
            assert_near(wrench_rows(wrench, pushes, moment=False), found[:, :3], 1e-12)
    return roots.size


def check_efforts(figure: Figure, rng: np.random.Generator) -> int:
    """Compares the rows of all joints' efforts with sweeps of the torque; how many there are."""
    samples = random_samples(figure, rng)
    (efforts,) = Torque().residuals(samples)
    count = len(efforts.value)
    at = np.repeat(np.arange(samples.count), count)

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        bar = np.zeros((count, rows.size))
        bar[rows % count, np.arange(rows.size)] = 1.0
        (own,) = Torque().residuals(copies)
        own.pulled_back(cotangent, bar)

    if count:
        expected = jacobian(samples, at, seeded).reshape(samples.count, count, 3, -1)
        assert_near(joint_rows(samples), expected, 1e-10)
    return count


def test_rows_of_efforts_are_those_of_the_adjoint_sweep(figure, rng):
    assert check_wrench(figure, rng) == figure.tables.free_links.size > 0
    assert check_efforts(figure, rng) > 0
    assert check_efforts(with_armature(figure, rng), rng) > 0


@pytest.mark.parametrize("coordinates", ["auto", "joint"])
def test_so_they_are_on_random_models(coordinates):
    assert sum(check_wrench(*random_figure(seed, coordinates)) for seed in SEEDS) > 5
    assert sum(check_efforts(*random_figure(seed, coordinates)) for seed in SEEDS) > 50
