"""The objective and its weights."""

from dataclasses import replace

import numpy as np
import pytest
from figures import CHAIN, figure_of, hinge_keys, hinged
from gradients import clip, every_penalty, taylor_slope
from random_models import TIMES, evenly
from scipy.interpolate import CubicSpline

from dynsplines.solver import objective as objectives
from dynsplines.solver import penalty
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty.block import Dense
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

ONE_HINGE = '<mujoco><worldbody><body><joint axis="0 1 0"/><geom size=".1"/></body></worldbody></mujoco>'


def test_the_renormalised_raw_spline_costs_the_sum_of_the_weights(figure, rng):
    raw = path_of(clip(figure, rng))
    length, spacing = TIMES[-1] - TIMES[0], np.mean(np.diff(TIMES))
    every = [(p, weight) for p, weight in every_penalty(figure) if not p.role.is_violation]
    integrals = objectives.Objective.of(figure, every).integrals(raw)
    floors = [
        p.normalization.reference * objectives.SMALL_SHARE * length / spacing**p.normalization.time_power
        for p, _ in every
    ]
    penalties = [pair for pair, integral, floor in zip(every, integrals, floors, strict=True) if integral > floor]
    assert len(penalties) >= 3
    objective = objectives.Objective.of(figure, penalties)
    renormalised = objective.renormalise(raw)
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
        contact = penalty.Collision((Point("p", 1, np.zeros(3)),), (floor,))
        (term,) = objectives.Objective.of(figure, [(contact, 3.0)]).renormalise(raw).terms
        np.testing.assert_allclose(term.factor, 3.0 / (little(figure) * share * length), rtol=1e-12)


def hinge_path(times: np.ndarray, angles: np.ndarray) -> tuple[objectives.Objective, Path]:
    """One hinge, whose covariant acceleration is its angle's own, and the natural spline through angles [rad]."""
    figure = figure_of(ONE_HINGE)
    raw = raw_timeline(figure, [Frame.key(t, [angle]) for t, angle in zip(times, angles, strict=True)])
    return objectives.Objective.of(figure, [(penalty.CovariantAcceleration(), 2.0)]), path_of(raw)


def violent_parts(times: np.ndarray, angles: np.ndarray) -> tuple[float, float]:
    """SciPy's natural spline: ∫ θ''² dt, and with no segment's mean over four times what four fifths of time stay
    below."""
    bend = CubicSpline(times, angles, bc_type="natural").derivative(2)(times)
    spans = np.diff(times)
    means = (bend[1:] ** 2 + bend[1:] * bend[:-1] + bend[:-1] ** 2) / 3
    passed = 0.0
    for mean, span in sorted(zip(means, spans, strict=True)):
        passed += span
        if passed >= objectives.MOST_OF_TIME * spans.sum():
            return float(means @ spans), float(np.minimum(means, objectives.VIOLENT * mean) @ spans)
    raise AssertionError


@pytest.mark.parametrize("seed", [0, 1, 2, None])
def test_violent_segments_count_as_four_times_what_most_of_the_time_stays_below_but_as_a_tenth_of_the_whole(seed):
    if seed is None:  # nearly all of the integral is in one segment
        times = np.append(np.arange(0.0, 20.0), 19.02)
        angles = np.append(0.01 * np.sin(times[:-1]), 3.0)
    else:
        rng = np.random.default_rng(seed)
        times = np.cumsum(rng.uniform(0.1, 0.4, 60))
        angles = 2 * rng.normal(size=60)
        angles[rng.integers(20, 40)] += rng.uniform(20, 60)
    objective, path = hinge_path(times, angles)
    whole, typical = violent_parts(times, angles)
    assert (typical < objectives.LEAST_TYPICAL * whole) == (seed is None) and typical < whole
    (term,) = objective.renormalise(path).terms
    expected = whole / max(typical, objectives.LEAST_TYPICAL * whole)
    np.testing.assert_allclose(term.factor * objective.integrals(path)[0] / term.weight, expected, rtol=1e-9)


@pytest.mark.parametrize(("ends", "kind"), [("free", "gauss"), ("clamped start", "uniform"), ("periodic", "gauss")])
def test_the_gradient_of_a_whole_clip_with_partial_keyframes_has_taylor_slope_two(figure, rng, ends, kind):
    timeline = clip(figure, rng, ends)
    objective = objectives.Objective.of(figure, every_penalty(figure), quadrature=Quadrature(kind)).renormalise(
        path_of(timeline)
    )
    objective = replace(objective, key_times=np.array([0.0, 0.3, TIMES[-1]]))
    problem = objective.on(evenly(timeline, 1))
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9


def test_the_parts_add_up_to_the_value_and_the_value_is_that_of_the_path(figure, rng):
    timeline = clip(figure, rng)
    objective = objectives.Objective.of(figure, every_penalty(figure)).renormalise(path_of(timeline))
    problem = objective.on(timeline)
    found = problem(problem.unknowns.start)
    np.testing.assert_allclose(sum(found.parts.values()), found.value, rtol=1e-14)
    np.testing.assert_allclose(objective.value(problem.path(problem.unknowns.start)), found.value, rtol=1e-10)
    np.testing.assert_allclose(found.parts["acceleration.angular"], 2.5, rtol=1e-10)  # two terms of one name


