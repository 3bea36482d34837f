"""Posture: relative velocities by SciPy, gradient, curvature, and what it takes off the swing between far keyframes."""

import numpy as np
import pytest
from figures import CHAIN, HUMAN_AND_CHAINS, figure_of
from penalty_slope import penalty_slope
from random_samples import random_samples
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, Posture, RootAcceleration, UnitMagnitude
from dynsplines.solver.penalty.curvature import Curvature
from dynsplines.solver.problem import Problem, Settings


@pytest.fixture(params=HUMAN_AND_CHAINS, ids=["human", "human, joints", "fixed balls", "fixed ball and hinge"])
def jointed(request) -> Figure:
    text, coordinates = request.param
    return figure_of(text, coordinates)


def residuals(figure: Figure, y: np.ndarray, y_d: np.ndarray) -> np.ndarray:
    """Half the joints' angular velocities, (S, r)."""
    omega = Samples(figure, y, y_d, 0 * y).links.omega
    balls = [i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL]
    relative = [omega[:, i] - omega[:, figure.links[i].parent] for i in balls]
    hinges = figure.tables.hinge_columns
    return 0.5 * np.hstack([np.concatenate(relative).T, y_d[:, hinges]])


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
    np.testing.assert_allclose(Posture().evaluate(samples), expected, rtol=1e-5)


def test_the_gradient_has_taylor_slope_two(jointed, rng):
    assert penalty_slope(Posture(), random_samples(jointed, rng, 5), rng) > 1.95


def test_its_curvature_is_that_of_differences(jointed, rng):
    samples, h = random_samples(jointed, rng, 3), 1e-6
    curvature, scale, phi = Curvature(samples), rng.uniform(1, 2, 3), rng.normal(size=(3, 3))
    Posture().curvature(samples, curvature, scale)
    rows = []
    for entry in np.eye(jointed.width):
        moved = [
            residuals(jointed, samples.y + s * phi[:, :1] * entry, samples.y_d + s * phi[:, 1:2] * entry)
            for s in (h, -h)
        ]
        rows.append((moved[0] - moved[1]) / (2 * h))
    expected = 2 * np.einsum("s,msr,nsr->mn", scale, np.array(rows), np.array(rows))
    np.testing.assert_allclose(curvature.quadratic(phi, 0, 3), expected, rtol=1e-5, atol=1e-6 * expected.max())


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
