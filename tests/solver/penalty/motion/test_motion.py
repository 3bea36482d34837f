"""Accelerations, velocities, torques, cycles and recordings: values, and motions that obey them."""

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, CHAINS, figure_of, with_armature
from gradients import penalty_slope
from motions import FIGURE, GROUND, SOLES, TIME, WALK, gait
from oracles import kinematics, mujoco_forces
from random_models import at_times, evenly, random_samples
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from dynsplines.clip.build import constraints
from dynsplines.clip.contacts import schedule_of
from dynsplines.clip.context import Context
from dynsplines.solver import penalty
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Steps
from dynsplines.solver.contacts.gait import Gait
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty.motion.tracking import BACK, EASED, STRAYS
from dynsplines.solver.problem import Problem, Settings


def sizes(samples: Samples) -> Array:
    """(S, joints): |α − α_parent| of ball joints and hinges, by the links' angular accelerations."""
    links, found = samples.links, []
    for i, link in enumerate(samples.figure.links):
        if i and link.kind in (link.kind.BALL, link.kind.HINGE):
            found.append(np.linalg.norm(links.alpha[:, i] - links.alpha[:, link.parent], axis=0))
    return np.array(found).T


def test_it_is_the_sum_of_eighth_powers(figure, rng):
    samples = random_samples(figure, rng)
    np.testing.assert_allclose(
        penalty.PeakAcceleration().evaluate(samples), np.sum(sizes(samples) ** 8, axis=1), rtol=1e-10
    )


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
    np.testing.assert_allclose(penalty.Posture().evaluate(samples), expected, rtol=1e-5)


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
    assert penalty.Posture().evaluate(samples).min() > 1
    none = np.zeros(len(figure.links), bool)
    no_steps = Steps(times, np.zeros((len(figure.links), 2), bool), none)
    between = penalty.Between.of(figure, raw_timeline(figure, frames), no_steps)
    np.testing.assert_allclose(penalty.Posture(between=between).evaluate(samples), 0, atol=1e-6)


def test_it_is_the_squared_acceleration_of_root_and_slides(figure, rng):
    samples = random_samples(figure, rng)
    counted = [0, 1, 2] + [link.qpos for link in figure.links[1:] if link.kind is link.kind.SLIDE]
    np.testing.assert_allclose(
        penalty.RootAcceleration().evaluate(samples), np.sum(samples.y_dd[:, counted] ** 2, axis=1), rtol=1e-14
    )


@pytest.mark.parametrize("armature", [False, True])
def test_it_is_the_sum_of_squares_of_mj_inverses_joint_entries(figure, rng, armature):
    figure = with_armature(figure, rng) if armature else figure
    samples = random_samples(figure, rng)
    joints = np.array([figure.model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE for j in figure.model.dof_jntid])
    expected = np.sum(mujoco_forces(samples)[:, joints] ** 2, axis=1)
    np.testing.assert_allclose(penalty.Torque().evaluate(samples), expected, rtol=1e-9)


BALL = '<mujoco><worldbody><body><joint type="ball"/><geom size="0.1"/></body></worldbody></mujoco>'


def test_the_square_is_the_sum_of_squared_excess_lengths(figure, rng):
    samples = random_samples(figure, rng)
    expected = sum((samples.y[:, c] ** 2).sum(axis=1) - 1 for c in figure.tables.quaternion_columns.T[:1]) ** 2
    for columns in figure.tables.quaternion_columns.T[1:]:
        expected = expected + ((samples.y[:, columns] ** 2).sum(axis=1) - 1) ** 2
    np.testing.assert_allclose(penalty.UnitMagnitude().evaluate(samples), expected, rtol=1e-12)


def test_a_raw_spline_that_is_far_off_unit_length_does_not_make_it_soft():
    figure = figure_of(BALL)
    turns = [[1.0, 0, 0, 0], [0.1, 1, 0, 0], [1, 0.1, 0, 0]]
    raw = path_of(raw_timeline(figure, [Frame.key(t, q) for t, q in zip((0.0, 0.1, 3.0), turns, strict=True)]))
    firm, soft = (
        Objective.of(figure, [(penalty.UnitMagnitude(most=m), 2.0)]).renormalise(raw).terms[0] for m in (0.01, 1e9)
    )
    np.testing.assert_allclose(firm.factor, 2.0 / (0.01 * 3.0), rtol=1e-12)
    assert soft.factor < firm.factor / 2


