"""Skating and hovering: values, and motions that obey them."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import BALL, figure_of
from gradients import assembled, curvature_of
from random_models import at_times, random_samples

from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.schedule import grounded_intervals, open_intervals
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import (
    Contact,
    CovariantAcceleration,
    HoverPenalty,
    RootAcceleration,
    Skate,
    UnitMagnitude,
)
from dynsplines.solver.penalty.block import summed
from dynsplines.solver.penalty.ground.skate import SwingSegments
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point, places_of

UP = np.array([0.0, 0, 1])


def some_points(samples: Samples) -> tuple[Point, ...]:
    last = len(samples.figure.links) - 1
    return Point("a", 1, np.array([0.1, 0.2, -0.3]), 0.05), Point("b", last, np.array([0.0, 0.1, -0.2]))


def below(samples: Samples, normal: np.ndarray = UP) -> Plane:
    """A plane under all of the points."""
    centres, _ = places_of(some_points(samples), samples)
    return Plane("floor", (np.einsum("i,ins->ns", normal, centres).min() - 0.3) * normal, normal)


def test_the_value_is_the_velocity_by_differences_weighted_by_height(figure, rng):
    samples, h = random_samples(figure, rng, 5), 1e-6
    points, floor = some_points(samples), below(samples)
    before, after = (Samples(figure, samples.y + s * samples.y_d, samples.y_d, samples.y_dd) for s in (-h, h))
    contact = Contact(points, ())
    velocity = (contact.centres(after)[0] - contact.centres(before)[0]) / (2 * h)
    height = contact.centres(samples)[0][2] - floor.point[2] - np.array([0.05, 0])[:, None]
    u = height / 0.4
    expected = np.sum(np.exp(-u * (u + 0.5) / 1.5) * np.sum(velocity**2, axis=0), axis=0)
    np.testing.assert_allclose(Skate(points, (floor,), 0.4).evaluate(samples), expected, rtol=1e-6)


def test_a_step_of_the_model_cannot_gain_without_limit(figure, rng):
    """The gradient is within the range of the matrices, and the model promises at most the squares of its residuals."""
    samples = random_samples(figure, rng, 3)
    skate, cotangent = Skate(some_points(samples), (below(samples),), 1.0), Cotangent(samples)
    values = skate.evaluate(samples, cotangent)
    matrices = assembled(curvature_of(skate, samples, np.ones(3)), np.tile(np.eye(3), (3, 1, 1)))
    for value, matrix, gradient in zip(values, matrices, np.hstack(cotangent.gradients()), strict=True):
        step = np.linalg.lstsq(matrix, -gradient, rcond=1e-10)[0]
        np.testing.assert_allclose(matrix @ step, -gradient, atol=1e-6 * np.abs(gradient).max())
        assert 0 < -0.5 * gradient @ step <= 2 * value * (1 + 1e-6)


def test_the_value_is_continuous_where_a_point_passes_over_the_edge_of_a_step():
    figure, skate = figure_of(BALL), Skate((FOOT,), (FLOOR, STEP))
    for height in (0.0, 0.01, 0.05):
        y = np.array([[x, 0, 0.3 + height, 1, 0, 0, 0] for x in (-1e-9, 1e-9)])
        left, right = skate.evaluate(Samples(figure, y, np.eye(1, 7) + np.zeros((2, 1)), np.zeros((2, 7))))
        assert left > 0.1
        np.testing.assert_allclose(left, right, rtol=1e-6)


FOOT = Point("foot", 1, np.zeros(3), 0.1)


FLOOR = Plane("floor", np.zeros(3), UP)


STEP = Box("step", np.array([0.5, 0, 0.1]), np.eye(3), np.array([0.5, 0.5, 0.1]))


def speed_on_the_ground(weight: float, clock: float = 1.0) -> float:
    """How fast a ball moves on the average while it is within 5 mm of the floor, between keyframes on and above it."""
    figure = figure_of(BALL)
    places = [(0.0, 0.4), (0.4, 0.1), (0.5, 0.1), (0.9, 0.4)]
    keys = [Frame.key(0.3 * clock * i, [x, 0, z, 1, 0, 0, 0]) for i, (x, z) in enumerate(places)]
    penalties = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0)]
    motion = inbetween(
        Problem(figure, keys, [*penalties, (Skate((FOOT,), (FLOOR,)), weight)], Settings(tolerance=1e-4))
    )
    t = np.linspace(0, 0.9 * clock, 901)
    qpos = motion.at(t)
    speed = np.linalg.norm(np.gradient(qpos[:, :2], t, axis=0), axis=1)
    np.testing.assert_allclose(motion.at([key.time for key in keys]), [key.state for key in keys], atol=1e-12)
    return float(clock * speed[np.abs(qpos[:, 2] - 0.1) < 0.005].mean())


@pytest.mark.slow
def test_a_point_that_comes_down_is_slow_there_and_without_the_penalty_it_is_not():
    assert speed_on_the_ground(0.0) > 0.25
    assert speed_on_the_ground(300.0) < 0.7 * speed_on_the_ground(0.0)


def stepping(rest: float) -> tuple[Figure, Timeline]:
    """A foot on a leg that steps 20 cm in 0.2 s, then rests, then goes 20 cm in `rest` seconds."""
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom type="plane" size="5 5 1"/><body pos="0 0 0.1"><freejoint/><geom size="0.1"/></body>'
        "</worldbody></mujoco>"
    )
    figure = Figure(model)
    keys = [
        Frame.key(time, [x, 0, 0.1, 1, 0, 0, 0]) for time, x in ((0.0, 0.0), (0.2, 0.2), (0.4, 0.2), (0.4 + rest, 0.4))
    ]
    return figure, raw_timeline(figure, keys)


def test_a_point_that_comes_far_between_near_keyframes_swings():
    figure, keys = stepping(0.4)
    swings = SwingSegments.of(figure, keys, (Point("sole", 1, np.array([0.0, 0, -0.1])),))
    np.testing.assert_array_equal(swings.at(np.array([0.1, 0.3, 0.7])), [[True, False, False]])


def test_a_point_that_swings_is_as_fast_as_it_likes(rng):
    figure, keys = stepping(0.1)
    points, floor = (Point("sole", 1, np.array([0.0, 0, -0.1])),), Plane("floor", np.zeros(3), UP)
    t = np.array([0.1, 0.3])
    y = np.tile([0.0, 0, 0.15, 1, 0, 0, 0], (2, 1))
    y_d = rng.normal(size=y.shape)
    samples = Samples(figure, y, y_d, 0 * y, t=t)
    free, all_ = Skate(points, (floor,), swings=SwingSegments.of(figure, keys, points)), Skate(points, (floor,))
    np.testing.assert_array_equal(free.evaluate(samples), all_.evaluate(samples) * [0, 1])


def case(figure: Figure, rng: np.random.Generator, count: int = 6) -> tuple[Samples, HoverPenalty]:
    samples = at_times(random_samples(figure, rng, count), np.linspace(0, 1, count))
    points = some_points(samples)
    centres, _ = places_of(points, samples)
    floor = Plane("floor", (centres[2].min() - 0.3) * UP, UP)
    return samples, HoverPenalty(points, (floor,), ((0.1, 0.5), (0.7, 1.0)), reach=0.8, blend=0.2)


def lowest(samples: Samples, grounded: HoverPenalty, blend: float | np.ndarray) -> np.ndarray:
    """The smooth minimum of the heights of the two points, (S,)."""
    (floor,) = grounded.surfaces
    assert isinstance(floor, Plane)
    centres, _ = places_of(grounded.points, samples)
    height = centres[2] - floor.point[2] - np.array([0.05, 0])[:, None]
    return np.maximum(-blend * np.log(np.sum(np.exp(-height / blend), axis=0)), 0)


def test_the_value_by_hand(figure, rng):
    samples, grounded = case(figure, rng)
    low = lowest(samples, grounded, 0.2)
    expected = np.where([False, True, True, False, True, True], 0.64 * (1 - np.exp(-((low / 0.8) ** 2))), 0)
    np.testing.assert_allclose(grounded.evaluate(samples), expected, rtol=1e-9)
    assert np.count_nonzero(expected) > 1


def test_where_it_is_firm_it_is_ten_times_the_square_of_the_height(figure, rng):
    samples, fading = case(figure, rng)
    firm = replace(fading, firm=fading.intervals[1:])
    values, before = firm.evaluate(samples), fading.evaluate(samples)
    assert np.array_equal(values[:4], before[:4])  # until 0.7 s
    np.testing.assert_allclose(values[4:], 10 * lowest(samples, fading, 0.04)[4:] ** 2, rtol=1e-9)
    assert values[4:].min() > 0


def grounded(
    figure: Figure, keys: Timeline, points: tuple[Point, ...], surfaces: tuple[Plane, ...], flights: tuple = ()
) -> tuple:
    """The segments between keyframes in which the lowest of the points is on the ground."""
    down = KeyframePoints.of(figure, keys, points, surfaces).touches
    return grounded_intervals(keys, down, np.zeros(down.size - 1, bool), flights)


def test_segments_with_an_end_in_the_air_are_left_out():
    figure = figure_of(BALL)
    keys = [Frame.key(float(i), [0, 0, z + 0.1, 1, 0, 0, 0]) for i, z in enumerate([0.0, 0.04, 0.0, 0.3, 0.0])]
    timeline = raw_timeline(figure, keys)
    assert grounded(figure, timeline, (FOOT,), (FLOOR,)) == ((0.0, 1.0), (1.0, 2.0))
    assert grounded(figure, timeline, (FOOT,), (FLOOR,), ((1.5, 1.7),)) == ((0.0, 1.0), (1.0, 1.5), (1.7, 2.0))
    down, flight, is_hop = np.array([False, True, True, True, False]), ((0.5, 3.5),), np.zeros(4, bool)
    assert grounded_intervals(timeline, down, is_hop, flight) == ()
    assert grounded_intervals(timeline, ~down, is_hop, flight, 0.1) == ((0.0, 0.4), (3.6, 4.0))
    assert grounded_intervals(timeline, ~down, is_hop, ((-0.5, 4.5),)) == ()
    assert grounded_intervals(timeline, ~down, is_hop, flight, 0.6) == ()
    assert grounded(figure, timeline, (), (FLOOR,)) == grounded(figure, timeline, (FOOT,), ()) == ()


POST = '<mujoco><worldbody><body><freejoint/><geom type="box" size=".05 .05 .5"/></body></worldbody></mujoco>'


FOOT_OF_IT = Point("foot", 1, np.array([0, 0, -0.5]))


def open_of(heights: list[float], free: set[int], flights: tuple = (), step: float = 1.0) -> tuple:
    """Which segments, by the times of their keyframes, are open of a post's keyframes, some of no height."""
    figure = figure_of(POST)
    states = [np.array([0, 0, z + 0.5, 1, 0, 0, 0]) for z in heights]
    fixed = [np.arange(7) != (2 if i in free else -1) for i in range(len(heights))]
    keys = [Frame(step * i, *both, np.arange(7) == 2) for i, both in enumerate(zip(states, fixed, strict=True))]
    timeline = raw_timeline(figure, keys)
    down = KeyframePoints.of(figure, timeline, (FOOT_OF_IT,), (FLOOR,)).touches
    return open_intervals(timeline, down, ~timeline.fixed[:, 2], flights)


