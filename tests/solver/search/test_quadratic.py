"""The model of a step: its minimum against dense Gauss-Newton steps in the unknowns, on both sides and on one."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from figures import BALL, FLOOR, ONE_BALL, TINY, figure_of, limits_of, stance_of
from gradients import (
    RESIDUALS,
    SMOOTH,
    assert_dense,
    dense_hessian,
    discretised,
    flat_energy,
    moved_by,
    smooth_problem,
    tiny_clip,
)
from random_models import TIMES, evenly, mask_without, masks_by_name, random_keys
from scipy.optimize import minimize

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.size import Size
from dynsplines.solver.objective import Discretised, Objective
from dynsplines.solver.penalty import (
    Attachment,
    Contact,
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    UnitMagnitude,
)
from dynsplines.solver.penalty.block import Block
from dynsplines.solver.search.quadratic import SETTLED, Layout, Model, line_minimum, middle
from dynsplines.solver.surface.points import Point

ENDS = ["free", "clamped", "clamped end", "periodic"]


@pytest.mark.parametrize(("ends", "coordinates"), list(zip(ENDS, ["world", "joint"] * 2, strict=True)))
def test_the_step_is_the_dense_gauss_newton_step_in_the_unknowns(rng, ends, coordinates):
    figure = figure_of(TINY, coordinates)
    timeline = tiny_clip(rng, ends, coordinates, partial=True)
    problem, x = smooth_problem(timeline, figure, rng)
    assert_dense(problem, SMOOTH, x)


@pytest.mark.slow
def test_so_it_is_with_anything_left_free_in_any_keyframe(figure):
    """Each figure with one kind of ends."""
    rng, ends = np.random.default_rng(0), ("free", "clamped end", "periodic")[figure.width % 3]
    keys = random_keys(figure, rng, masks_by_name(figure, "any", rng))
    if ends == "periodic":
        keys[-1] = Frame.key(TIMES[-1], keys[0].state, keys[0].fixed & keys[-1].fixed)
    slope = rng.normal(size=(2, figure.width)) if ends.startswith("clamped") else None
    problem = discretised(raw_timeline(figure, keys, ends, slope), figure, [RESIDUALS[name][0] for name in SMOOTH[:3]])
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    # an entry fixed once at most may drift for nothing; springs of places are as stiff as those of angles, but metres
    # count more in a small figure
    assert_dense(problem, SMOOTH[:3], x, 1e-4 / Size.of(figure).length ** 2, share=0.1)


def full_turn(coordinates: str, rng: np.random.Generator, *, partial: bool) -> tuple[Figure, Timeline]:
    """A loop in which the root turns once round, so that its quaternion comes back as −q, and the knee swings."""
    figure, keys = figure_of(TINY, coordinates), []
    for time, angle in zip(TIMES, np.radians([0.0, 100, 230, 360]), strict=True):
        knee = quat.from_rotation_vector(0.6 * np.sin([angle, 2 * angle, 0.5 * np.sin(angle)]))
        turn = quat.from_rotation_vector(angle * np.array([0.6, 0, 0.8]))
        state = np.concatenate([0.2 * np.sin([angle, 2 * angle, -angle]), turn, knee])
        keys.append(Frame.key(time, state, mask_without(figure, "root x", "knee") if partial and time == 0.4 else None))
    return figure, raw_timeline(figure, keys, "periodic")


@pytest.mark.parametrize(("coordinates", "partial"), [("world", True), ("joint", False)])
def test_so_it_is_on_a_loop_whose_quaternions_come_back_as_their_negatives(rng, coordinates, partial):
    figure, timeline = full_turn(coordinates, rng, partial=partial)
    columns = figure.tables.quaternion_columns[:, 0]
    assert timeline.states[0, columns] @ timeline.states[-1, columns] < -0.9
    problem, x = smooth_problem(timeline, figure, rng)
    assert_dense(problem, SMOOTH, x)


@pytest.mark.parametrize(("ends", "variable"), list(zip(ENDS, [1, 3] * 2, strict=True)))
def test_so_it_is_between_two_keyframes(rng, ends, variable):
    figure = figure_of(ONE_BALL)
    second = [0.8, 0.5, 0.1, 0] if ends != "periodic" else [1, 0, 0, 0]
    keys = [Frame.key(0.0, [1, 0, 0, 0]), Frame.key(1.0, second)]
    timeline = raw_timeline(figure, keys, ends, np.zeros((2, 4)) if ends.startswith("clamped") else None)
    problem = discretised(timeline, figure, [CovariantAcceleration(), UnitMagnitude()], variable)
    x = problem.unknowns.start + 0.2 * rng.normal(size=problem.unknowns.size)
    assert_dense(problem, ("covariant", "unit"), x)


def test_stances_enter_the_model_like_the_others(rng, monkeypatch):
    planted = Attachment((stance_of(1, 0.2, 1.0), stance_of(2, 0.5, 1.2)))
    monkeypatch.setattr("curvature_of.PLANTED", planted)
    figure = figure_of(TINY)
    names = ("covariant", "unit", "root", "planted")
    penalties = [planted if name == "planted" else RESIDUALS[name][0] for name in names]
    problem = discretised(tiny_clip(rng, "free", "world"), figure, penalties)
    assert_dense(problem, names, problem.unknowns.start + 0.05 * rng.normal(size=problem.unknowns.size))


@pytest.mark.parametrize("ends", ["clamped", "periodic"])
def test_a_model_made_of_few_spans_at_once_is_the_same(rng, ends, monkeypatch):
    figure = figure_of(TINY)
    problem, x = smooth_problem(tiny_clip(rng, ends, "world"), figure, rng)
    gradient, spans = problem(x).gradient, problem.spline.times.size - 1
    step, promised, _ = Model(Layout(problem), x, gradient).minimise(0.1)
    monkeypatch.setattr("dynsplines.solver.search.quadratic.SPAN_ENTRIES", 0)
    for at_once in (1, 2, 4, spans - 1, spans, spans + 1):
        monkeypatch.setattr("dynsplines.solver.search.quadratic.SPANS_AT_ONCE", at_once)
        layout = Layout(problem)
        assert len(layout.pieces) == -(-spans // at_once)
        again, promised_again, _ = Model(layout, x, gradient).minimise(0.1)
        np.testing.assert_allclose(again, step, rtol=1e-7, atol=1e-9)
        np.testing.assert_allclose(promised_again, promised, rtol=1e-9)


@pytest.mark.parametrize("ends", ["free", "periodic"])
def test_damping_adds_the_flat_energy_of_the_step(rng, ends):
    figure = figure_of(TINY)
    problem, x = smooth_problem(tiny_clip(rng, ends, "world"), figure, rng)
    gradient, flat = problem(x).gradient, flat_energy(problem)
    hessian, model = dense_hessian(problem, SMOOTH, x), Model(Layout(problem), x, gradient)
    lengths, promises = [], []
    for damping in np.array([0.0, 0.01, 0.1, 1, 10]) * model.scale:
        step, promised, _ = model.minimise(damping)
        expected = -np.linalg.solve(hessian + damping * flat, gradient)
        assert np.linalg.norm(step - expected) < 1e-3 * np.linalg.norm(expected)
        np.testing.assert_allclose(promised, -0.5 * gradient @ expected, rtol=1e-3)
        lengths.append(step @ flat @ step)
        promises.append(promised)
    assert np.all(np.diff(lengths) < 0)
    assert np.all(np.diff(promises) < 0)
    assert promises[-1] > 0


def test_what_no_penalty_feels_does_not_move_the_step_out_of_bounds(rng):
    figure = figure_of(TINY)
    problem = discretised(tiny_clip(rng, "free", "world"), figure, [CovariantAcceleration(), RootAcceleration()])
    x = problem.unknowns.start
    before, gradient = problem(x).value, problem(x).gradient
    step, promised, _ = Model(Layout(problem), x, gradient).minimise(1e-3)
    assert np.all(np.isfinite(step))
    assert promised > 0
    assert gradient @ step < 0
    assert problem(x + 0.1 * step).value < before


def test_a_model_that_has_no_minimum_promises_nothing(rng):
    figure = figure_of(TINY)
    problem, x = smooth_problem(tiny_clip(rng, "free", "world"), figure, rng)
    model = Model(Layout(problem), x, problem(x).gradient)
    model.curvature *= -1
    step, promised, _ = model.minimise(0.0)
    assert step.shape == x.shape
    assert not step.any()
    assert promised == 0


class Touching(Contact):
    """All points near the floor, but not in it, touch it."""

    def nearby(self, samples: Samples) -> Iterator[Block]:
        for block in super().nearby(samples):
            yield replace(block, value=np.where(block.value > 0, block.value, -1e-9))


def one_sided_problem(
    rng: np.random.Generator, ends: str, *, floor: bool = True, kind: type[Contact] = Contact
) -> tuple[Discretised, Array]:
    """Two bodies whose points lie in a floor and just over it, and whose knee bends too far or nearly so."""
    figure = figure_of(TINY)
    timeline = tiny_clip(rng, ends, "world")
    rows = np.array(timeline.rows)
    rows[:-2, 2] *= 0.1
    timeline = timeline.with_rows(rows)
    positions = 0.15 * rng.normal(size=(8, 3))
    points = tuple(Point(f"{i}", 1 + i % 2, position, 0.02) for i, position in enumerate(positions))
    contact, bend = kind(points, (FLOOR,)), limits_of(figure)
    more: list[Penalty] = [contact, bend] if floor else [bend]
    problem = discretised(timeline, figure, [*(RESIDUALS[name][0] for name in SMOOTH), *more])
    start = problem.unknowns.start
    return problem, start + 0.05 * rng.normal(size=start.size)


class Dense:
    """m(δ) of the module's text on dense matrices, in the unknowns."""

    def __init__(self, problem: Discretised, x: Array) -> None:
        two_sided = Objective(problem.objective.figure, problem.objective.terms[: len(SMOOTH)])
        self.hessian = dense_hessian(two_sided.on(problem.timeline), SMOOTH, x)
        samples = problem.objective.samples(problem.path(x), problem.sampling.t)
        moved = moved_by(problem, problem.sampling.t)[:, 0]
        values, weights, rows = [], [], []
        for term in problem.objective.terms[len(SMOOTH) :]:
            sides = term.penalty.one_sided_residuals(samples)
            assert sides is not None
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


