"""Log densities of normal distributions about nought, by NumPy."""

import numpy as np

from dynsplines.solver.array import Array


def log_normal(x: Array, covariance: Array) -> float:
    """Of all of x (n,) together, covariance (n, n)."""
    sign, size = np.linalg.slogdet(2 * np.pi * covariance)
    assert sign > 0
    return float(-0.5 * (size + x @ np.linalg.solve(covariance, x)))
