"""The objective: renormalisation, and its gradient in x over whole clips."""

from dataclasses import replace

import numpy as np
import pytest
from even_frames import evenly
from every_penalty import clip, every_penalty
from figures import figure_of
from random_keys import TIMES
from scipy.interpolate import CubicSpline
from taylor import taylor_slope
from walker import FINE, walk, walker

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.size import Size
from dynsplines.solver.objective import (
    LEAST_TYPICAL,
    MOST_OF_TIME,
    RUN,
    SMALL_SHARE,
    VIOLENT,
    Objective,
    segment_integrals,
)
from dynsplines.solver.penalty import (
    Contact,
    CovariantAcceleration,
    Normalization,
    Penalty,
    Posture,
    RootAcceleration,
)
from dynsplines.solver.penalty.block import Dense
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point

ONE_HINGE = '<mujoco><worldbody><body><joint axis="0 1 0"/><geom size=".1"/></body></worldbody></mujoco>'


def test_the_renormalised_raw_spline_costs_the_sum_of_the_weights(figure, rng):
    raw = path_of(clip(figure, rng))
    length, spacing = TIMES[-1] - TIMES[0], np.mean(np.diff(TIMES))
    every = [(p, weight) for p, weight in every_penalty(figure) if not p.normalization.is_violation]
    integrals = Objective.of(figure, every).integrals(raw)
    floors = [p.normalization.reference * SMALL_SHARE * length / spacing**p.normalization.time_power for p, _ in every]
    penalties = [pair for pair, integral, floor in zip(every, integrals, floors, strict=True) if integral > floor]
    assert len(penalties) >= 3
    objective = Objective.of(figure, penalties)
    renormalised = objective.renormalised(raw)
    np.testing.assert_allclose(renormalised.value(raw), sum(weight for _, weight in penalties), rtol=1e-12)
    np.testing.assert_allclose([t.weight for t in renormalised.terms], [weight for _, weight in penalties])


def little(figure: Figure) -> float:
    """[m²] the square of what counts as a centimetre does for an adult."""
    return (0.01 * Size.of(figure).length) ** 2


def test_a_violation_is_divided_by_no_more_than_its_reference_over_the_whole_clip(figure, rng):
    raw = path_of(clip(figure, rng))
    length = TIMES[-1] - TIMES[0]
    for height, share in ((50.0, 1.0), (-50.0, 0.01)):
        floor = Plane("floor", np.array([0.0, 0, height]), np.array([0.0, 0, 1]))
        contact = Contact((Point("p", 1, np.zeros(3)),), (floor,))
        (term,) = Objective.of(figure, [(contact, 3.0)]).renormalised(raw).terms
        np.testing.assert_allclose(term.factor, 3.0 / (little(figure) * share * length), rtol=1e-12)


def hinge_path(times: np.ndarray, angles: np.ndarray) -> tuple[Objective, Path]:
    """One hinge, whose covariant acceleration is its angle's own, and the natural spline through angles [rad]."""
    figure = figure_of(ONE_HINGE)
    raw = raw_timeline(figure, [Frame.key(t, [angle]) for t, angle in zip(times, angles, strict=True)])
    return Objective.of(figure, [(CovariantAcceleration(), 2.0)]), path_of(raw)


def violent_parts(times: np.ndarray, angles: np.ndarray) -> tuple[float, float]:
    """SciPy's natural spline: ∫ θ''² dt, and with no segment's mean over four times what four fifths of time stay
    below."""
    bend = CubicSpline(times, angles, bc_type="natural").derivative(2)(times)
    spans = np.diff(times)
    means = (bend[1:] ** 2 + bend[1:] * bend[:-1] + bend[:-1] ** 2) / 3
    passed = 0.0
    for mean, span in sorted(zip(means, spans, strict=True)):
        passed += span
        if passed >= MOST_OF_TIME * spans.sum():
            return float(means @ spans), float(np.minimum(means, VIOLENT * mean) @ spans)
    raise AssertionError


@pytest.mark.parametrize("seed", range(3))
def test_violent_segments_count_as_four_times_what_most_of_the_time_stays_below(seed):
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.uniform(0.1, 0.4, 60))
    angles = 2 * rng.normal(size=60)
    angles[rng.integers(20, 40)] += rng.uniform(20, 60)
    objective, path = hinge_path(times, angles)
    whole, typical = violent_parts(times, angles)
    assert 0.1 * whole < typical < whole
    (term,) = objective.renormalised(path).terms
    np.testing.assert_allclose(term.factor * objective.integrals(path)[0] / term.weight, whole / typical, rtol=1e-9)


