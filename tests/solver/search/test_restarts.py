"""Searches that end in a poor local minimum are found, and the best of several paths is selected."""

import sys
from functools import cache

import numpy as np
import pytest
from figures import BALL_TREE, KNEE, ONE_BALL, SMOOTHNESS, UP, figure_of, limb, limits
from oracles import by_scipy, kinematics
from random_models import evenly, random_keys

from dynsplines.solver import Problem, Solution, inbetween
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Collision, Flight
from dynsplines.solver.search import restarts
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import Point
from dynsplines.solver.tolerances import ROUNDING

VERB = sys.modules["dynsplines.solver.inbetween"]  # the package has the verb under the module's name
LIMB = limb()
TERMS = [*SMOOTHNESS, (limits(KNEE), 1.0)]
HEAP = 41  # a seed whose first search ends with a knee behind itself


def swinging(seed: int) -> list[Frame]:
    """Keyframes at very uneven times, through which the spline swings a knee that is bent well at all of them."""
    rng, keys = np.random.default_rng(seed), []
    times = np.cumsum(np.append(0, np.exp(rng.uniform(np.log(0.03), np.log(1.0), 4))))
    for time in times:
        root = np.array([0, 0, 1.0, *quat.from_rotation_vector(0.8 * rng.normal(size=3))])
        knee = quat.from_rotation_vector([0, rng.uniform(0.1, 2.2), 0])
        keys.append(Frame.key(time, np.concatenate([root, knee])))
    return keys


@cache
def first_search(seed: int) -> Solution:
    """What comes out if nobody begins again."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(VERB, "is_poor_minimum", lambda *_: False)
        patch.setattr(VERB, "violation_dominates", lambda *_: False)
        patch.setattr(VERB, "cost_increased", lambda *_: False)
        patch.setattr(VERB, "is_pose_outlier", lambda *_: False)
        return inbetween(Problem(LIMB, swinging(seed), TERMS))


def value(motion: Solution) -> float:
    return motion.objective.value(motion.path)


def least_flexion(motion: Solution) -> float:
    """[degrees], of a knee that may fold by a little more than half a turn."""
    t = np.linspace(*motion.path.span, 500)
    flexion = np.degrees(limits(KNEE).angles(motion.objective.samples(motion.path, t))[0])
    return float(np.where(flexion < -150, flexion + 360, flexion).min())


# how it is known


def places(figure: Figure, qpos: Array) -> Array:
    """(T, b, 3) [m] of MuJoCo's bodies from the root."""
    places = np.array([kinematics(figure.model, row).xpos for row in qpos])
    return places[:, 1:] - places[:, 1:2]


@pytest.mark.parametrize(("coordinates", "count"), [("world", 2), ("joint", 4)])
def test_the_deviation_of_a_joint_from_the_straight_path_is_what_mujoco_computes(coordinates, count, rng):
    figure = figure_of(BALL_TREE.replace('<body name="pack" pos=".1 0 -.2">', "<body>"))
    assert figure.model.nbody == 6
    figure = Figure(figure.model, coordinates)
    keys = random_keys(figure, rng)[:count]
    timeline = evenly(raw_timeline(figure, keys), 1)
    rows = np.array(timeline.rows)
    rows[1::2] += 0.3 * rng.normal(size=rows[1::2].shape)
    timeline, times = timeline.with_rows(rows), np.array([key.time for key in keys])
    share = (np.arange(restarts.SAMPLES_PER_SEGMENT) + 0.5) / restarts.SAMPLES_PER_SEGMENT
    t = (times[:-1, None] + share * np.diff(times)[:, None]).ravel()
    ways = by_scipy(figure, times, figure.to_qpos(timeline.states[::2]), t)
    apart = places(figure, figure.to_qpos(path_of(timeline).at(t))) - places(figure, ways)
    size = np.linalg.norm(places(figure, figure.model.qpos0[None]), axis=2).max()
    found = restarts.largest_deviation(figure, timeline)
    np.testing.assert_allclose(found, np.linalg.norm(apart, axis=2).max() / size, rtol=1e-9)
    assert found > 0.1


@pytest.mark.slow
def test_a_limb_that_began_behind_its_knee_is_out_of_there_by_the_straight_way():
    keys, before = swinging(HEAP), first_search(HEAP)
    after = inbetween(Problem(LIMB, keys, TERMS))
    assert restarts.is_poor_minimum(before.objective, before.timeline, before.trace[-1][3])
    assert np.all(np.diff([entry[2] for entry in after.trace]) < 0)
    assert least_flexion(before) < -20
    assert least_flexion(after) > -1.5
    assert not restarts.violation_dominates(after.objective, after.trace[-1][3])
    assert value(after) < 0.1 * value(before)
    raw = evenly(raw_timeline(LIMB, keys), 2)
    assert restarts.largest_deviation(LIMB, raw) > restarts.MAX_DEVIATION
    assert after.trace[0][2] < 0.1 * after.objective.value(path_of(raw))
    fine = np.linspace(*after.path.span, 2000)
    assert after.objective.value(after.path, fine) < 0.5 * after.objective.value(path_of(after.raw), fine)


