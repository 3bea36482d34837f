"""The last stage: NLopt in the model's variables lowers what Gauss-Newton steps found, or ends at once."""

from dataclasses import replace

import numpy as np
import pytest
import shipped
from figures import BALL_TREE, figure_of
from small_problems import discretised, problem_of, slider

from dynsplines.clip.load import load
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Discretised
from dynsplines.solver.search import newton, nlopt_methods
from dynsplines.solver.search.descent import Descent
from dynsplines.solver.search.minimum import Minimum, Stop
from dynsplines.solver.search.newton import GaussNewton
from dynsplines.solver.search.nlopt_methods import METHODS, NONE
from dynsplines.solver.search.quadratic import Layout, Model

NAMES = [name for name in METHODS if name != NONE]


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


@pytest.mark.parametrize("method", NAMES)
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
