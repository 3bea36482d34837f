"""Several soft constraints that share one name, one weight and one row of the report."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..figure.kinematics import Samples
from .block import Block, Dense
from .penalty import Normalization, Penalty, Role


@dataclass(frozen=True)
class Sum(Penalty):
    """The sum of at least one soft constraint, all of the same unit."""

    parts: tuple[Penalty, ...]
    term_name: str

    @property
    def name(self) -> str:
        return self.term_name

    @property
    def role(self) -> Role:
        return self.parts[0].role

    @property
    def obstructs(self) -> bool:
        return any(part.obstructs for part in self.parts)

    @property
    def normalization(self) -> Normalization:
        return self.parts[0].normalization

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.residuals(samples)

    def nearby(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.nearby(samples)
