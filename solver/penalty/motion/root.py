"""Acceleration of the root, and of slides: |T''|²."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...figure.kinematics import Samples
from ..block import Block, every
from ..penalty import Normalization, Penalty


@dataclass(frozen=True)
class RootAcceleration(Penalty):
    """Σ of the squared accelerations of free roots' positions and of slides [m²/s⁴]."""

    name = "acceleration.linear"
    normalization = Normalization(4.0, length_power=2, time_power=4, by_tension=-1.0)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        tables = samples.figure.tables
        yield every(samples, np.concatenate([tables.position_columns.ravel(), tables.slide_columns]), 2)
