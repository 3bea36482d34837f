"""What a minimisation is: how it is asked for, what comes out, why it ended."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from ..array import Array
from ..objective import Discretised, Evaluation

Improved = Callable[[int, Evaluation, Array], None]

TOLERANCE = 1e-6  # of a search, unless told: relative progress at which it ends
MOST_EVALUATIONS = 300  # of a search, unless told


class Stop(Enum):
    """Why a minimisation ended, and what the caller can do about it."""

    CONVERGED = "progress per evaluation fell below the tolerance"
    BUDGET = "the evaluation budget is spent; raise max_evaluations (in a clip, solve.evaluations) to go on"
    ASKED = "stopped as asked; the best path so far is kept"
    STUCK = "the optimiser found no further descent; the best path so far is kept"


@dataclass(frozen=True)
class Minimum:
    """The best point seen: x (n,), its value, how many evaluations it took and why the search ended."""

    x: Array
    value: float
    evaluations: int
    stop: Stop


class StopSearch(Exception):
    """Raise inside a callback to end the search and keep the best x."""


class Optimiser(Protocol):
    """A way to lower E over the unknowns of one timeline: any function that is called like this."""

    def __call__(
        self,
        problem: Discretised,
        *,
        max_evaluations: int,
        tolerance: float,
        improved: Improved | None,
    ) -> Minimum:
        """The best point. What it learns in a round for the next it keeps itself.

        problem    E and its gradient, problem(x) -> Evaluation, from problem.unknowns.start
        tolerance  relative progress at which it ends
        improved   to be called with (evaluation, Evaluation, x) whenever E falls below all before; it may raise
                   StopSearch, which like KeyboardInterrupt is to end the search with Stop.ASKED
        """
        ...
