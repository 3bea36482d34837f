"""Taylor tests of gradients and curvature, for every soft constraint."""

from collections.abc import Callable

import numpy as np
from figures import TINY, figure_of, stance_of
from oracles import mujoco_forces
from random_models import at_times, closed, evenly, mask_without, partial_keys, random_keys, random_samples

from dynsplines.solver import penalty as kinds
from dynsplines.solver.array import Array, Index
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Discretised, Objective
from dynsplines.solver.penalty.block import one_sided_residuals
from dynsplines.solver.penalty.curvature import Curvature, OneSidedResiduals
from dynsplines.solver.search.quadratic import POINTS, Layout, QuadraticModel
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point, places_of

# The quadratic model of a step by differences of residuals, dense and slow.

SMOOTH = ("covariant", "unit", "root", "torque")


def discretised(timeline: Timeline, figure: Figure, penalties: list[kinds.Penalty], variable: int = 1) -> Discretised:
    objective = Objective.of(figure, [(penalty, 1.0) for penalty in penalties]).renormalise(path_of(timeline))
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
            t, w = own if term.penalty.is_sharp else few
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
    model = QuadraticModel(Layout(problem), x, gradient)
    hessian = dense_hessian(problem, names, x) + share * model.scale * flat_energy(problem)
    expected = -np.linalg.solve(hessian, gradient)
    step, promised, _ = model.minimise(share * model.scale)
    assert np.linalg.norm(expected) > 0.01
    assert np.linalg.norm(step - expected) < rtol * np.linalg.norm(expected)
    np.testing.assert_allclose(promised, -0.5 * gradient @ expected, rtol=rtol)
    np.testing.assert_allclose(promised, -(gradient @ step + 0.5 * step @ hessian @ step), rtol=rtol)


# The Taylor test of a gradient: |f(x + hd) − f(x) − h g·d| must fall as h².


def taylor_slope(fun: Callable[[Array], float], x: Array, gradient: Array, rng: np.random.Generator) -> float:
    """The slope of log remainder over log step between two steps, 2 for an exact gradient of a smooth function.

    A function that is linear along the direction leaves only rounding: its slope counts as 2. Where rounding dominates
    at the smaller step, steps ten times as long are tried too, and the greater slope counts.
    """
    direction = rng.normal(size=x.shape)
    direction /= np.linalg.norm(direction)
    value, slope = fun(x), float(np.sum(gradient * direction))
    rounding = 1e-11 * max(abs(value), abs(slope), 1.0)

    def remainders_of(steps: Array) -> Array:
        return np.array([abs(fun(x + h * direction) - value - h * slope) for h in steps])

    def slope_of(remainders: Array) -> float:
        return float(np.log10((remainders[0] + 1e-300) / (remainders[1] + 1e-300)))

    steps = np.array([1e-3, 1e-4])
    remainders = remainders_of(steps)
    if np.all(remainders < rounding):
        return 2.0
    order = slope_of(remainders)
    return order if remainders[1] >= rounding else max(order, slope_of(remainders_of(10 * steps)))


# The Taylor test of a soft constraint, whose value does not depend on the length of quaternions.


def penalty_slope(
    penalty: kinds.Penalty, samples: Samples, rng: np.random.Generator, *, any_length: bool = True
) -> float:
    """The Taylor slope of Σ_s scale_s f(y_s, y'_s, y''_s) along a random direction of all three; with any_length, f is
    also that of quaternions of any length."""
    scale = rng.uniform(0.5, 2, samples.count)
    cotangent = Cotangent(samples)
    values = penalty.evaluate(samples, cotangent, scale)
    np.testing.assert_array_equal(values, penalty.evaluate(samples))
    if any_length:
        np.testing.assert_allclose(penalty.evaluate(scaled_like(samples, rng)), values, rtol=1e-8, atol=1e-12)
    gradients = cotangent.gradients()
    unscaled, ones = Cotangent(samples), Cotangent(samples)
    penalty.evaluate(samples, unscaled)
    penalty.evaluate(samples, ones, np.ones(samples.count))
    for own, expected in zip(unscaled.gradients(), ones.gradients(), strict=True):
        np.testing.assert_allclose(own, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max(initial=0.0))

    def value(point: np.ndarray) -> float:
        return float(scale @ penalty.evaluate(Samples(samples.figure, *point, t=samples.t)))

    return taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng)


