"""What every optimiser guarantees: its budget, the best x however it ends, and errors of the caller."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
import shipped
from figures import BALL_TREE, figure_of
from problems import Watched, by_nlopt, discretised, problem_of, slider

from dynsplines import load
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Discretised, Evaluation
from dynsplines.solver.search import newton, nlopt_methods
from dynsplines.solver.search.descent import WIDEST, Descent, optimiser_of
from dynsplines.solver.search.minimum import Minimum, Stop, StopSearch
from dynsplines.solver.search.newton import GaussNewton
from dynsplines.solver.search.nlopt_methods import METHODS, NONE, minimise
from dynsplines.solver.search.quadratic import Layout, Model

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


def rosenbrock(x: np.ndarray) -> tuple[float, np.ndarray]:
    a, b = 1 - x[0], x[1] - x[0] ** 2
    return a**2 + 10 * b**2, np.array([-2 * a - 40 * x[0] * b, 20 * b])


def bowl(x: np.ndarray) -> tuple[float, np.ndarray]:
    stiffness = np.arange(1.0, x.size + 1)
    away = x - 1 / stiffness
    return 3 + float(stiffness @ away**2), 2 * stiffness * away


START = np.array([-1.2, 1.0])


@pytest.mark.parametrize("method", METHODS_OF_NLOPT)
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


@pytest.mark.parametrize("method", METHODS_OF_NLOPT)
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


@pytest.fixture
def problem(rng) -> Discretised:
    return discretised(figure_of(BALL_TREE), rng, "free")


def rough_and_refined(problem: Discretised, method: str, tolerance: float = 1e-2, **more: object) -> list[Minimum]:
    """What rough steps find, alone and with the stage after them."""
    alone, both = GaussNewton(), GaussNewton(method, tolerance)
    return [each(problem, tolerance=tolerance, **more) for each in (alone, both)]  # type: ignore[arg-type]


@pytest.mark.slow
def test_a_shipped_clip_is_lower_with_it_and_its_keyframes_are_met():
    ours, clip = shipped.solved("run_loop").motion, load("run_loop")
    alone = inbetween(replace(clip.problem, settings=replace(clip.settings, optimiser=NONE)))
    assert ours.trace[-1][2] <= alone.trace[-1][2]
    assert ours.stop is Stop.CONVERGED
    for key in clip.keys:
        held = key.fixed
        difference = np.abs(ours.at([key.time])[0] - alone.at([key.time])[0])
        assert held.any()
        assert difference[held].max() < 1e-9


@pytest.mark.parametrize("method", METHODS_OF_NLOPT)
def test_every_method_lowers_what_rough_steps_left(rng, method):
    problem = problem_of(rng, "periodic")
    rough, refined = rough_and_refined(problem, method)
    assert refined.stop is Stop.CONVERGED
    assert refined.value <= rough.value
    assert problem(refined.x).value == refined.value


def test_where_nothing_is_left_to_gain_it_takes_a_few_evaluations(problem):
    alone, refined = rough_and_refined(problem, "lbfgs", 1e-6, max_evaluations=200)
    assert alone.evaluations < refined.evaluations <= alone.evaluations + newton.PATIENCE
    assert refined.value == pytest.approx(alone.value, rel=1e-5)


def test_rounds_that_others_follow_have_none(problem, monkeypatch):
    monkeypatch.setattr(newton, "minimise", lambda *_, **__: pytest.fail("NLopt was asked"))
    search = GaussNewton("lbfgs", final=1e-5)
    assert search(problem, tolerance=1e-2).stop is Stop.CONVERGED


def test_nlopts_own_names_will_do_in_a_descent(problem):
    found = Descent(problem.objective, problem.timeline).run(optimiser="LD_MMA", tolerance=1e-4)
    assert found.stop is Stop.CONVERGED
    assert found.value < problem(problem.unknowns.start).value


def test_a_dense_method_is_left_out_of_large_problems(problem, monkeypatch):
    monkeypatch.setattr(newton, "minimise", lambda *_, **__: pytest.fail("NLopt was asked"))
    monkeypatch.setitem(nlopt_methods.DENSE, "slsqp", problem.unknowns.size - 1)
    rough, refined = rough_and_refined(problem, "SLSQP")
    assert refined.evaluations == rough.evaluations


@pytest.mark.parametrize("variable", [1, 4])
def test_in_these_variables_the_flat_acceleration_energy_is_a_sphere(variable):
    """The dense Hessian of E itself, by differences of its gradient."""
    problem = slider(np.array([0.0, 0.3, 1.0, 2.5]), variable)
    layout, start = Layout(problem), problem.unknowns.start
    base = problem(start).gradient
    factor = Model(layout, start, base).minimise(0.0).factor
    assert factor is not None
    hessian = np.array([problem(start + e).gradient - base for e in np.eye(start.size)])
    to_z = np.array([layout.whiten(factor, layout.from_x(e)) for e in np.eye(start.size)])
    # the entries of z that move nothing have the eigenvalue 0
    after = np.linalg.eigvalsh(to_z.T @ hessian @ to_z)[-start.size :]
    np.testing.assert_allclose(after, 1.0, rtol=1e-3)
    raw = np.linalg.eigvalsh(hessian)
    assert raw[-1] / raw[0] > 20
