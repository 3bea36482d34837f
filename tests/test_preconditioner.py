"""The change of variables: a linear map with its exact transpose, in which the flat acceleration energy is a sphere."""

import mujoco
import numpy as np
import pytest
from test_objective import clip

from solver.descent import Descent
from solver.figure import Figure
from solver.frame import Frame
from solver.objective import Objective
from solver.penalty import CovariantAcceleration, RootAcceleration
from solver.preconditioner import Preconditioner
from solver.subdivision import evenly, path_of
from solver.unknowns import raw_timeline

ENDS = ["free", "clamped", "periodic"]


def discretised(figure: Figure, rng: np.random.Generator, ends: str):
    timeline = clip(figure, rng, ends)
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    return objective.renormalised(path_of(timeline)).on(evenly(timeline, 2))


@pytest.mark.parametrize("ends", ENDS)
def test_gradient_is_the_transpose_of_to_x(figure, rng, ends):
    problem = discretised(figure, rng, ends)
    preconditioner = Preconditioner(problem)
    z, g = rng.normal(size=preconditioner.size), rng.normal(size=problem.unknowns.size)
    np.testing.assert_allclose(g @ preconditioner.to_x(z), preconditioner.gradient(g) @ z, rtol=1e-10)


@pytest.mark.parametrize("ends", ENDS)
def test_to_x_is_linear_and_reaches_every_unknown(figure, rng, ends):
    problem = discretised(figure, rng, ends)
    preconditioner = Preconditioner(problem)
    to_x = preconditioner.to_x
    a, b = rng.normal(size=(2, preconditioner.size))
    np.testing.assert_allclose(to_x(2 * a - b), 2 * to_x(a) - to_x(b), rtol=1e-9, atol=1e-12)
    reached = np.array([preconditioner.gradient(e) for e in np.eye(problem.unknowns.size)])
    assert np.linalg.matrix_rank(reached, tol=1e-9) == problem.unknowns.size


def slider(times: np.ndarray, variable: int):
    """One slide under its acceleration energy, the flat case."""
    figure = Figure(
        mujoco.MjModel.from_xml_string(
            '<mujoco><worldbody><body><joint type="slide"/><geom size=".1"/></body></worldbody></mujoco>'
        )
    )
    keys = [Frame.key(t, [np.sin(3 * t)]) for t in times]
    raw = raw_timeline(figure, keys)
    return Objective.of(figure, [(RootAcceleration(), 1.0)]).renormalised(path_of(raw)).on(evenly(raw, variable))


@pytest.mark.parametrize("variable", [1, 4])
def test_in_z_the_flat_acceleration_energy_is_nearly_a_sphere(variable):
    problem = slider(np.array([0.0, 0.3, 1.0, 2.5]), variable)
    preconditioner, start = Preconditioner(problem), problem.unknowns.start
    base = problem(start).gradient
    hessian = np.array([problem(start + e).gradient - base for e in np.eye(start.size)])
    to_z = np.array([preconditioner.gradient(e) for e in np.eye(start.size)])
    raw = np.linalg.eigvalsh(hessian)
    # the entries of z that move nothing have the eigenvalue 0
    after = np.linalg.eigvalsh(to_z.T @ hessian @ to_z)[-start.size :]
    assert after[0] > 0
    assert after[-1] / after[0] < 20
    assert raw[-1] / raw[0] > 20 * after[-1] / after[0]


def test_the_descent_in_z_is_the_objective_in_x(figure, rng):
    timeline = evenly(clip(figure, rng), 1)
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    descent = Descent(objective, timeline)
    z = 0.01 * rng.normal(size=descent.preconditioner.size)
    value, gradient = descent(z)
    at_x = descent.problem(descent.x(z))
    assert value == at_x.value
    np.testing.assert_array_equal(gradient, descent.preconditioner.gradient(at_x.gradient))
    np.testing.assert_array_equal(descent.x(0 * z), descent.start)


def test_a_flat_problem_is_solved_in_a_few_evaluations():
    problem = slider(np.array([0.0, 0.3, 1.0, 2.5]), 4)
    found = Descent(problem.objective, problem.timeline).run(tolerance=1e-10)
    assert found.evaluations < 40
    assert np.abs(problem(found.x).gradient).max() < 1e-3 * np.abs(problem(problem.unknowns.start + 0.1).gradient).max()
