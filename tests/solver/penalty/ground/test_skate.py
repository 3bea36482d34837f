"""Skating and hovering: values, and motions that obey them."""

import numpy as np
import pytest
from figures import BALL, FLOOR, SMOOTHNESS, figure_of, plane_below, two_points
from gradients import assembled, curvature_of
from random_models import at_times, random_samples

from dynsplines.solver import penalty
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point, places_of


def test_the_value_is_the_velocity_by_differences_weighted_by_height(figure, rng):
    samples, h = random_samples(figure, rng, 5), 1e-6
    points, floor = two_points(figure), plane_below(samples)
    before, after = (Samples(figure, samples.y + s * samples.y_d, samples.y_d, samples.y_dd) for s in (-h, h))
    contact = penalty.Collision(points, ())
    velocity = (contact.centres(after)[0] - contact.centres(before)[0]) / (2 * h)
    height = contact.centres(samples)[0][2] - floor.point[2] - np.array([0.05, 0])[:, None]
    u = height / 0.4
    expected = np.sum(np.exp(-u * (u + 0.5) / 1.5) * np.sum(velocity**2, axis=0), axis=0)
    np.testing.assert_allclose(penalty.Skate(points, (floor,), 0.4).evaluate(samples), expected, rtol=1e-6)


def test_a_step_of_the_model_cannot_gain_without_limit(figure, rng):
    """The gradient is within the range of the matrices, and the model promises at most the squares of its residuals."""
    samples = random_samples(figure, rng, 3)
    skate, cotangent = penalty.Skate(two_points(figure), (plane_below(samples),), 1.0), Cotangent(samples)
    values = skate.evaluate(samples, cotangent)
    matrices = assembled(curvature_of(skate, samples, np.ones(3)), np.tile(np.eye(3), (3, 1, 1)))
    for value, matrix, gradient in zip(values, matrices, np.hstack(cotangent.gradients()), strict=True):
        step = np.linalg.lstsq(matrix, -gradient, rcond=1e-10)[0]
        np.testing.assert_allclose(matrix @ step, -gradient, atol=1e-6 * np.abs(gradient).max())
        assert 0 < -0.5 * gradient @ step <= 2 * value * (1 + 1e-6)


def test_the_value_is_continuous_where_a_point_passes_over_the_edge_of_a_step():
    figure, skate = figure_of(BALL), penalty.Skate((FOOT,), (FLOOR, STEP))
    for height in (0.0, 0.01, 0.05):
        y = np.array([[x, 0, 0.3 + height, 1, 0, 0, 0] for x in (-1e-9, 1e-9)])
        left, right = skate.evaluate(Samples(figure, y, np.eye(1, 7) + np.zeros((2, 1)), np.zeros((2, 7))))
        assert left > 0.1
        np.testing.assert_allclose(left, right, rtol=1e-6)


FOOT = Point("foot", 1, np.zeros(3), 0.1)


STEP = Box("step", np.array([0.5, 0, 0.1]), np.eye(3), np.array([0.5, 0.5, 0.1]))


def speed_on_the_ground(weight: float, clock: float = 1.0) -> float:
    """How fast a ball moves on the average while it is within 5 mm of the floor, between keyframes on and above it."""
    figure = figure_of(BALL)
    places = [(0.0, 0.4), (0.4, 0.1), (0.5, 0.1), (0.9, 0.4)]
    keys = [Frame.key(0.3 * clock * i, [x, 0, z, 1, 0, 0, 0]) for i, (x, z) in enumerate(places)]
    motion = inbetween(
        Problem(figure, keys, [*SMOOTHNESS, (penalty.Skate((FOOT,), (FLOOR,)), weight)], Settings(tolerance=1e-4))
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


def case(figure: Figure, rng: np.random.Generator, count: int = 6) -> tuple[Samples, penalty.HoverPenalty]:
    samples = at_times(random_samples(figure, rng, count), np.linspace(0, 1, count))
    return samples, penalty.HoverPenalty(two_points(figure), (plane_below(samples),), reach=0.8, blend=0.2)


def lowest(samples: Samples, grounded: penalty.HoverPenalty, blend: float | np.ndarray) -> np.ndarray:
    """The smooth minimum of the heights of the two points, (S,)."""
    (floor,) = grounded.surfaces
    assert isinstance(floor, Plane)
    centres, _ = places_of(grounded.points, samples)
    height = centres[2] - floor.point[2] - np.array([0.05, 0])[:, None]
    return np.maximum(-blend * np.log(np.sum(np.exp(-height / blend), axis=0)), 0)


def test_the_value_by_hand(figure, rng):
    samples, grounded = case(figure, rng)
    low = lowest(samples, grounded, 0.2)
    expected = 0.64 * (1 - np.exp(-((low / 0.8) ** 2)))
    np.testing.assert_allclose(grounded.evaluate(samples), expected, rtol=1e-9)
    assert np.count_nonzero(expected) > 1
