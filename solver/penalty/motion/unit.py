"""Unit magnitude of the state's quaternions: f₁ = (1 − q·q)² (eq. 9), or the paper's |1 − q·q|, made smooth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...figure.adjoint import Cotangent
from ...figure.kinematics import Samples
from ..curvature import Curvature
from ..penalty import Penalty, Scale

EPSILON = 1e-3  # unless told


@dataclass(frozen=True)
class UnitMagnitude(Penalty):
    """Σ over quaternion blocks of (1 − b)², b = q·q; with form "absolute", of √((1 − b)² + ε²) − ε.

    epsilon  the absolute form's rounding of the corner at b = 1
    most     what the raw spline is taken to have of it at most, on the average: one that swings far out between distant
             keyframes must not let quaternions vanish
    """

    form: str = "square"
    epsilon: float = EPSILON
    most: float = 1.0

    @property
    def name(self) -> str:
        return "unit"

    def __post_init__(self) -> None:
        if self.form not in ("square", "absolute"):
            raise ValueError(f"unit magnitude: form = {self.form!r} is not one of 'square', 'absolute'")

    @property
    def scale(self) -> Scale:
        return Scale(4e-4 if self.form == "square" else 2e-2, most=self.most)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        excess = samples.q_dots[0] - 1
        if self.form == "square":
            values, slope = excess * excess, 2 * excess
        else:
            root = np.sqrt(excess**2 + self.epsilon**2)
            values, slope = root - self.epsilon, excess / root
        if into is not None:
            into.absorb("q", (2 * scale * slope) * samples.q)
        return values.sum(axis=0)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        excess = samples.q_dots[0] - 1
        slope = 2.0 if self.form == "square" else np.sqrt(2) / (excess**2 + self.epsilon**2) ** 0.25
        rows = np.zeros((samples.count, excess.shape[0], 1, 3, 4))
        rows[:, :, 0, 0] = (slope * samples.q).transpose(2, 1, 0)
        into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)
