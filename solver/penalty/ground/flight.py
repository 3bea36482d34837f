"""Flight: with nothing to push on, the centre of mass falls freely, and the angular momentum about it stays.

This goes beyond the paper. What is penalised is the wrench that would have to come from nothing, see `RootWrench`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array, Mask
from ...figure.adjoint import Cotangent
from ...figure.figure import Figure
from ...figure.jacobian_rows import Pushes, has_moment_rows, wrench_rows
from ...figure.joint_wrench import any_wrench_rows
from ...figure.kinematics import Samples
from ...figure.wrench import RootWrench, height, weight
from ..curvature import Curvature
from ..penalty import Penalty, Scale

A_TENTH = 0.01  # a tenth of the weight, squared


@dataclass(frozen=True)
class Flight(Penalty):
    """|F|² + angular · |N|² of a tree in flight: force in units of its weight, which is |a − g|²/g² of the centre of
    mass, and moment about it in units of its weight times its height.

    root       index of the tree's free link
    intervals  (first, last) [s] of every flight
    unit       [N] its weight;  length  [m] its height, see `height`
    angular    how much the moment counts
    """

    root: int
    intervals: tuple[tuple[float, float], ...]
    unit: float
    length: float
    angular: float = 0.0

    @property
    def name(self) -> str:
        return "flight"

    @classmethod
    def of(cls, figure: Figure, root: int, intervals: tuple[tuple[float, float], ...], angular: float = 0.0) -> Flight:
        return cls(root, intervals, weight(figure, root), height(figure, root), angular)

    @property
    def scale(self) -> Scale:
        return Scale(A_TENTH, is_violation=True, is_sharp=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = np.zeros(samples.count)
        aloft = within(self.intervals, samples.t)
        if not aloft.any():
            return values
        wrench = RootWrench(samples, self.root)
        shares = np.array([1.0, self.angular / self.length**2]) / self.unit**2
        force, moment = wrench.force * aloft, wrench.moment * aloft
        if into is not None:
            wrench.pull_back(into, 2 * scale * shares[0] * force, 2 * scale * shares[1] * moment)
        values += shares[0] * np.einsum("is,is->s", force, force)
        values += shares[1] * np.einsum("is,is->s", moment, moment)
        return values

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        at = np.flatnonzero(within(self.intervals, samples.t))
        if not at.size:
            return
        rows = rows_of_wrench(samples.taken(at), self.root)
        rows = rows * (np.repeat([1.0, np.sqrt(self.angular) / self.length], 3) / self.unit)[:, None, None]
        rows = rows[:, : 6 if self.angular else 3]
        each = np.repeat(at, rows.shape[1])
        into.add_rows(each, scale[each], rows.reshape(each.size, 3, -1))


def within(intervals: tuple[tuple[float, float], ...], t: Array) -> Mask:
    """(S,) whether times t (S,) lie in one of the intervals."""
    edges = np.reshape(intervals, (-1, 2))
    return np.any((edges[:, :1] <= t) & (t <= edges[:, 1:]), axis=0)


def rows_of_wrench(samples: Samples, root: int, pushes: Pushes | None = None) -> Array:
    """`wrench_rows`, whatever the figure's joints and coordinates: (S, 6, 3, N)."""
    rows = wrench_rows if has_moment_rows(samples.figure) else any_wrench_rows
    return rows(RootWrench(samples, root), pushes)
