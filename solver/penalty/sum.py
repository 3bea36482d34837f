"""Several soft constraints that share one name, one weight and one row of the report."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..figure.kinematics import Samples
from .block import Block, Dense
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

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.residuals(samples)

    def nearby(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.nearby(samples)
