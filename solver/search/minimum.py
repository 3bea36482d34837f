"""The interface of optimisers: the protocol of an optimiser, its result, and its stop reasons."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from ..array import Array
from ..objective import Discretised, Evaluation

Improved = Callable[[int, Evaluation, Array], None]

TOLERANCE = 1e-6  # [1] default progress per evaluation at which a search ends, relative to E
MOST_EVALUATIONS = 300  # default evaluation budget


class Stop(Enum):
    """Why a minimisation ended, and what the caller can do about it."""

    CONVERGED = "progress per evaluation fell below the tolerance"
    MAX_EVALUATIONS = "the evaluation budget is spent; raise max_evaluations (in a clip, solve.evaluations) to continue"
    INTERRUPTED = "interrupted; the best path so far is kept"
    NO_PROGRESS = "the optimiser found no further descent; the best path so far is kept"


@dataclass(frozen=True)
class Minimum:
    """The result of a minimisation.

    Attributes:
        x: The best point evaluated, (n,).
        value: The objective E at x.
        evaluations: The number of evaluations.
        stop: Why the minimisation ended.
    """

    x: Array
    value: float
    evaluations: int
    stop: Stop


class StopSearch(Exception):
    """Raise inside a callback to end the search and keep the best x."""


class Optimiser(Protocol):
    """A function that minimises the objective E over the unknowns of a timeline.

    A timeline contains keyframes and variable frames at fixed times. The unknowns are the variable frames and the free
    entries of partial keyframes.
    """

    def __call__(
        self,
        problem: Discretised,
        *,
        max_evaluations: int,
        tolerance: float,
        improved: Improved | None,
    ) -> Minimum:
        """Return the best point. An optimiser may store state for the next round.

        Args:
            problem: E and its gradient: problem(x) returns an `Evaluation`. The search starts at
                problem.unknowns.start, (n,).
            max_evaluations: The evaluation budget.
            tolerance: Relative progress at which the search ends.
            improved: Called with (evaluation, Evaluation, x) whenever E falls below all earlier values. It may raise
                StopSearch. Then, and after KeyboardInterrupt, the search must end with Stop.INTERRUPTED.

        Returns:
            The best point, its value, and the reason for the stop.
        """
        ...
