"""The model of a step: its minimum against dense Gauss-Newton steps in the unknowns, on both sides and on one."""

from collections.abc import Iterator
from dataclasses import replace

import gradients
import numpy as np
import pytest
from figures import FLOOR, TINY, figure_of, limits_of
from random_models import TIMES, masks_by_name, random_keys
from scipy.optimize import minimize

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Discretised, Objective
from dynsplines.solver.penalty import Collision, Penalty
from dynsplines.solver.penalty.block import Block
from dynsplines.solver.search.quadratic import Layout, QuadraticModel, line_minimum
from dynsplines.solver.surface.points import Point

ENDS = ["free", "clamped", "clamped end", "periodic"]


@pytest.mark.parametrize(("ends", "coordinates"), list(zip(ENDS, ["world", "joint"] * 2, strict=True)))
def test_the_step_is_the_dense_gauss_newton_step_in_the_unknowns(rng, ends, coordinates):
    figure = figure_of(TINY, coordinates)
    timeline = gradients.tiny_clip(rng, ends, coordinates, partial=True)
    problem, x = gradients.smooth_problem(timeline, figure, rng)
    gradients.assert_dense(problem, gradients.SMOOTH, x)


@pytest.mark.slow
def test_so_it_is_with_anything_left_free_in_any_keyframe(figure):
    """Each figure with one kind of ends."""
    rng, ends = np.random.default_rng(0), ("free", "clamped end", "periodic")[figure.width % 3]
    keys = random_keys(figure, rng, masks_by_name(figure, "any", rng))
    if ends == "periodic":
        keys[-1] = Frame.key(TIMES[-1], keys[0].state, keys[0].fixed & keys[-1].fixed)
    slope = rng.normal(size=(2, figure.width)) if ends.startswith("clamped") else None
    problem = gradients.discretised(
        raw_timeline(figure, keys, ends, slope), figure, [gradients.RESIDUALS[name][0] for name in gradients.SMOOTH[:3]]
    )
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    # an entry fixed once at most may drift for nothing; springs of places are as stiff as those of angles, but metres
    # count more in a small figure
    gradients.assert_dense(problem, gradients.SMOOTH[:3], x, 1e-4 / Size.of(figure).length ** 2, share=0.1)


