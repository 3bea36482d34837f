"""Minimisation of E by Gauss-Newton steps with Levenberg's damping: few evaluations, each step a banded solve.

The damping is lowered where the model foretold E's decrease well, raised where it did not, after D. W. Marquardt,
"An algorithm for least-squares estimation of nonlinear parameters", J. SIAM 1963; here it weighs the flat acceleration
energy of the step, so that a damped step is a smooth one.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from ..array import Array
from ..objective import Discretised, Evaluation
from .minimum import TOLERANCE, Improved, Minimum, Stop, StopSearch
from .quadratic import Layout, Model, Proposal

Refine = Callable[["Search", Array, float], None]
MOST_STEPS = 100  # evaluations, unless told
FIRST_DAMPING = 1.0  # E's own curvature in y'' is one
LEAST_DAMPING, MOST_DAMPING = 1e-6, 1e9  # between Newton's step and hardly any
WELL, BADLY = 0.7, 0.25  # of the decrease that a step promised: damp less from here, more below
LOWER, RAISE, REJECT = 0.2, 3.0, 8.0  # times the damping after a good step, a bad one, one that raised E
NEGLIGIBLE = 1e-3  # of the first E: less than that counts as so much
# the decrease that is left, of the last promise: least share by its trend, and by what the model missed
SUDDEN, SURE, UNSEEN = 0.1, 0.02, 2.0


class GaussNewton:
    """The optimiser: Gauss-Newton steps into the valley, and a stage that refines what they find.

    refine   that stage, refine(search, factor, tolerance) with Cholesky's factor of the last model, or None
    final    tolerance of the searches that it follows, the last rounds
    damping  of the next step; it is kept from round to round
    """

    def __init__(self, refine: Refine | None = None, final: float = TOLERANCE, damping: float = FIRST_DAMPING) -> None:
        self.refine, self.final, self.damping = refine, final, damping

    def __call__(
        self,
        problem: Discretised,
        *,
        max_evaluations: int = MOST_STEPS,
        tolerance: float = TOLERANCE,
        improved: Improved | None = None,
    ) -> Minimum:
        """The Minimum of E over a timeline's unknowns from where it is.

        tolerance  stop when the next step promises less than this share of E, or of a thousandth of the first E
        improved   called with (evaluation, Evaluation, x) whenever E falls; may raise StopSearch to end the search

        KeyboardInterrupt ends the search like StopSearch.
        """
        search = Search(problem, max_evaluations, self.damping, improved)
        try:
            stop = search.begun() or _run(search, tolerance)
            if self.refine is not None and search.factor is not None and tolerance <= self.final:
                self.refine(search, search.factor, tolerance)
        except (KeyboardInterrupt, StopSearch):
            stop = Stop.ASKED
        self.damping = search.damping
        return search.minimum(stop)


def _run(search: Search, tolerance: float) -> Stop:
    last = np.inf
    while search.count < search.budget:
        model, before = search.model(), search.value
        proposal, stop = search.stepped(model, tolerance)
        if stop is not None:
            return stop
        kept, promised = (before - search.value) / proposal.promised, proposal.promised
        # a step of Newton's kind leaves the square of what its model did not see; and promises go on falling
        unseen = float(np.clip(UNSEEN * (1 - kept) ** 2, SURE, 1.0))
        left = promised * min(unseen, float(np.clip(promised / last, SUDDEN, 1.0)))
        if kept > WELL and search.is_negligible(left, tolerance):
            return Stop.CONVERGED
        last = promised
        search.learn(kept)
    return Stop.BUDGET


class Search:
    """The best point so far, and the way from there.

    x, value, gradient  (n,), E and dE/dx (n,) of the best point
    factor  Cholesky's, of the last model
    """

    def __init__(self, problem: Discretised, budget: int, damping: float, improved: Callable | None) -> None:
        self.problem, self.budget, self.damping, self.improved = problem, budget, damping, improved
        self.x, self.value, self.count = problem.unknowns.start, np.inf, 0
        self.gradient = np.zeros(0)
        self.first = np.inf
        self.unit: float | None = None
        self.factor: Array | None = None

    @cached_property
    def layout(self) -> Layout:
        return Layout(self.problem)

    def minimum(self, stop: Stop) -> Minimum:
        return Minimum(self.x, self.value, self.count, stop)

    def begun(self) -> Stop | None:
        """Evaluates E where the timeline is; a Stop if there is nothing to search."""
        self.evaluated(self.x)
        self.first = self.value
        if not np.isfinite(self.value):
            return Stop.STUCK
        return Stop.CONVERGED if self.x.size == 0 else None

    def evaluated(self, x: Array) -> Evaluation:
        """E at x, which is the best point from now on if E is lower there."""
        self.count += 1
        found = self.problem(x)
        if np.isfinite(found.value) and np.all(np.isfinite(found.gradient)) and found.value < self.value:
            self.x, self.value, self.gradient = x, found.value, found.gradient
            if self.improved is not None:
                self.improved(self.count, found, x)
        return found

    def is_negligible(self, decrease: float, tolerance: float) -> bool:
        """Whether a decrease is less than a share of E, or of a thousandth of the first E."""
        size = min(max(self.value, NEGLIGIBLE * self.first), self.problem.objective.heavy)
        return decrease <= tolerance * size

    def model(self) -> Model:
        """Of E at the best point."""
        model = Model(self.layout, self.x, self.gradient, self.unit)
        self.unit = model.scale
        return model

    def stepped(self, model: Model, tolerance: float) -> tuple[Proposal, Stop | None]:
        """The model's step that was taken, damped until E falls; or one not worth it, and why the search ends."""
        while True:
            proposal = model.minimised(self.damping * model.scale)
            self.factor = proposal.factor
            if proposal.factor is None:  # no curvature, no step
                self.damping *= REJECT
                if self.damping > MOST_DAMPING:
                    return proposal, Stop.STUCK
                continue
            if self.is_negligible(proposal.promised, tolerance):
                return proposal, Stop.CONVERGED
            x = self.x + proposal.step
            self.evaluated(x)
            if self.x is x:
                return proposal, None
            self.damping *= REJECT
            if self.damping > MOST_DAMPING:
                return proposal, Stop.STUCK
            if self.count >= self.budget:
                return proposal, Stop.BUDGET

    def learn(self, kept: float) -> None:
        """Adapts the damping to the share of the promised decrease that came about."""
        if kept > WELL:
            self.damping = max(self.damping * LOWER, LEAST_DAMPING)
        elif kept < BADLY:
            self.damping *= RAISE
