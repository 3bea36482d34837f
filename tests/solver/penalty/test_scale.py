"""What counts as little: a centimetre, a degree or ten of one violation; costs of motion fall as a clip gets slower."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, CHAIN, figure_of
from ground import FLOOR

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import Grasp, Rest, Stance
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Attachment,
    Bend,
    BendLimits,
    Contact,
    Coupling,
    CouplingPenalty,
    CovariantAcceleration,
    GraspPenalty,
    HoverPenalty,
    JointRange,
    Lean,
    PeakAcceleration,
    Placed,
    Posture,
    Range,
    RestPenalty,
    RootAcceleration,
    Sum,
    Torque,
    Upright,
)
from dynsplines.solver.penalty.joints.self_contact import Bar, SelfContact
from dynsplines.solver.surface.points import Point

UP, X = np.array([0.0, 0, 1]), np.array([1.0, 0, 0])
ORIGIN = Point("middle", 1, np.zeros(3))
CENTIMETRE = {
    "contact": Contact((ORIGIN,), (FLOOR,)),
    "grounded": HoverPenalty((ORIGIN,), (FLOOR,), ((-1.0, 1.0),), reach=10.0),
    "planted": Attachment((Stance(ORIGIN, -1, 1, np.zeros(3), np.zeros(3)),)),
    "resting": RestPenalty((Rest(ORIGIN, -1, 1),), (FLOOR,)),
    "placement": Attachment.at_instants((Placed(ORIGIN, 0.0, np.zeros(3)),)),
    "grasp": GraspPenalty.of((Grasp(ORIGIN, 0, "world", -1, 1, (Stance(ORIGIN, -1, 1, np.zeros(3), np.zeros(3)),)),)),
    "closed": Attachment((Stance(ORIGIN, -np.inf, np.inf, np.zeros(3), np.zeros(3)),), "closed"),
    "self": SelfContact((Bar(0, 1, 0 * UP, UP, 0.0, 0.1), Bar(1, 0, 0.19 * UP, UP, 0.0, 0.1)), np.array([[0], [1]])),
}  # fmt: skip


@pytest.mark.parametrize("name", CENTIMETRE)
def test_a_centimetre_counts_as_the_reference_specifies(name):
    figure, penalty = figure_of(BALL), CENTIMETRE[name]
    away = {"contact": -0.01, "self": 0.0}.get(name, 0.01)
    y = np.array([[0, 0, away, 1, 0, 0, 0.0]])
    still = Samples(figure, y, 0 * y, 0 * y, t=np.zeros(1))
    assert penalty.normalization.is_violation
    assert penalty.normalization.time_power == 0
    np.testing.assert_allclose(penalty.evaluate(still), penalty.normalization.reference, rtol=1e-5)
    assert Sum((penalty,), "both").normalization == penalty.normalization


@pytest.mark.parametrize("name", sorted({*CENTIMETRE} - {"self"}))
def test_a_violation_on_a_larger_figure_counts_more_by_the_power_that_its_scale_specifies(name):
    """By the length of a violation: a deviation that is twice as large."""
    figure, penalty = figure_of(BALL), CENTIMETRE[name]
    y = np.array([[0, 0, -away if name == "contact" else away, 1, 0, 0, 0.0] for away in (0.01, 0.02)])
    one, two = penalty.evaluate(Samples(figure, y, 0 * y, 0 * y, t=np.zeros(2)))
    assert two / one == pytest.approx(2.0**penalty.normalization.length_power, rel=1e-3)


@pytest.mark.parametrize("degrees", [-1.0, 1.0])
def test_a_degree_beyond_a_joints_range_a_bends_bound_or_a_couplings_line_counts_as_the_reference_specifies(degrees):
    hinge = figure_of(CHAIN.format("hinge"), "joint")
    angle = float(np.radians(degrees))
    y = np.array([[1.0, 0, 0, 0, 0.4 + angle]])
    still = Samples(hinge, y, 0 * y, 0 * y)
    kind = hinge.links[2].kind
    of_range = JointRange((Range("hinge", 2, kind, *((0.4, 9.0) if degrees < 0 else (-9.0, 0.4))),))
    of_coupling = CouplingPenalty((Coupling("hinge", 4, -1, (0.3, 0.0), np.array([0.1, 0, 0, 0, 0]), "degrees"),))
    for penalty in (of_range, of_coupling):
        np.testing.assert_allclose(penalty.evaluate(still), penalty.normalization.reference)
        assert penalty.normalization.is_violation
    balls = figure_of(CHAIN.format("ball"), "joint")
    straight = quat.from_rotation_vector(np.array([0, 0.2 - np.radians(1), 0]))
    y = np.concatenate([[1.0, 0, 0, 0], straight])[None]
    knee = BendLimits((Bend("knee", 2, np.array([0.0, 1, 0]), -UP),), 0.2, 1.0, 1.0)
    np.testing.assert_allclose(knee.evaluate(Samples(balls, y, 0 * y, 0 * y)), knee.normalization.reference)


@pytest.mark.parametrize(
    "penalty", [Upright((Lean(1, UP),)), Upright((Lean(1, UP, 0.0),))], ids=["always", "at a time"]
)
def test_ten_degrees_off_the_vertical_count_as_the_reference_specifies(penalty):
    figure = figure_of(BALL)
    y = np.concatenate([np.zeros(3), quat.from_rotation_vector(np.radians(10) * X)])[None]
    value = penalty.evaluate(Samples(figure, y, 0 * y, 0 * y, t=np.zeros(1)))
    np.testing.assert_allclose(value, (2 * np.sin(np.radians(5))) ** 2)  # a chord, nearly the angle
    np.testing.assert_allclose(value, penalty.normalization.reference, rtol=5e-3)


def points_of(figure) -> tuple[Point, ...]:
    return tuple(Point(f"{i}", i, np.array([0.1, 0.2, -0.3])) for i in range(1, len(figure.links)))


def test_a_newton_metre_counts_as_the_reference_of_torques_says():
    arm = '<body><joint type="hinge" axis="0 1 0"/><geom size=".001" pos="0.1 0 0" mass="1"/></body>'
    figure = figure_of(f'<mujoco><option gravity="0 0 -10"/><worldbody>{arm}</worldbody></mujoco>')
    y = np.zeros((1, figure.width))
    np.testing.assert_allclose(
        Torque().evaluate(Samples(figure, y, y, y)), Torque().normalization.reference, rtol=1e-12
    )


def test_two_radians_a_unit_of_spacing_squared_count_as_the_references_of_accelerations_specify():
    """A joint's 8 rad/s² with keyframes 1 s apart, and 2 m/s² of the root."""
    figure = figure_of(CHAIN.format("hinge"), "joint")
    y = np.array([[1.0, 0, 0, 0, 0.3]])
    hinge = Samples(figure, y, 0 * y, np.array([[0.0, 0, 0, 0, 8]]))
    for penalty in (CovariantAcceleration(), PeakAcceleration()):
        np.testing.assert_allclose(penalty.evaluate(hinge), penalty.normalization.reference)
    turning = Samples(figure, y, np.array([[0.0, 0, 0, 0, 2]]), 0 * y)
    posture = Posture(0.3)
    np.testing.assert_allclose(posture.evaluate(turning), (2 / 2) ** 2)
    root = figure_of(BALL)
    y = np.array([[0, 0, 1, 1, 0, 0, 0.0]])
    lifted = Samples(root, y, 0 * y, np.array([[0, 0, 2, 0, 0, 0, 0.0]]))
    np.testing.assert_allclose(RootAcceleration().evaluate(lifted), RootAcceleration().normalization.reference)