WALL = Collision((Point("hand", 2, np.zeros(3)),), (Box("wall", 9 * UP, np.eye(3), np.ones(3), buried=False),))


def test_a_minimum_is_poor_by_its_violations_and_by_the_cost_of_a_detour():
    """The cost of motion, of joints beyond their bounds, of an obstacle and of physics, relative to the raw spline."""
    smooth, limit = SMOOTHNESS[0][0].name, TERMS[-1][0].name
    plain = Objective.of(LIMB, [*TERMS, (Flight(1, (), 1.0, 1.0), 1.0)])
    walled = Objective.of(LIMB, [*TERMS, (WALL, 1.0)])
    raw = plain.raw_cost
    for motion in (0.5 * raw, 2 * raw):
        for share, poor in ((0.999, False), (1.001, True)):
            beyond = share * max(motion, raw)
            assert restarts.violation_dominates(plain, {smooth: motion, limit: beyond}) == poor
            assert restarts.violation_dominates(walled, {smooth: motion, WALL.name: beyond}) == poor
            assert not restarts.violation_dominates(plain, {smooth: motion, "flight": 9 * beyond})
    for share, increased in ((1.999, False), (2.001, True)):
        assert restarts.cost_increased(walled, {smooth: share * raw, limit: 9 * raw}) == increased
        assert restarts.cost_increased(walled, {smooth: raw, WALL.name: (share - 1) * raw}) == increased
        assert not restarts.cost_increased(plain, {smooth: share * raw})
    still = evenly(raw_timeline(LIMB, [Frame.key(t, LIMB.model.qpos0) for t in (0.0, 1.0)]), 1)
    for degrees, length, share, poor in (
        (40, 1.0, 0.0199, False),
        (40, 1.0, 0.0201, True),  # two per cent is a bound, and the limb is far from its straight path
        (20, 1.0, 0.4, False),
        (0, 1.99, 0.0, False),
        (0, 2.01, 0.0, True),
    ):
        rows = still.rows * np.where(np.arange(LIMB.width) < 3, 1.0, length)
        rows[1, 3:7] = length * quat.from_rotation_vector(np.radians([0, degrees, 0]))
        rows[1, 7:] = quat.product(rows[1, 3:7], [1, 0, 0, 0])
        assert restarts.is_poor_minimum(plain, still.with_rows(rows), {smooth: 5 - 5 * share, limit: 5 * share}) == poor


def test_keyframes_up_to_10_000_times_as_far_apart_as_their_neighbours_end_with_quaternions_near_unit_length():
    root = [0, 0, 1.0, 1, 0, 0, 0]
    knees = [quat.from_rotation_vector([0, np.radians(angle), 0]) for angle in (20, 21, 80)]
    raw, ours = [], []
    for apart in np.geomspace(1e-3, 0.1, 3):
        keys = [Frame.key(t, np.concatenate([root, q])) for t, q in zip((0, apart, 10 - apart), knees, strict=True)]
        motion = inbetween(Problem(LIMB, keys, TERMS))
        raw.append(restarts.longest_quaternion(LIMB, motion.raw))
        ours.append(restarts.longest_quaternion(LIMB, motion.timeline))
        assert motion.trace[-1][2] < 1e3
    assert raw[0] > restarts.MAX_QUATERNION_LENGTH
    assert np.median(ours) < 1.25 and max(ours) < 2


QUATERNIONS = figure_of(ONE_BALL).tables.quaternion_columns.T


def line(times: Array, start: Array, end: Array) -> Timeline:
    """Frames on the straight line between two quaternions as numbers, not as rotations: the spline through them."""
    share = (times - times[0]) / (times[-1] - times[0])
    states = start + share[:, None] * (end - start)
    frames = Frame.many(times, states, np.ones(states.shape, bool))
    return Timeline(tuple(frames), np.tile((end - start) / (times[-1] - times[0]), (2, 1)))


@pytest.mark.parametrize("short", [1e-2, 1e-3])
@pytest.mark.parametrize("where", [0.3, 0.71])
def test_about_the_moment_at_which_a_quaternion_passes_zero_are_samples_as_close_as_it_is_short(short, where):
    """On a line that passes nought at a distance the joint turns half round in about distance over speed."""
    aside = np.array([0, short, 0, 0])
    way = np.array([2.0, 0, 0, 0])
    timeline = line(np.array([1.0, 1.5, 3.0]), aside - where * way, aside + (1 - where) * way)
    edges = restarts.common_grid([timeline], QUATERNIONS)
    moment = 2.0 * short / 2.0  # [s] of a line that makes 2 in 2 s
    middle = 1.0 + 2.0 * where
    for about in restarts.OFFSETS:
        assert np.abs(edges - (middle + about * moment)).min() < 1e-9
    assert np.all(np.diff(edges) > ROUNDING / restarts.SUBDIVISIONS)
    assert edges[0] == 1.0
    assert edges[-1] == 3.0
    alone = restarts.common_grid([timeline])
    assert alone.size < edges.size
    np.testing.assert_allclose(alone[:: restarts.SUBDIVISIONS], [1, 1.5, 3])
