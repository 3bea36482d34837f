"""Rows of wrenches on links, on figures of any joints: against MuJoCo's Jacobians and the adjoint sweep."""

from __future__ import annotations

from unittest import mock

import mujoco
import numpy as np
import pytest
from closed_forms import assert_near
from random_model import random_figure
from random_samples import random_samples

from dynsplines.solver import compiled
from dynsplines.solver.array import Index
from dynsplines.solver.figure.adjoint import Cotangent, Quantity
from dynsplines.solver.figure.dynamics import velocities
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
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
