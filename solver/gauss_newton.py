"""Minimisation of E by Gauss-Newton steps with Levenberg's damping: few evaluations, each step a banded solve.

The damping is lowered where the model foretold E's decrease well, raised where it did not, after D. W. Marquardt,
"An algorithm for least-squares estimation of nonlinear parameters", J. SIAM 1963; here it weighs the flat acceleration
energy of the step, so that a damped step is a smooth one.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .model import Layout, Model
from .objective import Discretised, Evaluation
from .optimiser import Minimum, Stop, StopSearch
from .quaternion import Array

FIRST_DAMPING = 1.0
LEAST_DAMPING, MOST_DAMPING = 1e-6, 1e9
WELL, BADLY = 0.7, 0.25
LOWER, RAISE, REJECT = 0.2, 3.0, 8.0
NEGLIGIBLE = 1e-3
SUDDEN, SURE, UNSEEN = 0.1, 0.02, 2.0


def gauss_newton(
    problem: Discretised,
    *,
    max_evaluations: int = 100,
    tolerance: float = 1e-6,
    damping: float = FIRST_DAMPING,
    improved: Callable[[int, Evaluation, Array], None] | None = None,
) -> tuple[Minimum, float]:
    """The Minimum of E over a timeline's unknowns from where it is, and the last damping, for the next round.

    tolerance  stop when the next step promises less than this share of E, or of a thousandth of the first E
    improved   called with (evaluation, Evaluation, x) whenever E falls; may raise StopSearch to end the search

    KeyboardInterrupt ends the search like StopSearch.
    """
    search = _Search(problem, max_evaluations, improved)
    try:
        stop = search.run(tolerance, damping)
    except (KeyboardInterrupt, StopSearch):
        stop = Stop.ASKED
    return Minimum(search.x, search.value, search.count, stop), search.damping


class _Search:
    """The best point so far, and the way from there."""

    def __init__(self, problem: Discretised, budget: int, improved: Callable | None) -> None:
        self.problem, self.budget, self.improved = problem, budget, improved
        self.x, self.value, self.count = problem.unknowns.start, np.inf, 0
        self.gradient = np.zeros(0)
        self.damping = FIRST_DAMPING

    def tried(self, x: Array) -> bool:
        """Evaluates E at x and goes there if it is lower."""
        self.count += 1
        found = self.problem(x)
        if not (np.isfinite(found.value) and np.all(np.isfinite(found.gradient)) and found.value < self.value):
            return False
        self.x, self.value, self.gradient = x, found.value, found.gradient
        if self.improved is not None:
            self.improved(self.count, found, x)
        return True

    def run(self, tolerance: float, damping: float) -> Stop:
        self.damping = damping
        self.tried(self.x)
        if not np.isfinite(self.value):
            return Stop.STUCK
        if self.x.size == 0:
            return Stop.CONVERGED
        layout, first, unit, last = Layout(self.problem), self.value, None, np.inf
        while self.count < self.budget:
            model = Model(layout, self.x, self.gradient, unit)
            unit = model.scale
            before = self.value
            while True:
                step, promised = model.minimised(self.damping * unit)
                if promised <= tolerance * max(self.value, NEGLIGIBLE * first):
                    return Stop.CONVERGED
                if self.tried(self.x + step):
                    break
                self.damping *= REJECT
                if self.damping > MOST_DAMPING:
                    return Stop.STUCK
                if self.count >= self.budget:
                    return Stop.BUDGET
            kept = (before - self.value) / promised
            # a step of Newton's kind leaves the square of what its model did not see; and promises go on falling
            unseen = float(np.clip(UNSEEN * (1 - kept) ** 2, SURE, 1.0))
            left = promised * min(unseen, float(np.clip(promised / last, SUDDEN, 1.0)))
            if kept > WELL and left <= tolerance * max(self.value, NEGLIGIBLE * first):
                return Stop.CONVERGED
            last = promised
            if kept > WELL:
                self.damping = max(self.damping * LOWER, LEAST_DAMPING)
            elif kept < BADLY:
                self.damping *= RAISE
        return Stop.BUDGET
