"""What comes out of the verb: the best timeline and its path, and how the search went."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .array import Array
from .curve.frame import Timeline
from .curve.spline import Path, path_of
from .figure.figure import Figure
from .objective import Objective
from .search.minimum import Stop

AT_AN_END = 1e-9  # [s] beyond the first and the last keyframe, which rounding takes a time to


@dataclass(frozen=True)
class Improvement:
    """An evaluation that lowered E: its number in all, the round, E, its parts by term, and a way to its timeline."""

    evaluation: int
    round: int
    value: float
    parts: dict[str, float]
    build: Callable[[], Timeline]

    @cached_property
    def path(self) -> Path:
        """The curve as it stands."""
        return path_of(self.build())


@dataclass(frozen=True)
class Solution:
    """The best timeline that was found, the raw one to compare with, and how it went.

    trace  (evaluation, round, E, parts) of every evaluation that lowered E
    """

    figure: Figure
    objective: Objective
    timeline: Timeline
    raw: Timeline
    trace: tuple[tuple[int, int, float, dict[str, float]], ...] = ()
    evaluations: int = 0
    stop: Stop = Stop.CONVERGED

    @property
    def path(self) -> Path:
        """The spline through all frames."""
        return path_of(self.timeline)

    @property
    def is_raw(self) -> bool:
        """Whether nothing was searched and it is the raw spline, as a recording is."""
        pairs = [(line.times, line.states, line.end_slope) for line in (self.raw, self.timeline)]
        return self.evaluations == 0 and all(map(np.array_equal, *pairs))

    def at(self, t: ArrayLike) -> Array:
        """MuJoCo configurations at times t (S,) [s] of the clip: (S, nq), quaternions unit."""
        first, last = self.path.span
        if np.any(np.asarray(t) < first - AT_AN_END) or np.any(np.asarray(t) > last + AT_AN_END):
            raise ValueError(f"the motion runs from {first:g} to {last:g} s; there is nothing to see outside")
        return self.figure.to_qpos(self.path.at(np.atleast_1d(np.asarray(t, float))))