def test_a_tenth_of_the_integral_counts_however_violent_one_segment_is():
    times = np.append(np.arange(0.0, 20.0), 19.02)
    angles = np.append(0.01 * np.sin(times[:-1]), 3.0)
    objective, path = hinge_path(times, angles)
    whole, typical = violent_parts(times, angles)
    assert typical < LEAST_TYPICAL * whole
    (term,) = objective.renormalised(path).terms
    np.testing.assert_allclose(term.factor, term.weight / (LEAST_TYPICAL * objective.integrals(path)[0]), rtol=1e-12)


def test_a_pose_a_thirtieth_of_a_second_before_a_walk_does_not_make_the_walk_soft():
    figure, soles = walker()
    time, qpos = walk(figure, soles, 1.1, 3.5)
    walked = [Frame.key(time[k], qpos[k]) for k in range(0, time.size, round(0.14 * FINE))]
    pose = np.array(figure.model.qpos0)
    pose[:3] = qpos[0, :3]
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    plain, posed = (
        path_of(raw_timeline(figure, keys)) for keys in (walked, [Frame.key(time[0] - 1 / 30, pose), *walked])
    )
    assert np.all(objective.integrals(posed) > 2 * objective.integrals(plain))
    kept, softer = (np.array([t.factor for t in objective.renormalised(path).terms]) for path in (plain, posed))
    assert np.all(softer > kept / 1.5)


def test_without_renormalisation_it_is_the_weighted_sum_of_integrals(figure, rng):
    raw, penalties = path_of(clip(figure, rng)), every_penalty(figure)
    objective = Objective.of(figure, penalties)
    expected = np.dot([weight for _, weight in penalties], objective.integrals(raw))
    np.testing.assert_allclose(objective.value(raw), expected, rtol=1e-12)
    t, w = Quadrature().nodes(raw.spline.times)
    np.testing.assert_allclose(w @ objective.density(objective.samples(raw, t)), expected, rtol=1e-12)


@pytest.mark.parametrize(("ends", "kind"), [("free", "gauss"), ("clamped start", "uniform"), ("periodic", "gauss")])
def test_the_gradient_of_a_whole_clip_with_partial_keyframes_has_taylor_slope_two(figure, rng, ends, kind):
    timeline = clip(figure, rng, ends)
    objective = Objective.of(figure, every_penalty(figure), quadrature=Quadrature(kind)).renormalised(path_of(timeline))
    problem = objective.on(evenly(timeline, 1))
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9


def test_the_parts_add_up_to_the_value_and_the_value_is_that_of_the_path(figure, rng):
    timeline = clip(figure, rng)
    objective = Objective.of(figure, every_penalty(figure)).renormalised(path_of(timeline))
    problem = objective.on(timeline)
    found = problem(problem.unknowns.start)
    np.testing.assert_allclose(sum(found.parts.values()), found.value, rtol=1e-14)
    np.testing.assert_allclose(objective.value(problem.path(problem.unknowns.start)), found.value, rtol=1e-10)
    np.testing.assert_allclose(found.parts["acceleration.angular"], 2.5, rtol=1e-10)  # two terms of one name
    assert set(found.parts) == {
        "acceleration.angular",
        "unit",
        "acceleration.linear",
        "torque",
        "limits.bend",
        "collision.soles",
    }


def test_sample_gradients_are_those_of_the_density(figure, rng):
    objective = Objective.of(figure, every_penalty(figure)[:6])
    samples = objective.samples(path_of(clip(figure, rng)), np.array([0.1, 0.7, 1.2]))
    point = np.stack([samples.y, samples.y_d, samples.y_dd])

    def value(p: np.ndarray) -> float:
        return float(objective.density(Samples(figure, *p)).sum())

    assert taylor_slope(value, point, np.stack(objective.sample_gradients(samples)), rng) > 1.95


