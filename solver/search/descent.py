"""Steps 3 and 4 of the paper's figure 5 on one timeline: move its variable frames to the nearest minimum of E."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ..array import Array
from ..curve.frame import Timeline
from ..objective import Discretised, Evaluation, Objective
from . import optimiser
from .newton import FIRST_DAMPING, gauss_newton
from .optimiser import Minimum, Stop
from .refinement import refined

NEWTON = "newton"
METHODS = {
    NEWTON: "Gauss-Newton steps on banded matrices",
    **{name: text for name, (_, text) in optimiser.METHODS.items()},
}


def check_method(method: str) -> None:
    """Raises ValueError for a name that is no method."""
    if method.lower() == NEWTON:
        return
    try:
        optimiser.algorithm(method)
    except ValueError:
        known = ", ".join(METHODS)
        raise ValueError(f"no optimiser '{method}'; there are: {known} (or any LD_ name of NLopt)") from None


class Descent:
    """The minimisation of E over one timeline's unknowns: by Gauss-Newton steps, or with NLopt's refinement of each.

    damping  of the Gauss-Newton steps, to begin with and as it was left
    """

    def __init__(self, objective: Objective, timeline: Timeline, *, damping: float = FIRST_DAMPING) -> None:
        self.problem: Discretised = objective.on(timeline)
        self.damping = damping

    def run(
        self,
        *,
        method: str = NEWTON,
        max_evaluations: int = 300,
        tolerance: float = 1e-6,
        improved: Callable[[int, Evaluation, Array], None] | None = None,
    ) -> Minimum:
        """The Minimum, its x in the unknowns of the timeline; `improved` gets (evaluation, Evaluation, x)."""
        check_method(method)
        search = gauss_newton if method.lower() == NEWTON else partial(refined, method=method)
        found, self.damping = search(
            self.problem,
            max_evaluations=max_evaluations,
            tolerance=tolerance,
            damping=self.damping,
            improved=improved,
        )
        return found


def optimised(
    objective: Objective, timeline: Timeline, *, max_evaluations: int = 300, tolerance: float = 1e-7
) -> Timeline:
    """The timeline with its variable frames at the nearest minimum of E. Ctrl-C goes on to the caller."""
    descent = Descent(objective, timeline)
    found = descent.run(max_evaluations=max_evaluations, tolerance=tolerance)
    if found.stop is Stop.ASKED:
        raise KeyboardInterrupt
    return timeline.with_rows(descent.problem.unknowns.rows(found.x))
