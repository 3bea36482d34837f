"""Speed: joints rotate at most at a maximum speed. Not in the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches
from ..block import Block
from ..penalty import Normalization, Penalty, Role

STILL = 1e-12  # [rad/s] smallest divisor, against division by zero


@dataclass(frozen=True, eq=False)
class Speed(Penalty):
    """Σ over hinges and ball joints of max(0, |ω − ω_parent| − limit)² [rad²/s²].

    Attributes:
        links: The links that the joints rotate, (J,).
        limits: The maximum speeds, (J,) [rad/s].
    """

    links: Index
    limits: Array

    name = "limits.speed"
    role = Role.LIMIT
    normalization = Normalization(1.0, is_violation=True, time_power=2, is_sharp=True)

    @classmethod
    def of(cls, figure: Figure, limit: float) -> Speed:
        """Return the penalty of all hinges and ball joints with one limit [rad/s]."""
        links = figure.tables.rotary_links
        return cls(links, np.full(links.size, limit))

    def residuals(self, samples: Samples) -> Iterator[Block]:
        relative = self._relative(samples)
        size = np.linalg.norm(relative, axis=0)
        at, joint = np.nonzero((size > self.limits[:, None]).T)
        fast, link = size[joint, at], self.links[joint]
        axis = relative[:, joint, at] / np.maximum(fast, STILL)
        parent = samples.figure.tables.parents[link]
        changes = Wrenches(at, link, torque_d=axis), Wrenches(at, parent, torque_d=-axis)
        yield Block(at, fast - self.limits[joint], changes)

    def speeds(self, samples: Samples) -> Array:
        return np.linalg.norm(self._relative(samples), axis=0)

    def _relative(self, samples: Samples) -> Array:
        omega, parents = samples.links.omega, samples.figure.tables.parents
        return omega[:, self.links] - omega[:, parents[self.links]]
