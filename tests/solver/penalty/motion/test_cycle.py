"""The cycle's soft constraint: value by SciPy, gradient, curvature, and what it does to a walk with few keyframes."""

from dataclasses import replace

import numpy as np
import pytest
from curvature_of import assert_squares
from even_frames import evenly
from figures import HUMAN_AND_CHAINS, figure_of
from gaits import FIGURE, GROUND, SOLES, TIME, WALK, gait
from penalty_slope import penalty_slope
from random_samples import random_samples
from scipy.spatial.transform import Rotation

from dynsplines.clip.build import constraints
from dynsplines.clip.context import Context
from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts.gait_period import Gait
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Cycle
from dynsplines.solver.problem import Problem, Settings

LYING = """<mujoco><worldbody><body pos="0 0 1" quat=".7071 .7071 0 0"><freejoint/><geom size=".1"/>
  <body pos="0 -.3 0" quat=".8 0 .6 0"><joint type="ball"/><geom size=".1" pos="0 -.1 0"/></body>
</body></worldbody></mujoco>"""
LAIN = [(LYING, "world"), (LYING, "joint")]  # whose model has its root turned


@pytest.fixture(
    params=[*HUMAN_AND_CHAINS, *LAIN],
    ids=["human", "human, joints", "fixed balls", "fixed ball and hinge", "turned root", "turned root, joints"],
)
def cycled(request, rng) -> Cycle:
    text, coordinates = request.param
    figure = figure_of(text, coordinates)
    keys = [Frame.key(0.3 * k, qpos) for k, qpos in enumerate(figure.to_qpos(random_samples(figure, rng, 6).y))]
    gait_cycle = Gait(figure, raw_timeline(figure, keys), (), ()).with_period(0.7)
    assert gait_cycle is not None and gait_cycle.trust.max() > 0
    return Cycle(figure, gait_cycle)


def at_its_times(cycle: Cycle, rng: np.random.Generator, count: int) -> tuple[Samples, np.ndarray]:
    """Random samples at some of the times that the gait cycle covers, and which."""
    some = rng.choice(cycle.gait_cycle.times.size, count, replace=False)
    seen = random_samples(cycle.figure, rng, count)
    return Samples(seen.figure, seen.y, seen.y_d, seen.y_dd, cycle.gait_cycle.times[some]), some


def residuals(cycle: Cycle, y: np.ndarray, some: np.ndarray) -> np.ndarray:
    """How far joints, hinges and the root's height are off, (S, r), the trust aside."""
    figure, gait_cycle = cycle.figure, cycle.gait_cycle
    qpos, out = figure.to_qpos(y), []
    for i, link in enumerate(figure.tables.quaternion_links):
        own = qpos[:, quaternion_columns(figure.links[link])]
        off = Rotation.from_quat(np.roll(gait_cycle.rotations[some, i], -1, 1)).inv()
        out.append(2 * (off * Rotation.from_quat(np.roll(own, -1, 1))).as_quat(canonical=True)[:, :3])
    out.append(qpos[:, figure.tables.hinge_columns] - gait_cycle.angles[some])
    out.append(gait_cycle.poses.map.up * (qpos[:, figure.tables.position_columns[2]] - gait_cycle.heights[some]))
    return np.hstack(out)


def test_the_deviation_is_the_angle_by_which_joints_are_off(cycled, rng):
    samples, some = at_its_times(cycled, rng, 5)
    halves = (
        residuals(cycled, samples.y, some)[:, : 3 * cycled.figure.tables.quaternion_links.size].reshape(5, -1, 3) / 2
    )
    np.testing.assert_allclose(cycled.deviation(samples).T, 2 * np.arcsin(np.linalg.norm(halves, axis=2)), rtol=1e-6)


def test_the_gradient_has_taylor_slope_two(cycled, rng):
    assert penalty_slope(cycled, at_its_times(cycled, rng, 5)[0], rng) > 1.95


def test_it_and_its_curvature_are_squares_of_how_far_joints_are_off(cycled, rng):
    samples, some = at_its_times(cycled, rng, 3)
    trust = np.sqrt(cycled.gait_cycle.trust[some])[:, None]
    assert_squares(cycled, lambda seen: trust * residuals(cycled, seen.y, some), samples, rng)


@pytest.mark.slow
def test_a_walk_with_few_keyframes_is_nearer_to_the_real_one_and_goes_through_them():
    keys = [Frame.key(TIME[k], WALK[k]) for k in range(0, TIME.size, 280)]
    penalties = constraints(Context.of(FIGURE, gait(WALK, 0.7).keys, GROUND, "walk"), {}).penalties
    off = {}
    for some in (penalties, [(p, w) for p, w in penalties if p.name != "cycle"]):
        motion = inbetween(Problem(FIGURE, keys, some, Settings(frames=30, tolerance=1e-2)))
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
    cycle = Cycle(FIGURE, gait_cycle)
    initial_guess = cycle.initial_guess(seen.keys, None)
    spacing = gait_cycle.period / 8
    needed = sum(int(np.ceil(span / spacing - 1e-9)) - 1 for span in np.diff(seen.keys.times))
    assert initial_guess.variable_count == needed
    assert np.diff(initial_guess.times).max() <= 1.001 * spacing
    fixed = [frame for frame in initial_guess.frames if not frame.is_variable]
    np.testing.assert_array_equal([f.state for f in fixed], seen.keys.states)
    loose = np.array([frame.state for frame in initial_guess.frames if frame.is_variable])
    times = np.array([frame.time for frame in initial_guess.frames if frame.is_variable])
    off = cycle.deviation(Samples(FIGURE, loose, 0 * loose, 0 * loose, times))
    assert np.degrees(off.max()) < 0.1
    turns = FIGURE.tables.quaternion_columns.T
    assert np.einsum("tqi,tqi->tq", loose[:, turns], path_of(seen.keys).at(times)[:, turns]).min() > 0
    for present in (0, 5):
        keys = evenly(seen.keys, present)
        assert cycle.initial_guess(keys, 0).variable_count == keys.variable_count


def test_what_it_leads_with_is_as_long_as_the_clip_though_the_last_keyframe_fixes_nothing():
    seen = gait(WALK, 0.7)
    *before, last = seen.keys.frames
    keys = replace(seen.keys, frames=(*before, Frame.variable(last.time, last.state)))
    gait_cycle = seen.infer()
    assert gait_cycle is not None
    initial_guess = Cycle(FIGURE, gait_cycle).initial_guess(keys, None)
    np.testing.assert_array_equal(initial_guess.times[[0, -1]], keys.times[[0, -1]])
    np.testing.assert_array_equal(initial_guess.frames[-1].state, last.state)