def test_segments_are_open_whose_keyframes_stand_at_a_height_of_nobodys():
    assert open_of([0.0, 0.0, 0.0, 0.0], {2}) == ((1.0, 2.0), (2.0, 3.0))
    assert open_of([0.0, 0.0, 0.0], set()) == ()
    assert open_of([0.0, 0.0, 0.0, 0.0], {1}, ((1.5, 1.7),)) == ((0.0, 1.0),)
    assert open_of([0.0, 0.0, 0.0, 0.0], {1, 2}, ((1.0, 2.0),)) == ((0.0, 1.0), (2.0, 3.0))


@pytest.mark.parametrize(("step", "tolerated"), [(0.15, True), (0.5, False)])
def test_the_height_of_keyframes_that_are_close_in_time_is_tolerated_between_them(step, tolerated):
    figure = figure_of(BALL)
    keys = [Frame.key(i * step, [0, 0, z + 0.1, 1, 0, 0, 0]) for i, z in enumerate([0.0, 0.03, 0.03, 0.0])]
    hover = HoverPenalty((FOOT,), (FLOOR,), ((0.0, 3 * step),)).allowing(figure, raw_timeline(figure, keys))
    middle = np.array([1.5 * step])

    def cost(z: float) -> float:
        samples = Samples.still(figure, np.array([[0, 0, z + 0.1, 1, 0, 0, 0]]), t=middle)
        return float(summed(hover.residuals(samples), samples)[0])

    lower, higher = cost(0.03), cost(0.05)
    assert (lower == 0) == tolerated
    assert higher == pytest.approx(0.05**2 * -np.expm1(-((0.02 if tolerated else 0.05) ** 2) / 0.05**2))
