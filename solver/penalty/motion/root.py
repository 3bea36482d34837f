"""Acceleration of the root, and of slides: |T''|²."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...figure.adjoint import Cotangent
from ...figure.kinematics import Samples
from ..curvature import Curvature
from ..penalty import Penalty, Scale


@dataclass(frozen=True)
class RootAcceleration(Penalty):
    """Σ of the squared accelerations of free roots' positions and of slides [m²/s⁴]."""

    @property
    def name(self) -> str:
        return "root"

    @property
    def scale(self) -> Scale:
        return Scale(4.0, time_power=4)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        tables = samples.figure.tables
        columns = np.concatenate([tables.position_columns.ravel(), tables.slide_columns])
        accelerations = samples.y_dd[:, columns]
        if into is not None:
            into.buffer("y_dd")[:, columns] += 2 * np.reshape(scale, (-1, 1)) * accelerations
        return np.einsum("sc,sc->s", accelerations, accelerations)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        tables = samples.figure.tables
        into.add_squares(np.concatenate([tables.position_columns.ravel(), tables.slide_columns]), 2, scale)
