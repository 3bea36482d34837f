"""Unit magnitude of the state's quaternions: f₁ = (1 − q·q)² (eq. 9), or a smooth form of the paper's |1 − q·q|."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...figure.adjoint import Cotangent
from ...figure.kinematics import Samples
from ..block import Dense
from ..curvature import Curvature
from ..penalty import Normalization, Penalty, Role

EPSILON = 1e-3  # [1] default of `epsilon`


@dataclass(frozen=True)
class UnitMagnitude(Penalty):
    """Σ over quaternion blocks of (1 − b)² with b = q·q, or for the form "absolute" of √((1 − b)² + ε²) − ε.

    Attributes:
        form: "square" or "absolute".
        epsilon: The smoothing ε of the absolute form at b = 1.
        most: The upper limit of the raw spline's mean value in the normalization. A raw spline that swings far out
            between distant keyframes therefore does not let quaternions vanish.
    """

    form: str = "square"
    epsilon: float = EPSILON
    most: float = 1.0

    name = "unit"
    role = Role.SMOOTHNESS

    def __post_init__(self) -> None:
        if self.form not in ("square", "absolute"):
            raise ValueError(f"unit magnitude: form = {self.form!r} is not one of 'square', 'absolute'")

    @property
    def normalization(self) -> Normalization:
        return Normalization(4e-4 if self.form == "square" else 2e-2, raw_cap=self.most)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        excess = samples.q_dots[0] - 1
        value, slope = excess, np.ones_like(excess)
        if self.form == "absolute":  # √(e² + ε²) − ε = (e g)²
            root = np.sqrt(excess**2 + self.epsilon**2)
            g = 1 / np.sqrt(root + self.epsilon)
            value, slope = excess * g, 1 / (2 * root * g)

        def pulled_back(into: Cotangent, bar: Array) -> None:
            into.accumulate("q", (2 * slope * bar) * samples.q, donate=True)

        def curved(into: Curvature, scale: Array) -> None:
            rows = np.zeros((samples.count, excess.shape[0], 1, 3, 4))
            rows[:, :, 0, 0] = (2 * slope * samples.q).transpose(2, 1, 0)
            into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)

        yield Dense(value, pulled_back, curved)
