"""Closed rows of points on figures of any joints, against the adjoint sweep."""

from __future__ import annotations

import numpy as np
import pytest
from closed_forms import assert_near, some_points
from random_model import random_figure
from random_samples import random_samples

from dynsplines.solver.array import Index
from dynsplines.solver.figure import joint_rows
from dynsplines.solver.figure.adjoint import Cotangent, attached_pulled_back
from dynsplines.solver.figure.algebra import cross
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.joint_rows import any_point_rows, any_velocity_rows
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty.curvature import jacobian


def check(figure: Figure, rng: np.random.Generator) -> None:
    samples = random_samples(figure, rng)
    at, link, offset, direction = some_points(figure, samples, rng)

    def of_place(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        here = np.arange(rows.size)
        cotangent.buffer("x")[:, link[rows], here] = direction[:, rows]
        cotangent.buffer("turn")[:, link[rows], here] = cross(offset[:, rows], direction[:, rows])

    def of_velocity(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        here = np.arange(rows.size)
        every = np.zeros((3, rows.size, rows.size))
        arms = every.copy()
        every[:, here, here], arms[:, here, here] = direction[:, rows], offset[:, rows]
        for i, owner in enumerate(link[rows]):
            cotangent.buffer("x_d")[:, owner, i] += direction[:, rows[i]]
        attached_pulled_back(cotangent, arms, (None, every, None), link[rows])

    assert_near(any_point_rows(samples, at, link, offset, direction), jacobian(samples, at, of_place)[:, 0], 1e-11)
    assert_near(
        any_velocity_rows(samples, at, link, offset, direction), jacobian(samples, at, of_velocity)[:, :2], 1e-11
    )


def test_rows_are_those_of_the_adjoint_sweep(figure, rng):
    check(figure, rng)


@pytest.mark.parametrize("coordinates", ["auto", "joint"])
@pytest.mark.parametrize("seed", range(12))
def test_so_they_are_on_random_models(seed, coordinates):
    check(*random_figure(seed, coordinates))


def test_many_points_are_taken_in_parts(figure, rng, monkeypatch):
    monkeypatch.setattr(joint_rows, "AT_ONCE", 60)
    samples = random_samples(figure, rng)
    at, link = rng.integers(0, samples.count, 200), rng.integers(1, len(figure.links), 200)
    offset, direction = rng.normal(size=(2, 3, at.size))
    parts = any_point_rows(samples, at, link, offset, direction)
    monkeypatch.undo()
    np.testing.assert_allclose(parts, any_point_rows(samples, at, link, offset, direction), atol=1e-12)


def test_points_of_the_world_have_no_rows(figure, rng):
    samples = random_samples(figure, rng)
    zeros, offset = np.zeros(3, np.intp), rng.normal(size=(3, 3))
    assert not any_point_rows(samples, zeros, zeros, offset, offset).any()
    assert not any_velocity_rows(samples, zeros, zeros, offset, offset).any()
