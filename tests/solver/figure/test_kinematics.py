"""Kinematics, wrenches and torques against MuJoCo and differences."""

from unittest import mock

import mujoco
import numpy as np
import pytest
from figures import assert_near, figure_of
from gradients import jacobian
from oracles import kinematics, mujoco_forces
from random_models import random_samples

from dynsplines.solver import compiled
from dynsplines.solver.array import Index
from dynsplines.solver.figure.adjoint import Cotangent, Quantity
from dynsplines.solver.figure.dynamics import RootWrench, height, weight
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import boxes
from dynsplines.solver.figure.wrenches import Wrenches


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
