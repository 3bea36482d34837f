"""Joint ranges, bends, tilts and speeds: values against MuJoCo and SciPy, and motions that obey them."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, DOWN, ELBOW, EVERY_JOINT, KNEE, figure_of, limb, limits
from gradients import penalty_slope, shifted
from hypothesis import example, given, settings
from hypothesis import strategies as st
from oracles import kinematics
from random_models import random_samples
from scipy.spatial.transform import Rotation

from dynsplines import inbetween as solve_clip
from dynsplines import load
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import (
    CovariantAcceleration,
    JointRange,
    Speed,
    UnitMagnitude,
    Upright,
    joint_ranges,
    leans,
)
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
def limited_figure(request: pytest.FixtureRequest) -> Figure:
    text, coordinates = FIGURES[request.param]
    return figure_of(limited(text), coordinates)


def by_mujoco(limited_figure: Figure, samples: Samples) -> Array:
    """How far joints are beyond their ranges by MuJoCo's limit constraints, (n, S); 0 for those within."""
    model = limited_figure.model
    names = [r.name for r in joint_ranges(limited_figure)]
    out = np.zeros((len(names), samples.count))
    data = mujoco.MjData(model)
    for s, qpos in enumerate(limited_figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        for i in range(data.nefc):
            kind, joint = int(data.efc_type[i]), int(data.efc_id[i])
            if kind == mujoco.mjtConstraint.mjCNSTR_LIMIT_JOINT:
                out[names.index(model.joint(joint).name), s] = -data.efc_pos[i]
    return out


def test_how_far_joints_are_beyond_their_ranges_is_what_mujoco_computes(limited_figure, rng):
    samples = random_samples(limited_figure, rng, 20)
    found = JointRange(joint_ranges(limited_figure)).beyond(samples)
    assert len(found) == len(limited_figure.links) - 2
    np.testing.assert_allclose(np.maximum(found, 0), by_mujoco(limited_figure, samples), atol=1e-9)
    assert np.count_nonzero(found > 0) > 20
    assert np.count_nonzero(found < 0) > 5


ONE = """<mujoco><worldbody><body><joint name="j" type="ball" limited="true" range="0 {}"/><geom size=".1"/></body>
  </worldbody></mujoco>"""


def turned_by(limited_figure: Figure, angles: list[float], axis: Array) -> Samples:
    y = np.array([quat.from_rotation_vector(angle * axis) for angle in angles])
    return Samples(limited_figure, y, 0 * y, 0 * y)


@pytest.mark.parametrize("off", [0.0, 1e-9, 1e-4, 0.005, 0.1])
def test_half_a_turn_is_smooth_and_no_turn_too(off, rng):
    limited_figure = figure_of(ONE.format(0.001))
    axis = np.array([0.6, 0, 0.8])
    penalty = JointRange(joint_ranges(limited_figure))
    samples = turned_by(limited_figure, [np.pi - off, np.pi + off, off, -off], axis)
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


def test_what_keyframes_violate_passes_along_the_line_to_the_next(limited_figure, rng):
    """Beyond by a keyframe: nothing to pay there, half of it to spare midway to one within."""
    ranges = joint_ranges(limited_figure)
    states = limited_figure.to_state(
        np.vstack(
            [
                limited_figure.model.qpos0,
                rng.normal(size=(1, limited_figure.width)),
                limited_figure.model.qpos0,
            ]
        )
    )
    keys = Timeline(tuple(Frame.key(float(t), y) for t, y in enumerate(states)), np.zeros((2, limited_figure.width)))
    plain, lenient = JointRange(ranges), JointRange(ranges).allowing(limited_figure, keys)
    at_keys = Samples(limited_figure, states, 0 * states, 0 * states, t=keys.times)
    over = np.maximum(plain.beyond(at_keys), 0)
    assert np.count_nonzero(over[:, 1]) > 1
    np.testing.assert_allclose(lenient.beyond(at_keys)[:, 1][over[:, 1] > 0], 0, atol=1e-12)
    midway = Samples(limited_figure, states[[1]], 0 * states[[1]], 0 * states[[1]], t=np.array([1.5]))
    within = over[:, 2] == 0
    np.testing.assert_allclose(np.maximum(lenient.beyond(midway), 0)[within, 0], over[within, 1] / 2, atol=1e-12)
    samples = random_samples(limited_figure, rng, 6)
    timed = Samples(limited_figure, samples.y, samples.y_d, samples.y_dd, t=np.linspace(0.7, 1.3, 6))
    assert penalty_slope(lenient, timed, rng) > 1.9
    loose = Timeline(tuple(Frame.key(f.time, f.state, 0 * f.fixed) for f in keys.frames), keys.end_slope)
    nothing = JointRange(ranges).allowing(limited_figure, loose)
    np.testing.assert_array_equal(nothing.evaluate(timed), plain.evaluate(timed))


@pytest.mark.parametrize("kind", ["hinge", "ball"])
def test_a_joint_keyed_beyond_its_range_does_not_flick(kind):
    """Keyed 20° beyond: 2.3 times the raw spline's acceleration, where without allowance it is ten times."""
    bounds = 'range="-60 60"' if kind == "hinge" else 'range="0 60"'
    limited_figure = figure_of(
        f'<mujoco><worldbody><body><joint name="j" type="{kind}" axis="0 1 0" {bounds}/>'
        '<geom size="0.1" pos="0 0 1"/></body></worldbody></mujoco>'
    )
    angles = np.radians([0.0, 80, 0])
    poses = angles[:, None] if kind == "hinge" else quat.from_rotation_vector(angles[:, None] * [0, 1.0, 0])
    keys = [Frame.key(0.5 * i, pose) for i, pose in enumerate(poses)]
    raw = raw_timeline(limited_figure, keys)
    terms = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0)]

    def peak(timeline: Timeline) -> float:
        path, t = path_of(timeline), np.linspace(0, 1, 400)
        samples = Samples(limited_figure, *(path.at(t, order) for order in range(3)), t=t)
        return float(np.linalg.norm(samples.links.alpha[:, 1], axis=0).max())

    def solved(limits: JointRange) -> float:
        chosen = [term for term in (*terms, (limits, 1.0)) if kind == "ball" or term[0].name != "unit"]
        return peak(inbetween(Problem(limited_figure, keys, chosen, Settings(frames=8, tolerance=1e-4))).timeline)

    strict = JointRange(joint_ranges(limited_figure))
    assert solved(strict.allowing(limited_figure, raw)) <= 2.5 * peak(raw)
    assert solved(strict) > 8 * peak(raw)