def test_a_long_clip_in_runs_of_samples_has_the_value_and_gradient_of_one_piece(figure, rng):
    timeline = clip(figure, rng)
    objective = Objective.of(figure, every_penalty(figure), quadrature=Quadrature("uniform", 1203))
    problem = objective.on(timeline)
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert problem.weights.size > 2 * RUN
    found = problem(x)
    assert problem.evaluated_runs(x) is problem.evaluated_runs(x)
    samples = Samples(figure, *problem.sampling.samples(problem.unknowns.rows(x)), t=problem.sampling.t)
    whole = sum(problem.weights @ (term.factor * term.penalty.evaluate(samples)) for term in objective.terms)
    np.testing.assert_allclose(found.value, whole, rtol=1e-12)
    np.testing.assert_allclose(problem.weights @ objective.density(samples), whole, rtol=1e-12)
    cotangent = Cotangent(samples)
    for term in objective.terms:
        term.penalty.evaluate(samples, cotangent, term.factor * problem.weights)
    gradients = cotangent.gradients()
    expected = problem.unknowns.pulled_back(problem.sampling.pulled_back(gradients))
    np.testing.assert_allclose(found.gradient, expected, rtol=1e-10, atol=1e-12 * np.abs(expected).max())
    for own, g in zip(objective.sample_gradients(samples), gradients, strict=True):
        np.testing.assert_allclose(problem.weights[:, None] * own, g, rtol=1e-10, atol=1e-12 * np.abs(g).max())


def test_what_costs_more_on_a_path_that_leads_is_divided_by_that_and_violations_by_the_raw_path_alone(figure, rng):
    timeline = clip(figure, rng)
    raw = path_of(timeline)
    rows = timeline.rows + 0.3 * rng.normal(size=timeline.rows.shape)
    initial_guess = path_of(timeline.with_rows(rows))
    objective = Objective.of(figure, [*every_penalty(figure), (Posture(), 0.5)])
    plain, other, found = (
        o.terms
        for o in (
            objective.renormalised(raw),
            objective.renormalised(initial_guess),
            objective.renormalised(raw, initial_guess),
        )
    )
    below = 0
    for own, there, both in zip(plain, other, found, strict=True):
        scale = both.penalty.normalization
        if scale.is_violation:
            assert both.factor == own.factor
        elif not scale.normalize_by:
            assert both.factor == pytest.approx(min(own.factor, there.factor))
            below += both.factor < own.factor
        else:
            measure = [t for t in found if t.penalty.name == scale.normalize_by][-1]
            size, powers = Size.of(figure), (scale.time_power, measure.penalty.normalization.time_power)
            reference = scale.reference * size.length**scale.length_power * size.time ** (powers[1] - powers[0])
            assert both.factor * reference / both.weight == pytest.approx(measure.factor / measure.weight)
    assert below > 0


def test_motion_costs_the_weights_of_what_its_own_integrals_measure():
    figure = figure_of(ONE_HINGE)
    keys = [Frame.key(t, [q]) for t, q in ((0, 0.0), (1, 1.0), (2, 0.5))]
    objective = Objective.of(figure, [(CovariantAcceleration(), 2.0), (Posture(), 5.0), (RootAcceleration(), 0.25)])
    assert objective.raw_cost == 2.25
    assert [term.penalty.name for term in objective.raw_normalized] == ["acceleration.angular", "acceleration.linear"]
    assert objective.renormalised(path_of(raw_timeline(figure, keys))).heavy == pytest.approx(10 * 2.25)
    assert Objective.of(figure, [(Posture(), 5.0)]).renormalised(path_of(raw_timeline(figure, keys))).heavy == np.inf


@pytest.mark.parametrize("weight", [-1.0, np.nan, np.inf])
def test_a_weight_that_is_none_is_refused_by_name(weight, figure):
    with pytest.raises(ValueError, match=r"the weight of 'acceleration.linear' is .*; it must be a number, at least 0"):
        Objective.of(figure, [(RootAcceleration(), weight)])
    assert Objective.of(figure, [(RootAcceleration(), 0)]).terms[0].weight == 0


class Clock(Penalty):
    """t⁵, whatever the figure does."""

    @property
    def name(self) -> str:
        return "clock"

    @property
    def normalization(self) -> Normalization:
        return Normalization(1.0)

    def residuals(self, samples: Samples) -> list[Dense]:
        return [Dense(samples.t[None] ** 2.5, lambda cotangent, bar: None)]


class Bell(Penalty):
    """1 + t at some instants."""

    @property
    def name(self) -> str:
        return "bell"

    @property
    def normalization(self) -> Normalization:
        return Normalization(1.0)

    @property
    def instants(self) -> np.ndarray:
        return np.array([-1.0, 0.0, 0.25, 0.5, 1.1, 2.0, 3.0])  # of which two are outside

    def residuals(self, samples: Samples) -> list[Dense]:
        rings = np.isin(samples.t, self.instants)
        return [Dense(np.sqrt(np.where(rings, 1 + samples.t, 0.0))[None], lambda cotangent, bar: None)]


