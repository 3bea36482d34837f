"""Flight: without contact, the centre of mass is in free fall and the angular momentum about it is constant.

This goes beyond the paper. The penalised wrench is the one that no contact supplies, see `RootWrench`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...contacts.contact import within
from ...figure.adjoint import Cotangent
from ...figure.dynamics import RootWrench, height, weight
from ...figure.effort_rows import wrench_rows
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ..block import Dense
from ..curvature import Curvature
from ..penalty import Normalization, Penalty, Role

A_TENTH = 0.01  # the square of a tenth of the weight


@dataclass(frozen=True)
class Flight(Penalty):
    """|F|² + angular · |N|² of a tree in flight.

    The force F is in units of the weight, so that |F|² is |a − g|²/g² of the centre of mass. The moment N about the
    centre of mass is in units of weight times height.

    root       index of the tree's free link
    intervals  (first, last) [s] of every flight
    unit       weight [N];  length  height [m], see `height`
    angular    weight of the moment
    """

    root: int
    intervals: tuple[tuple[float, float], ...]
    unit: float
    length: float
    angular: float = 0.0

    name = "flight"
    role = Role.PHYSICS
    is_sharp = True
    normalization = Normalization(A_TENTH)

    @classmethod
    def of(cls, figure: Figure, root: int, intervals: tuple[tuple[float, float], ...], angular: float = 0.0) -> Flight:
        return cls(root, intervals, weight(figure, root), height(figure, root), angular)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        aloft = within(self.intervals, samples.t)
        at = np.flatnonzero(aloft)
        if not at.size:
            return
        wrench = RootWrench(samples, self.root)
        share = np.repeat([1.0, np.sqrt(self.angular) / self.length], 3)[: 6 if self.angular else 3] / self.unit
        value = share[:, None] * (np.concatenate([wrench.force, wrench.moment])[: share.size] * aloft)

        def pulled_back(into: Cotangent, bar: Array) -> None:
            felt = np.zeros((6, samples.count))
            felt[: share.size] = share[:, None] * bar * aloft
            wrench.pull_back(into, felt[:3], felt[3:])

        def curved(into: Curvature, scale: Array) -> None:
            wrench = RootWrench(samples.select(at), self.root)
            rows = share[:, None, None] * wrench_rows(wrench, moment=bool(self.angular))
            each = np.repeat(at, share.size)
            into.add_rows(each, scale[each], rows.reshape(each.size, 3, -1))

        yield Dense(value, pulled_back, curved)
