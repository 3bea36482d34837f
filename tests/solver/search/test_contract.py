"""What every optimiser guarantees: its budget, the best x however it ends, and errors of the caller."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from small_problems import Watched, by_nlopt, problem_of

from dynsplines.solver.array import Array
from dynsplines.solver.objective import Discretised, Evaluation
from dynsplines.solver.search.descent import WIDEST, optimiser_of
from dynsplines.solver.search.minimum import Minimum, Stop, StopSearch
from dynsplines.solver.search.newton import GaussNewton
from dynsplines.solver.search.nlopt_methods import METHODS, NONE

METHODS_OF_NLOPT = [method for method in METHODS if method != NONE]
REPORTING = ("Gauss-Newton", "Gauss-Newton and refinement")
ALL = (*REPORTING, *METHODS_OF_NLOPT)


def searched(name: str, problem: Discretised, *, max_evaluations: int = 100, **more: Any) -> Minimum:
    """The result of an optimiser; the refinement begins with the ninth evaluation."""
    tolerance = 1e-9 if name == REPORTING[1] else 1e-12
    match name:
        case "Gauss-Newton":
            optimiser: Callable[..., Minimum] = GaussNewton()
        case "Gauss-Newton and refinement":
            optimiser = GaussNewton("lbfgs", tolerance)
        case _:
            optimiser = partial(by_nlopt, method=name)
    return optimiser(problem, max_evaluations=max_evaluations, tolerance=tolerance, **more)


def assert_best(found: Minimum, problem: Watched) -> None:
    """That a result is the best of the points that were evaluated, or the start."""
    if problem.values:
        best = int(np.argmin(problem.values))
        assert found.value == problem.values[best]
        np.testing.assert_array_equal(found.x, problem.points[best])
    else:
        np.testing.assert_array_equal(found.x, problem.unknowns.start)


@pytest.mark.parametrize("budget", [1, 2, 5])
@pytest.mark.parametrize("name", ALL)
def test_the_budget_is_kept_and_the_best_x_within_it_is_returned(name, budget, rng):
    problem = Watched(problem_of(rng))
    found = searched(name, problem, max_evaluations=budget)
    assert (found.stop, found.evaluations) == (Stop.MAX_EVALUATIONS, budget)
    assert len(problem.values) == budget
    assert_best(found, problem)


@pytest.mark.parametrize("error", [StopSearch, KeyboardInterrupt, ZeroDivisionError("mine")])
@pytest.mark.parametrize("name", ALL)
def test_a_stop_keeps_the_best_x_and_another_error_is_raised(name, error, rng):
    raw = problem_of(rng)
    for count in (1, 4, 9):  # the ninth is one of the refinement

        def spoil(k: int, evaluation: Evaluation, count=count) -> Evaluation:
            if k == count:
                raise error
            return evaluation

        problem = Watched(raw, spoil)
        if isinstance(error, Exception):
            with pytest.raises(ZeroDivisionError) as caught:
                searched(name, problem)
            assert caught.value is error
        else:
            found = searched(name, problem)
            assert found.stop is Stop.INTERRUPTED
            assert_best(found, problem)


@pytest.mark.parametrize("error", [StopSearch, KeyboardInterrupt, ZeroDivisionError])
@pytest.mark.parametrize("name", REPORTING)
def test_who_hears_of_every_lower_value_may_stop_the_search_or_fail(name, error, rng):
    raw, counts = problem_of(rng), []
    searched(name, raw, improved=lambda count, *_: counts.append(count))
    for last in (counts[0], counts[2], counts[-1]):

        def improved(count: int, _evaluation: Evaluation, _x: Array, last=last) -> None:
            if count >= last:
                raise error

        problem = Watched(raw)
        if error is ZeroDivisionError:
            with pytest.raises(ZeroDivisionError):
                searched(name, problem, improved=improved)
        else:
            found = searched(name, problem, improved=improved)
            assert (found.stop, len(problem.values)) == (Stop.INTERRUPTED, last)
            assert_best(found, problem)


@pytest.mark.parametrize(("part", "bad"), [("value", -np.inf), ("value", np.nan), ("gradient", np.nan)])
@pytest.mark.parametrize("name", ALL)
def test_what_is_no_number_never_becomes_the_best(name, bad, part, rng):
    def spoil(k: int, evaluation: Evaluation) -> Evaluation:
        if k not in (2, 3):
            return evaluation
        value, factor = (bad, 1) if part == "value" else (evaluation.value, bad)
        return Evaluation(value, evaluation.gradient * factor, evaluation.parts)

    problem = Watched(problem_of(rng), spoil)
    found = searched(name, problem)
    assert np.isfinite(found.value)
    assert found.value == Discretised.__call__(problem, found.x).value <= problem.values[0]


def test_figures_with_too_many_coordinates_are_refused_unless_the_optimiser_is_custom() -> None:
    assert isinstance(optimiser_of("lbfgs", WIDEST, 1e-6), GaussNewton)
    with pytest.raises(ValueError, match="the figure has 301 coordinates, more than the 300 that a search supports"):
        optimiser_of("lbfgs", WIDEST + 1, 1e-6)
    custom = GaussNewton()
    assert optimiser_of(custom, WIDEST + 1, 1e-6) is custom
