"""What every optimiser guarantees, and the Gauss-Newton search: the minimum that NLopt finds, in few evaluations."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from figures import BALL_TREE, TINY, figure_of
from problems import TERMS, Watched, by_nlopt, discretised, problem_of
from scipy.optimize import rosen, rosen_der

from dynsplines import load
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Discretised, Evaluation, Objective
from dynsplines.solver.search import newton, nlopt_methods
from dynsplines.solver.search.descent import WIDEST, optimiser_of
from dynsplines.solver.search.descent import minimise as descend
from dynsplines.solver.search.minimum import Minimum, Stop, StopSearch
from dynsplines.solver.search.newton import FIRST_DAMPING, GaussNewton
from dynsplines.solver.search.nlopt_methods import METHODS, NONE, minimise
from dynsplines.solver.search.quadratic import Proposal, QuadraticModel

METHODS_OF_NLOPT = [method for method in METHODS if method != NONE]


REPORTING = ("Gauss-Newton", "Gauss-Newton and refinement")


KINDS = (*REPORTING, "lbfgs")


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
@pytest.mark.parametrize("name", KINDS)
def test_the_budget_is_kept_and_the_best_x_within_it_is_returned(name, budget, rng):
    problem = Watched(problem_of(rng))
    found = searched(name, problem, max_evaluations=budget)
    assert (found.stop, found.evaluations) == (Stop.MAX_EVALUATIONS, budget)
    assert len(problem.values) == budget
    assert_best(found, problem)


@pytest.mark.parametrize("error", [StopSearch, KeyboardInterrupt, ZeroDivisionError("mine")])
@pytest.mark.parametrize("name", KINDS)
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


@pytest.mark.parametrize(("part", "bad"), [("value", -np.inf), ("value", np.nan), ("gradient", np.nan)])
@pytest.mark.parametrize("name", KINDS)
def test_what_is_no_number_never_becomes_the_best(name, bad, part, rng):
    def spoil(k: int, evaluation: Evaluation) -> Evaluation:
        if k not in (2, 3):
            return evaluation
        value, factor = (bad, 1) if part == "value" else (evaluation.value, bad)
        return Evaluation(value, evaluation.gradient * factor, evaluation.parts)

    problem = Watched(problem_of(rng), spoil)
    found = searched(name, problem, max_evaluations=20)
    assert np.isfinite(found.value)
    assert found.value == Discretised.__call__(problem, found.x).value <= problem.values[0]


def test_figures_with_too_many_coordinates_are_refused_unless_the_optimiser_is_custom() -> None:
    assert isinstance(optimiser_of("lbfgs", WIDEST, 1e-6), GaussNewton)
    with pytest.raises(ValueError, match="the figure has 301 coordinates, more than the 300 that a search supports"):
        optimiser_of("lbfgs", WIDEST + 1, 1e-6)
    custom = GaussNewton()
    assert optimiser_of(custom, WIDEST + 1, 1e-6) is custom


START = np.array([-1.2, 1.0])


@pytest.mark.parametrize("name", ["newton", "", "LD_", "success", "GN_DIRECT", "opt", "num_algorithms"])
def test_an_unknown_method_is_refused_and_the_known_ones_listed(name):
    with pytest.raises(ValueError, match=f"no optimiser '{name}'; there are: lbfgs, slsqp, ccsaq, tnewton, var2"):
        minimise(lambda x: (float(x @ x), 2 * x), START, method=name)


@pytest.mark.parametrize("method", METHODS_OF_NLOPT)
def test_the_unit_of_the_objective_does_not_matter(method):
    found = [
        minimise(lambda x, unit=unit: (unit * rosen(x), unit * rosen_der(x)), START, method=method, max_evaluations=300)
        for unit in (1.0, 2.0**20, 2.0**-20)
    ]
    for other in found[1:]:
        np.testing.assert_array_equal(other.x, found[0].x)
        assert other.evaluations == found[0].evaluations
    assert rosen(found[0].x) < 0.1 * rosen(START)


@pytest.mark.parametrize("method", ["lbfgs", "tnewton", "var2"])
def test_up_a_gradient_that_is_wrong_by_its_sign_a_search_is_stuck(method):
    found = minimise(lambda x: (float(x @ x), -2 * x), START, method=method, max_evaluations=500)
    assert found.stop is Stop.NO_PROGRESS
    np.testing.assert_array_equal(found.x, START)


def test_an_optimiser_of_the_user_is_asked_every_round_and_keeps_the_keyframes():
    """Steepest descent with halved steps: it lowers E, and whatever it does the keyframes are met."""
    clip, budgets = load("tumble"), []

    def steepest(problem, *, max_evaluations, tolerance, improved):
        budgets.append(max_evaluations)
        x, here, step = problem.unknowns.start, problem(problem.unknowns.start), 1e-9
        for count in range(2, 31):
            there = problem(x - step * here.gradient)
            if there.value < here.value:
                x, here, step = x - step * here.gradient, there, 3 * step
                improved(count, here, x)
            else:
                step /= 2
        return Minimum(x, here.value, 30, Stop.CONVERGED)

    solved = inbetween(replace(clip.problem, settings=replace(clip.settings, optimiser=steepest)))
    assert set(budgets) == {clip.settings.max_evaluations}
    before, after = (clip.problem.objective.value(path_of(timeline)) for timeline in (solved.raw, solved.timeline))
    assert after < before
    times = np.array([key.time for key in clip.keys])
    np.testing.assert_allclose(solved.path.at(times), path_of(solved.raw).at(times), atol=1e-12)


@pytest.fixture
def problem(rng) -> Discretised:
    return discretised(figure_of(BALL_TREE), rng, "free")


def rough_and_refined(problem: Discretised, method: str, tolerance: float = 1e-2, **more: object) -> list[Minimum]:
    """What rough steps find, alone and with the stage after them."""
    alone, both = GaussNewton(), GaussNewton(method, tolerance)
    return [each(problem, tolerance=tolerance, **more) for each in (alone, both)]  # type: ignore[arg-type]


@pytest.mark.parametrize("method", METHODS_OF_NLOPT)
def test_every_method_lowers_what_rough_steps_left(rng, method):
    problem = problem_of(rng, "periodic")
    rough, refined = rough_and_refined(problem, method)
    assert refined.stop is Stop.CONVERGED
    assert refined.value <= rough.value
    assert problem(refined.x).value == refined.value


def test_a_dense_method_is_left_out_of_large_problems(problem, monkeypatch):
    monkeypatch.setattr(newton, "minimise", lambda *_, **__: pytest.fail("NLopt was asked"))
    monkeypatch.setitem(nlopt_methods.DENSE, "slsqp", problem.unknowns.size - 1)
    rough, refined = rough_and_refined(problem, "SLSQP")
    assert refined.evaluations == rough.evaluations


@pytest.mark.slow
@pytest.mark.parametrize(("coordinates", "ends"), [("joint", "free"), ("world", "clamped"), ("joint", "periodic")])
def test_it_finds_the_minimum_that_nlopt_finds_with_fewer_evaluations(rng, ends, coordinates):
    problem = problem_of(rng, ends, coordinates)
    found = GaussNewton()(problem, max_evaluations=200, tolerance=1e-10)
    other = by_nlopt(problem)
    assert found.stop is Stop.CONVERGED
    np.testing.assert_allclose(found.value, other.value, rtol=1e-7)
    assert found.evaluations < 0.3 * other.evaluations
    assert problem(found.x).value == found.value


def test_one_evaluation_sees_that_there_is_nothing_to_search():
    """Whole keyframes and given slopes at the ends leave nothing open."""
    figure = figure_of(TINY)
    keys = [Frame.key(time, figure.model.qpos0) for time in (0.0, 1.0)]
    timeline = raw_timeline(figure, keys, "clamped", np.zeros((2, figure.width)))
    found = GaussNewton()(Objective.of(figure, TERMS).on(timeline))
    assert (found.x.size, found.evaluations, found.stop) == (0, 1, Stop.CONVERGED)


def test_the_budget_is_kept_where_every_step_is_refused(rng):
    def spoil(k: int, found: Evaluation) -> Evaluation:
        return found if k == 1 else Evaluation(found.value + 1e9, found.gradient, found.parts)

    problem = Watched(problem_of(rng), spoil)
    optimiser = GaussNewton()
    found = optimiser(problem, max_evaluations=5)
    assert (found.stop, found.evaluations) == (Stop.MAX_EVALUATIONS, 5)
    assert optimiser.damping > FIRST_DAMPING
    lengths = [np.linalg.norm(x - problem.points[0]) for x in problem.points[1:]]
    assert np.all(np.diff(lengths) < 0)
    found = GaussNewton()(Watched(problem_of(np.random.default_rng(7)), spoil), max_evaluations=1000)
    assert found.evaluations < 100
    assert found.stop in (Stop.NO_PROGRESS, Stop.CONVERGED)


@pytest.mark.parametrize("higher", [0.0, 0.1])
def test_a_step_that_does_not_lower_e_is_refused_and_a_shorter_one_tried(rng, higher):
    told: list[int] = []

    def spoil(k: int, found: Evaluation) -> Evaluation:
        return Evaluation(min(problem.values) + higher, found.gradient, found.parts) if k == 3 else found

    problem = Watched(problem_of(rng), spoil)
    found = GaussNewton()(problem, tolerance=1e-8, improved=lambda k, _found, _x: told.append(k))
    assert told[:3] == [1, 2, 4]
    long, short = (np.linalg.norm(problem.points[k] - problem.points[1]) for k in (2, 3))
    assert 0 < short < long
    assert found.stop is Stop.CONVERGED


def test_a_start_that_is_no_number_is_stuck(rng):
    problem = Watched(problem_of(rng), lambda _, found: Evaluation(np.nan, found.gradient, found.parts))
    found = GaussNewton()(problem)
    assert (found.stop, found.evaluations) == (Stop.NO_PROGRESS, 1)
    np.testing.assert_array_equal(found.x, problem.unknowns.start)


def test_a_tighter_tolerance_gets_nearer_to_the_minimum(rng):
    problem = problem_of(rng)
    least = GaussNewton()(problem, max_evaluations=300, tolerance=1e-12).value
    ends = [GaussNewton()(problem, tolerance=tolerance) for tolerance in (1e-2, 1e-4, 1e-7)]
    gaps = [found.value - least for found in ends]
    evaluations = [found.evaluations for found in ends]
    assert gaps[0] >= gaps[1] >= gaps[2]
    assert evaluations[0] < evaluations[1] < evaluations[2]
    for gap, tolerance in zip(gaps, (1e-2, 1e-4, 1e-7), strict=True):
        assert gap < 5 * tolerance * least


def test_newtons_steps_alone_are_called_none_and_unknown_names_are_refused(rng):
    problem = problem_of(rng)
    alone, refined = (descend(problem, optimiser=name, tolerance=1e-3) for name in ("None", "lbfgs"))
    assert alone.value >= refined.value
    with pytest.raises(ValueError, match="no optimiser 'gauss'; there are: lbfgs, "):
        descend(problem, optimiser="gauss")


@pytest.mark.parametrize("failures", [2, 10_000])
def test_a_curvature_that_has_no_factor_is_damped_until_it_has_one_and_is_no_minimum(rng, monkeypatch, failures):
    count = []
    minimised = QuadraticModel.minimise

    def failing(self, damping):
        count.append(damping)
        found = minimised(self, damping)
        return found if len(count) > failures else Proposal(np.zeros_like(found.step), 0.0, None)

    monkeypatch.setattr(QuadraticModel, "minimise", failing)
    problem = problem_of(rng)
    found = GaussNewton()(Watched(problem), tolerance=1e-10)
    assert np.all(np.diff(count[: min(failures, len(count))]) > 0)
    if failures == 2:
        assert found.stop is Stop.CONVERGED
        np.testing.assert_allclose(found.value, by_nlopt(problem).value, rtol=1e-6)
    else:
        assert (found.stop, found.evaluations) == (Stop.NO_PROGRESS, 1)
