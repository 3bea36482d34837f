"""NLopt: the last stage of a search, and the only file that knows NLopt.

Gauss-Newton steps find the valley; NLopt sees E alone and lowers it where their model errs. It searches in variables z,
x = x₀ + P z, in which that model is a sphere: P Pᵀ = c H⁻¹, H the model's curvature with what counts of its one-sided
residuals, c the size of E. So a quasi-Newton method begins with the right metric. The stage ends when its
evaluations gain less than the tolerance.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

import nlopt
import numpy as np

from ..array import Array
from .minimum import MOST_EVALUATIONS, TOLERANCE, Minimum, Stop, StopSearch
from .newton import Search

LBFGS, NONE = "lbfgs", "none"
METHODS = (LBFGS, "slsqp", "ccsaq", "tnewton", "var2", NONE)
LONG_NAMES = {"tnewton": "TNEWTON_PRECOND_RESTART"}
DENSE = {"slsqp": 300}  # unknowns up to which an iteration takes a fifth of a second; 1200 take 15 s
# NLopt's general failure is a class of its own in 2.11 and no RuntimeError
FAILURES = (nlopt.RoundoffLimited, RuntimeError, getattr(nlopt, "runtime_error", RuntimeError))
INFINITELY_BAD = 1e300  # E where it is no number: NLopt cannot do with infinity
NEGLIGIBLE = 1e-3  # of the first value: a step that changes less ends a search
PATIENCE = 3  # evaluations: a line search takes some that gain nothing
STILL = 1e-12  # of x: a step that moves it by less ends one, too


def algorithm(method: str) -> int:
    """NLopt's number of a method by our name or NLopt's, with or without LD_. Raises ValueError for any other."""
    name = LONG_NAMES.get(method.lower(), method.upper()).removeprefix("LD_")
    number = getattr(nlopt, f"LD_{name}", None)
    if number is None:
        raise ValueError(f"no optimiser '{method}'; there are: {', '.join(METHODS)} (or any LD_ name of NLopt)")
    return int(number)


def copes(method: str, size: int) -> bool:
    """Whether a method does anything with so many unknowns while one waits; it hears no Ctrl-C meanwhile."""
    return size <= DENSE.get(method.lower(), size)


def refine(search: Search, factor: Array, tolerance: float, method: str = LBFGS) -> None:
    """Lowers E from the best point of a search on, in variables whitened by Cholesky's factor of its last model.

    tolerance  share of E: where PATIENCE evaluations gain less each, they are the last
    """
    layout, around, known, unit = search.layout, search.x, search.gradient, sqrt(search.value or 1.0)
    values, is_enough, room = [search.value] * PATIENCE, False, search.budget - search.count

    def fun(z: Array) -> tuple[float, Array]:
        nonlocal is_enough
        if not z.any():
            return values[0], unit * layout.whitened(factor, layout.from_x(known))
        found = search.evaluated(around + layout.to_x(layout.coloured(factor, unit * z)))
        values.append(search.value)
        is_enough = search.is_negligible((values[-1 - PATIENCE] - values[-1]) / PATIENCE, tolerance)
        if is_enough:
            raise StopSearch
        return found.value, unit * layout.whitened(factor, layout.from_x(found.gradient))

    if room > 0 and copes(method, search.x.size):
        found = minimise(fun, np.zeros(layout.count * layout.width), method=method, max_evaluations=room + 1)
        if found.stop is Stop.ASKED and not is_enough:
            raise StopSearch


def minimise(
    fun: Callable[[Array], tuple[float, Array]],
    x0: Array,
    *,
    method: str = LBFGS,
    max_evaluations: int = MOST_EVALUATIONS,
    tolerance: float = TOLERANCE,
) -> Minimum:
    """The best x (n,) of fun(x) -> (value, gradient) that was seen, whatever ends the search: a spent budget, a failed
    line search, StopSearch or Ctrl-C inside fun.

    tolerance  stop when the value changes by less than this share of itself in a step, or by less than a thousandth of
               this share of its first value
    """
    seen = _Seen(fun, np.array(x0, float), max_evaluations)
    try:
        search = nlopt.opt(algorithm(method), max(seen.x.size, 1))
    except (ValueError, nlopt.invalid_argument) as error:
        raise ValueError(f"NLopt cannot make the optimiser '{method}': {error}") from error
    if not seen.x.size:
        seen.evaluate(seen.x)
        return Minimum(seen.x, float(seen.value), seen.count, Stop.CONVERGED)
    seen.halt = search.force_stop
    search.set_min_objective(seen.objective)
    search.set_ftol_rel(tolerance)
    search.set_ftol_abs(NEGLIGIBLE * tolerance)
    search.set_xtol_rel(STILL)
    search.set_maxeval(max_evaluations)
    try:
        search.optimize(seen.x.copy())
        stop = Stop.BUDGET if search.last_optimize_result() == nlopt.MAXEVAL_REACHED else Stop.CONVERGED
    except (KeyboardInterrupt, nlopt.ForcedStop):
        stop = Stop.ASKED
    except FAILURES:
        stop = Stop.STUCK
    finally:
        seen.halt = lambda: None  # else the two hold each other, past the garbage collector's sight
    if seen.failure is not None:
        raise seen.failure
    return Minimum(seen.x, float(seen.value), seen.count, seen.forced or stop)


class _Seen:
    """The objective as NLopt calls it, with the best point kept beside it."""

    def __init__(self, fun: Callable, x0: Array, budget: int) -> None:
        self.fun, self.x, self.value, self.budget, self.count = fun, x0.copy(), np.inf, budget, 0
        self.halt: Callable[[], None] = lambda: None
        self.forced: Stop | None = None
        self.failure: Exception | None = None
        self.unit = 0.0  # the first value, by which NLopt's objective is divided

    def objective(self, x: Array, gradient: Array) -> float:
        """What NLopt calls. Never raises: some of its line searches call again with the exception still pending."""
        try:
            if self.count >= self.budget:
                self.forced = Stop.BUDGET
            if self.forced is None and self.failure is None:
                value, slope = self.evaluate(np.array(x))
                self.unit = self.unit or (abs(value) if 0 < abs(value) < INFINITELY_BAD else 1.0)
                if gradient.size:
                    gradient[:] = slope / self.unit
                return value / self.unit
        except (KeyboardInterrupt, StopSearch):
            self.forced = Stop.ASKED
        except Exception as error:
            self.failure = error
        self.halt()
        gradient[:] = 0
        return INFINITELY_BAD

    def evaluate(self, x: Array) -> tuple[float, Array]:
        self.count += 1
        value, slope = self.fun(x)
        if not (np.isfinite(value) and np.all(np.isfinite(slope))):
            return INFINITELY_BAD, np.zeros_like(x)
        if value < self.value:
            self.value, self.x = value, x
        return value, slope
