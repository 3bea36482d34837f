"""Steps 3 and 4 of the paper's figure 5 on one timeline: move its variable frames to the nearest minimum of E."""

from __future__ import annotations

from ..objective import Discretised
from .minimum import MOST_EVALUATIONS, TOLERANCE, Improved, Minimum, Optimiser
from .newton import GaussNewton
from .nlopt_methods import LBFGS, METHODS, algorithm

WIDEST = 300  # largest number of columns of the state; time and memory of Newton steps are at least quadratic in it


def check_method(method: str | Optimiser) -> None:
    """Check the name of a method.

    Raises:
        ValueError: The name is not in METHODS and not an NLopt algorithm.
    """
    if isinstance(method, str) and method.lower() not in METHODS:
        algorithm(method)


def optimiser_of(method: str | Optimiser, width: int, final: float) -> Optimiser:
    """Return the optimiser for a method.

    Args:
        method: A name from METHODS or of NLopt; or an optimiser, which is returned unchanged.
        width: The number of columns of the state, N.
        final: The tolerance of the last rounds.

    Raises:
        ValueError: The method is unknown, or the state too wide for it.
    """
    check_method(method)
    if not isinstance(method, str):
        return method
    if width > WIDEST:
        raise ValueError(
            f"the figure has {width} coordinates, more than the {WIDEST} that a search supports; remove or weld joints"
        )
    return GaussNewton(method, final)


def minimise(
    problem: Discretised,
    *,
    optimiser: str | Optimiser = LBFGS,
    max_evaluations: int = MOST_EVALUATIONS,
    tolerance: float = TOLERANCE,
    improved: Improved | None = None,
) -> Minimum:
    """Minimise E over one timeline's unknowns, the x (n,) of the result.

    Args:
        tolerance: Relative progress at which the search ends.
        improved: Called with (evaluation, Evaluation, x) whenever E falls.
    """
    minimise = optimiser_of(optimiser, problem.timeline.width, tolerance)
    return minimise(problem, max_evaluations=max_evaluations, tolerance=tolerance, improved=improved)