def clock_and_bell(quadrature: Quadrature) -> tuple[Objective, Path]:
    figure = figure_of(ONE_HINGE)
    objective = Objective.of(figure, [(Bell(), 2.0), (Clock(), 3.0)], quadrature=quadrature)
    return objective, path_of(raw_timeline(figure, [Frame.key(t, [t]) for t in (0.0, 0.7, 1.1, 2.0)]))


@pytest.mark.parametrize("quadrature", [Quadrature("gauss", 3), Quadrature("uniform", 9)])
def test_momentary_terms_count_at_their_instants_once_and_in_no_integral(quadrature):
    objective, path = clock_and_bell(quadrature)
    t, w, each = objective.nodes(path.spline.times)
    plain, plain_weights = quadrature.nodes(path.spline.times)
    assert np.all(np.diff(t) >= 0)
    rung = np.array([0.0, 0.25, 0.5, 1.1, 2.0])
    np.testing.assert_array_equal(np.sort(np.append(plain, rung)), t)
    np.testing.assert_array_equal(np.unique(t[each[0] > 0]), rung)
    np.testing.assert_array_equal(each[0][each[0] > 0], 1)
    np.testing.assert_array_equal(each[1], w)
    for power in range(4):
        np.testing.assert_allclose(w @ t**power, plain_weights @ plain**power, rtol=1e-13)
    alone = replace(objective, terms=objective.terms[1:]).nodes(path.spline.times)
    np.testing.assert_array_equal(alone[0], plain)
    np.testing.assert_array_equal(alone[1], plain_weights)
    np.testing.assert_array_equal(alone[2], [plain_weights])
    bell, clock = objective.integrals(path)
    assert bell == pytest.approx(np.sum(1 + rung), rel=1e-13)
    assert clock == pytest.approx(plain_weights @ plain**5, rel=1e-13)


def test_shares_of_segments_are_exact_and_an_instant_between_two_belongs_to_the_later():
    objective, path = clock_and_bell(Quadrature())
    edges = np.array([0.2, 0.5, 1.1, 1.2, 2.0])  # the spline has knots at 0, 0.7, 1.1 and 2
    shares = segment_integrals(objective, path, edges)
    np.testing.assert_allclose(shares[:, 1], 3 * np.diff(edges**6) / 6, rtol=1e-12)
    np.testing.assert_allclose(shares[:, 0], 2 * np.array([1.25, 1.5, 2.1, 3.0]), rtol=1e-13)
    whole = segment_integrals(objective, path, np.array([0.0, 0.7, 1.1, 2.0])).sum(axis=0)
    np.testing.assert_allclose(whole, [2 * (1 + 1.25 + 1.5 + 2.1 + 3), 3 * 2.0**6 / 6], rtol=1e-12)


def test_samples_are_added_only_where_they_miss_a_violation():
    """A ball passes a wall between two samples, and rests in another one for a long time, which no sample misses."""
    slide = '<mujoco><worldbody><body><joint type="slide" axis="1 0 0"/><geom size=".02"/></body></worldbody></mujoco>'
    figure = figure_of(slide)
    times = np.array([0.0, 1.0, 2.0, 3.0])
    keys = [Frame.key(t, np.array([x])) for t, x in zip(times, (0.0, 1.0, 1.0, 1.0), strict=True)]
    path = path_of(raw_timeline(figure, keys))
    ball = Point("ball", len(figure.links) - 1, np.zeros(3), 0.02)
    quadrature = Quadrature(points=3, longest=0.2)

    def objective(x: float, half: float) -> Objective:
        wall = Box("wall", np.array([x, 0, 0]), np.eye(3), np.array([half, 1.0, 1.0]))
        return Objective.of(figure, [(Contact((ball,), (wall,)), 1.0)], quadrature=quadrature)

    thin, thick = objective(0.5, 0.001), objective(1.1, 0.1)
    finer = thin.finer(path)
    exact = thin.value(path, np.linspace(0, 3, 3001))
    assert thin.value(path) < 0.5 * exact
    assert abs(finer.value(path) - exact) < 0.3 * exact
    assert all(0 < cut < 1 for cut in finer.quadrature.cuts)
    assert thick.value(path) > 0 and thick.finer(path) is thick
