"""The seam of a loop: where its last frame stands beside its first, and how smoothly the curve goes on across it.

    last = signs · first + travel        y' and y'' of the end = signs · those of the start

signs are −1 in the columns of quaternions that come back as −q, after a full turn. travel is how far a free root comes
in one period: a walk cycle repeats itself, moved on. It is constant, so it does not show in y' and y'': a column that
travels is a ramp plus a periodic remainder, and a cubic spline holds both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .figure import Figure
from .frame import Timeline
from .quaternion import Array
from .spline import Path


@dataclass(frozen=True, eq=False)
class Seam:
    """How a state (N,) comes back: signs (N,) ±1, travel (N,) [m], zero but for the positions of free roots."""

    signs: Array
    travel: Array

    @classmethod
    def between(cls, figure: Figure, first: Array, last: Array) -> Seam:
        """The seam of a loop that begins and ends with these states (N,)."""
        signs = sameness(figure, first, last)
        travel = np.zeros(first.size)
        moving = figure.tables.position_columns.ravel()
        travel[moving] = last[moving] - first[moving]
        return cls(signs, travel)

    @classmethod
    def of(cls, figure: Figure, timeline: Timeline) -> Seam:
        """The seam of a periodic timeline."""
        return cls.between(figure, timeline.states[0], timeline.states[-1])

    def moved(self, states: Array, periods: int = 1) -> Array:
        """States (..., N) some periods later."""
        return states * self.signs**periods + periods * self.travel

    def apart(self, path: Path) -> Array:
        """(3,) the largest entry by which y, y' and y'' at the end of a loop miss those at the start, moved on."""
        start, end = (path.motion(np.array([t]))[:, 0] for t in path.span)
        wanted = start * self.signs
        wanted[0] += self.travel
        return np.abs(end - wanted).max(axis=1)


def sameness(figure: Figure, first: Array, last: Array) -> Array:
    """(N,): +1, or −1 in the columns of quaternions that come back on the other hemisphere."""
    signs = np.ones(first.size)
    for columns in figure.tables.quaternion_columns.T:
        if first[columns] @ last[columns] < 0:
            signs[columns] = -1.0
    return signs