def bent(figure: Figure, lateral: np.ndarray, angles: np.ndarray, rng: np.random.Generator) -> Samples:
    """The limb with flexion about the lateral axis, then sideways, then twist about the long axis: angles (S, 3)."""
    axes = np.column_stack([lateral, np.cross(DOWN, lateral), DOWN])
    relative = Rotation.from_matrix(axes @ Rotation.from_euler("XYZ", angles).as_matrix() @ axes.T)
    turn = Rotation.from_quat(np.roll(figure.links[2].turn, -1))
    qpos = rng.normal(size=(len(angles), figure.width))
    qpos[:, 7:] = np.roll((turn.inv() * relative * turn).as_quat(), 1, axis=1)
    y = figure.to_state(qpos)
    return Samples(figure, y, 0 * y, 0 * y)


LIMBS = limb(), limb("joint", ".8 .1 -.2 .4")


@given(
    st.sampled_from(LIMBS),
    st.floats(-3, 3),
    st.floats(-1.4, 1.4),
    st.floats(-1.5, 1.5),
    st.sampled_from([1.0, -1.0]),
)
@example(LIMBS[1], 1.5, 0.0, 0.0, 1.0)
@example(LIMBS[1], 0.0, 1.4, 0.0, -1.0)
@example(LIMBS[1], 0.0, 0.0, -1.5, 1.0)
@settings(deadline=None, max_examples=60)
def test_the_angles_are_the_euler_angles_with_the_twist_wide_by_the_sideways_bend(figure, flexion, side, twist, sign):
    samples = bent(figure, sign * KNEE, np.array([[flexion, side, twist]]), np.random.default_rng(1))
    seen = limits(sign * KNEE).angles(samples)[:, 0, 0]
    wide = np.arctan2(np.sin(twist), np.cos(twist) * np.cos(side))
    np.testing.assert_allclose(seen, [flexion, side, wide], atol=1e-10)


