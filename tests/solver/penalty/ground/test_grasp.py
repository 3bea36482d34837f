"""Grasps: the value by hand, gradient and curvature, and a ball that stays where it was on a box that moves."""

import numpy as np
import pytest
from figures import figure_of
from random_samples import at_times, random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Grasp, Stance
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, GraspPenalty, RootAcceleration, UnitMagnitude, slipped
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface.points import Point

TWO = """<mujoco><worldbody>
<body name="hand"><freejoint/><geom size=".1"/></body>
<body name="box"><freejoint/><geom type="box" size=".2 .3 .1"/></body>
</worldbody></mujoco>"""
HAND = Point("hand", 1, np.array([0.1, 0.2, -0.3]))


def grasps(figure: Figure) -> tuple[Grasp, Grasp]:
    """One whose spot drifts and then stays, with more and more slack, and one whose spot nobody knows."""
    last = len(figure.links) - 1
    spots = (
        Stance(HAND, 0.1, 0.4, np.array([0.1, 0, 0.2]), np.array([0.1, 0.3, 0]), 1.0, last, (0.0, 0.3)),
        Stance(HAND, 0.4, 0.8, np.array([0.1, 0.3, 0]), np.array([0.1, 0.3, 0]), 1.0, last, (0.3, 0.7)),
    )
    return Grasp(HAND, last, "it", 0.1, 0.8, spots), Grasp(Point("b", last, np.ones(3)), 1, "it", 0.3, 1.0)


def case(figure: Figure, rng: np.random.Generator) -> tuple[Samples, tuple[Grasp, Grasp]]:
    return at_times(random_samples(figure, rng, 6), np.linspace(0, 1, 6)), grasps(figure)


def known(samples: Samples, grasp: Grasp) -> Array:
    """(S, 3) the way from the spot to the hand, as far as it is beyond the slack."""
    links = samples.links
    away = np.empty((samples.count, 3))
    for s, t in enumerate(samples.t):
        share = np.clip((t - 0.1) / 0.3, 0, 1)
        spot = np.array([0.1, 0.3 * share, 0.2 * (1 - share)])
        hand = links.x[:, grasp.point.link, s] + links.rotation[:, :, grasp.point.link, s] @ grasp.point.position
        whole = hand - links.x[:, grasp.link, s] - links.rotation[:, :, grasp.link, s] @ spot
        far = float(np.linalg.norm(whole))
        away[s] = max(far - np.interp(t, [0.1, 0.8], [0, 0.7]), 0) / far * whole
    return away


def sliding(samples: Samples, grasp: Grasp) -> Array:
    """(S, 3) how fast the hand moves on the body, in that link's axes, by differences along y', y''."""
    h = 1e-5
    there = [
        slipped(Samples(samples.figure, samples.y + k * h * samples.y_d, samples.y_d, samples.y_dd), grasp)
        for k in (-1, 1)
    ]
    return ((there[1] - there[0]) / (2 * h)).T


def test_the_value_is_the_distance_from_the_spot_or_what_the_hand_slides_on_the_body_in_a_twentieth_of_a_second(
    figure, rng
):
    samples, (first, second) = case(figure, rng)
    t = samples.t
    expected = ((t >= 0.1) & (t <= 0.8)) * np.sum(known(samples, first) ** 2, axis=1)
    settling = Thresholds.of(samples.figure).settling
    expected += ((t >= 0.3) & (t <= 1.0)) * settling**2 * np.sum(sliding(samples, second) ** 2, axis=1)
    np.testing.assert_allclose(GraspPenalty.of((first, second)).evaluate(samples), expected, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("is_known", [True, False])
def test_a_hand_stays_on_a_box_that_turns_where_the_raw_spline_loses_it(is_known):
    figure = figure_of(TWO)
    spot, keys = np.array([0.9, 0, 0]), []
    for i in range(2):
        box, turn = np.array([0.5, 0.4, 0.3]) * i, [np.cos(0.6 * i), 0, 0, np.sin(0.6 * i)]
        keys.append(Frame.key(float(i), [*(box + quat.rotated(turn, spot)), 1, 0, 0, 0, *box, *turn]))
    hand = Point("hand", 1, np.zeros(3))
    spots = (Stance(hand, 0, 1, spot, spot, link=2),) if is_known else ()
    grasp = Grasp(hand, 2, "box", 0.0, 1.0, spots)
    others = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0)]

    def worst(weight: float) -> float:
        penalties = [*others, (GraspPenalty.of((grasp,)), weight)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(tolerance=1e-5)))
        samples = Samples(figure, *(figure.to_state(motion.at(np.linspace(0, 1, 80))),) * 3)
        return float(np.linalg.norm(slipped(samples, grasp) - spot[:, None], axis=0).max())

    assert worst(0.0) > 0.1
    assert worst(300.0) < 0.003