@pytest.mark.parametrize("kind", [Contact, Touching])
@pytest.mark.parametrize("ends", ["clamped", "periodic"])
def test_with_one_sided_residuals_the_step_minimises_the_convex_model(rng, ends, kind, monkeypatch):
    problem, x = one_sided_problem(rng, ends, kind=kind)
    dense = Dense(problem, x)
    before = dense(np.zeros(x.size))[0]
    best, least = dense.minimum()
    after = dense.value + dense.rows @ best
    assert np.count_nonzero((after > 0) != (dense.value > 0)) > 0  # what counts changes within the step
    monkeypatch.setattr("dynsplines.solver.search.quadratic.SETTLED", 1e-14)
    model = Model(Layout(problem), x, problem(x).gradient)
    step, promised, _ = model.minimise(0.0)
    np.testing.assert_allclose(dense(step)[0], least, rtol=0, atol=1e-4 * (before - least))
    np.testing.assert_allclose(promised, before - least, rtol=1e-3)
    assert np.linalg.norm(step - best) < 0.01 * np.linalg.norm(best)


@pytest.mark.parametrize("seed", [2])
def test_so_it_does_where_whole_newton_steps_would_raise_the_model(seed, monkeypatch):
    rng = np.random.default_rng(seed)
    problem, _ = one_sided_problem(rng, "free", floor=False)
    x = problem.unknowns.start + 0.3 * rng.normal(size=problem.unknowns.size)
    dense = Dense(problem, x)
    before, (_, least) = dense(np.zeros(x.size))[0], dense.minimum()
    monkeypatch.setattr("dynsplines.solver.search.quadratic.SETTLED", 1e-14)
    step, promised, _ = Model(Layout(problem), x, problem(x).gradient).minimise(0.0)
    np.testing.assert_allclose(dense(step)[0], least, rtol=0, atol=1e-4 * (before - least))
    np.testing.assert_allclose(promised, before - least, rtol=1e-3)


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


