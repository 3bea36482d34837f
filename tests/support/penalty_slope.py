"""The Taylor test of a soft constraint, whose value does not depend on the length of quaternions."""

from __future__ import annotations

import numpy as np
from taylor import taylor_slope

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Penalty


def penalty_slope(penalty: Penalty, samples: Samples, rng: np.random.Generator, *, any_length: bool = True) -> float:
    """The Taylor slope of Σ_s scale_s f(y_s, y'_s, y''_s) along a random direction of all three; with any_length, f is
    also that of quaternions of any length."""
    scale = rng.uniform(0.5, 2, samples.count)
    cotangent = Cotangent(samples)
    values = penalty.evaluate(samples, cotangent, scale)
    np.testing.assert_array_equal(values, penalty.evaluate(samples))
    if any_length:
        np.testing.assert_allclose(penalty.evaluate(scaled_like(samples, rng)), values, rtol=1e-8, atol=1e-12)
    gradients = cotangent.gradients()
    unscaled, ones = Cotangent(samples), Cotangent(samples)
    penalty.evaluate(samples, unscaled)
    penalty.evaluate(samples, ones, np.ones(samples.count))
    for own, expected in zip(unscaled.gradients(), ones.gradients(), strict=True):
        np.testing.assert_allclose(own, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max(initial=0.0))

    def value(point: np.ndarray) -> float:
        return float(scale @ penalty.evaluate(Samples(samples.figure, *point, t=samples.t)))

    return taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng)


def scaled_like(samples: Samples, rng: np.random.Generator) -> Samples:
    """The same rotations at every moment, by quaternions q -> ρ(t) q with ρ, ρ', ρ'' of their own."""
    y, y_d, y_dd = samples.y.copy(), samples.y_d.copy(), samples.y_dd.copy()
    for columns in samples.figure.tables.quaternion_columns.T:
        rho, rho_d, rho_dd = rng.uniform(0.5, 2, (samples.count, 1)), *rng.normal(size=(2, samples.count, 1))
        q, q_d, q_dd = (a[:, columns] for a in (samples.y, samples.y_d, samples.y_dd))
        y[:, columns] = rho * q
        y_d[:, columns] = rho_d * q + rho * q_d
        y_dd[:, columns] = rho_dd * q + 2 * rho_d * q_d + rho * q_dd
    return Samples(samples.figure, y, y_d, y_dd, samples.t)
