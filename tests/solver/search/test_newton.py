"""The Gauss-Newton search: the minimum that NLopt finds, in few evaluations, and every way of being stopped."""

import numpy as np
import pytest
from figures import TINY, figure_of
from problems import TERMS, Watched, by_nlopt, problem_of

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.objective import Evaluation, Objective
from dynsplines.solver.search.descent import minimise
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.search.newton import FIRST_DAMPING, GaussNewton
from dynsplines.solver.search.quadratic import Proposal, QuadraticModel


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
    alone, refined = (minimise(problem, optimiser=name, tolerance=1e-3) for name in ("None", "lbfgs"))
    assert alone.value >= refined.value
    with pytest.raises(ValueError, match="no optimiser 'gauss'; there are: lbfgs, "):
        minimise(problem, optimiser="gauss")


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
