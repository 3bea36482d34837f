"""The result of in-betweening: the best timeline, its path, and the trace of the search."""

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
from .tolerances import ROUNDING


@dataclass(frozen=True)
class Improvement:
    """An evaluation that lowered E, or the first one after E got more samples, which may raise it.

    Attributes:
        evaluation: The number of evaluations so far.
        round: The index of the round.
        value: E.
        parts: The contributions of terms, by name.
        build: Returns the timeline of this evaluation.
    """

    evaluation: int
    round: int
    value: float
    parts: dict[str, float]
    build: Callable[[], Timeline]

    @cached_property
    def path(self) -> Path:
        """The path of the timeline."""
        return path_of(self.build())


@dataclass(frozen=True, repr=False)
class Solution:
    """The result of in-betweening.

    Attributes:
        figure: The figure.
        objective: The objective E that the search minimised.
        timeline: The frames of the solution, including variable frames.
        raw: The timeline of the spline through the keyframes alone.
        trace: (evaluation, round, E, parts) of every improvement. E may rise where a round begins.
        evaluations: The number of evaluations.
        stop: Why the search ended.
    """

    figure: Figure
    objective: Objective
    timeline: Timeline
    raw: Timeline
    trace: tuple[tuple[int, int, float, dict[str, float]], ...] = ()
    evaluations: int = 0
    stop: Stop = Stop.CONVERGED

    def __repr__(self) -> str:
        first, last = self.path.span
        return f"<Solution: {first:g} to {last:g} s, {self.evaluations} evaluations, {self.stop.name.lower()}>"

    @property
    def path(self) -> Path:
        """The spline through all frames."""
        return path_of(self.timeline)

    def at(self, t: ArrayLike) -> Array:
        """Return MuJoCo configurations at given times.

        Args:
            t: One time, or (S,) times [s].

        Returns:
            qpos (S, nq), with unit quaternions.

        Raises:
            ValueError: A time is outside the motion.
        """
        first, last = self.path.span
        if np.any(np.asarray(t) < first - ROUNDING) or np.any(np.asarray(t) > last + ROUNDING):
            raise ValueError(f"the motion runs from {first:g} to {last:g} s; give times within")
        return self.figure.to_qpos(self.path.at(np.atleast_1d(np.asarray(t, float))))
