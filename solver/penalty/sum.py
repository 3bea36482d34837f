"""Several soft constraints that share one name, one weight and one row of the report."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .curvature import Curvature
from .one_sided import OneSided
from .penalty import Penalty, Scale


@dataclass(frozen=True)
class Sum(Penalty):
    """Σ of soft constraints of the same unit; at least one."""

    parts: tuple[Penalty, ...]
    called: str

    @property
    def name(self) -> str:
        return self.called

    @property
    def scale(self) -> Scale:
        return self.parts[0].scale

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        return np.add.reduce([part.evaluate(samples, into, scale) for part in self.parts])

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        for part in self.parts:
            part.curvature(samples, into, scale)

    def sides(self, samples: Samples) -> OneSided | None:
        found = [sides for part in self.parts if (sides := part.sides(samples)) is not None]
        return OneSided.joined(found) if found else None
