"""Every method finds its minimum, and the best x is kept however the search ends."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from dynsplines import load
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.search.minimum import Minimum, Stop
from dynsplines.solver.search.nlopt_methods import METHODS as NAMES
from dynsplines.solver.search.nlopt_methods import NONE, minimise


def rosenbrock(x: np.ndarray) -> tuple[float, np.ndarray]:
    a, b = 1 - x[0], x[1] - x[0] ** 2
    return a**2 + 10 * b**2, np.array([-2 * a - 40 * x[0] * b, 20 * b])


def bowl(x: np.ndarray) -> tuple[float, np.ndarray]:
    stiffness = np.arange(1.0, x.size + 1)
    away = x - 1 / stiffness
    return 3 + float(stiffness @ away**2), 2 * stiffness * away


METHODS = [name for name in NAMES if name != NONE]
START = np.array([-1.2, 1.0])


@pytest.mark.parametrize("method", METHODS)
def test_every_method_goes_down_a_bent_valley(method):
    found = minimise(rosenbrock, START, method=method, max_evaluations=5000, tolerance=1e-12)
    assert found.value < 1e-4
    np.testing.assert_allclose(found.x, [1, 1], atol=0.05)


@pytest.mark.parametrize("name", ["newton", "", "LD_", "success", "GN_DIRECT", "opt", "num_algorithms"])
def test_an_unknown_method_is_refused_and_the_known_ones_listed(name):
    with pytest.raises(ValueError, match=f"no optimiser '{name}'; there are: lbfgs, slsqp, ccsaq, tnewton, var2"):
        minimise(bowl, np.zeros(2), method=name)


def test_a_gradient_that_is_no_number_counts_as_infinitely_bad():
    found = minimise(lambda x: (float(x @ x), np.full(2, np.nan)), START, max_evaluations=20)
    assert found.value == np.inf
    np.testing.assert_array_equal(found.x, START)


def asked_of(fun: Callable, method: str) -> tuple[Minimum, list[np.ndarray]]:
    """What comes out from START, and all points that were asked for."""
    asked: list[np.ndarray] = []

    def watched(x: np.ndarray) -> tuple[float, np.ndarray]:
        asked.append(x.copy())
        return fun(x)

    return minimise(watched, START, method=method, max_evaluations=500), asked


@pytest.mark.parametrize("method", METHODS)
def test_a_search_that_ended_in_a_minimum_is_not_begun_again_from_there(method):
    found, asked = asked_of(rosenbrock, method)
    assert found.stop is Stop.CONVERGED
    assert sum(np.array_equal(x, found.x) for x in asked) == 1


@pytest.mark.parametrize("method", ["lbfgs", "tnewton", "var2"])
def test_up_a_gradient_that_is_wrong_by_its_sign_a_search_is_stuck(method):
    found, _ = asked_of(lambda x: (float(x @ x), -2 * x), method)
    assert found.stop is Stop.NO_PROGRESS
    np.testing.assert_array_equal(found.x, START)


def test_an_optimiser_of_the_user_is_asked_every_round_and_keeps_the_keyframes():
    """Steepest descent with halved steps: it lowers E, and whatever it does the keyframes are met."""
    clip = load("tumble")
    asked: list[int] = []

    def steepest(problem, *, max_evaluations, tolerance, improved):
        asked.append(max_evaluations)
        x = problem.unknowns.start.copy()
        here = problem(x)
        step, count = 1e-3 / max(float(np.abs(here.gradient).max()), 1e-12), 1
        while count < 30:
            there = problem(x - step * here.gradient)
            count += 1
            if there.value < here.value:
                x, here, step = x - step * here.gradient, there, 1.5 * step
                if improved is not None:
                    improved(count, here, x)
            else:
                step /= 2
        return Minimum(x, here.value, count, Stop.CONVERGED)

    solved = inbetween(replace(clip.problem, settings=replace(clip.settings, optimiser=steepest)))
    assert asked
    assert all(budget == clip.settings.max_evaluations for budget in asked)
    own, raw = (clip.problem.objective.value(path_of(timeline)) for timeline in (solved.timeline, solved.raw))
    assert own < raw
    times = np.array([key.time for key in clip.keys])
    states = path_of(solved.timeline).at(times)
    np.testing.assert_allclose(states, path_of(solved.raw).at(times), atol=1e-12)


def test_nothing_to_choose_is_one_evaluation():
    empty = np.zeros(0)
    found = minimise(lambda x: (5.0, x), empty)
    assert (found.value, found.evaluations, found.stop) == (5.0, 1, Stop.CONVERGED)
