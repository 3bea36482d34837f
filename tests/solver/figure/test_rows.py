"""Closed-form rows of points and moments, against the adjoint sweep and against differences."""

import mujoco
import numpy as np
import pytest
from closed_forms import CLOSED, PLAIN, assert_near
from figures import BALL_TREE, EVERY_JOINT, with_armature
from random_samples import random_samples

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.dynamics import InverseDynamics
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.jacobian_rows import (
    has_moment_rows,
    moment_rows,
)
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty.curvature import jacobian


@pytest.fixture(params=CLOSED)
def closed(request: pytest.FixtureRequest) -> Figure:
    """A figure in world coordinates whose joints sit at their bodies' origins."""
    return Figure(mujoco.MjModel.from_xml_string(CLOSED[request.param]), "world")


def test_rows_of_moments_are_those_of_the_adjoint_sweep(closed, rng):
    samples = random_samples(closed, rng)
    balls = closed.tables.ball_links
    at, link, axis = (a.ravel() for a in np.meshgrid(range(samples.count), balls, range(3), indexing="ij"))

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        inverse = copies.once(InverseDynamics)
        bar = np.zeros_like(inverse.moment)
        bar[axis[rows], link[rows], np.arange(rows.size)] = 1.0
        inverse.pull_back(cotangent, bar)

    expected = jacobian(samples, at, seeded).reshape(samples.count, -1, 3, closed.width)
    found = moment_rows(samples)
    assert found.shape == (samples.count, 3 * balls.size, 3, closed.width)
    for order in range(3):
        assert_near(found[:, :, order], expected[:, :, order], 1e-11)


def test_rows_of_moments_are_the_differences_of_the_moments(closed, rng):
    samples, h = random_samples(closed, rng, 3), 1e-5
    balls, state = closed.tables.ball_links, np.stack([samples.y, samples.y_d, samples.y_dd])

    def moments(point: Array) -> Array:
        return Samples(closed, *point).once(InverseDynamics).moment[:, balls].transpose(2, 1, 0).reshape(3, -1)

    found = moment_rows(samples)
    for order in range(3):
        for column in range(closed.width):
            by = np.zeros_like(state)
            by[order, :, column] = h
            expected = (moments(state + by) - moments(state - by)) / (2 * h)
            np.testing.assert_allclose(
                found[:, :, order, column], expected, rtol=0, atol=1e-7 * np.abs(found[:, :, order]).max()
            )


def test_the_jacobian_of_many_rows_is_that_of_each(closed, rng, monkeypatch):
    samples = random_samples(closed, rng)
    at = np.array([4, 0, 0, 2, 1, 3, 3])
    weight = rng.normal(size=(at.size, closed.width))

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        np.testing.assert_array_equal(copies.y, samples.y[at[rows]])
        cotangent.buffer("y_d")[:] += weight[rows]

    whole = jacobian(samples, at, seeded)
    monkeypatch.setattr("dynsplines.solver.penalty.curvature.ROWS_AT_ONCE", 3)
    np.testing.assert_array_equal(jacobian(samples, at, seeded), whole)
    np.testing.assert_array_equal(whole[:, 1], weight)
    assert not whole[:, [0, 2]].any()


def test_closed_forms_know_figures_in_world_coordinates_without_offset_joints_only(closed):
    assert has_moment_rows(closed)
    for other in (
        Figure(closed.model, "joint"),
        Figure(mujoco.MjModel.from_xml_string(BALL_TREE), "world"),  # its hip sits off the leg's origin
        Figure(mujoco.MjModel.from_xml_string(EVERY_JOINT)),
    ):
        assert not has_moment_rows(other)


def test_closed_forms_of_moments_know_no_armature_of_balls(closed, rng):
    heavy = with_armature(closed, rng)
    assert not has_moment_rows(heavy)
    on_the_root = mujoco.MjModel.from_xml_string(PLAIN)
    on_the_root.dof_armature[:6] = 0.3
    assert has_moment_rows(Figure(on_the_root, "world"))
