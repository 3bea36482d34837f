"""minimise(fun, x0) -> Minimum: unconstrained minimisation by NLopt's methods; the only file that knows NLopt.

The best x seen is kept whatever happens: a spent budget, a failed line search, the caller's or the user's stop.
"""

from __future__ import annotations

from collections.abc import Callable

import nlopt
import numpy as np

from ..array import Array
from .methods import METHODS
from .minimum import MOST_EVALUATIONS, TOLERANCE, Minimum, Stop, StopSearch

# NLopt's general failure is a class of its own in 2.11 and no RuntimeError
FAILURES = (nlopt.RoundoffLimited, RuntimeError, getattr(nlopt, "runtime_error", RuntimeError))

INFINITELY_BAD = 1e300  # E where it is no number: NLopt cannot do with infinity


DAMPINGS = (1.0, 1e-2, 1e-4)  # of the first step, tried in turn
NEGLIGIBLE = 1e-3  # of the first value: a step that changes less ends a search
ROUNDING = 1e-12  # of a value that is nought
STILL = 1e-12  # of x: a step that moves it by less ends a run


def algorithm(method: str) -> int:
    """NLopt's number of a method by our name or NLopt's own (with or without LD_)."""
    name = METHODS.get(method.lower(), (method.upper(),))[0]
    number = getattr(nlopt, f"LD_{name.removeprefix('LD_')}", None)
    if number is None:
        raise ValueError(f"no optimiser '{method}'; there are: {', '.join(METHODS)} (or any LD_ name of NLopt)")
    return int(number)


def minimise(
    fun: Callable[[Array], tuple[float, Array]],
    x0: Array,
    *,
    method: str = "lbfgs",
    max_evaluations: int = MOST_EVALUATIONS,
    tolerance: float = TOLERANCE,
    improved: Callable[[int, float, Array], None] | None = None,
) -> Minimum:
    """Minimises fun(x) -> (value, gradient) from x0 (n,).

    tolerance  stop when the value changes by less than this share of itself in a step, or by less than a thousandth of
               this share of its first value
    improved   called with (evaluation, value, x) whenever the value falls below all earlier ones; may raise StopSearch

    KeyboardInterrupt ends the search like StopSearch. Values that are not finite count as infinitely bad.
    """
    search = _NloptSearch(fun, np.array(x0, float), max_evaluations, improved)
    if search.best_x.size == 0:
        try:
            search.evaluate(search.best_x)
        except (KeyboardInterrupt, StopSearch):
            return search.minimum(Stop.ASKED)
        return search.minimum(Stop.CONVERGED)
    stop = Stop.STUCK
    for damping in DAMPINGS:
        stop = _attempt(search, algorithm(method), tolerance, damping)
        if search.failure is not None:
            raise search.failure
        if stop is not Stop.STUCK:
            break
    if stop is Stop.STUCK and abs(search.best) < ROUNDING:
        stop = Stop.CONVERGED
    return search.minimum(stop)


def _attempt(search: _NloptSearch, number: int, tolerance: float, damping: float) -> Stop:
    """One run of NLopt from the best point, on the objective divided by its value there and multiplied by `damping`.

    Some of NLopt's line searches give up where a first step of the gradient's length overshoots; a smaller one passes.
    """
    try:
        optimiser = nlopt.opt(number, search.best_x.size)
    except (ValueError, nlopt.invalid_argument) as error:
        raise ValueError("NLopt cannot make this optimiser: it needs options that are not given") from error
    optimiser.set_min_objective(search.objective)
    search.halt, search.forced = optimiser.force_stop, None
    search.damping = damping
    optimiser.set_ftol_rel(tolerance)
    optimiser.set_ftol_abs(damping * NEGLIGIBLE * tolerance)
    optimiser.set_xtol_rel(STILL)
    optimiser.set_maxeval(max(search.budget - search.count, 1))
    try:
        optimiser.optimize(search.best_x.copy())
        result = optimiser.last_optimize_result()
        stop = Stop.BUDGET if result == nlopt.MAXEVAL_REACHED else Stop.CONVERGED
    except (KeyboardInterrupt, nlopt.ForcedStop):
        stop = Stop.ASKED
    except FAILURES:
        stop = Stop.STUCK
    finally:
        search.halt = lambda: None  # else the two hold each other, past the garbage collector's sight
    return search.forced or stop


class _NloptSearch:
    """The objective as NLopt calls it, with the best point kept beside it."""

    def __init__(self, fun: Callable, x0: Array, budget: int, improved: Callable | None) -> None:
        self.fun, self.improved, self.budget = fun, improved, budget
        self.best_x, self.best = x0.copy(), np.inf
        self.count = 0
        self.halt: Callable[[], None] = lambda: None
        self.forced: Stop | None = None
        self.damping = 1.0
        self.unit: float | None = None
        self.failure: Exception | None = None

    def minimum(self, stop: Stop) -> Minimum:
        return Minimum(self.best_x, float(self.best), self.count, stop)

    def objective(self, x: Array, gradient: Array) -> float:
        """What NLopt calls. Never raises: some of its line searches call again with the exception still pending."""
        try:
            if self.count >= self.budget:
                self.forced = Stop.BUDGET
            if self.forced is None and self.failure is None:
                value, slope = self.evaluate(x)
                scale = self.scale(value)
                if gradient.size:
                    gradient[:] = scale * slope
                return scale * value
        except (KeyboardInterrupt, StopSearch):
            self.forced = Stop.ASKED
        except Exception as error:
            self.failure = error
        self.halt()
        gradient[:] = 0
        return INFINITELY_BAD

    def scale(self, value: float) -> float:
        """What NLopt's objective is multiplied by: one over the first value, and the damping."""
        if self.unit is None:
            self.unit = abs(value) if 0 < abs(value) < INFINITELY_BAD else 1.0
        return self.damping / self.unit

    def evaluate(self, x: Array) -> tuple[float, Array]:
        self.count += 1
        point = np.array(x)
        value, slope = self.fun(point)
        if not (np.isfinite(value) and np.all(np.isfinite(slope))):
            return INFINITELY_BAD, np.zeros_like(point)
        if value < self.best:
            self.best, self.best_x = value, point
            if self.improved is not None:
                self.improved(self.count, value, point)
        return value, slope
