"""NLopt's methods in the model's variables: as low as Gauss-Newton, keyframes exact, and stopped as asked."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE
from small_problems import discretised, problem_of

from dynsplines.clip.load import load
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Discretised, Objective
from dynsplines.solver.penalty import CovariantAcceleration
from dynsplines.solver.refine.subdivision import evenly
from dynsplines.solver.search import methods, refinement
from dynsplines.solver.search.descent import NEWTON, Descent
from dynsplines.solver.search.methods import METHODS
from dynsplines.solver.search.minimum import Stop, StopSearch
from dynsplines.solver.search.newton import gauss_newton
from dynsplines.solver.search.refinement import refined
from dynsplines.solver.solution import Solution

TWO_BALLS = """
<mujoco><worldbody><body><joint type="ball"/><geom size=".1" pos="0 0 -.3"/>
  <body pos="0 0 -.5"><joint type="ball"/><geom size=".1" pos=".1 0 -.3"/></body></body></worldbody></mujoco>"""


@pytest.fixture
def problem(rng) -> Discretised:
    return discretised(Figure(mujoco.MjModel.from_xml_string(BALL_TREE)), rng, "free")


def solved(name: str, method: str) -> Solution:
    clip = load(name)
    return inbetween(replace(clip.problem, settings=replace(clip.settings, method=method)))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["run_loop", "sit_down"])
def test_a_shipped_clip_is_as_low_by_nlopt_as_by_gauss_newton_and_its_keyframes_are_met(name):
    ours, theirs = solved(name, "lbfgs"), solved(name, NEWTON)
    assert ours.trace[-1][2] <= 1.01 * theirs.trace[-1][2]
    assert ours.stop is Stop.CONVERGED
    for key in load(name).keys:
        held = key.fixed
        difference = np.abs(ours.at([key.time])[0] - theirs.at([key.time])[0])
        assert held.any()
        assert difference[held].max() < 1e-9


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("ends", ["free", "periodic"])
def test_every_method_ends_as_low_as_gauss_newton(rng, method, ends):
    problem = problem_of(rng, ends)
    found, _ = refined(problem, method=method, max_evaluations=100, tolerance=1e-7)
    lowest, _ = gauss_newton(problem, tolerance=1e-9)
    assert found.stop is Stop.CONVERGED
    assert found.value <= 1.001 * lowest.value
    assert problem(found.x).value == found.value


def test_a_partial_keyframe_keeps_what_it_fixes_while_the_rest_moves(rng):
    """Of two balls in a chain the upper one is free at the middle keyframe."""
    figure = Figure(mujoco.MjModel.from_xml_string(TWO_BALLS), "world")
    first, middle, last = (figure.to_qpos(rng.normal(size=(1, figure.width)))[0] for _ in range(3))
    mask = np.arange(middle.size) >= 4
    keys = [Frame.key(0.0, first), Frame.key(0.5, middle, mask), Frame.key(1.0, last)]
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0)])
    timeline = evenly(raw_timeline(figure, keys), 2)
    problem = objective.on(timeline)
    found, _ = refined(problem, method="lbfgs", max_evaluations=100, tolerance=1e-9)
    assert found.value < 0.99 * problem(problem.unknowns.start).value
    solved = figure.to_qpos(path_of(timeline.with_rows(problem.unknowns.rows(found.x))).at([0.0, 0.5, 1.0]))
    begun = figure.to_qpos(path_of(timeline).at([0.0, 0.5, 1.0]))
    np.testing.assert_allclose(np.abs(np.sum(solved[1, 4:] * middle[4:])), 1, atol=1e-9)
    np.testing.assert_allclose(solved[[0, 2]], begun[[0, 2]], atol=1e-12)
    assert np.abs(solved[1, :4] - begun[1, :4]).max() > 1e-4


def test_nlopt_lowers_e_where_the_model_has_no_more_to_promise(problem):
    """With the budget of one step, and then with NLopt's few evaluations after it."""
    step, _ = refined(problem, method="lbfgs", max_evaluations=2, tolerance=1e-12)
    more, _ = refined(problem, method="lbfgs", max_evaluations=6, tolerance=1e-12)
    assert more.value < step.value
    assert (step.evaluations, more.evaluations) == (2, 6)


@pytest.mark.parametrize("budget", [1, 2, 3, 5, 9])
def test_the_budget_holds_and_the_best_point_is_kept(problem, budget):
    told: list[float] = []
    count = 0

    def counted(x: np.ndarray):
        nonlocal count
        count += 1
        return Discretised.__call__(problem, x)

    watched = _Watched(problem, counted)
    found, _ = refined(
        watched,  # type: ignore[arg-type]
        method="lbfgs",
        max_evaluations=budget,
        tolerance=1e-15,
        improved=lambda n, evaluation, x: told.append(evaluation.value),
    )
    assert count == found.evaluations == budget
    assert found.stop is Stop.BUDGET
    assert found.value == told[-1] == min(told)
    assert np.all(np.diff(told) < 0)


class _Watched:
    """A problem whose evaluations go through a function."""

    def __init__(self, problem: Discretised, call) -> None:
        self._problem, self._call = problem, call

    def __getattr__(self, name: str):
        return getattr(self._problem, name)

    def __call__(self, x: np.ndarray):
        return self._call(x)


@pytest.mark.parametrize("error", [StopSearch, KeyboardInterrupt])
@pytest.mark.parametrize("at", [1, 2, 3])
def test_a_stop_asked_for_in_any_phase_keeps_the_best_point(problem, error, at):
    told = []

    def improved(_count, evaluation, _x) -> None:
        told.append(evaluation.value)
        if len(told) == at:
            raise error

    found, _ = refined(problem, method="lbfgs", max_evaluations=100, tolerance=1e-12, improved=improved)
    assert found.stop is Stop.ASKED
    assert found.value == told[-1]
    assert len(told) == at


def test_an_error_in_the_callback_comes_out_as_it_went_in(problem):
    def improved(count, _evaluation, _x) -> None:
        if count > 2:
            raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        refined(problem, method="lbfgs", max_evaluations=100, tolerance=1e-12, improved=improved)


def test_nlopts_own_names_will_do_in_a_descent(problem):
    found = Descent(problem.objective, problem.timeline).run(method="LD_MMA", tolerance=1e-4)
    assert found.stop is Stop.CONVERGED
    assert found.value < problem(problem.unknowns.start).value


def test_a_dense_method_is_left_out_of_large_problems(problem, monkeypatch):
    def never(*_: object, **__: object) -> None:
        raise AssertionError("NLopt was asked")

    monkeypatch.setattr(refinement, "minimise", never)
    with pytest.raises(AssertionError, match="NLopt was asked"):
        refined(problem, method="slsqp", max_evaluations=100, tolerance=1e-9)
    monkeypatch.setitem(methods.DENSE, "slsqp", problem.unknowns.size - 1)
    found, _ = refined(problem, method="SLSQP", max_evaluations=100, tolerance=1e-9)
    expected, _ = gauss_newton(problem, tolerance=1e-9)
    np.testing.assert_allclose(found.value, expected.value, rtol=1e-6)
    with pytest.raises(AssertionError, match="NLopt was asked"):
        refined(problem, method="lbfgs", max_evaluations=100, tolerance=1e-9)
