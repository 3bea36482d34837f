"""Sums of squares: a soft constraint that gives its residuals and how to pull them back has the rest from here."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from ..array import Array, Index
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .curvature import Curvature, jacobian
from .penalty import Penalty


class SumOfSquares(Penalty):
    """f_j = Σ_r residual_r², smooth: value, gradient and Gauss-Newton curvature follow from two methods.

    The curvature takes a sweep of the kinematics for every residual: where they are many, rows in closed form, as
    `CovariantAcceleration` and `Torque` have them, are faster.
    """

    @abstractmethod
    def residuals(self, samples: Samples) -> Array:
        """(R, S): R of them at every sample; zero at times when the constraint asks nothing."""

    @abstractmethod
    def pull_back(self, samples: Samples, into: Cotangent, bar: Array) -> None:
        """Adds the gradient of Σ bar · residuals to `into`, bar (R, S)."""

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        found = self.residuals(samples)
        if into is not None:
            self.pull_back(samples, into, 2 * scale * found)
        return np.sum(found**2, axis=0)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        count, residuals = samples.count, len(self.residuals(samples))
        at, which = np.repeat(np.arange(count), residuals), np.tile(np.arange(residuals), count)

        def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
            bar = np.zeros((residuals, copies.count))
            bar[which[rows], np.arange(rows.size)] = 1.0
            self.pull_back(copies, cotangent, bar)

        into.add_rows(at, scale[at], jacobian(samples, at, seeded))
