"""Covariant acceleration against angular acceleration, the gauge q -> ρ(t) q, the paper's form on the sphere."""

import numpy as np
import pytest
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import CovariantAcceleration
from dynsplines.solver.penalty.motion.covariant import covariant_acceleration


def angular_accelerations(samples: Samples) -> np.ndarray:
    """Σ |ω'|²/4 of the state's quaternion blocks, and θ''²/4 of hinges."""
    total = 0.25 * np.sum(samples.y_dd[:, samples.figure.tables.hinge_columns] ** 2, axis=1)
    for columns in samples.figure.tables.quaternion_columns.T:
        alpha = quat.angular_acceleration(*(a[:, columns] for a in (samples.y, samples.y_d, samples.y_dd)))
        total = total + np.sum(alpha**2, axis=1) / 4
    return total


@pytest.mark.parametrize("form", ["intrinsic", "paper"])
def test_the_gradient_has_taylor_slope_two(figure, rng, form):
    assert (
        penalty_slope(CovariantAcceleration(form), random_samples(figure, rng), rng, any_length=form != "paper") > 1.95
    )


def test_the_intrinsic_form_is_a_quarter_of_the_squared_angular_acceleration(figure, rng):
    samples = random_samples(figure, rng)
    np.testing.assert_allclose(CovariantAcceleration().evaluate(samples), angular_accelerations(samples), rtol=1e-11)


def test_the_papers_form_is_the_intrinsic_one_on_the_unit_sphere(figure, rng):
    samples = random_samples(figure, rng)
    y, y_d = samples.y.copy(), samples.y_d.copy()
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] = quat.normalised(y[:, columns])
        along = np.sum(y[:, columns] * y_d[:, columns], axis=1, keepdims=True)
        y_d[:, columns] -= along * y[:, columns]
    on_sphere = Samples(figure, y, y_d, samples.y_dd)
    np.testing.assert_allclose(
        CovariantAcceleration("paper").evaluate(on_sphere), CovariantAcceleration().evaluate(on_sphere), rtol=1e-12
    )
    paper, intrinsic = (CovariantAcceleration(form).evaluate(samples) for form in ("paper", "intrinsic"))
    assert np.all(np.abs(paper / intrinsic - 1) > 1e-3)


def test_the_papers_form_is_the_square_of_equation_nine(figure, rng):
    samples = random_samples(figure, rng)
    total = 0.25 * np.sum(samples.y_dd[:, figure.tables.hinge_columns] ** 2, axis=1)
    for columns in figure.tables.quaternion_columns.T:
        q, q_dd = samples.y[:, columns], samples.y_dd[:, columns]
        felt = covariant_acceleration(q, q_dd)
        np.testing.assert_allclose(np.sum(felt * q, axis=1), 0, atol=1e-12)
        closed = np.sum(q_dd**2, axis=1) - np.sum(q_dd * q, axis=1) ** 2 / np.sum(q * q, axis=1)
        np.testing.assert_allclose(np.sum(felt**2, axis=1), closed, rtol=1e-9)
        total = total + closed
    np.testing.assert_allclose(CovariantAcceleration("paper").evaluate(samples), total, rtol=1e-9)


def test_an_unknown_form_is_refused():
    with pytest.raises(ValueError, match="'flat' is not one of 'intrinsic', 'paper'"):
        CovariantAcceleration("flat")
