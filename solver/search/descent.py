"""Steps 3 and 4 of the paper's figure 5 on one timeline: move its variable frames to the nearest minimum of E."""

from __future__ import annotations

from functools import partial

from ..curve.frame import Timeline
from ..objective import Discretised, Objective
from .matrix_free import matrix_free
from .minimum import MOST_EVALUATIONS, TOLERANCE, Improved, Minimum, Optimiser, Stop
from .newton import GaussNewton
from .refinement import LBFGS, METHODS, NONE, algorithm, refine

WIDEST = 150  # columns of the state for which a step of Newton's is worth its matrices, squares of these
FINE = 1e-7  # relative progress at which a timeline is at its minimum, unless told


def check_method(method: str | Optimiser) -> None:
    """Raises ValueError for a name that is no method."""
    if isinstance(method, str) and method.lower() not in METHODS:
        if method.lower() == "newton":
            raise ValueError(f"optimiser 'newton' is called '{NONE}' now: Gauss-Newton steps alone")
        algorithm(method)


def optimiser_of(method: str | Optimiser, width: int, final: float) -> Optimiser:
    """The optimiser that a name means for states of so many columns, whose last rounds have the tolerance `final`; one
    of a program's own is itself."""
    check_method(method)
    if not isinstance(method, str):
        return method
    if width > WIDEST:
        return matrix_free
    stage = None if method.lower() == NONE else partial(refine, method=method)
    return GaussNewton(stage, final)


class Descent:
    """The minimisation of E over one timeline's unknowns."""

    def __init__(self, objective: Objective, timeline: Timeline) -> None:
        self.problem: Discretised = objective.on(timeline)

    def run(
        self,
        *,
        optimiser: str | Optimiser = LBFGS,
        max_evaluations: int = MOST_EVALUATIONS,
        tolerance: float = TOLERANCE,
        improved: Improved | None = None,
    ) -> Minimum:
        """The Minimum, its x in the unknowns of the timeline; `improved` gets (evaluation, Evaluation, x)."""
        found = optimiser_of(optimiser, self.problem.timeline.width, tolerance)
        return found(self.problem, max_evaluations=max_evaluations, tolerance=tolerance, improved=improved)


def optimised(
    objective: Objective, timeline: Timeline, *, max_evaluations: int = MOST_EVALUATIONS, tolerance: float = FINE
) -> Timeline:
    """The timeline with its variable frames at the nearest minimum of E. Ctrl-C goes on to the caller."""
    descent = Descent(objective, timeline)
    found = descent.run(max_evaluations=max_evaluations, tolerance=tolerance)
    if found.stop is Stop.ASKED:
        raise KeyboardInterrupt
    return timeline.with_rows(descent.problem.unknowns.rows(found.x))