def test_a_long_clip_in_runs_of_samples_has_the_value_and_gradient_of_one_piece(figure, rng):
    timeline = clip(figure, rng)
    objective = objectives.Objective.of(figure, every_penalty(figure), quadrature=Quadrature("uniform", 1203))
    problem = objective.on(timeline)
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert problem.weights.size > 2 * objectives.RUN
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
    objective = objectives.Objective.of(figure, every_penalty(figure))
    plain, other, found = (
        o.terms
        for o in (
            objective.renormalise(raw),
            objective.renormalise(initial_guess),
            objective.renormalise(raw, initial_guess),
        )
    )
    below = 0
    for own, there, both in zip(plain, other, found, strict=True):
        if both.penalty.role.is_violation:
            assert both.factor == own.factor
        else:
            assert both.factor == pytest.approx(min(own.factor, there.factor))
            below += both.factor < own.factor
    assert below > 0


@pytest.mark.parametrize("weight", [-1.0, np.nan, np.inf])
def test_a_weight_that_is_none_is_refused_by_name(weight, figure):
    with pytest.raises(ValueError, match=r"the weight of 'acceleration.linear' is .*; it must be a number, at least 0"):
        objectives.Objective.of(figure, [(penalty.RootAcceleration(), weight)])
    assert objectives.Objective.of(figure, [(penalty.RootAcceleration(), 0)]).terms[0].weight == 0


class Clock(penalty.Penalty):
    """t⁵, whatever the figure does."""

    @property
    def name(self) -> str:
        return "clock"

    @property
    def normalization(self) -> penalty.Normalization:
        return penalty.Normalization(1.0)

    def residuals(self, samples: Samples) -> list[Dense]:
        return [Dense(samples.t[None] ** 2.5, lambda cotangent, bar: None)]


@pytest.mark.parametrize("quadrature", [Quadrature("gauss", 3), Quadrature("uniform", 9)])
def test_integrals_are_those_of_the_quadrature(quadrature):
    objective, path = clock(quadrature)
    t, w = quadrature.nodes(path.spline.times)
    np.testing.assert_allclose(objective.integrals(path), [w @ t**5], rtol=1e-13)


def test_shares_of_segments_are_exact():
    objective, path = clock(Quadrature())
    edges = np.array([0.2, 0.5, 1.1, 1.2, 2.0])  # the spline has knots at 0, 0.7, 1.1 and 2
    shares = objectives.segment_integrals(objective, path, edges)
    np.testing.assert_allclose(shares[:, 0], 3 * np.diff(edges**6) / 6, rtol=1e-12)


def clock(quadrature: Quadrature) -> tuple[objectives.Objective, Path]:
    figure = figure_of(ONE_HINGE)
    objective = objectives.Objective.of(figure, [(Clock(), 3.0)], quadrature=quadrature)
    return objective, path_of(raw_timeline(figure, [Frame.key(t, [t]) for t in (0.0, 0.7, 1.1, 2.0)]))


PENALTIES = [
    (penalty.CovariantAcceleration(), 1.0),
    (penalty.RootAcceleration(), 0.5),
    (penalty.UnitMagnitude(), 2.0),
    (penalty.Posture(), 0.7),
]


def objective_of(timeline: Timeline, figure: Figure, key_times: Array | None) -> objectives.Objective:
    return replace(objectives.Objective.of(figure, PENALTIES), key_times=key_times)


@pytest.mark.parametrize(("gap", "tension"), [(0.1, 1.0), (0.25, 1.0), (0.3, 1.2**4), (0.4, 1.6**4), (2.0, 8.0)])
def test_it_rises_with_the_fourth_power_of_the_time_between_keyframes(gap, tension):
    objective = objective_of(raw_timeline(hinged(), hinge_keys()), hinged(), np.array([0, gap, gap + 0.1]))
    found = objective.tension(np.array([-0.1, 0, 0.01, gap - 0.01, gap, gap + 0.1, gap + 1]))
    np.testing.assert_allclose(found, [tension] * 4 + [1.0] * 3)


def swing_keys(figure: Figure, times: Array) -> list[Frame]:
    """Keyframes of a chain whose second joint bends by 60° and back."""
    bent = [quat.from_rotation_vector(np.radians([0, angle, 0])) for angle in (0, 60, 60, 0)]
    return [Frame.key(t, np.concatenate([[1, 0, 0, 0], q])) for t, q in zip(times, bent, strict=True)]


def test_joints_overshoot_less_between_keyframes_that_are_farther_apart():
    """Relative to the same motion at another speed, of which plain accelerations make the same path."""
    figure = figure_of(CHAIN.format("ball"))

    def overshoot(gap: float, weight: float) -> float:
        keys = swing_keys(figure, np.linspace(0, 3 * gap, 4))
        penalties = [*PENALTIES[:3], (penalty.Posture(), weight)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(tolerance=1e-6)))
        q = motion.at(np.linspace(gap, 2 * gap, 101))[:, 4:]
        return float(np.degrees(quat.angle_between(np.array([1.0, 0, 0, 0]), q)).max()) - 60

    plain = [overshoot(gap, 0.0) for gap in (0.2, 0.6)]
    assert plain[1] == pytest.approx(plain[0], rel=0.02)
    short, long = overshoot(0.2, 0.7), overshoot(0.6, 0.7)
    assert short > 0.8 * plain[0]
    assert long < 0.5 * plain[0]
