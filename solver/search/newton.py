"""Minimisation of E by Gauss-Newton steps with Levenberg's damping, then by NLopt. Each step is a banded solve.

The damping decreases after good predictions of the reduction of E and increases after poor ones (D. W. Marquardt, "An
algorithm for least-squares estimation of nonlinear parameters", J. SIAM 1963), by the factors of H. B. Nielsen,
"Damping parameter in Marquardt's method", IMM 1999. It multiplies ∫ |δy''|² dt of the step δy, with equal weight for
all coordinates, so that a damped step is smooth.

Gauss-Newton steps approach the minimum. NLopt then uses only E and its gradient, so it can lower E where the model of
these steps is inaccurate. It searches in whitened variables z, x = x₀ + P z with P Pᵀ = c H⁻¹, where H is the model's
curvature including active one-sided residuals, and c the size of E. A quasi-Newton method thus starts with the right
metric.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from math import sqrt

import numpy as np

from ..array import Array
from ..objective import Discretised, Evaluation
from ..tolerances import NEGLIGIBLE
from .minimum import MOST_EVALUATIONS, TOLERANCE, Improved, Minimum, Stop, StopSearch
from .nlopt_methods import NONE, is_practical, minimise
from .quadratic import Layout, Proposal, QuadraticModel

FIRST_DAMPING = 1.0  # in units of E's curvature in y''
MIN_DAMPING, MAX_DAMPING = 1e-6, 1e9  # from a full Newton step to a negligible one
GOOD_RATIO = 0.7  # [1] gain ratio, actual by predicted reduction, above which a prediction is reliable
# [1] estimate of the remaining reduction relative to the last predicted one, see `_run`
MIN_TREND, MIN_MODEL_ERROR, MODEL_ERROR = 0.1, 0.02, 2.0


class GaussNewton:
    """The default optimiser: Gauss-Newton steps, then a final stage near the minimum.

    Attributes:
        method: The algorithm of NLopt for the final stage, see `nlopt_methods.algorithm`; "none": no final stage.
        final: The tolerance of the last rounds; a round is one search and one subdivision. The final stage runs only if
            the tolerance of a search is no larger than this.
        damping: The damping of the next step, carried over from one search to the next.
    """

    def __init__(self, method: str = NONE, final: float = TOLERANCE) -> None:
        self.method, self.final, self.damping = method.lower(), final, FIRST_DAMPING

    def __call__(
        self,
        problem: Discretised,
        *,
        max_evaluations: int = MOST_EVALUATIONS,
        tolerance: float = TOLERANCE,
        improved: Improved | None = None,
    ) -> Minimum:
        """Minimise E over a timeline's unknowns, from its present state. KeyboardInterrupt ends the search like
        StopSearch.

        Args:
            problem: E and its gradient.
            tolerance: The search ends when the next step is predicted to reduce E by less than tolerance · max(E,
                E_first / 1000).
            improved: Called as improved(count, evaluation, x) whenever E falls, with the number of evaluations so far.
                It may raise StopSearch to end the search.

        Returns:
            The best point.
        """
        search = Search(problem, max_evaluations, self.damping, improved)
        try:
            stop = search.start() or _run(search, tolerance)
            if self.method != NONE and search.factor is not None and tolerance <= self.final:
                _refine(search, search.factor, tolerance, self.method)
        except (KeyboardInterrupt, StopSearch):
            stop = Stop.INTERRUPTED
        self.damping = search.damping
        return search.minimum(stop)


def _run(search: Search, tolerance: float) -> Stop:
    previous = np.inf
    while search.count < search.budget:
        model, before = search.model(), search.value
        proposal, stop = search.step(model, tolerance)
        if stop is not None:
            return stop
        gain_ratio, predicted = (before - search.value) / proposal.predicted_reduction, proposal.predicted_reduction
        # predicted reductions decrease with the steps, and the error of a full Newton step is quadratic in the model's
        trend = float(np.clip(predicted / previous, MIN_TREND, 1.0))
        model_error = float(np.clip(MODEL_ERROR * (1 - gain_ratio) ** 2, MIN_MODEL_ERROR, 1.0))
        remaining = predicted * (min(model_error, trend) if search.damping < FIRST_DAMPING else trend)
        if gain_ratio > GOOD_RATIO and search.is_negligible(remaining, tolerance):
            return Stop.CONVERGED
        previous = predicted
        search.update_damping(gain_ratio)
    return Stop.MAX_EVALUATIONS


def _refine(search: Search, factor: Array, tolerance: float, method: str) -> None:
    """Lower E from the best point of a search, in variables whitened by the Cholesky factor of its last model.

    Args:
        tolerance: Stop when an evaluation gains less than this share of E.

    Raises:
        StopSearch: The search was interrupted.
    """
    layout, around, gradient, unit = search.layout, search.x, search.gradient, sqrt(search.value)
    first, is_converged, remaining = search.value, False, search.budget - search.count

    def fun(z: Array) -> tuple[float, Array]:
        nonlocal is_converged
        if not z.any():
            return first, unit * layout.whiten(factor, layout.from_x(gradient))
        before = search.value
        result = search.evaluate(around + layout.to_x(layout.unwhiten(factor, unit * z)))
        is_converged = search.is_negligible(before - search.value, tolerance)
        if is_converged:
            raise StopSearch
        return result.value, unit * layout.whiten(factor, layout.from_x(result.gradient))

    if remaining > 0 and is_practical(method, search.x.size):
        result = minimise(fun, np.zeros(layout.count * layout.width), method=method, max_evaluations=remaining + 1)
        if result.stop is Stop.INTERRUPTED and not is_converged:
            raise StopSearch


class Search:
    """The state of a search.

    Attributes:
        x: The best point so far, (n,).
        value: E there.
        gradient: dE/dx there, (n,).
        count: The number of evaluations so far.
        scale: The median second derivative of E with respect to y'' in the first model; damping is a multiple of it.
        factor: The Cholesky factor of the last model.
        increase: The factor of the damping after the next step that does not reduce E.
    """

    def __init__(self, problem: Discretised, budget: int, damping: float, improved: Callable | None) -> None:
        self.problem, self.budget, self.damping, self.improved = problem, budget, damping, improved
        self.x, self.value, self.count = problem.unknowns.start, np.inf, 0
        self.gradient = np.zeros(0)
        self.first = np.inf
        self.scale: float | None = None
        self.factor: Array | None = None
        self.increase = 4.0

    @cached_property
    def layout(self) -> Layout:
        return Layout(self.problem)

    def minimum(self, stop: Stop) -> Minimum:
        return Minimum(self.x, self.value, self.count, stop)

    def start(self) -> Stop | None:
        """Evaluate E at the start; return a Stop if there is nothing to minimise."""
        self.evaluate(self.x)
        self.first = self.value
        if not np.isfinite(self.value):
            return Stop.NO_PROGRESS
        return Stop.CONVERGED if self.x.size == 0 else None

    def evaluate(self, x: Array) -> Evaluation:
        """Return E at x (n,), which becomes the best point if E is lower there."""
        self.count += 1
        evaluation = self.problem(x)
        if np.isfinite(evaluation.value) and np.all(np.isfinite(evaluation.gradient)) and evaluation.value < self.value:
            self.x, self.value, self.gradient = x, evaluation.value, evaluation.gradient
            if self.improved is not None:
                self.improved(self.count, evaluation, x)
        return evaluation

    def is_negligible(self, decrease: float, tolerance: float) -> bool:
        """Return whether decrease < tolerance · max(E, E_first / 1000), with E at most `Objective.heavy`."""
        size = min(max(self.value, NEGLIGIBLE * self.first), self.problem.objective.heavy)
        return decrease <= tolerance * size

    def model(self) -> QuadraticModel:
        model = QuadraticModel(self.layout, self.x, self.gradient, self.scale)
        self.scale = model.scale
        return model

    def step(self, model: QuadraticModel, tolerance: float) -> tuple[Proposal, Stop | None]:
        """Take the model's step, damped until E falls.

        Returns:
            The last proposed step, and None; a Stop instead of None if the search ends.
        """
        while True:
            proposal = model.minimise(self.damping * model.scale)
            self.factor = proposal.factor
            if proposal.factor is not None:  # otherwise there is no curvature, thus no step
                if self.is_negligible(proposal.predicted_reduction, tolerance):
                    return proposal, Stop.CONVERGED
                x = self.x + proposal.step
                self.evaluate(x)
                if self.x is x:
                    return proposal, None
            self.damping *= self.increase
            self.increase *= 2
            if self.damping > MAX_DAMPING:
                return proposal, Stop.NO_PROGRESS
            if self.count >= self.budget:
                return proposal, Stop.MAX_EVALUATIONS

    def update_damping(self, gain_ratio: float) -> None:
        """Change the damping after a step that reduced E, by a factor from 1/3 (gain ratio 1 or more) to 2 (0)."""
        self.damping = max(self.damping * max(1 / 3, 1 - (2 * gain_ratio - 1) ** 3), MIN_DAMPING)
        self.increase = 4.0