def scaled_like(samples: Samples, rng: np.random.Generator) -> Samples:
    """The same rotations at every moment, by quaternions q -> ρ(t) q with ρ, ρ', ρ'' of their own."""
    y, y_d, y_dd = samples.y.copy(), samples.y_d.copy(), samples.y_dd.copy()
    for columns in samples.figure.tables.quaternion_columns.T:
        rho, rho_d, rho_dd = rng.uniform(0.5, 2, (samples.count, 1)), *rng.normal(size=(2, samples.count, 1))
        q, q_d, q_dd = (a[:, columns] for a in (samples.y, samples.y_d, samples.y_dd))
        y[:, columns] = rho * q
        y_d[:, columns] = rho_d * q + rho * q_d
        y_dd[:, columns] = rho_dd * q + 2 * rho_d * q_d + rho * q_dd
    return Samples(samples.figure, y, y_d, y_dd, samples.t)


# Every soft constraint at once, and random clips.

SURFACES = (
    Plane("floor", np.zeros(3), np.array([0.0, 0, 1])),
    Box("step", np.array([0.3, 0.2, 0.1]), np.eye(3), np.array([0.9, 0.8, 0.5])),
)


def every_penalty(figure: Figure) -> list[tuple[kinds.Penalty, float]]:
    balls = [i for i, link in enumerate(figure.links) if i and link.kind is link.kind.BALL]
    joints = tuple(kinds.Bend(f"{i}", i, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])) for i in balls)
    points = tuple(Point(f"{i}", i, np.array([0.05, 0.1, -0.2]), 0.1) for i in range(1, len(figure.links)))
    return [
        (kinds.CovariantAcceleration(), 2.0),
        (kinds.CovariantAcceleration(), 0.5),
        (kinds.UnitMagnitude(), 5.0),
        (kinds.UnitMagnitude(most=0.1), 1.0),
        (kinds.RootAcceleration(), 1.5),
        (kinds.Torque(), 0.3),
        (kinds.BendLimits(joints), 2.5),
        (kinds.Collision(points, SURFACES), 4.0),
    ]


def clip(
    figure: Figure, rng: np.random.Generator, ends: str = "free", masks: dict[int, Array] | None = None
) -> Timeline:
    """Four random keyframes, by default two of them partial."""
    keys = partial_keys(figure, rng) if masks is None else random_keys(figure, rng, masks)
    slope = rng.normal(size=(2, figure.width)) if ends.startswith("clamped") else None
    return raw_timeline(figure, closed(keys) if ends == "periodic" else keys, ends, slope)


def tiny_clip(rng: np.random.Generator, ends: str, coordinates: str, *, partial: bool = False) -> Timeline:
    """Of two bodies; with `partial`, a keyframe leaves the root's turn free, on which the knee hangs."""
    figure = figure_of(TINY, coordinates)
    masks = {1: mask_without(figure, "root turn", "root x"), 2: mask_without(figure, "knee")} if partial else {}
    return clip(figure, rng, ends, masks)


# Residuals of soft constraints, written independently, and Gauss-Newton matrices by their differences.

STEP_SIZE = 1e-5
PLANTED = kinds.Attachment((stance_of(1, 0.2, 1.0), stance_of(2, 0.5, 2.0), stance_of(2, 0.0, 0.6)))


def _blocks(samples: Samples) -> tuple[Array, Array, Array]:
    """q, q', q'' of the state's quaternions, (S, n, 4) each."""
    columns = samples.figure.tables.quaternion_columns.T
    return samples.y[:, columns], samples.y_d[:, columns], samples.y_dd[:, columns]


def _along(a: Array, b: Array) -> Array:
    return np.sum(a * b, axis=-1, keepdims=True)


def _intrinsic(samples: Samples) -> Array:
    """P(q'' − 2 s q')/√b for quaternions, θ''/2 for hinges."""
    q, q_d, q_dd = _blocks(samples)
    b = _along(q, q)
    felt = q_dd - 2 * _along(q, q_d) / b * q_d
    felt = (felt - _along(felt, q) / b * q) / np.sqrt(b)
    return np.hstack([felt.reshape(samples.count, -1), samples.y_dd[:, samples.figure.tables.hinge_columns] / 2])


def _unit(samples: Samples) -> Array:
    q, _, _ = _blocks(samples)
    return 1 - np.sum(q * q, axis=-1)


def _root(samples: Samples) -> Array:
    tables = samples.figure.tables
    return samples.y_dd[:, [*tables.position_columns.ravel(), *tables.slide_columns]]


def _efforts(samples: Samples) -> Array:
    """MuJoCo's joint entries of qfrc_inverse, those of ball joints turned from the body's axes to the world's."""
    figure, forces = samples.figure, mujoco_forces(samples)
    efforts = []
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind == link.kind.BALL:
            own = forces[:, link.dof : link.dof + 3]
            efforts.append(np.einsum("ijs,sj->si", samples.links.rotation[:, :, i], own))
        elif link.kind != link.kind.FREE:
            efforts.append(forces[:, link.dof : link.dof + 1])
    return np.hstack(efforts)


