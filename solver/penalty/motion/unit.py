"""Unit magnitude of the state's quaternions: f₁ = (1 − q·q)² (eq. 9)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...figure.adjoint import Cotangent
from ...figure.kinematics import Samples
from ..block import Dense
from ..curvature import Curvature
from ..penalty import Normalization, Penalty


@dataclass(frozen=True)
class UnitMagnitude(Penalty):
    """Σ over quaternion blocks of (1 − b)² with b = q·q.

    Attributes:
        most: The upper limit of the raw spline's mean value in the normalization. A raw spline that swings far out
            between distant keyframes therefore does not let quaternions vanish.
    """

    most: float = 1.0

    name = "unit"

    @property
    def normalization(self) -> Normalization:
        return Normalization(4e-4, raw_cap=self.most)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        excess = samples.q_dots[0] - 1

        def pulled_back(into: Cotangent, bar: Array) -> None:
            into.accumulate("q", (2 * bar) * samples.q, donate=True)

        def curved(into: Curvature, scale: Array) -> None:
            rows = np.zeros((samples.count, excess.shape[0], 1, 3, 4))
            rows[:, :, 0, 0] = (2 * samples.q).transpose(2, 1, 0)
            into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)

        yield Dense(excess, pulled_back, curved)
