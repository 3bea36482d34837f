"""Joint ranges, holds, bends, tilts and speeds: values against MuJoCo and SciPy, and motions that obey them."""

from collections.abc import Sequence

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, DOWN, ELBOW, EVERY_JOINT, KNEE, SMOOTHNESS, figure_of, limb, limits
from gradients import penalty_slope, shifted
from hypothesis import example, given, settings
from hypothesis import strategies as st
from oracles import kinematics
from random_models import random_samples
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from dynsplines.solver import penalty as kinds
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty.joints.overshoot import SAME, SWINGS, holds, overshoot
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
    names = [r.name for r in kinds.joint_ranges(limited_figure)]
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
    found = kinds.JointRange(kinds.joint_ranges(limited_figure)).beyond(samples)
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
    penalty = kinds.JointRange(kinds.joint_ranges(limited_figure))
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
        return [r.name for r in kinds.joint_ranges(figure_of(text))]

    assert ranges(ONE.format(50)) == ["j"]
    assert ranges(ONE.format(180)) == []
    assert ranges(ONE.format(50).replace('limited="true"', 'limited="false"')) == []
    assert ranges(BALL_TREE) == []
    free = random_samples(figure_of(BALL_TREE), np.random.default_rng(1))
    assert not list(kinds.JointRange(()).residuals(free))
    assert not kinds.JointRange(()).evaluate(free, Cotangent(free)).any()


def test_what_keyframes_violate_passes_along_the_line_to_the_next(limited_figure, rng):
    """Beyond by a keyframe: nothing to pay there, half of it to spare midway to one within."""
    ranges = kinds.joint_ranges(limited_figure)
    states = limited_figure.to_state(
        np.vstack([limited_figure.model.qpos0, rng.normal(size=(1, limited_figure.width)), limited_figure.model.qpos0])
    )
    keys = Timeline(tuple(Frame.key(float(t), y) for t, y in enumerate(states)), np.zeros((2, limited_figure.width)))
    plain, lenient = kinds.JointRange(ranges), kinds.JointRange(ranges).allowing(limited_figure, keys)
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
    nothing = kinds.JointRange(ranges).allowing(limited_figure, loose)
    np.testing.assert_array_equal(nothing.evaluate(timed), plain.evaluate(timed))