def test_a_knee_flexes_its_shin_backward_and_an_elbow_its_forearm_forward(rng):
    for lateral, sign in ((KNEE, -1), (ELBOW, 1)):
        figure = limb("joint")
        samples = bent(figure, lateral, np.array([[0.5, 0, 0]]), rng)
        samples = Samples(figure, np.hstack([[[0.0, 0, 0, 1, 0, 0, 0]], samples.y[:, 7:]]), samples.y_d, samples.y_dd)
        tip = samples.links.rotation[:, :, 2, 0] @ DOWN
        np.testing.assert_allclose(tip, [sign * np.sin(0.5), 0, -np.cos(0.5)], atol=1e-12)


@pytest.mark.parametrize("lateral", [KNEE, ELBOW], ids=["knee", "elbow"])
def test_inside_the_limits_it_is_exactly_zero_without_gradient_and_outside_the_squared_excess(rng, lateral):
    degrees = np.array([[30, 9, -9], [-20, 0, 0], [20, 25, 0], [20, -25, 0], [20, 0, 25], [20, 0, -25], [0.1, 0, 0]])
    samples = bent(limb(), lateral, np.radians(degrees), rng)
    cotangent = Cotangent(samples)
    values = limits(lateral).evaluate(samples, cotangent)
    np.testing.assert_allclose(np.degrees(np.sqrt(values)), [0, 20, 15, 15, 15, 15, 0], atol=1e-9)
    assert values[0] == 0
    gradient = np.abs(cotangent.gradients()[0]).max(axis=1)
    np.testing.assert_array_equal(gradient > 0, [False, True, True, True, True, True, False])


@pytest.mark.parametrize("gap", [1e-3, 1e-7, 1e-12, 0.0])
def test_a_limb_out_at_a_right_angle_sideways_has_a_true_angle_and_a_finite_gradient(rng, gap):
    samples = bent(limb(), KNEE, np.array([[0.3, np.pi / 2 - gap, 0.2]]), rng)
    penalty = limits(KNEE, least=-4.0, twist=4.0)
    np.testing.assert_allclose(penalty.angles(samples)[1], np.pi / 2 - gap, atol=2e-9)
    cotangent = Cotangent(samples)
    penalty.evaluate(samples, cotangent)
    assert np.abs(cotangent.gradients()[0]).max() < 20


UP = np.array([0.0, 0, 1])


BOW = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
root.rotation = {{rotvec = [0, 30, 0]}}
[[keyframe]]
time = 1
others = "rest"
root.rotation = {{rotvec = [0, 30, 0]}}
{more}
"""


ASKED = '[[penalty]]\nkind = "upright"\nbodies = ["chest"]'


def turned(figure: Figure, qpos: Array, link: int, axis: Array) -> Array:
    """An axis of a link in the world, by MuJoCo's kinematics."""
    data = kinematics(figure.model, qpos)
    return data.body(figure.links[link].body).xmat.reshape(3, 3) @ axis


def test_it_is_about_keyframes_whose_roots_turn_was_posed_and_keeps_what_points_up_there():
    figure = figure_of(BALL_TREE, "world")
    qpos, free = np.array(figure.model.qpos0), np.zeros(figure.width, bool)
    qpos[3:7] = [np.cos(0.2), 0, np.sin(0.2), 0]
    free[3:7] = True
    keys = [Frame.key(0.0, qpos), Frame(1.0, qpos, ~free, free), Frame.key(2.0, qpos, ~free), Frame.key(3.0, qpos)]
    (lean,) = leans(figure, raw_timeline(figure, keys), figure.tables.free_links.tolist())
    assert (lean.link, lean.time) == (int(figure.tables.free_links[0]), 1.0)
    np.testing.assert_allclose(turned(figure, qpos, lean.link, lean.axis), UP, atol=1e-12)


