"""The minimum of an objective nearest to one timeline, without inserting frames or starting again."""

from __future__ import annotations

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.objective import Objective
from dynsplines.solver.search.descent import minimise
from dynsplines.solver.search.minimum import MOST_EVALUATIONS, TOLERANCE, Stop


def optimise(
    objective: Objective, timeline: Timeline, *, max_evaluations: int = MOST_EVALUATIONS, tolerance: float = TOLERANCE
) -> Timeline:
    """Return the timeline with its variable frames at the nearest minimum of E.

    Raises:
        KeyboardInterrupt: The search was interrupted.
    """
    problem = objective.on(timeline)
    minimum = minimise(problem, max_evaluations=max_evaluations, tolerance=tolerance)
    if minimum.stop is Stop.INTERRUPTED:
        raise KeyboardInterrupt
    return timeline.with_rows(problem.unknowns.rows(minimum.x))
