"""Covariant acceleration against angular acceleration, the gauge q -> ρ(t) q and Taylor slopes."""

import numpy as np
from random_samples import random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import CovariantAcceleration


def angular_accelerations(samples: Samples) -> np.ndarray:
    """Σ |ω'|²/4 of the state's quaternion blocks, and θ''²/4 of hinges."""
    total = 0.25 * np.sum(samples.y_dd[:, samples.figure.tables.hinge_columns] ** 2, axis=1)
    for columns in samples.figure.tables.quaternion_columns.T:
        q, q_d, q_dd = (a[:, columns] for a in (samples.y, samples.y_d, samples.y_dd))
        rate = quat.product(q_d, quat.inverse(q))
        alpha = 2 * (quat.product(q_dd, quat.inverse(q)) - quat.product(rate, rate))[:, 1:]
        total = total + np.sum(alpha**2, axis=1) / 4
    return total


def test_it_is_a_quarter_of_the_squared_angular_acceleration(figure, rng):
    samples = random_samples(figure, rng)
    np.testing.assert_allclose(CovariantAcceleration().evaluate(samples), angular_accelerations(samples), rtol=1e-11)