LYING = """<mujoco><worldbody><body pos="0 0 1" quat=".7071 .7071 0 0"><freejoint/><geom size=".1"/>
  <body pos="0 -.3 0" quat=".8 0 .6 0"><joint type="ball"/><geom size=".1" pos="0 -.1 0"/></body>
</body></worldbody></mujoco>"""


LAIN = [(LYING, "world"), (LYING, "joint")]  # whose model has its root turned


@pytest.fixture(
    params=[*CHAINS, *LAIN], ids=["free", "fixed balls", "fixed ball and hinge", "turned root", "turned root, joints"]
)
def cycled(request, rng) -> penalty.Cycle:
    text, coordinates = request.param
    figure = figure_of(text, coordinates)
    keys = [Frame.key(0.3 * k, qpos) for k, qpos in enumerate(figure.to_qpos(random_samples(figure, rng, 6).y))]
    gait_cycle = Gait(KeyframePoints.of(figure, raw_timeline(figure, keys), (), ())).with_period(0.7)
    assert gait_cycle is not None and gait_cycle.trust.max() > 0
    return penalty.Cycle(figure, gait_cycle)


def at_its_times(cycle: penalty.Cycle, rng: np.random.Generator, count: int) -> tuple[Samples, np.ndarray]:
    """Random samples at some of the times that the gait cycle covers, and which."""
    some = rng.choice(cycle.gait_cycle.times.size, count, replace=False)
    seen = random_samples(cycle.figure, rng, count)
    return Samples(seen.figure, seen.y, seen.y_d, seen.y_dd, cycle.gait_cycle.times[some]), some


def test_the_gradient_has_taylor_slope_two_of_cycles(cycled, rng):
    assert penalty_slope(cycled, at_its_times(cycled, rng, 5)[0], rng) > 1.95


def test_the_poses_of_a_cycle_cost_nothing(cycled):
    figure, gait_cycle = cycled.figure, cycled.gait_cycle
    poses = Samples.still(figure, figure.to_state(gait_cycle.qpos(figure.width)), gait_cycle.times)
    np.testing.assert_allclose(cycled.evaluate(poses), 0, atol=1e-12)


@pytest.mark.slow
def test_a_walk_with_few_keyframes_is_nearer_to_the_real_one_and_goes_through_them():
    keys = [Frame.key(TIME[k], WALK[k]) for k in range(0, TIME.size, 280)][:5]
    _, penalties, _ = constraints(Context(schedule_of(FIGURE, gait(WALK, 0.7).keys, GROUND, "walk"), "walk"), {})
    off = {}
    for some in (penalties, [(p, w) for p, w in penalties if p.name != "cycle"]):
        motion = inbetween(Problem(FIGURE, keys, some, Settings(frames=8, tolerance=1e-2)))
        reached = TIME[keys[-1].time >= TIME][::20]
        found = motion.at(reached)[:, FIGURE.tables.quaternion_columns.T]
        real = WALK[: 20 * reached.size : 20][:, FIGURE.tables.quaternion_columns.T]
        off[len(some)] = np.degrees(quat.angle_between(found, real).mean())
        met = motion.at([key.time for key in keys])[:, FIGURE.tables.quaternion_columns.T]
        wanted = np.array([key.state for key in keys])[:, FIGURE.tables.quaternion_columns.T]
        assert quat.angle_between(met, wanted).max() < 1e-6
    assert off[len(penalties)] < 0.6 * off[len(penalties) - 1]


def test_the_path_to_begin_with_is_the_cycle_at_variable_frames_and_keeps_the_keyframes():
    seen = gait(WALK, 0.7)
    gait_cycle = seen.infer()
    assert gait_cycle is not None and len(SOLES) == 4
    cycle = penalty.Cycle(FIGURE, gait_cycle)
    initial_guess = cycle.initial_guess(seen.keys, None)
    spacing = gait_cycle.period / 8
    needed = sum(int(np.ceil(span / spacing - 1e-9)) - 1 for span in np.diff(seen.keys.times))
    assert initial_guess.variable_count == needed
    assert np.diff(initial_guess.times).max() <= 1.001 * spacing
    fixed = [frame for frame in initial_guess.frames if not frame.is_variable]
    np.testing.assert_array_equal([f.state for f in fixed], seen.keys.states)
    loose = np.array([frame.state for frame in initial_guess.frames if frame.is_variable])
    times = np.array([frame.time for frame in initial_guess.frames if frame.is_variable])
    off = cycle.evaluate(Samples(FIGURE, loose, 0 * loose, 0 * loose, times))
    assert np.degrees(np.sqrt(off.max())) < 0.1
    turns = FIGURE.tables.quaternion_columns.T
    assert np.einsum("tqi,tqi->tq", loose[:, turns], path_of(seen.keys).at(times)[:, turns]).min() > 0
    for present in (0, 5):
        keys = evenly(seen.keys, present)
        assert cycle.initial_guess(keys, 0).variable_count == keys.variable_count