@pytest.mark.parametrize("axis", [None, (0.3, -0.2, 1.0)])
def test_the_value_is_what_mujoco_computes_of_the_axis(figure, rng, axis):
    samples, model = random_samples(figure, rng, 4), figure.model
    bodies = [i for i in range(1, model.nbody) if figure.body_link[i]][:2]
    rest, expected = kinematics(model), np.zeros(4)
    for s, qpos in enumerate(figure.to_qpos(samples.y)):
        data = kinematics(model, qpos)
        for body in bodies:
            own = rest.xmat[body].reshape(3, 3).T @ [0, 0, 1] if axis is None else np.array(axis) / np.linalg.norm(axis)
            expected[s] += np.sum((data.xmat[body].reshape(3, 3) @ own - [0, 0, 1]) ** 2)
    np.testing.assert_allclose(Upright.of(figure, bodies, axis).evaluate(samples), expected, atol=1e-9)


@pytest.mark.slow
def test_a_chest_rises_between_keyframes_that_bow():
    lean = {}
    for more in ("", ASKED):
        motion = solve_clip(load(BOW.format(more=more)))
        model = motion.clip.figure.model
        data = kinematics(model, motion.at(0.5))
        lean[more] = np.degrees(np.arccos(data.body("chest").xmat[8]))
    assert lean[""] > 25
    assert lean[ASKED] < 0.5 * lean[""]


# An elbow that bends far, and comes back
SWING = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 0.5
others = "rest"
joints.left_elbow = {{rotvec = [0, -100, 0]}}
[[keyframe]]
time = 1
others = "rest"
{more}
"""


def unit_samples(figure, rng, count):
    """Random samples with quaternions of unit length, all the time."""
    samples = random_samples(figure, rng, count)
    y, y_d = samples.y.copy(), samples.y_d.copy()
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] /= np.linalg.norm(y[:, columns], axis=1, keepdims=True)
        y_d[:, columns] -= y[:, columns] * np.sum(y[:, columns] * y_d[:, columns], axis=1, keepdims=True)
    return type(samples)(figure, y, y_d, samples.y_dd)


def test_joints_are_as_fast_as_mujoco_computes(figure, rng):
    samples, model, h = unit_samples(figure, rng, 4), figure.model, 1e-6
    joints = [i for i, link in enumerate(figure.links) if i and link.kind in (JointKind.HINGE, JointKind.BALL)]
    before, after = (figure.to_qpos(samples.y + k * h * samples.y_d) for k in (-0.5, 0.5))
    expected = np.zeros((len(joints), 4))
    for s in range(4):
        qvel = np.zeros(model.nv)
        mujoco.mj_differentiatePos(model, qvel, h, before[s], after[s])
        for row, i in enumerate(joints):
            joint = figure.links[i].joint
            at, size = int(model.jnt_dofadr[joint]), 3 if figure.links[i].kind is JointKind.BALL else 1
            expected[row, s] = np.linalg.norm(qvel[at : at + size])
    speed = Speed.of(figure, 1.0)
    np.testing.assert_allclose(speed.speeds(samples), expected, rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(speed.evaluate(samples), np.sum(np.maximum(expected - 1, 0) ** 2, axis=0), rtol=1e-3)


@pytest.mark.slow
def test_a_joint_takes_its_time():
    """100 degrees in half a second, there and back, are 200 degrees a second on the average."""
    fastest = {}
    for more in ("", '[[penalty]]\nkind = "limits"\nspeed = 260'):
        motion = solve_clip(load(SWING.format(more=more)))
        figure = motion.clip.figure
        times = np.linspace(0, 1, 500)
        qpos = np.array([motion.at(t) for t in times])
        at = int(figure.model.jnt_qposadr[figure.model.joint("left_elbow").id])
        size = np.abs(np.einsum("ij,ij->i", qpos[1:, at : at + 4], qpos[:-1, at : at + 4]))
        fastest[more] = float(np.degrees(2 * np.arccos(np.minimum(size, 1)) / np.diff(times)).max())
    free, limited = fastest.values()
    assert free > 280 and limited < 262, fastest
