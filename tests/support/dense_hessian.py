"""The matrix of a quadratic model by differences of gradients: an oracle, dense and slow."""

from __future__ import annotations

import numpy as np
from curvature_of import RESIDUALS
from even_frames import evenly
from figures import TINY, figure_of
from random_keys import TIMES, mask_without, random_keys

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Discretised, Objective
from dynsplines.solver.penalty import Penalty
from dynsplines.solver.search.quadratic import POINTS, Layout, Model

SMOOTH = ("covariant", "unit", "root", "torque")


def tiny_clip(rng: np.random.Generator, ends: str, coordinates: str, *, partial: bool = False) -> Timeline:
    """Four keyframes of two bodies; with `partial`, the second leaves the root's turn free, on which the knee hangs."""
    figure = figure_of(TINY, coordinates)
    masks = {1: mask_without(figure, "root turn", "root x"), 2: mask_without(figure, "knee")} if partial else {}
    keys = random_keys(figure, rng, masks)
    if ends == "periodic":
        keys[-1] = Frame.key(TIMES[-1], keys[0].state)
    slope = rng.normal(size=(2, figure.width)) if ends.startswith("clamped") else None
    return raw_timeline(figure, keys, ends, slope)


def discretised(timeline: Timeline, figure: Figure, penalties: list[Penalty], variable: int = 1) -> Discretised:
    objective = Objective.of(figure, [(penalty, 1.0) for penalty in penalties]).renormalised(path_of(timeline))
    return objective.on(evenly(timeline, variable))


def moved_by(problem: Discretised, t: Array) -> Array:
    """(S, 3, N, n): how y, y', y'' at t move with the unknowns."""
    spline, matrix = problem.spline, problem.unknowns.matrix.toarray()
    coefficients = spline.coefficients(matrix.reshape(spline.size, -1))
    shape = (t.size, problem.timeline.width, -1)
    return np.stack([(spline.basis(t, k) @ coefficients).reshape(shape) for k in range(3)], axis=1)


def dense_hessian(problem: Discretised, names: tuple[str, ...], x: Array) -> Array:
    """Σ w 2 JᵀJ over two Gauss points a span, over E's own samples for sharp terms, J by differences of residuals with
    respect to the unknowns."""
    few = gauss_nodes(np.asarray(problem.spline.times), POINTS)
    own = problem.sampling.t, problem.weights

    def residuals(at: Array) -> Array:
        parts = []
        for name, term in zip(names, problem.objective.terms, strict=True):
            t, w = own if term.penalty.normalization.is_sharp else few
            samples = problem.objective.samples(problem.path(at), t)
            parts.append((np.sqrt(2 * term.factor * w)[:, None] * RESIDUALS[name][1](samples)).ravel())
        return np.concatenate(parts)

    h = 1e-5
    columns = [(residuals(x + h * e) - residuals(x - h * e)) / (2 * h) for e in np.eye(x.size)]
    jacobian = np.array(columns).T
    return jacobian.T @ jacobian


def flat_energy(problem: Discretised) -> Array:
    """F: ∫ |δ''|² + 0.3 |δ|²/(spacing of keyframes)⁴ of steps in the unknowns."""
    t, w = gauss_nodes(np.asarray(problem.spline.times), POINTS)
    moved = moved_by(problem, t)
    frames = problem.timeline.frames
    spacing = (frames[-1].time - frames[0].time) / max(sum(not frame.is_variable for frame in frames), 2)
    value, acceleration = (np.sqrt(w)[:, None, None] * moved[:, k] for k in (0, 2))
    value, acceleration = (part.reshape(-1, moved.shape[-1]) for part in (value, acceleration))
    return acceleration.T @ acceleration + 0.3 / spacing**4 * value.T @ value


def smooth_problem(timeline: Timeline, figure: Figure, rng: np.random.Generator) -> tuple[Discretised, Array]:
    """A problem with residuals on both sides only, and unknowns off where it starts."""
    problem = discretised(timeline, figure, [RESIDUALS[name][0] for name in SMOOTH])
    start = problem.unknowns.start
    return problem, start + 0.05 * rng.normal(size=start.size)


def assert_dense(
    problem: Discretised, names: tuple[str, ...], x: Array, rtol: float = 1e-4, share: float = 0.0
) -> None:
    """That a step is the dense one, with damping by a share of the model's unit."""
    gradient = problem(x).gradient
    model = Model(Layout(problem), x, gradient)
    hessian = dense_hessian(problem, names, x) + share * model.scale * flat_energy(problem)
    expected = -np.linalg.solve(hessian, gradient)
    step, promised, _ = model.minimise(share * model.scale)
    assert np.linalg.norm(expected) > 0.01
    assert np.linalg.norm(step - expected) < rtol * np.linalg.norm(expected)
    np.testing.assert_allclose(promised, -0.5 * gradient @ expected, rtol=rtol)
    np.testing.assert_allclose(promised, -(gradient @ step + 0.5 * step @ hessian @ step), rtol=rtol)
