"""Posture: relative velocities by SciPy, gradient, curvature, and what it takes off the swing between far keyframes."""

import numpy as np
import pytest
from curvature_of import assert_squares
from figures import BALL_TREE, CHAIN, HUMAN_AND_CHAINS, figure_of
from penalty_slope import penalty_slope
from random_samples import random_samples
from scipy.spatial.transform import Rotation, Slerp

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import Steps
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.size import Size
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Between, CovariantAcceleration, Posture, RootAcceleration, UnitMagnitude
from dynsplines.solver.problem import Problem, Settings


@pytest.fixture(params=HUMAN_AND_CHAINS, ids=["human", "human, joints", "fixed balls", "fixed ball and hinge"])
def jointed(request) -> Figure:
    text, coordinates = request.param
    return figure_of(text, coordinates)


PLACING = 2  # a link that places a foot


def stepping(figure: Figure, links: list[int]) -> Between:
    """A timeline of one segment, in which these links take a step and the roots' mean velocities are zero."""
    steps, placing = np.zeros((len(figure.links), 1), bool), np.zeros(len(figure.links), bool)
    steps[links], placing[PLACING] = True, True
    times, roots = np.array([0.0, 1.0]), len(roots_of(figure))
    turning, across = np.zeros((3, roots, 1)), np.zeros((2, roots, 1))
    return Between(times, turning, across, Steps(times, steps, steps[:, 0], placing), np.array([True]))


def residuals(samples: Samples, exempt: list[int]) -> np.ndarray:
    """Half the velocities of joints and roots, those of roots times √12 and √2, of other joints, except those that
    place a foot, times 2, (S, r)."""
    figure, y_d, omega = samples.figure, samples.y_d, samples.links.omega
    balls = [i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL and i not in exempt]
    relative = [(1 if i == PLACING else 2) * (omega[:, i] - omega[:, figure.links[i].parent]) for i in balls]
    is_moving = ~np.isin(figure.tables.hinge_links, exempt)
    hinges, hinge_links = figure.tables.hinge_columns[is_moving], figure.tables.hinge_links[is_moving]
    roots = roots_of(figure)
    turning = [np.sqrt(12) * omega[:, i] for i in roots]
    across = [np.sqrt(2) * y_d[:, figure.links[i].qpos : figure.links[i].qpos + 2] for i in roots]
    bending = np.where(hinge_links == PLACING, 1, 2) * y_d[:, hinges]
    return 0.5 * np.hstack([*(part.T for part in (*relative, *turning)), bending, *across])


def roots_of(figure: Figure) -> list[int]:
    """The links with a free joint that carry others."""
    carrying = {link.parent for link in figure.links[1:]}
    return [i for i, link in enumerate(figure.links) if i in carrying and i and link.kind is JointKind.FREE]


def test_the_value_is_the_speed_of_the_joints_by_differences(figure, rng):
    samples, h = random_samples(figure, rng, 4), 1e-6
    expected = np.zeros(4)
    before, after = (figure.to_qpos(samples.y + s * samples.y_d) for s in (-h, h))
    for link in figure.links[1:]:
        if link.kind is JointKind.BALL:
            some = slice(link.qpos, link.qpos + 4)
            a, b = (Rotation.from_quat(np.roll(q[:, some], -1, axis=1)) for q in (before, after))
            expected += np.sum(((a.inv() * b).as_rotvec() / (2 * h)) ** 2, axis=1) / 4
        elif link.kind is JointKind.HINGE:
            expected += ((after - before)[:, link.qpos] / (2 * h)) ** 2 / 4
    for i in roots_of(figure):
        qpos, size = figure.links[i].qpos, Size.of(figure).length
        expected += np.sum(((after - before)[:, qpos : qpos + 2] / (2 * h)) ** 2, axis=1) / 2 / size**2
        a, b = (Rotation.from_quat(q[:, qpos + 3 : qpos + 7], scalar_first=True) for q in (before, after))
        expected += 3 * np.sum(((a.inv() * b).as_rotvec() / (2 * h)) ** 2, axis=1)
    np.testing.assert_allclose(Posture().evaluate(samples), expected, rtol=1e-5)


@pytest.mark.parametrize("exempt", [[], [2]])
def test_the_gradient_has_taylor_slope_two(jointed, rng, exempt):
    penalty = Posture(between=stepping(jointed, exempt))
    assert penalty_slope(penalty, random_samples(jointed, rng, 5), rng) > 1.95


@pytest.mark.parametrize("exempt", [[], [2]])
def test_it_and_its_curvature_are_squares_of_velocities(jointed, rng, exempt):
    penalty = Posture(between=stepping(jointed, exempt))
    assert_squares(penalty, lambda seen: residuals(seen, exempt), random_samples(jointed, rng, 3), rng)


def test_a_root_that_turns_and_travels_evenly_between_its_keyframes_costs_nothing(rng):
    figure, times = figure_of(BALL_TREE), np.array([0.0, 0.4, 1.1])
    (root,) = roots_of(figure)
    first, places = figure.links[root].qpos, rng.normal(size=(3, 3))
    slerp = Slerp(times, Rotation.random(3, random_state=rng))
    t, h = np.array([0.1, 0.3, 0.5, 1.0]), 1e-5

    def states(t: np.ndarray) -> np.ndarray:
        qpos = np.tile(figure.model.qpos0, (t.size, 1))
        qpos[:, first : first + 3] = np.transpose([np.interp(t, times, column) for column in places.T])
        qpos[:, first + 3 : first + 7] = slerp(t).as_quat(scalar_first=True)
        return np.asarray(figure.to_state(qpos))

    frames = [Frame.key(k, state) for k, state in zip(times.tolist(), states(times), strict=True)]
    y_d = (states(t + h) - states(t - h)) / (2 * h)
    samples = Samples(figure, states(t), y_d, 0 * y_d, t=t)
    assert Posture().evaluate(samples).min() > 1
    none = np.zeros(len(figure.links), bool)
    no_steps = Steps(times, np.zeros((len(figure.links), 2), bool), none, none)
    between = Between.of(figure, raw_timeline(figure, frames), no_steps)
    np.testing.assert_allclose(Posture(between=between).evaluate(samples), 0, atol=1e-6)


def swing(weight: float) -> float:
    """How far [degrees] the second joint of a chain swings between keyframes 2 s apart, all within 60°."""
    figure = figure_of(CHAIN.format("ball"))
    keys = []
    for i, angle in enumerate([0, 60, 60, 0]):
        bent = quat.from_rotation_vector(np.radians([0, angle, 0]))
        keys.append(Frame.key(2.0 * i, np.concatenate([[1, 0, 0, 0], bent])))
    penalties = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0)]
    motion = inbetween(Problem(figure, keys, [*penalties, (Posture(), weight)], Settings(tolerance=1e-5)))
    q = motion.at(np.linspace(0, 6, 601))[:, 4:]
    return float(np.degrees(quat.angle_between(np.array([1.0, 0, 0, 0]), q)).max())


def test_a_joint_overshoots_less():
    assert swing(1.0) < 65 < swing(0.0) - 3
