"""The paper's form of the covariant acceleration and its Euler-Lagrange residual, against independent formulas."""

from __future__ import annotations

from typing import cast

import numpy as np
import pytest
from curvature_of import assert_squares
from exact_path import exact_path
from paper.equations import PaperAcceleration, covariant_residual, tangential
from paper.orientations import PAPER, Case, moderate, spinner
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration, UnitMagnitude
from dynsplines.solver.refine import euler_lagrange
from dynsplines.solver.refine.euler_lagrange import residual


def test_the_gradient_has_taylor_slope_two(figure, rng):
    assert penalty_slope(PaperAcceleration(), random_samples(figure, rng), rng, any_length=False) > 1.95


def residuals(samples: Samples) -> np.ndarray:
    """q'' off q for quaternions, θ''/2 for hinges, (S, r)."""
    columns = samples.figure.tables.quaternion_columns.T
    q, q_dd = samples.y[:, columns], samples.y_dd[:, columns]
    felt = q_dd - np.sum(q_dd * q, axis=-1, keepdims=True) / np.sum(q * q, axis=-1, keepdims=True) * q
    return np.hstack([felt.reshape(samples.count, -1), samples.y_dd[:, samples.figure.tables.hinge_columns] / 2])


def test_it_is_the_square_of_equation_nine(figure, rng):
    samples = random_samples(figure, rng)
    total = 0.25 * np.sum(samples.y_dd[:, figure.tables.hinge_columns] ** 2, axis=1)
    for columns in figure.tables.quaternion_columns.T:
        q, q_dd = samples.y[:, columns], samples.y_dd[:, columns]
        total += np.sum(q_dd**2, axis=1) - np.sum(q_dd * q, axis=1) ** 2 / np.sum(q * q, axis=1)
    np.testing.assert_allclose(PaperAcceleration().evaluate(samples), total, rtol=1e-9)


def test_the_curvature_is_twice_the_square_of_the_residuals_jacobian(figure, rng):
    assert_squares(PaperAcceleration(), residuals, figure, rng)


def test_it_is_the_solvers_penalty_on_the_unit_sphere_only(figure, rng):
    samples = random_samples(figure, rng)
    y, y_d = samples.y.copy(), samples.y_d.copy()
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] = quat.normalised(y[:, columns])
        along = np.sum(y[:, columns] * y_d[:, columns], axis=1, keepdims=True)
        y_d[:, columns] -= along * y[:, columns]
    on_sphere = Samples(figure, y, y_d, samples.y_dd)
    paper, ours = PaperAcceleration(), CovariantAcceleration()
    np.testing.assert_allclose(paper.evaluate(on_sphere), ours.evaluate(on_sphere), rtol=1e-12)
    assert np.all(np.abs(paper.evaluate(samples) / ours.evaluate(samples) - 1) > 1e-3)


@pytest.mark.parametrize(("nodes", "close"), [(8, 1e-3), (16, 1e-7)])
def test_the_closed_form_is_half_the_residual_of_the_sample_gradients(
    nodes: int, close: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(euler_lagrange, "NODES", nodes)
    path = Case(1).solved(PAPER, 1).path
    generic = residual(Objective.of(spinner(), [(PaperAcceleration(), 1.0), (UnitMagnitude(), 3.0)]), path)
    closed = covariant_residual(path, generic.t.ravel(), 3.0).reshape(generic.value.shape)
    np.testing.assert_allclose(closed, generic.value / 2, atol=close * abs(generic.value).max())


@pytest.mark.slow
def test_on_the_exact_path_the_tangential_residual_vanishes_and_the_radial_one_does_not() -> None:
    path = exact_path(np.arange(7.0), moderate(np.random.default_rng(1), 7))
    t = np.linspace(0.05, 5.95, 40)
    without = covariant_residual(cast(Path, path), t, 3.0)
    whole = without + path.at(t, 4)
    assert abs(tangential(whole, path.at(t))).max() < 1e-8
    assert np.linalg.norm(whole, axis=1).mean() > 0.1
    assert np.linalg.norm(tangential(without, path.at(t)), axis=1).mean() > 1e-3


def test_the_tangential_part_is_orthogonal_to_the_quaternion_whatever_its_length(rng):
    residual, q = rng.normal(size=(20, 4)), rng.normal(size=(20, 4))
    part = tangential(residual, q)
    np.testing.assert_allclose(np.sum(part * q, axis=1), 0, atol=1e-12)
    gone = residual - part
    np.testing.assert_allclose(
        np.abs(np.sum(gone * q, axis=1)), np.linalg.norm(gone, axis=1) * np.linalg.norm(q, axis=1)
    )
    np.testing.assert_allclose(tangential(residual, 3.0 * q), part, atol=1e-12)
    np.testing.assert_allclose(tangential(part, q), part, atol=1e-12)