@pytest.mark.parametrize("ends", ["clamped", "periodic"])
def test_a_model_made_of_few_spans_at_once_is_the_same(rng, ends, monkeypatch):
    figure = figure_of(TINY)
    problem, x = gradients.smooth_problem(gradients.tiny_clip(rng, ends, "world"), figure, rng)
    gradient, spans = problem(x).gradient, problem.spline.times.size - 1
    step, promised, _ = QuadraticModel(Layout(problem), x, gradient).minimise(0.1)
    monkeypatch.setattr("dynsplines.solver.search.quadratic.IN_CACHE", 0)
    for at_once in (1, 2, 4, spans - 1, spans, spans + 1):
        monkeypatch.setattr("dynsplines.solver.search.quadratic.SPANS_AT_ONCE", at_once)
        layout = Layout(problem)
        assert len(layout.pieces) == -(-spans // at_once)
        again, promised_again, _ = QuadraticModel(layout, x, gradient).minimise(0.1)
        np.testing.assert_allclose(again, step, rtol=1e-7, atol=1e-9)
        np.testing.assert_allclose(promised_again, promised, rtol=1e-9)


def test_a_model_that_has_no_minimum_promises_nothing(rng):
    figure = figure_of(TINY)
    problem, x = gradients.smooth_problem(gradients.tiny_clip(rng, "free", "world"), figure, rng)
    model = QuadraticModel(Layout(problem), x, problem(x).gradient)
    model.curvature *= -1
    step, promised, _ = model.minimise(0.0)
    assert step.shape == x.shape
    assert not step.any()
    assert promised == 0


class Touching(Collision):
    """All points near the floor, but not in it, touch it."""

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for block in super().residuals(samples):
            yield replace(block, value=np.where(block.value > 0, block.value, -1e-9))


def one_sided_problem(
    rng: np.random.Generator, ends: str, *, floor: bool = True, kind: type[Collision] = Collision
) -> tuple[Discretised, Array]:
    """Two bodies whose points lie in a floor and just over it, and whose knee bends too far or nearly so."""
    figure = figure_of(TINY)
    timeline = gradients.tiny_clip(rng, ends, "world")
    rows = np.array(timeline.rows)
    rows[:-2, 2] *= 0.1
    timeline = timeline.with_rows(rows)
    positions = 0.15 * rng.normal(size=(8, 3))
    points = tuple(Point(f"{i}", 1 + i % 2, position, 0.02) for i, position in enumerate(positions))
    contact, bend = kind(points, (FLOOR,)), limits_of(figure)
    more: list[Penalty] = [contact, bend] if floor else [bend]
    problem = gradients.discretised(
        timeline, figure, [*(gradients.RESIDUALS[name][0] for name in gradients.SMOOTH), *more]
    )
    start = problem.unknowns.start
    return problem, start + 0.05 * rng.normal(size=start.size)


class Dense:
    """m(δ) of the module's text on dense matrices, in the unknowns."""

    def __init__(self, problem: Discretised, x: Array) -> None:
        two_sided = Objective(problem.objective.figure, problem.objective.terms[: len(gradients.SMOOTH)])
        self.hessian = gradients.dense_hessian(two_sided.on(problem.timeline), gradients.SMOOTH, x)
        samples = problem.objective.samples(problem.path(x), problem.sampling.t)
        moved = gradients.moved_by(problem, problem.sampling.t)[:, 0]
        values, weights, rows = [], [], []
        for term in problem.objective.terms[len(gradients.SMOOTH) :]:
            sides = gradients.sides_of(term.penalty, samples)
            values.append(sides.value)
            weights.append(term.factor * problem.weights[sides.at])
            rows.append(np.einsum("pn,pnx->px", sides.rows, moved[sides.at]))
        self.value, self.weight, self.rows = np.concatenate(values), np.concatenate(weights), np.concatenate(rows)
        self.gradient = problem(x).gradient - self.pull(self.value)

    def pull(self, over: Array) -> Array:
        return self.rows.T @ (2 * self.weight * np.maximum(over, 0))

    def __call__(self, step: Array) -> tuple[float, Array]:
        over, bent = self.value + self.rows @ step, self.hessian @ step
        worth = self.gradient @ step + 0.5 * step @ bent + self.weight @ np.maximum(over, 0) ** 2
        return float(worth), np.asarray(self.gradient + bent + self.pull(over), float)

    def minimum(self) -> tuple[Array, float]:
        """By SciPy, in coordinates in which the two-sided part is a sphere."""
        half = np.linalg.cholesky(self.hessian)

        def fun(z: Array) -> tuple[float, Array]:
            value, gradient = self(np.linalg.solve(half.T, z).astype(float))
            return value, np.linalg.solve(half, gradient).astype(float)

        options = {"maxiter": 20000, "maxfun": 40000, "ftol": 1e-16, "gtol": 1e-9, "maxcor": 40}
        found = minimize(fun, np.zeros(len(half)), jac=True, method="L-BFGS-B", options=options)
        return np.linalg.solve(half.T, found.x), float(found.fun)


@pytest.mark.parametrize("kind", [Collision, Touching])
@pytest.mark.parametrize("ends", ["clamped", "periodic"])
def test_with_one_sided_residuals_the_step_minimises_the_convex_model(rng, ends, kind, monkeypatch):
    problem, x = one_sided_problem(rng, ends, kind=kind)
    dense = Dense(problem, x)
    before = dense(np.zeros(x.size))[0]
    best, least = dense.minimum()
    after = dense.value + dense.rows @ best
    assert np.count_nonzero((after > 0) != (dense.value > 0)) > 0  # what counts changes within the step
    monkeypatch.setattr("dynsplines.solver.search.quadratic.SETTLED", 1e-14)
    model = QuadraticModel(Layout(problem), x, problem(x).gradient)
    step, promised, _ = model.minimise(0.0)
    np.testing.assert_allclose(dense(step)[0], least, rtol=0, atol=1e-4 * (before - least))
    np.testing.assert_allclose(promised, before - least, rtol=1e-3)
    assert np.linalg.norm(step - best) < 0.01 * np.linalg.norm(best)


@pytest.mark.parametrize("seed", range(20))
def test_the_line_search_finds_the_minimum_on_a_fine_grid(seed):
    rng, share = np.random.default_rng(seed), np.linspace(0, 1, 5001)
    count = rng.integers(1, 30)
    weight, value, change = rng.random(count), rng.normal(size=count), 3 * rng.normal(size=count)
    value[rng.random(count) < 0.2] = 0.0
    slope, bend = float(-5 * rng.random() - 2 * weight @ (np.maximum(value, 0) * change)), rng.random()

    def worth(s: Array) -> Array:
        return slope * s + bend * s**2 / 2 + weight @ np.maximum(value[:, None] + change[:, None] * s, 0) ** 2

    found = line_minimum(slope, bend, weight, value, change)
    assert worth(np.array([found]))[0] <= worth(share).min() + 1e-12
