"""Random samples of a figure's motion, and what tests change in them."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples


def random_samples(figure: Figure, rng: np.random.Generator, count: int = 5) -> Samples:
    """States with quaternions well off unit length, and derivatives of every entry."""
    y = figure.to_state(rng.normal(size=(count, figure.width)))
    lengths = rng.uniform(0.7, 1.4, size=(count, figure.width))
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] *= lengths[:, columns[:1]]
    return Samples(figure, y, rng.normal(size=y.shape), 3 * rng.normal(size=y.shape))


def at_times(samples: Samples, t: np.ndarray) -> Samples:
    return Samples(samples.figure, samples.y, samples.y_d, samples.y_dd, t)