def test_a_joint_keyed_beyond_its_range_does_not_flick():
    """Keyed 20° beyond: 2.3 times the raw spline's acceleration, where without allowance it is ten times."""
    limited_figure = figure_of(
        '<mujoco><worldbody><body><joint name="j" axis="0 1 0" range="-60 60"/><geom size="0.1" pos="0 0 1"/></body>'
        "</worldbody></mujoco>"
    )
    keys = [Frame.key(t, [np.radians(angle)]) for t, angle in ((0, 0), (0.5, 80), (1, 0))]
    raw = raw_timeline(limited_figure, keys)

    def peak(timeline: Timeline) -> float:
        path, t = path_of(timeline), np.linspace(0, 1, 400)
        samples = Samples(limited_figure, *(path.at(t, order) for order in range(3)), t=t)
        return float(np.linalg.norm(samples.links.alpha[:, 1], axis=0).max())

    def solved(limits: kinds.JointRange) -> float:
        terms = [(kinds.CovariantAcceleration(), 1.0), (limits, 1.0)]
        return peak(inbetween(Problem(limited_figure, keys, terms, Settings(frames=8, tolerance=1e-4))).timeline)

    strict = kinds.JointRange(kinds.joint_ranges(limited_figure))
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
    st.sampled_from(LIMBS), st.floats(-3, 3), st.floats(-1.4, 1.4), st.floats(-1.5, 1.5), st.sampled_from([1.0, -1.0])
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
    np.testing.assert_allclose(kinds.Upright.of(figure, bodies, axis).evaluate(samples), expected, atol=1e-9)


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
    speed = kinds.Speed(1.0)
    np.testing.assert_allclose(speed.excess(samples), expected - 1, rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(speed.evaluate(samples), np.sum(np.maximum(expected - 1, 0) ** 2, axis=0), rtol=1e-3)


HINGE = '<mujoco><worldbody><body><joint name="hinge"/><geom size=".1"/></body></worldbody></mujoco>'
CHAIN = """<mujoco><worldbody><body><freejoint name="root"/><geom size=".1"/>
<body pos="0 .2 0"><joint name="slide" type="slide"/><geom size=".1"/>
<body pos="0 .2 0"><joint name="hinge"/><geom size=".1"/>
<body pos="0 .2 0" quat=".8 .1 .5 0"><joint name="ball" type="ball"/><geom size=".1"/></body></body></body></body>
</worldbody></mujoco>"""


def hinged(times: Sequence[float], degrees: Sequence[float], ends: str = "free") -> tuple[Figure, Timeline]:
    """A hinge through keyframes."""
    figure = figure_of(HINGE)
    keys = [Frame.key(t, [np.radians(angle)]) for t, angle in zip(times, degrees, strict=True)]
    return figure, raw_timeline(figure, keys, ends)


def held_from(times: Sequence[float], degrees: Sequence[float]) -> list[float]:
    """The times [s] at which holds of a hinge begin."""
    penalty = kinds.overshoot(kinds.holds(*hinged(times, degrees)))
    joints = penalty.joints if penalty is not None else ()
    np.testing.assert_allclose([np.degrees(joint.high - joint.low) for joint in joints], 2)
    return [joint.first for joint in joints]


def test_values_that_neighbouring_keyframes_share_are_held() -> None:
    assert held_from([0, 1, 1.3, 2.3], [0, 0, 90, 90]) == [0, 1.3]
    assert held_from([0, 1, 2, 3], [0, 90, 90.3, 0]) == []
    assert held_from([0, 0.1, 0.3, 0.4], [0, 90, 90, 0]) == []  # passed in a fifth of a second


FREE = '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>'


def test_the_height_of_a_root_is_not_held_in_a_flight() -> None:
    figure = figure_of(FREE)
    states = [[0, 0, z, 1, 0, 0, 0] for z in (0.5, 1, 1, 0.5)]
    keys = raw_timeline(figure, [Frame.key(t, state) for t, state in enumerate(states)])
    for flights, columns in (((), {0, 1, 2}), (((1.0, 2.0),), set())):
        joints = kinds.holds(figure, keys, flights)
        assert {joint.column for joint in joints if joint.first == 1.0 and joint.home is None} == columns


def turned_off(home: Array, qpos: Array) -> Array:
    """(T,) [rad] how far quaternions (T, 4) are from one."""
    rotations = Rotation.from_quat(home, scalar_first=True).inv() * Rotation.from_quat(qpos, scalar_first=True)
    return np.asarray(rotations.magnitude())


def swings(first: Array, last: Array) -> tuple[Array, Array]:
    """How far a chain of every joint leaves two values (nq,) that are held for a second, 0.3 s apart: the root's place,
    slide [m], hinge, ball and the root's rotation [rad]; of the raw spline, and with the holds."""
    figure = figure_of(CHAIN)
    keys = [Frame.key(t, q) for t, q in zip((0, 1, 1.3, 2.3), (first, first, last, last), strict=True)]
    raw = raw_timeline(figure, keys)
    held = kinds.overshoot(kinds.holds(figure, raw))
    assert held is not None
    solution = inbetween(Problem(figure, keys, [*SMOOTHNESS, (held, 10.0)], Settings(frames=20, tolerance=1e-3)))

    def off(timeline: Timeline) -> Array:
        out = np.zeros(5)
        for home, times in ((first, np.linspace(0, 1, 200)), (last, np.linspace(1.3, 2.3, 200))):
            qpos = figure.to_qpos(path_of(timeline).at(times))
            apart = qpos - home
            rows = [np.linalg.norm(apart[:, :3], axis=1), np.abs(apart[:, 7]), np.abs(apart[:, 8])]
            rows += [turned_off(home[some], qpos[:, some]) for some in (slice(9, 13), slice(3, 7))]
            out = np.maximum(out, np.max(rows, axis=1))
        return out

    return off(raw), off(solution.timeline)


def test_slides_hinges_balls_and_the_root_are_held_alike() -> None:
    first = np.array([0, 0, 1, 1, 0, 0, 0, 0, 0, 1.0, 0, 0, 0])
    turned = Rotation.from_rotvec([0, 1.7, 0]).as_quat(scalar_first=True)
    last = np.array([0.8, 0, 1, *turned, 0.6, 1.9, *Rotation.from_rotvec([1.2, 0, 0.9]).as_quat(scalar_first=True)])
    raw, held = swings(first, last)
    assert np.all(raw > [0.2, 0.15, 0.5, 0.3, 0.4])
    assert np.all(held < [0.025, 0.025, 0.06, 0.06, 0.06])


HELD = """<mujoco><worldbody><body><freejoint name="root"/><geom size=".1"/>
  <body><joint name="hinge" axis="0 1 0"/><geom size=".1"/></body>
  <body><joint name="slide" type="slide"/><geom size=".1"/></body>
  <body><joint name="ball" type="ball"/><geom size=".1"/></body></body></worldbody></mujoco>"""


@pytest.mark.parametrize("name", ["root", "hinge", "slide", "ball"])
@pytest.mark.parametrize(
    ("duration", "off", "swing", "flights", "held"),
    [
        (1.0, 0.9, 1.25, [(0.0, 2.3), (3.3, 3.6)], True),
        (1.0, 0.9, 1.25, [(3.2, 3.6)], True),  # roots in flight hold no position
        (1.0, 1.1, 1.25, [], False),
        (1.0, 0.9, 0.95, [], False),
        (0.31, 0.9, 1.25, [], True),
        (0.29, 0.9, 1.25, [], False),
    ],
)
def test_joints_hold_values_of_two_keyframes_that_the_spline_would_leave(name, duration, off, swing, flights, held):
    """By SciPy's spline: nearly the same value at 2.3 s and `duration` later, with a `swing` in between."""
    figure, times = figure_of(HELD), np.cumsum([2, 0.3, duration, 0.3])
    link = next(link for link in figure.links if link.name == name)
    unit = "angle" if name in ("hinge", "ball") else "length"
    shape = CubicSpline(times, [-1, 0, 0, 1], bc_type="natural")(np.linspace(times[1], times[2], 200))
    away = swing * SWINGS[unit] / np.abs(shape).max()
    qpos = np.tile([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0.5, 1, 0, 0, 0], (4, 1))
    for row, value in zip(qpos, (-away, 0, off * SAME[unit], away), strict=True):
        if name == "ball":
            row[link.columns] = quat.from_rotation_vector([0, value, 0])
        else:
            row[link.qpos] += value
    found = holds(figure, raw_timeline(figure, list(map(Frame.key, times, qpos))), flights)
    positions = [] if len(flights) == 1 else [("root", value, times[1], times[2]) for value in (0.1, 0.2, 0.3)]
    if not held or (name == "root" and not positions):
        assert not found
        return
    others = [("hinge", 0.4, times[1], times[2]), ("slide", 0.5, times[1], times[2])]
    assert sorted((r.name, r.low, r.first, r.last) for r in found if not r.home) == [*others[:1], *positions, others[1]]
    assert {r.name: r.home for r in found if r.home} == dict.fromkeys(["root", "ball"], (1, 0, 0, 0))
    penalty = overshoot(found)
    assert penalty is not None
    for loose, joint in zip(penalty.joints, found, strict=True):
        room = {JointKind.SLIDE: 0.01}.get(joint.kind, np.radians(1))
        assert (loose.low, loose.high) == (joint.low - (0 if joint.home else room), joint.high + room)
