"""The change of variables: a linear map with its exact transpose, in which the Gauss-Newton model is a sphere."""

import numpy as np
import pytest
from small_problems import discretised, slider

from dynsplines.solver.objective import Discretised
from dynsplines.solver.search.descent import Descent
from dynsplines.solver.search.preconditioner import Preconditioner
from dynsplines.solver.search.quadratic import Layout, Model

ENDS = ["free", "clamped", "periodic"]


def preconditioned(problem: Discretised, damping: float = 0.0, value: float = 1.0) -> tuple[Preconditioner, Model]:
    """Of the model where the timeline is."""
    layout, start = Layout(problem), problem.unknowns.start
    model = Model(layout, start, problem(start).gradient)
    factor = model.minimised(damping * model.scale).factor
    assert factor is not None
    return Preconditioner(layout, factor, value), model


def transposed(preconditioner: Preconditioner, size: int) -> np.ndarray:
    """(n, z) P, a row for each unknown."""
    return np.array([preconditioner.gradient(e) for e in np.eye(size)])


@pytest.mark.parametrize("ends", ENDS)
def test_gradient_is_the_transpose_of_to_x(figure, rng, ends):
    problem = discretised(figure, rng, ends)
    preconditioner, _ = preconditioned(problem, 0.1, 3.0)
    z, g = rng.normal(size=preconditioner.size), rng.normal(size=problem.unknowns.size)
    np.testing.assert_allclose(g @ preconditioner.to_x(z), preconditioner.gradient(g) @ z, rtol=1e-9)


@pytest.mark.parametrize("ends", ENDS)
def test_to_x_is_linear_and_reaches_every_unknown(figure, rng, ends):
    problem = discretised(figure, rng, ends)
    preconditioner, _ = preconditioned(problem)
    to_x = preconditioner.to_x
    a, b = rng.normal(size=(2, preconditioner.size))
    np.testing.assert_allclose(to_x(2 * a - b), 2 * to_x(a) - to_x(b), rtol=1e-9, atol=1e-12)
    reached = transposed(preconditioner, problem.unknowns.size)
    assert np.linalg.matrix_rank(reached, tol=1e-9) == problem.unknowns.size


@pytest.mark.parametrize("ends", ENDS)
def test_the_slope_of_e_in_z_is_the_gradient_taken_along(figure, rng, ends):
    problem = discretised(figure, rng, ends)
    preconditioner, _ = preconditioned(problem)
    start, z = problem.unknowns.start, rng.normal(size=preconditioner.size)
    ahead, behind = (problem(start + preconditioner.to_x(sign * 1e-5 * z)).value for sign in (1, -1))
    slope = preconditioner.gradient(problem(start).gradient) @ z
    assert (ahead - behind) / 2e-5 == pytest.approx(slope, rel=1e-4)


@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize("value", [1.0, 7.0])
def test_in_z_the_model_of_e_is_a_sphere(figure, rng, ends, value):
    """The model falls by ½ gᵀH⁻¹g: P Pᵀ g is the model's step, and the fall is that of a sphere of radius √value."""
    problem = discretised(figure, rng, ends)
    preconditioner, model = preconditioned(problem, 0.0, value)
    gradient = preconditioner.gradient(problem(problem.unknowns.start).gradient)
    step, promised, _ = model.minimised(0.0)
    np.testing.assert_allclose(preconditioner.to_x(-gradient) / value, step, rtol=1e-6, atol=1e-9 * abs(step).max())
    assert 0.5 * float(gradient @ gradient) / value == pytest.approx(promised, rel=1e-9)


@pytest.mark.parametrize("variable", [1, 4])
def test_in_z_the_flat_acceleration_energy_is_a_sphere(variable):
    """The dense Hessian of E itself, by differences of its gradient."""
    problem = slider(np.array([0.0, 0.3, 1.0, 2.5]), variable)
    preconditioner, _ = preconditioned(problem)
    start = problem.unknowns.start
    base = problem(start).gradient
    hessian = np.array([problem(start + e).gradient - base for e in np.eye(start.size)])
    to_z = transposed(preconditioner, start.size)
    # the entries of z that move nothing have the eigenvalue 0
    after = np.linalg.eigvalsh(to_z.T @ hessian @ to_z)[-start.size :]
    np.testing.assert_allclose(after, 1.0, rtol=1e-3)
    raw = np.linalg.eigvalsh(hessian)
    assert raw[-1] / raw[0] > 20


def test_a_flat_problem_is_solved_in_a_few_evaluations():
    problem = slider(np.array([0.0, 0.3, 1.0, 2.5]), 4)
    found = Descent(problem.objective, problem.timeline).run(tolerance=1e-10)
    assert found.evaluations < 40
    assert np.abs(problem(found.x).gradient).max() < 1e-3 * np.abs(problem(problem.unknowns.start + 0.1).gradient).max()
