"""Steps 3 and 4 of the paper's figure 5 on one timeline: move its variable frames to the nearest minimum of E."""

from __future__ import annotations

from functools import partial

from ..curve.frame import Timeline
from ..objective import Discretised, Objective
from . import methods
from .minimum import MOST_EVALUATIONS, TOLERANCE, Improved, Minimum, Optimiser, Stop
from .newton import FIRST_DAMPING, gauss_newton

WIDEST = 150  # columns of the state for which a step of Newton's is worth its matrices, squares of these

FINE = 1e-7  # relative progress at which a timeline is at its minimum, unless told
NEWTON = "newton"
METHODS = {
    NEWTON: "Gauss-Newton steps on banded matrices",
    **{name: text for name, (_, text) in methods.METHODS.items()},
}


def check_method(method: str | Optimiser) -> None:
    """Raises ValueError for a name that is no method."""
    if not isinstance(method, str) or method.lower() in METHODS:
        return
    from . import optimiser  # only here: NLopt knows more names than we do

    try:
        optimiser.algorithm(method)
    except ValueError:
        known = ", ".join(METHODS)
        raise ValueError(f"no optimiser '{method}'; there are: {known} (or any LD_ name of NLopt)") from None


class Descent:
    """The minimisation of E over one timeline's unknowns: by Gauss-Newton steps, with NLopt's refinement of each, or by
    an optimiser of one's own.

    damping  of the Gauss-Newton steps, to begin with and as it was left
    """

    def __init__(self, objective: Objective, timeline: Timeline, *, damping: float = FIRST_DAMPING) -> None:
        self.problem: Discretised = objective.on(timeline)
        self.damping = damping

    def run(
        self,
        *,
        method: str | Optimiser = NEWTON,
        max_evaluations: int = MOST_EVALUATIONS,
        tolerance: float = TOLERANCE,
        improved: Improved | None = None,
    ) -> Minimum:
        """The Minimum, its x in the unknowns of the timeline; `improved` gets (evaluation, Evaluation, x)."""
        check_method(method)
        found, self.damping = _optimiser(method, self.problem)(
            self.problem,
            max_evaluations=max_evaluations,
            tolerance=tolerance,
            damping=self.damping,
            improved=improved,
        )
        return found


def _optimiser(method: str | Optimiser, problem: Discretised) -> Optimiser:
    """The one that a name means, for problems of this size; one of a program's own is itself."""
    if not isinstance(method, str):
        return method
    if problem.timeline.width > WIDEST:
        from .matrix_free import matrix_free

        return matrix_free
    if method.lower() == NEWTON:
        return gauss_newton
    from .refinement import refined  # only here: it needs NLopt

    return partial(refined, method=method)


def optimised(
    objective: Objective, timeline: Timeline, *, max_evaluations: int = MOST_EVALUATIONS, tolerance: float = FINE
) -> Timeline:
    """The timeline with its variable frames at the nearest minimum of E. Ctrl-C goes on to the caller."""
    descent = Descent(objective, timeline)
    found = descent.run(max_evaluations=max_evaluations, tolerance=tolerance)
    if found.stop is Stop.ASKED:
        raise KeyboardInterrupt
    return timeline.with_rows(descent.problem.unknowns.rows(found.x))
