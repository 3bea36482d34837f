"""The algorithms of NLopt, for the final stage of a search; the only file that imports NLopt."""

from __future__ import annotations

from collections.abc import Callable

import nlopt
import numpy as np

from ..array import Array
from ..tolerances import NEGLIGIBLE, TINY
from .minimum import MOST_EVALUATIONS, TOLERANCE, Minimum, Stop, StopSearch

LBFGS, NONE = "lbfgs", "none"
METHODS = (LBFGS, "slsqp", "ccsaq", "tnewton", "var2", NONE)
LONG_NAMES = {"tnewton": "TNEWTON_PRECOND_RESTART"}
DENSE = {"slsqp": 300}  # unknowns up to which an iteration takes at most 0.2 s; with 1200 unknowns it takes 15 s
# NLopt 2.11 raises its own class for a general failure, which is not a RuntimeError
FAILURES = (nlopt.RoundoffLimited, RuntimeError, getattr(nlopt, "runtime_error", RuntimeError))
NOT_FINITE = 1e300  # replaces values of E that are not finite, which NLopt does not accept


def algorithm(method: str) -> int:
    """Return NLopt's number of an algorithm.

    Args:
        method: A name from METHODS or of NLopt, with or without LD_.

    Raises:
        ValueError: There is no such algorithm.
    """
    name = LONG_NAMES.get(method.lower(), method.upper()).removeprefix("LD_")
    number = getattr(nlopt, f"LD_{name}", None)
    if number is None:
        raise ValueError(f"no optimiser '{method}'; there are: {', '.join(METHODS)} (or any LD_ name of NLopt)")
    return int(number)


def is_practical(method: str, size: int) -> bool:
    """Return whether an iteration with `size` unknowns is short enough, as Ctrl-C takes effect between iterations."""
    return size <= DENSE.get(method.lower(), size)


def minimise(
    fun: Callable[[Array], tuple[float, Array]],
    x0: Array,
    *,
    method: str = LBFGS,
    max_evaluations: int = MOST_EVALUATIONS,
    tolerance: float = TOLERANCE,
) -> Minimum:
    """Minimise a function with NLopt and return the best point evaluated.

    Args:
        fun: fun(x) -> (value, gradient (n,)). It may raise StopSearch or KeyboardInterrupt to end the search.
        x0: The start, (n,).
        method: The algorithm, see `algorithm`.
        tolerance: The search ends when a step changes the value by less than this share of it, or by less than a
            thousandth of this share of the first value.

    Returns:
        The best point, whatever the reason for the stop.

    Raises:
        ValueError: The method is unknown, or NLopt cannot create it.
    """
    recorder = _Recorder(fun, np.array(x0, float), max_evaluations)
    try:
        search = nlopt.opt(algorithm(method), max(recorder.x.size, 1))
    except (ValueError, nlopt.invalid_argument) as error:
        raise ValueError(f"NLopt cannot make the optimiser '{method}': {error}") from error
    if not recorder.x.size:
        recorder.evaluate(recorder.x)
        return Minimum(recorder.x, float(recorder.value), recorder.count, Stop.CONVERGED)
    recorder.halt = search.force_stop
    search.set_min_objective(recorder.objective)
    search.set_ftol_rel(tolerance)
    search.set_ftol_abs(NEGLIGIBLE * tolerance)
    search.set_xtol_rel(TINY)
    search.set_maxeval(max_evaluations)
    try:
        search.optimize(recorder.x.copy())
        stop = Stop.MAX_EVALUATIONS if search.last_optimize_result() == nlopt.MAXEVAL_REACHED else Stop.CONVERGED
    except (KeyboardInterrupt, nlopt.ForcedStop):
        stop = Stop.INTERRUPTED
    except FAILURES:
        stop = Stop.NO_PROGRESS
    finally:
        recorder.halt = lambda: None  # breaks a reference cycle that the garbage collector does not detect
    if recorder.failure is not None:
        raise recorder.failure
    return Minimum(recorder.x, float(recorder.value), recorder.count, recorder.forced or stop)


class _Recorder:
    """The objective for NLopt, which records the best point."""

    def __init__(self, fun: Callable, x0: Array, budget: int) -> None:
        self.fun, self.x, self.value, self.budget, self.count = fun, x0.copy(), np.inf, budget, 0
        self.halt: Callable[[], None] = lambda: None
        self.forced: Stop | None = None
        self.failure: Exception | None = None
        self.unit = 0.0  # the first value, by which NLopt's objective is divided

    def objective(self, x: Array, gradient: Array) -> float:
        """Return the scaled value for NLopt and write its gradient to `gradient` (n,). It raises no exceptions: some of
        NLopt's line searches would call again with the exception pending."""
        try:
            if self.count >= self.budget:
                self.forced = Stop.MAX_EVALUATIONS
            if self.forced is None and self.failure is None:
                value, slope = self.evaluate(np.array(x))
                self.unit = self.unit or (abs(value) if 0 < abs(value) < NOT_FINITE else 1.0)
                if gradient.size:
                    gradient[:] = slope / self.unit
                return value / self.unit
        except (KeyboardInterrupt, StopSearch):
            self.forced = Stop.INTERRUPTED
        except Exception as error:
            self.failure = error
        self.halt()
        gradient[:] = 0
        return NOT_FINITE

    def evaluate(self, x: Array) -> tuple[float, Array]:
        self.count += 1
        value, slope = self.fun(x)
        if not (np.isfinite(value) and np.all(np.isfinite(slope))):
            return NOT_FINITE, np.zeros_like(x)
        if value < self.value:
            self.value, self.x = value, x
        return value, slope