@pytest.mark.parametrize("ends", ["free", "periodic"])
def test_it_settles_when_little_is_left_to_gain(rng, ends):
    problem, x = one_sided_problem(rng, ends)
    dense, model = Dense(problem, x), Model(Layout(problem), x, problem(x).gradient)
    before, (_, least) = dense(np.zeros(x.size))[0], dense.minimum()
    step, promised, _ = model.minimise(0.0)
    assert before - dense(step)[0] > (1 - 2 * SETTLED) * (before - least)
    np.testing.assert_allclose(promised, before - dense(step)[0], rtol=1e-3)
    promises = [model.minimise(damping * model.scale)[1] for damping in (0.0, 0.1, 10.0)]
    assert promises[0] > promises[1] > promises[2] > 0


def test_near_misses_keep_a_step_from_falling_through_the_floor():
    """A ball two keyframes hold high and whose frames between lie just over the floor, on their way down."""
    figure = figure_of(BALL)
    keys = [Frame.key(float(i), [0, 0, z, 1, 0, 0, 0]) for i, z in enumerate([0.5, 0.12, 0.12, 0.5])]
    contact = Contact((Point("ball", 1, np.zeros(3), 0.1),), (FLOOR,))
    raw = raw_timeline(figure, keys)
    lifted = np.array(evenly(raw, 2).rows)
    lifted[:-2, 2] = np.maximum(lifted[:-2, 2], 0.125)
    terms: list[tuple[Penalty, float]] = [(RootAcceleration(), 1.0), (UnitMagnitude(), 1.0), (contact, 1e4)]
    problem = Objective.of(figure, terms).on(evenly(raw, 2).with_rows(lifted))
    x = problem.unknowns.start
    t = np.linspace(1, 2, 50)
    assert problem.path(x).at(t)[:, 2].min() > 0.1
    step, _, _ = Model(Layout(problem), x, problem(x).gradient).minimise(0.0)
    free = Objective.of(figure, terms[:2]).on(problem.timeline)
    through, _, _ = Model(Layout(free), x, free(x).gradient).minimise(0.0)
    assert problem.path(x + through).at(t)[:, 2].min() < 0.09
    assert problem.path(x + step).at(t)[:, 2].min() > 0.097


@pytest.mark.parametrize("size", [1, 2, 9, 400])
def test_the_middle_is_numpys_median_and_leaves_its_values_in_order(size, rng):
    for values in (rng.normal(size=size), rng.integers(3, size=size).astype(float), rng.normal(size=(2, size))):
        before = values.copy()
        assert middle(values) == np.median(values)
        np.testing.assert_array_equal(values, before)
