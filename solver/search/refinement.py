"""Minimisation of E by NLopt's methods, in variables in which the Gauss-Newton model of E is a sphere.

NLopt sees E alone and lowers it where the model errs; but no smooth metric foresees which contacts come and go, and a
metric grows old. So every few evaluations a new model is made, its own step is taken, and NLopt searches on from there
in the variables that the curvature at the end of this step whitens. A dense method is left out of large problems, whose
steps are the model's alone.
"""

from __future__ import annotations

import numpy as np

from ..array import Array
from ..objective import Discretised
from .methods import copes
from .minimum import Improved, Minimum, Stop, StopSearch
from .newton import FIRST_DAMPING, Search
from .optimiser import minimise
from .preconditioner import Preconditioner

FEW = 6  # evaluations of NLopt with one factor, which costs about ten


def refined(
    problem: Discretised,
    *,
    method: str,
    max_evaluations: int,
    tolerance: float,
    damping: float = FIRST_DAMPING,
    improved: Improved | None = None,
) -> tuple[Minimum, float]:
    """As `gauss_newton`, by steps of the model and a few evaluations of one of NLopt's methods after each.

    tolerance  stop when a step and what follows it lower E by less than this share, or of a thousandth of the first E
    """
    search = Search(problem, max_evaluations, damping, improved)
    try:
        stop = search.begun() or _run(search, method, tolerance)
    except (KeyboardInterrupt, StopSearch):
        stop = Stop.ASKED
    return search.minimum(stop), search.damping


def _run(search: Search, method: str, tolerance: float) -> Stop:
    while search.count < search.budget:
        model, before = search.model(), search.value
        proposal, ended = search.stepped(model, tolerance)
        if ended is None:
            search.learn((before - search.value) / proposal.promised)
        if proposal.factor is None:
            return Stop.STUCK
        if copes(method, search.x.size):
            _search_on(search, Preconditioner(search.layout, proposal.factor, search.value or 1.0), method, tolerance)
        if ended is not None or search.is_negligible(before - search.value, tolerance):
            return ended or Stop.CONVERGED
    return Stop.BUDGET


def _search_on(search: Search, preconditioner: Preconditioner, method: str, tolerance: float) -> None:
    """A few evaluations of NLopt around the best point, whose own are known."""
    around, known = search.x, (search.value, search.gradient)

    def fun(z: Array) -> tuple[float, Array]:
        if not z.any():
            return known[0], preconditioner.gradient(known[1])
        found = search.evaluated(around + preconditioner.to_x(z))
        return found.value, preconditioner.gradient(found.gradient)

    room = min(FEW, search.budget - search.count)
    found = minimise(fun, np.zeros(preconditioner.size), method=method, max_evaluations=room + 1, tolerance=tolerance)
    if found.stop is Stop.ASKED:
        raise StopSearch
