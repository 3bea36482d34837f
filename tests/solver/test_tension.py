"""Tension: between keyframes far apart accelerations cost less and speeds of joints more."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from even_frames import evenly
from figures import CHAIN, figure_of
from hinged import hinge_keys, hinged
from scaled import scaled
from taylor import taylor_slope

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective, segment_integrals
from dynsplines.solver.penalty import CovariantAcceleration, Posture, RootAcceleration, UnitMagnitude
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.refine.subdivision import CRITERIA
from dynsplines.solver.search.quadratic import Layout, Model

PENALTIES = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 0.5), (UnitMagnitude(), 2.0), (Posture(), 0.7)]


def objective_of(timeline: Timeline, figure: Figure, key_times: Array | None) -> Objective:
    return replace(Objective.of(figure, PENALTIES), key_times=key_times)


@pytest.mark.parametrize(("gap", "tension"), [(0.1, 1.0), (0.25, 1.0), (0.3, 1.2**4), (0.4, 1.6**4), (2.0, 8.0)])
def test_it_rises_with_the_fourth_power_of_the_time_between_keyframes(gap, tension):
    objective = objective_of(raw_timeline(hinged(), hinge_keys()), hinged(), np.array([0, gap, gap + 0.1]))
    found = objective.tension(np.array([-0.1, 0, 0.01, gap - 0.01, gap, gap + 0.1, gap + 1]))
    np.testing.assert_allclose(found, [tension] * 4 + [1.0] * 3)


def test_figures_of_one_dynamic_similarity_have_the_same_tension():
    """Lengths four times as large, so times between keyframes twice as long."""
    tensions = []
    for size, pace in ((1.0, 1.0), (4.0, 2.0)):
        figure = Figure(scaled(models.figure_text("human"), size).compile())
        key_times = pace * np.array([0.0, 0.3, 0.7])
        tensions.append(replace(Objective.of(figure, []), key_times=key_times).tension(pace * np.array([0.1, 0.5])))
    np.testing.assert_allclose(tensions[1], tensions[0], rtol=1e-5)


@pytest.fixture
def same() -> tuple[Timeline, Objective, Objective]:
    """Keyframes at equal distances: E with tension, and with weights that are multiplied by it."""
    figure, angles = hinged(), np.linspace(0, 2, 5)
    keys = [Frame.key(0.3 * k, np.resize(np.sin([angle, 2 * angle]), figure.width)) for k, angle in enumerate(angles)]
    timeline = evenly(raw_timeline(figure, keys), 1)
    tension, powers = 1.2**4, (-1.0, -1.0, 0.0, 0.5)
    weighted = [(penalty, weight * tension**p) for (penalty, weight), p in zip(PENALTIES, powers, strict=True)]
    times = np.array([key.time for key in keys])
    return timeline, objective_of(timeline, figure, times), Objective.of(figure, weighted)


def test_equal_tension_multiplies_the_weights(same, rng):
    """In E, its density and gradients, its parts by segments, and what more frames promise."""
    timeline, tense, weighted = same
    path = path_of(timeline)
    np.testing.assert_allclose(tense.value(path), weighted.value(path), rtol=1e-12)
    t = rng.uniform(0, 1.2, 7)
    samples = [objective.samples(path, t) for objective in (tense, weighted)]
    np.testing.assert_allclose(tense.density(samples[0]), weighted.density(samples[1]), rtol=1e-12)
    for one, other in zip(tense.sample_gradients(samples[0]), weighted.sample_gradients(samples[1]), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12)
    parts = [segment_integrals(objective, path, timeline.times) for objective in (tense, weighted)]
    np.testing.assert_allclose(*parts, rtol=1e-12)
    for name in ("weak", "residual", "objective"):
        np.testing.assert_allclose(*(CRITERIA[name](each, timeline) for each in (tense, weighted)), rtol=1e-9)


def test_it_multiplies_the_curvature_as_well(same, rng):
    timeline, *objectives = same
    steps = []
    for objective in objectives:
        problem = objective.on(timeline)
        x = problem.unknowns.start + 0.1
        steps.append(Model(Layout(problem), x, problem(x).gradient).minimise(0.1)[0])
    np.testing.assert_allclose(*steps, rtol=1e-9)


def test_the_gradient_has_taylor_slope_two(rng):
    figure = figure_of(CHAIN.format("ball"))
    timeline = evenly(raw_timeline(figure, swing_keys(figure, np.array([0.0, 0.2, 0.5, 1.1]))), 1)
    problem = objective_of(timeline, figure, timeline.times[timeline.fixed.any(axis=1)]).on(timeline)
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.95


def swing_keys(figure: Figure, times: Array) -> list[Frame]:
    """Keyframes of a chain whose second joint bends by 60° and back."""
    bent = [quat.from_rotation_vector(np.radians([0, angle, 0])) for angle in (0, 60, 60, 0)]
    return [Frame.key(t, np.concatenate([[1, 0, 0, 0], q])) for t, q in zip(times, bent, strict=True)]


def test_joints_overshoot_less_between_keyframes_that_are_farther_apart():
    """Relative to the same motion at another speed, of which plain accelerations make the same path."""
    figure = figure_of(CHAIN.format("ball"))

    def overshoot(gap: float, weight: float) -> float:
        keys = swing_keys(figure, np.linspace(0, 3 * gap, 4))
        penalties = [*PENALTIES[:3], (Posture(), weight)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(tolerance=1e-6)))
        q = motion.at(np.linspace(gap, 2 * gap, 101))[:, 4:]
        return float(np.degrees(quat.angle_between(np.array([1.0, 0, 0, 0]), q)).max()) - 60

    plain = [overshoot(gap, 0.0) for gap in (0.2, 0.6)]
    assert plain[1] == pytest.approx(plain[0], rel=0.02)
    short, long = overshoot(0.2, 0.7), overshoot(0.6, 0.7)
    assert short > 0.8 * plain[0]
    assert long < 0.5 * plain[0]


def test_a_joint_starts_and_stops_gently():
    """From rest to rest, the spline of least acceleration has a peak of 6 rad/s² for a turn of 1 rad in 1 s."""
    figure = figure_of(CHAIN.format("ball"))
    bent = quat.from_rotation_vector(np.array([0, 1.0, 0]))
    keys = [Frame.key(0.0, [1, 0, 0, 0, 1, 0, 0, 0]), Frame.key(1.0, np.concatenate([[1, 0, 0, 0], bent]))]
    slope = np.zeros((2, figure.width))
    problem = Problem(figure, keys, PENALTIES, Settings(tolerance=1e-6), ends="clamped", end_slope=slope)
    motion, t = inbetween(problem), np.linspace(0, 1, 501)
    angle = quat.angle_between(np.array([1.0, 0, 0, 0]), motion.at(t)[:, 4:])
    assert np.abs(np.gradient(np.gradient(angle, t), t)[2:-2]).max() < 9
    assert problem.objective.at_rest == (True, True)


def test_only_the_soft_constraint_of_posture_brings_it():
    figure, keys = hinged(), hinge_keys()
    with_posture, without = (Problem(figure, keys, PENALTIES[:count]).objective for count in (4, 3))
    np.testing.assert_array_equal(with_posture.key_times, [key.time for key in keys])
    assert without.key_times is None