def _displacement(samples: Samples) -> Array:
    """Every planted point's way from its place, zeros when its stance is over."""
    centres, _ = places_of(tuple(s.point for s in PLANTED.contacts), samples)
    away = []
    for stance, centre in zip(PLANTED.contacts, centres.swapaxes(0, 1), strict=True):
        lasts = (samples.t >= stance.first) & (samples.t <= stance.last)
        away.append(((centre - stance.place(samples.t)) * lasts).T)
    return np.hstack(away)


RESIDUALS: dict[str, tuple[kinds.Penalty, Callable[[Samples], Array]]] = {
    "covariant": (kinds.CovariantAcceleration(), _intrinsic),
    "unit": (kinds.UnitMagnitude(), _unit),
    "root": (kinds.RootAcceleration(), _root),
    "torque": (kinds.Torque(), _efforts),
    "planted": (PLANTED, _displacement),
}


def shifted(samples: Samples, by: Array) -> Samples:
    """Samples moved by (3, S, N)."""
    return Samples(samples.figure, samples.y + by[0], samples.y_d + by[1], samples.y_dd + by[2], samples.t)


def jacobians(residuals: Callable[[Samples], Array], samples: Samples) -> Array:
    """(S, r, 3, N): central differences of residuals with respect to y, y', y''."""
    count, width = samples.y.shape
    out = []
    for order in range(3):
        for column in range(width):
            by = np.zeros((3, count, width))
            by[order, :, column] = STEP_SIZE
            out.append((residuals(shifted(samples, by)) - residuals(shifted(samples, -by))) / (2 * STEP_SIZE))
    return np.array(out).reshape(3, width, count, -1).transpose(2, 3, 0, 1)


def jacobian(samples: Samples, at: Index, seeded: Callable[[Samples, Cotangent, Index], None]) -> Array:
    """(P, 3, N): the gradients of P residuals at samples `at` (P,) with respect to y, y', y''.

    seeded(copies, cotangent, rows) adds the seeds of rows (R,) to the cotangent of R copied samples.
    """
    rows = np.arange(at.size)
    copies = samples.select(at)
    cotangent = Cotangent(copies)
    seeded(copies, cotangent, rows)
    return np.stack(cotangent.gradients(), axis=1)


def curvature_of(penalty: kinds.Penalty, samples: Samples, scale: Array) -> Curvature:
    curvature = Curvature(samples)
    for block in penalty.residuals(samples):
        block.add_to(curvature, scale)
    return curvature


def assembled(curvature: Curvature, phi: Array) -> Array:
    """(S, K N, K N): the matrices of the coefficients of K directions (S, 3, K), from rows and blocks."""
    count, width, directions = curvature.samples.count, curvature.width, phi.shape[2]
    out = np.zeros((count, directions * width, directions * width))
    for at, left, right in curvature.rows(phi):
        assert np.all(np.diff(at) >= 0)
        rows = np.matmul(left, right).reshape(at.size, -1)
        np.add.at(out, at, rows[:, :, None] * rows[:, None, :])
    for columns, squares in curvature.squares():
        blocks = np.einsum("soa,snokpl,spb->snakbl", phi, squares, phi)
        for n, own in enumerate(columns):
            place = (np.arange(directions)[:, None] * width + own).ravel()
            size = place.size
            out[np.ix_(np.arange(count), place, place)] += blocks[:, n].reshape(count, size, size)
    return out


def assert_near(actual: Array, expected: Array, rtol: float = 1e-5) -> None:
    np.testing.assert_allclose(actual, expected, rtol=0, atol=rtol * max(np.abs(expected).max(), 1e-12))


def some_samples(figure: Figure, rng: np.random.Generator, count: int = 4) -> Samples:
    return at_times(random_samples(figure, rng, count), np.linspace(0.1, 1.3, count))


def assert_squares(
    penalty: kinds.Penalty, residuals: Callable[[Samples], Array], samples: Samples, rng: np.random.Generator
):
    """That a penalty is the sum of squared residuals (S, r), and its matrices are 2 JᵀJ, J by differences."""
    np.testing.assert_allclose(np.sum(residuals(samples) ** 2, axis=1), penalty.evaluate(samples), rtol=1e-9)
    scale, phi = rng.uniform(0.5, 2, samples.count), rng.normal(size=(samples.count, 3, 2))
    moved = np.einsum("sron,soa->sran", jacobians(residuals, samples), phi)
    flat = moved.reshape(*moved.shape[:2], -1)
    expected = 2 * scale[:, None, None] * np.einsum("srx,sry->sxy", flat, flat)
    assert_near(assembled(curvature_of(penalty, samples, scale), phi), expected)


def sides_of(penalty: kinds.Penalty, samples: Samples) -> OneSidedResiduals:
    sides = one_sided_residuals(penalty.residuals(samples), samples)
    assert sides is not None
    assert sides.at.shape == sides.value.shape == sides.rows.shape[:1]
    return sides
