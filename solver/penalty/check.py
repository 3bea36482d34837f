"""Consistency check of a soft constraint: its values and its gradient, on random samples of a figure."""

from __future__ import annotations

import numpy as np

from ..array import Array
from ..figure.adjoint import Cotangent
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from .penalty import Penalty

SAMPLES = 5  # number of random samples
STEPS = np.array([1e-3, 1e-4])  # [1] steps h of the Taylor test


def check(penalty: Penalty, figure: Figure, *, seed: int = 0) -> None:
    """Check values and gradient of a soft constraint on random samples of a figure.

    By a Taylor test, |f(x + h d) − f(x) − h g·d| must be proportional to h² along a random direction d of y, y' and
    y''.

    Args:
        penalty: The soft constraint.
        figure: A figure, such as `load("run_and_step").figure`.
        seed: Seed of the random samples.

    Raises:
        ValueError: A value is negative, infinite or NaN; the gradient is not that of the values; or all values are 0,
            so that nothing was checked.
    """
    rng, name = np.random.default_rng(seed), penalty.name
    samples = _random(figure, rng)
    scale, cotangent = rng.uniform(0.5, 2, SAMPLES), Cotangent(samples)
    values = penalty.evaluate(samples, cotangent, scale)
    if not np.all(np.isfinite(values)) or np.any(values < 0):
        raise ValueError(f"penalty '{name}': a value is {float(np.min(values)):g}; finite ones from 0 on are penalties")
    slope = _taylor_slope(penalty, samples, scale, np.stack(cotangent.gradients()), rng)
    if slope < 1.9:  # 2 for an exact gradient, 1 for a wrong one
        raise ValueError(f"penalty '{name}': its gradient is not that of its values: Taylor slope {slope:.2f}, not 2")
    if not np.any(values):
        raise ValueError(
            f"penalty '{name}': no residual was positive on the samples, at 0 to {samples.t[-1]:g} s, so nothing was "
            "checked; pass another seed, or check the penalty with a bound that random poses violate, or at these times"
        )


def _random(figure: Figure, rng: np.random.Generator) -> Samples:
    """Return samples with poses far from rest and random derivatives of every entry."""
    y = figure.to_state(rng.normal(size=(SAMPLES, figure.width)))
    return Samples(figure, y, rng.normal(size=y.shape), rng.normal(size=y.shape), np.arange(SAMPLES) / SAMPLES)


def _taylor_slope(penalty: Penalty, samples: Samples, scale: Array, gradient: Array, rng: np.random.Generator) -> float:
    """Return the slope of log remainder over log step; 2 if the remainder is only rounding."""
    point = np.stack([samples.y, samples.y_d, samples.y_dd])
    direction = rng.normal(size=point.shape)
    direction /= np.linalg.norm(direction)

    def value(step: float) -> float:
        return float(scale @ penalty.evaluate(Samples(samples.figure, *(point + step * direction), t=samples.t)))

    first, rise = value(0.0), float(np.sum(gradient * direction))
    remainders = np.array([abs(value(step) - first - step * rise) for step in STEPS])
    if np.all(remainders < 1e-10 * max(abs(first), abs(rise), 1.0)):
        return 2.0
    return float(np.diff(np.log(remainders + np.finfo(float).tiny))[0] / np.diff(np.log(STEPS))[0])