TIMES = np.linspace(0, 2, 61)


def near(figure: Figure, rng: np.random.Generator) -> penalty.TrackingPenalty:
    states = figure.to_state(figure.model.qpos0 + 0.3 * np.sin(3 * TIMES[:, None] + rng.uniform(0, 6, figure.width)))
    return penalty.TrackingPenalty(Track(figure, TIMES, states, np.ones_like(states)))


def around(figure: Figure, rng: np.random.Generator, count: int) -> tuple[penalty.TrackingPenalty, Samples]:
    """A recording, and samples at times of it that are not its own."""
    found = near(figure, rng)
    return found, at_times(random_samples(figure, rng, count), rng.uniform(0.1, 1.9, count))


def test_the_value_is_that_of_differences_from_scipys_spline_and_mujocos_places(figure, rng):
    found, samples = around(figure, rng, 4)
    curve = CubicSpline(TIMES, found.recorded.bridged, bc_type="natural")
    weights = found._at(samples.t).weights
    links, _ = found.ends

    def places(state: np.ndarray) -> np.ndarray:
        data = kinematics(figure.model, figure.to_qpos(state[None])[0])
        bodies = [figure.links[link].body for link in links]
        arms = zip(bodies, found.ends[1].T, strict=True)
        return np.array([data.xpos[b] + data.xmat[b].reshape(3, 3) @ offset for b, offset in arms])

    for s, t in enumerate(samples.t):
        target = [curve(t), curve(t, 1), curve(t, 2)]
        for columns in figure.tables.quaternion_columns.T:
            if target[0][columns] @ samples.y[s, columns] < 0:
                for part in target:
                    part[columns] *= -1
        off = [part[s] - own for part, own in zip((samples.y, samples.y_d, samples.y_dd), target, strict=True)]
        value = sum(float(w[s] @ d**2) for w, d in zip(weights, off, strict=True))
        away = places(samples.y[s]) - places(target[0])
        value += float(np.sum(away**2)) / (2 * STRAYS**2 * BACK)
        np.testing.assert_allclose(found.evaluate(samples)[s], value, rtol=1e-7)


def test_next_to_an_edit_poses_hardly_count_and_smoothly_more_until_its_width_where_all_of_them_does(figure, rng):
    plain = near(figure, rng)
    eased = penalty.TrackingPenalty(plain.recorded, ((1.0, 0.4),))
    t = np.linspace(0.5, 1.5, 101)
    whole, held = plain._at(t).weights, eased._at(t).weights
    share = held[0] / whole[0]
    np.testing.assert_allclose(share, np.repeat(share[:, :1], figure.width, axis=1))
    share = share[:, 0]
    at = dict(zip(np.round(t, 2).tolist(), share.tolist(), strict=True))
    assert at[1.0] == pytest.approx(EASED)
    assert at[0.8] == pytest.approx(at[1.2]) == pytest.approx((1 + EASED) / 2)
    np.testing.assert_allclose(share[np.abs(t - 1) > 0.4 - 1e-9], 1)
    assert np.all(np.diff(share[t >= 1]) >= -1e-12)
    assert np.abs(np.diff(share)).max() < 1.6 * 0.01 / 0.4  # no jumps: half as steep again as a straight line
    np.testing.assert_array_equal(held[1:], whole[1:])


def test_it_leads_variable_frames_to_the_recording_and_no_others(figure, rng):
    found = near(figure, rng)
    state, wanted = figure.to_state(figure.model.qpos0[None])[0], found.recorded.path.at([1.0])[0]
    columns = figure.tables.quaternion_columns
    signs = np.where(np.sum(state[columns] * wanted[columns], axis=0) < 0, -1, 1)
    for flip in (1, -1):  # quaternions have the signs of the timeline's
        start, expected = np.array(state), np.array(wanted)
        start[columns] *= flip
        expected[columns] *= flip * signs
        frames = [Frame.key(0.0, start), Frame.variable(1.0, start), Frame.key(2.0, start)]
        initial_guess = found.initial_guess(Timeline(tuple(frames), np.zeros((2, figure.width))), None)
        np.testing.assert_allclose(initial_guess.frames[1].state, expected)
        assert all(np.array_equal(initial_guess.frames[k].state, start) for k in (0, 2))
