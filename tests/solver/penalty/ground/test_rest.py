"""Resting points: the value by hand, gradient and curvature, and a foot held for an interval whose spot nobody said."""

import numpy as np
import pytest
from figures import BALL, figure_of
from random_samples import at_times, random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import Rest
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, RestPenalty, RootAcceleration, UnitMagnitude
from dynsplines.solver.penalty.ground.rest import Rolling
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

UP, TILT = np.array([0.0, 0, 1]), np.array([0.28, 0, 0.96])
FLOOR = Plane("floor", -50 * UP, UP)


def case(figure: Figure, rng: np.random.Generator) -> tuple[Samples, RestPenalty]:
    samples = at_times(random_samples(figure, rng, 6), np.linspace(0, 1, 6))
    last, slope = len(figure.links) - 1, Plane("slope", -50 * UP + 3 * TILT, TILT)
    rests = (
        Rest(Point("a", 1, np.array([0.1, 0.2, -0.3]), 0.05), 0.1, 0.5, rolls=True),
        Rest(Point("b", last, UP), 0.3, 1.0),
        Rest(Point("c", last, np.array([0.2, 0.1, 0.0]), 0.02), 0.1, 0.9, slope, rolls=True),
        Rest(Point("d", last, np.array([0.0, 0.1, 0.2]), 0.03), 0.2, 0.8),
        Rest(Point("c again", last, np.array([0.2, 0.1, 0.0]), 0.02), 0.5, 1.0, rolls=True),
    )
    return samples, RestPenalty(rests, (FLOOR,))


def test_the_value_by_hand(figure, rng):
    samples, resting = case(figure, rng)
    expected = np.zeros(6)
    for rest in resting.rests:
        links = samples.links
        offset = np.einsum("ijs,j->is", links.rotation[:, :, rest.point.link], rest.point.position)
        place, normal = links.x[:, rest.point.link] + offset, UP if rest.ground is None else TILT
        lowest = offset - rest.rolls * rest.point.radius * normal[:, None]
        velocity = links.x_d[:, rest.point.link] + np.cross(links.omega[:, rest.point.link].T, lowest.T).T
        height = normal @ (place + 50 * UP[:, None]) - (3 if rest.ground else 0) - rest.point.radius
        during = (samples.t >= rest.first) & (samples.t <= rest.last)
        expected += during * (height**2 + Thresholds.of(samples.figure).settling ** 2 * np.sum(velocity**2, axis=0))
    np.testing.assert_allclose(resting.evaluate(samples), expected, rtol=1e-9)


def test_a_foot_rests_where_nobody_said_that_it_should():
    figure = figure_of(BALL)
    foot, floor = Point("foot", 1, np.zeros(3), 0.1), Plane("floor", np.zeros(3), UP)
    keys = [Frame.key(float(i), [x, 0, 0.3, 1, 0, 0, 0]) for i, x in enumerate([0.0, 1.0])]
    penalties = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0)]

    def direction(weight: float) -> float:
        resting = RestPenalty((Rest(foot, 0.4, 0.6),), (floor,))
        motion = inbetween(Problem(figure, keys, [*penalties, (resting, weight)], Settings(tolerance=1e-4)))
        qpos = motion.at(np.linspace(0.4, 0.6, 100))
        return float(np.ptp(qpos[:, 0]) + np.abs(qpos[:, 2] - 0.1).max())

    assert direction(0.0) > 0.3
    assert direction(3000.0) < 0.01


@pytest.mark.parametrize("angle", [-0.7, 0.0, 1.2])
def test_a_sphere_that_rolls_goes_as_far_as_it_has_turned(angle):
    start = quat.from_rotation_vector([0.2, -0.4, 0.9])
    turned = quat.product(quat.from_rotation_vector([0, angle, 0]), start)[:, None]
    for rolls, ground, way in ((True, None, 1.0), (True, Plane("floor", np.zeros(3), UP), 1.0), (False, None, 0.0)):
        rest = Rest(Point("ball", 1, np.zeros(3), 0.05), 0.0, 1.0, ground, rolls)
        found = Rolling.of(rest, start).displacement(turned)
        np.testing.assert_allclose(found[:, 0], [way * 0.05 * angle, 0, 0], atol=1e-12)
