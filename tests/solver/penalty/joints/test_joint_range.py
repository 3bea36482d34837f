"""Joint ranges: angles against MuJoCo's own limits, values by hand, gradients, and half a turn from both sides."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from curvature_of import shifted, sides_of
from figures import BALL_TREE, EVERY_JOINT, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, JointRange, Range, UnitMagnitude, joint_ranges
from dynsplines.solver.problem import Problem, Settings

LIMITS = {"shoulder": 60, "elbow": 100, "hip": 20, "wrist": 50, "swing": 30}
PLAIN = {"yaw": (-40, 10), "pitch": (30, 90), "turn": (-1, 1)}


def limited(text: str) -> str:
    """The model with ranges on all its joints but the free one."""
    for name, high in LIMITS.items():
        text = text.replace(f'name="{name}" type="ball"', f'name="{name}" type="ball" limited="true" range="0 {high}"')
    for name, (low, high) in PLAIN.items():
        text = text.replace(
            f'name="{name}" type="hinge"', f'name="{name}" type="hinge" limited="true" range="{low} {high}"'
        )
    return text.replace('name="reach" type="slide"', 'name="reach" type="slide" limited="true" range="-.1 .2"')


FIGURES = {
    "ball tree, world": (BALL_TREE, "world"),
    "ball tree, joint": (BALL_TREE, "joint"),
    "every joint": (EVERY_JOINT, "joint"),
}


@pytest.fixture(params=FIGURES)
def figure(request: pytest.FixtureRequest) -> Figure:
    text, coordinates = FIGURES[request.param]
    return figure_of(limited(text), coordinates)


def by_mujoco(figure: Figure, samples: Samples) -> Array:
    """How far joints are beyond their ranges by MuJoCo's limit constraints, (n, S); 0 for those within."""
    model = figure.model
    names = [r.name for r in joint_ranges(figure)]
    out = np.zeros((len(names), samples.count))
    data = mujoco.MjData(model)
    for s, qpos in enumerate(figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        for i in range(data.nefc):
            kind, joint = int(data.efc_type[i]), int(data.efc_id[i])
            if kind == mujoco.mjtConstraint.mjCNSTR_LIMIT_JOINT:
                out[names.index(model.joint(joint).name), s] = -data.efc_pos[i]
    return out


def test_how_far_joints_are_beyond_their_ranges_is_what_mujoco_computes(figure, rng):
    samples = random_samples(figure, rng, 20)
    found = JointRange(joint_ranges(figure)).beyond(samples)
    assert len(found) == len(figure.links) - 2
    np.testing.assert_allclose(np.maximum(found, 0), by_mujoco(figure, samples), atol=1e-9)
    assert np.count_nonzero(found > 0) > 20
    assert np.count_nonzero(found < 0) > 5


@pytest.mark.parametrize(("kind", "near"), [("hinge", np.radians(4)), ("slide", 0.03), ("ball", np.radians(4))])
def test_the_model_includes_joints_within_their_range_by_at_most_four_degrees_or_three_centimetres(kind, near):
    low = 0 if kind == "ball" else -1
    joint = f'<joint type="{kind}" axis="0 1 0" range="{low} 1"/>'
    text = f'<mujoco><compiler angle="radian"/><worldbody><body>{joint}<geom size=".1"/></body></worldbody></mujoco>'
    over = np.array([-near - 1e-4, -near + 1e-4, 1e-4, 0.01])
    y = quat.from_rotation_vector((1 + over)[:, None] * np.eye(3)[1]) if kind == "ball" else (1 + over)[:, None]
    figure = figure_of(text)
    sides = sides_of(JointRange(joint_ranges(figure)), Samples.still(figure, y))
    assert sides.at.tolist() == [1, 2, 3]
    np.testing.assert_allclose(sides.value, over[1:], atol=2e-5)  # that of balls is rounded


@pytest.mark.parametrize("off", [0.0, 0.5])
def test_in_the_model_a_joint_leaves_a_small_range_in_any_direction(off, rng):
    """A ball joint is `off` [degrees] its value, within a range of 1°; a step turns it by 6° about another axis."""
    figure = figure_of(ONE.format(180))
    link = next(i for i, link in enumerate(figure.links) if link.name == "j")
    penalty = JointRange((Range("j", link, JointKind.BALL, 0, np.radians(1), home=(1.0, 0, 0, 0)),))
    axes = rng.normal(size=(20, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    start = turned_by(figure, [np.radians(off)], np.array([0.6, 0.8, 0]))
    sides = sides_of(penalty, start)
    for axis in axes:
        end = turned_by(figure, [np.radians(6)], axis)
        predicted = np.sum(np.maximum(sides.value + sides.rows @ (end.y - start.y)[0], 0) ** 2)
        assert 0.6 < predicted / penalty.evaluate(end)[0] < 1.1


ONE = """<mujoco><worldbody><body><joint name="j" type="ball" limited="true" range="0 {}"/><geom size=".1"/></body>
  </worldbody></mujoco>"""


def turned_by(figure: Figure, angles: list[float], axis: Array) -> Samples:
    y = np.array([quat.from_rotation_vector(angle * axis) for angle in angles])
    return Samples(figure, y, 0 * y, 0 * y)


@pytest.mark.slow
@settings(deadline=None, max_examples=60)
@given(st.floats(0, np.pi), st.floats(-1, 1), st.floats(0, 2 * np.pi), st.booleans())
def test_the_angle_is_that_of_the_rotation_whatever_the_quaternions_sign(angle, z, turn, negative):
    figure = figure_of(ONE.format(50))
    axis = np.array([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z])
    samples = turned_by(figure, [angle], axis)
    samples = Samples(figure, (-1 if negative else 1) * samples.y, samples.y_d, samples.y_dd)
    penalty = JointRange(joint_ranges(figure))
    np.testing.assert_allclose(penalty.beyond(samples), angle - np.radians(50), atol=1e-7)
    value = penalty.evaluate(samples)[0]
    np.testing.assert_allclose(np.sqrt(value), max(angle - np.radians(50), 0), atol=np.radians(0.6))


@pytest.mark.parametrize("off", [0.0, 1e-9, 1e-4, 0.005, 0.1])
def test_half_a_turn_is_smooth_and_no_turn_too(off, rng):
    figure = figure_of(ONE.format(0.001))
    axis = np.array([0.6, 0, 0.8])
    penalty = JointRange(joint_ranges(figure))
    samples = turned_by(figure, [np.pi - off, np.pi + off, off, -off], axis)
    cotangent = Cotangent(samples)
    values = penalty.evaluate(samples, cotangent)
    np.testing.assert_allclose(values[0], values[1], rtol=1e-9)
    gradient = cotangent.gradients()[0]
    assert np.all(np.isfinite(gradient))
    h = 1e-6
    for s in range(4):
        direction = rng.normal(size=4)
        by = np.zeros((3, 4, 4))
        by[0, s] = h * direction
        change = penalty.evaluate(shifted(samples, by)) - penalty.evaluate(shifted(samples, -by))
        np.testing.assert_allclose(change[s] / (2 * h), gradient[s] @ direction, atol=2e-4)


def test_only_limited_joints_that_can_pass_their_range_count():
    def ranges(text: str) -> list[str]:
        return [r.name for r in joint_ranges(figure_of(text))]

    assert ranges(ONE.format(50)) == ["j"]
    assert ranges(ONE.format(180)) == []
    assert ranges(ONE.format(50).replace('limited="true"', 'limited="false"')) == []
    assert ranges(BALL_TREE) == []
    free = random_samples(figure_of(BALL_TREE), np.random.default_rng(1))
    assert JointRange(()).one_sided_residuals(free) is None
    assert not JointRange(()).evaluate(free, Cotangent(free)).any()


def test_what_keyframes_violate_passes_along_the_line_to_the_next(figure, rng):
    """Beyond by a keyframe: nothing to pay there, half of it to spare midway to one within."""
    ranges = joint_ranges(figure)
    states = figure.to_state(np.vstack([figure.model.qpos0, rng.normal(size=(1, figure.width)), figure.model.qpos0]))
    keys = Timeline(tuple(Frame.key(float(t), y) for t, y in enumerate(states)), np.zeros((2, figure.width)))
    plain, lenient = JointRange(ranges), JointRange(ranges).allowing(figure, keys)
    at_keys = Samples(figure, states, 0 * states, 0 * states, t=keys.times)
    over = np.maximum(plain.beyond(at_keys), 0)
    assert np.count_nonzero(over[:, 1]) > 1
    np.testing.assert_allclose(lenient.beyond(at_keys)[:, 1][over[:, 1] > 0], 0, atol=1e-12)
    midway = Samples(figure, states[[1]], 0 * states[[1]], 0 * states[[1]], t=np.array([1.5]))
    within = over[:, 2] == 0
    np.testing.assert_allclose(np.maximum(lenient.beyond(midway), 0)[within, 0], over[within, 1] / 2, atol=1e-12)
    samples = random_samples(figure, rng, 6)
    timed = Samples(figure, samples.y, samples.y_d, samples.y_dd, t=np.linspace(0.7, 1.3, 6))
    assert penalty_slope(lenient, timed, rng) > 1.9
    loose = Timeline(tuple(Frame.key(f.time, f.state, 0 * f.fixed) for f in keys.frames), keys.end_slope)
    nothing = JointRange(ranges).allowing(figure, loose)
    np.testing.assert_array_equal(nothing.evaluate(timed), plain.evaluate(timed))


@pytest.mark.parametrize("kind", ["hinge", "ball"])
def test_a_joint_keyed_beyond_its_range_does_not_flick(kind):
    """Keyed 20° beyond: 2.3 times the raw spline's acceleration, where without allowance it is ten times."""
    bounds = 'range="-60 60"' if kind == "hinge" else 'range="0 60"'
    figure = figure_of(
        f'<mujoco><worldbody><body><joint name="j" type="{kind}" axis="0 1 0" {bounds}/>'
        '<geom size="0.1" pos="0 0 1"/></body></worldbody></mujoco>'
    )
    angles = np.radians([0.0, 80, 0])
    poses = angles[:, None] if kind == "hinge" else quat.from_rotation_vector(angles[:, None] * [0, 1.0, 0])
    keys = [Frame.key(0.5 * i, pose) for i, pose in enumerate(poses)]
    raw = raw_timeline(figure, keys)
    terms = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0)]

    def peak(timeline: Timeline) -> float:
        path, t = path_of(timeline), np.linspace(0, 1, 400)
        samples = Samples(figure, *(path.at(t, order) for order in range(3)), t=t)
        return float(np.linalg.norm(samples.links.alpha[:, 1], axis=0).max())

    def solved(limits: JointRange) -> float:
        chosen = [term for term in (*terms, (limits, 1.0)) if kind == "ball" or term[0].name != "unit"]
        return peak(inbetween(Problem(figure, keys, chosen, Settings(frames=8, tolerance=1e-4))).timeline)

    strict = JointRange(joint_ranges(figure))
    assert solved(strict.allowing(figure, raw)) <= 2.5 * peak(raw)
    assert solved(strict) > 8 * peak(raw)
