"""Placements: the value by hand, gradient and curvature, and that E holds them at their instants and nowhere else."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from closed_forms import WOOD
from curvature_of import RESIDUALS, assembled, assert_near, curvature_of, jacobians
from dense_hessian import SMOOTH, dense_hessian, tiny_clip
from every_penalty import clip
from figures import TINY, figure_of
from penalty_slope import penalty_slope
from random_keys import TIMES
from random_samples import at_times, random_samples
from taylor import taylor_slope

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective, segment_integrals
from dynsplines.solver.penalty import CovariantAcceleration, Placed, Placement, UnitMagnitude
from dynsplines.solver.problem import Problem
from dynsplines.solver.refine.subdivision import by_weak_form, evenly
from dynsplines.solver.search.quadratic import Layout, Model
from dynsplines.solver.surface.points import Point

TARGET = np.array([0.3, -0.2, 0.8])


def placed(link: int, time: float, target: Array = TARGET) -> Placed:
    return Placed(Point("p", link, np.array([0.1, 0.2, -0.3])), time, target)


def placement_of(figure: Figure, *times: float) -> Placement:
    """Points of the first and the last link at every time, one of them with a free axis."""
    last = len(figure.links) - 1
    loose = np.array([0.4, np.nan, 0.2])
    return Placement(tuple(point for t in times for point in (placed(1, t, loose), placed(last, t))))


def some(figure: Figure, rng: np.random.Generator) -> Samples:
    return at_times(random_samples(figure, rng, 6), np.array([0.0, 0.5, 0.5, 0.7, 1.0, 1.3]))


def test_it_is_the_squared_distance_along_the_given_axes_at_its_time(figure, rng):
    samples = some(figure, rng)
    last = len(figure.links) - 1
    values = placement_of(figure, 0.5, 1.3).evaluate(samples)
    for i in (1, 2, 5):
        data = mujoco.MjData(figure.model)
        data.qpos[:] = figure.to_qpos(samples.y[i])
        mujoco.mj_kinematics(figure.model, data)
        expected = 0.0
        for link, target in ((1, [0.4, np.nan, 0.2]), (last, TARGET)):
            body = data.body(figure.links[link].body)
            at = body.xpos + body.xmat.reshape(3, 3) @ [0.1, 0.2, -0.3]
            expected += np.nansum((at - target) ** 2)
        assert values[i] == pytest.approx(expected, rel=1e-9)
    assert not values[[0, 3, 4]].any()


def test_the_gradient_has_taylor_slope_two(figure, rng):
    assert penalty_slope(placement_of(figure, 0.5, 1.0), some(figure, rng), rng) > 1.95


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_the_curvature_is_twice_the_square_of_the_residuals_jacobian(figure, rng, closed):
    assert_curvature(Figure(mujoco.MjModel.from_xml_string(WOOD), "world") if closed else figure, rng)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_so_it_is_of_two_bodies(coordinates, rng):
    assert_curvature(figure_of(TINY, coordinates), rng)


def assert_curvature(figure: Figure, rng: np.random.Generator) -> None:
    placement, samples = placement_of(figure, 0.5, 1.0), some(figure, rng)

    def away(there: Samples) -> Array:
        out = np.zeros((there.count, len(placement.placed), 3))
        which, at = np.nonzero(np.array([p.time for p in placement.placed])[:, None] == there.t)
        for k, i in zip(which, at, strict=True):
            one = Placement((placement.placed[k],)).away(there.select(np.array([i])))[1]
            out[i, k] = one[:, 0]
        return out.reshape(there.count, -1)

    np.testing.assert_allclose(np.sum(away(samples) ** 2, axis=1), placement.evaluate(samples), rtol=1e-9)
    scale, phi = rng.uniform(0.5, 2, samples.count), rng.normal(size=(samples.count, 3, 2))
    moved = np.einsum("sron,soa->sran", jacobians(away, samples), phi).reshape(samples.count, -1, 2 * figure.width)
    expected = 2 * scale[:, None, None] * np.einsum("srx,sry->sxy", moved, moved)
    assert_near(assembled(curvature_of(placement, samples, scale), phi), expected)
    assert placement.one_sided_residuals(samples) is None


def test_nothing_to_place_costs_nothing(figure, rng):
    samples = random_samples(figure, rng)
    cotangent = Cotangent(samples)
    assert not Placement(()).evaluate(samples, cotangent, np.ones(samples.count)).any()
    assert not any(g.any() for g in cotangent.gradients())


QUADRATURES = [Quadrature(), Quadrature("gauss", 4, 0.05), Quadrature("uniform", 37)]


@pytest.mark.parametrize("quadrature", QUADRATURES, ids=["gauss", "panels", "uniform"])
def test_the_objective_holds_it_once_at_its_time_and_leaves_the_others_as_they_were(figure, rng, quadrature):
    path = path_of(clip(figure, rng))
    instants = (float(TIMES[1]), float(TIMES[-1]))
    placement = placement_of(figure, *instants)
    others = [(CovariantAcceleration(), 2.0), (UnitMagnitude(), 1.0)]
    plain = Objective.of(figure, others, quadrature=quadrature).integrals(path)
    found = Objective.of(figure, [*others, (placement, 3.0)], quadrature=quadrature).integrals(path)
    np.testing.assert_allclose(found[:2], plain, rtol=1e-12)
    at = Samples(figure, *path.motion(np.array(instants)), t=np.array(instants))
    assert found[2] == pytest.approx(placement.evaluate(at).sum(), rel=1e-12)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_the_objectives_gradient_has_taylor_slope_two(figure, rng, ends):
    timeline = evenly(clip(figure, rng, ends), 1)
    placement = placement_of(figure, float(TIMES[0]), float(TIMES[1]), float(TIMES[2]))
    problem = Objective.of(figure, [(placement, 2.0)]).on(timeline)
    x = problem.unknowns.start + 0.1 * rng.normal(size=problem.unknowns.size)
    found = problem(x)
    assert found.parts["attach.placement"] > 0
    assert taylor_slope(lambda z: problem(z).value, x, found.gradient, rng) > 1.95


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_the_step_is_the_dense_gauss_newton_step_in_the_unknowns(rng, ends, coordinates):
    figure = figure_of(TINY, coordinates)
    timeline = evenly(tiny_clip(rng, ends, coordinates, partial=True), 1)
    instants = np.array(TIMES[1:3])
    placement = placement_of(figure, *instants)
    smooth = [RESIDUALS[name][0] for name in SMOOTH]
    objective = Objective.of(figure, [*((penalty, 1.0) for penalty in smooth), (placement, 0.05)])
    problem = objective.renormalised(path_of(timeline)).on(timeline)
    x = problem.unknowns.start + 0.05 * rng.normal(size=problem.unknowns.size)
    factor = problem.objective.terms[-1].factor

    def away(z: Array) -> Array:
        samples = problem.objective.samples(problem.path(z), instants)
        return np.sqrt(2 * factor) * placement.away(samples)[1].ravel()

    h = 1e-5
    rows = np.array([(away(x + h * e) - away(x - h * e)) / (2 * h) for e in np.eye(x.size)]).T
    plain = replace(problem.objective, terms=problem.objective.terms[:-1]).on(timeline)
    hessian = dense_hessian(plain, SMOOTH, x) + rows.T @ rows
    gradient = problem(x).gradient
    expected = -np.linalg.solve(hessian, gradient)
    step, promised, _ = Model(Layout(problem), x, gradient).minimise(0.0)
    assert np.linalg.norm(step - expected) < 1e-4 * np.linalg.norm(expected)
    assert promised == pytest.approx(-0.5 * gradient @ expected, rel=1e-4)
    assert np.linalg.norm(rows @ step) > 0.1 * np.linalg.norm(away(x))


def test_frames_between_keyframes_promise_nothing_of_it(figure, rng):
    """A frame's cardinal function is zero at all other frames, and so at the keyframe's time."""
    timeline = clip(figure, rng)
    others = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 5.0)]
    plain = by_weak_form(Objective.of(figure, others), timeline)
    with_it = by_weak_form(Objective.of(figure, [*others, (placement_of(figure, float(TIMES[1])), 9.0)]), timeline)
    np.testing.assert_allclose(with_it, plain, rtol=1e-12)


def test_the_segments_of_a_window_share_it(figure, rng):
    path = path_of(clip(figure, rng))
    placement = placement_of(figure, float(TIMES[1]))
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (placement, 2.0)])
    parts = segment_integrals(objective, path, np.array(TIMES))
    assert parts[:, 1].sum() == pytest.approx(2 * objective.integrals(path)[1])
    assert np.count_nonzero(parts[:, 1]) == 1


BALL = '<mujoco><worldbody><body><freejoint/><geom size=".1"/><site pos=".1 .2 -.3"/></body></worldbody></mujoco>'


@pytest.mark.parametrize("coordinates", ["world", "joint"])
@pytest.mark.parametrize("which", [0, 1, 2])
def test_a_reachable_place_is_reached_within_a_millimetre(coordinates, which):
    figure = Figure(mujoco.MjModel.from_xml_string(BALL), coordinates)
    free = np.zeros(7, bool)
    keys = [Frame.key(float(i), [0.1 * i, 0, 1, 1, 0, 0, 0]) for i in range(3)]
    keys[which] = Frame.key(float(which), keys[which].state, free)
    penalties = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0), (Placement((placed(1, float(which)),)), 30.0)]
    motion = inbetween(Problem(figure, keys, penalties))
    data = mujoco.MjData(figure.model)
    data.qpos[:] = motion.at(float(which))[0]
    mujoco.mj_kinematics(figure.model, data)
    assert np.linalg.norm(data.site_xpos[0] - TARGET) < 1e-3
