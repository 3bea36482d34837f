"""A second motion after a first: placed where that one goes on, with a transition that takes over y, y' and y''."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, TINY, figure_of
from gradients import RESIDUALS, SMOOTH, assert_dense, every_penalty, taylor_slope
from oracles import kinematics
from problems import HOP_TERMS as TERMS
from problems import hop
from random_models import evenly, random_keys, random_qpos

from dynsplines.scene.compose import figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns, raw_timeline
from dynsplines.solver.edit.join import Placement, bridge, following, heading, joined, signed_like, trunk
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.refine.subdivision import split
from dynsplines.solver.search.descent import optimised

LENGTH = 0.4
SPINE = """<mujoco><worldbody><body><freejoint name="root"/><geom size=".1"/>
  <body><joint name="leg" type="ball"/><geom size=".05"/></body>
  <body><joint name="waist" type="ball"/><geom size=".1"/><body><joint name="chest" type="ball"/><geom size=".1"/>
    <body><joint name="left" type="ball"/><geom size=".05"/></body>
    <body><joint name="right" type="ball"/><geom size=".05"/></body></body></body></body>
<body name="object"><freejoint/><geom size=".5"/><body><joint name="lid"/><geom size=".5"/></body>
  <body><joint name="drawer"/><geom size=".5"/></body></body></worldbody></mujoco>"""


def sides(figure: Figure, rng: np.random.Generator) -> tuple[Timeline, Timeline]:
    """A motion, and another that begins a transition later, placed and signed to follow it."""
    settings = Settings(variable=2, frames=0)
    before = inbetween(Problem(figure, hop(2), TERMS, settings)).timeline
    after = inbetween(Problem(figure, random_keys(figure, rng), TERMS, settings)).timeline
    after = signed_like(figure, before, following(figure, before, after, LENGTH).timeline(figure, after))
    shift = before.times[-1] + LENGTH - after.times[0]
    frames = tuple(replace(frame, time=frame.time + shift) for frame in after.frames)
    return before, Timeline(frames, after.end_slope)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_both_motions_keep_their_curves_and_the_whole_is_smooth_to_the_second_derivative(rng, coordinates):
    figure = figure_of(TINY, coordinates)
    before, after = sides(figure, rng)
    begin = bridge(figure, before, after, variable=5)
    objective = Objective.of(figure, TERMS).renormalised(path_of(begin))
    between = optimised(objective, begin)
    assert objective.value(path_of(between)) < 0.9 * objective.value(path_of(begin))
    whole = path_of(joined(before, between, after))
    for part in (before, between, after):
        t = np.linspace(*path_of(part).span, 150)
        for order in range(3):
            wanted = path_of(part).at(t, order)
            assert np.abs(whole.at(t, order) - wanted).max() < 1e-9 * max(1, np.abs(wanted).max())
    for at in path_of(between).span:
        near, far = whole.at(at - 1e-7, 2), whole.at(at + 1e-7, 2)
        assert np.abs(near - far).max() < 1e-3 * np.abs(whole.at(np.linspace(*whole.span, 99), 2)).max()


def test_the_ends_of_a_transition_are_held_for_every_x(rng):
    figure = figure_of(TINY)
    before, after = sides(figure, rng)
    begin = bridge(figure, before, after, variable=4)
    for timeline in (begin, evenly(begin, 1)):
        unknowns = Unknowns.of(figure, timeline)
        for x in (unknowns.start, unknowns.start + rng.normal(size=unknowns.size)):
            path = path_of(timeline.with_rows(unknowns.rows(x)))
            for order in range(3):
                for at, side in ((path.span[0], before), (path.span[1], after)):
                    wanted = path_of(side).at(at, order)
                    np.testing.assert_allclose(path.at(at, order), wanted, atol=1e-8 * max(1, np.abs(wanted).max()))
        np.testing.assert_allclose(unknowns.rows(unknowns.start), timeline.rows, atol=1e-11)
    finer = split(begin, np.array([begin.times[0] + 0.01, begin.times[-1] - 0.02]))
    t = np.linspace(*path_of(begin).span, 60)
    np.testing.assert_allclose(path_of(finer).at(t), path_of(begin).at(t), atol=1e-10)


def test_the_gradient_and_the_step_under_held_ends_are_exact(rng):
    figure = figure_of(TINY)
    begin = bridge(figure, *sides(figure, rng), variable=5)
    assert begin.variable_count == 5
    objective = Objective.of(figure, every_penalty(figure)).renormalised(path_of(begin))
    problem = objective.on(begin)
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9
    smooth = [(RESIDUALS[name][0], 1.0) for name in SMOOTH]
    assert_dense(Objective.of(figure, smooth).renormalised(path_of(begin)).on(begin), SMOOTH, x, rtol=1e-3)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_placed_figure_is_turned_and_shifted_as_a_whole(rng, coordinates):
    model = mujoco.MjModel.from_xml_string(BALL_TREE)
    figure = Figure(model, coordinates)
    place = Placement(quat.from_rotation_vector([0, 0, 0.7]), np.array([1.0, -2, 0]))
    qpos = random_qpos(figure, rng)
    turn = np.stack([quat.rotated(place.turn, e) for e in np.eye(3)], axis=1)
    before = kinematics(model, qpos)
    after = kinematics(model, figure.to_qpos(place.states(figure, figure.to_state(qpos))))
    np.testing.assert_allclose(after.xpos[1:], before.xpos[1:] @ turn.T + place.shift, atol=1e-9)
    rotations = (data.xmat[1:].reshape(-1, 3, 3) for data in (after, before))
    np.testing.assert_allclose(next(rotations), turn @ next(rotations), atol=1e-9)
    timeline = raw_timeline(figure, random_keys(figure, rng))
    t = np.linspace(0, 1.3, 30)
    wanted = place.states(figure, path_of(timeline).at(t))
    np.testing.assert_allclose(path_of(place.timeline(figure, timeline)).at(t), wanted, atol=1e-10)


def test_the_root_continues_in_its_heading_and_at_the_mean_of_both_velocities(rng):
    figure = figure_of(TINY)
    before, after = sides(figure, rng)
    end, start = before.states[-1], after.states[0]
    turned = heading(np.stack([axes(quat.normalised(state[3:7])) for state in (end, start)]))
    np.testing.assert_allclose(np.cos(turned[1] - turned[0]), 1, atol=1e-12)
    velocities = [path_of(before).at(before.times[-1], 1), path_of(after).at(after.times[0], 1)]
    np.testing.assert_allclose(start[:2] - end[:2], LENGTH * np.mean(velocities, axis=0)[0, :2], atol=1e-9)


def test_a_motion_that_follows_keeps_its_heights(rng):
    figure = figure_of(TINY)
    up = np.eye(figure.width)[2]
    low, high = ([Frame.key(key.time, key.state + z * up) for key in random_keys(figure, rng)] for z in (0.0, 2.0))
    before, after = raw_timeline(figure, low), raw_timeline(figure, high)
    place = following(figure, before, after, LENGTH)
    assert place.shift[2] == 0
    assert np.abs(place.shift[:2]).min() > 0.01
    np.testing.assert_allclose(place.timeline(figure, after).states[:, 2], after.states[:, 2], rtol=1e-12)


def test_of_two_free_bodies_the_first_says_where_a_motion_continues():
    one = '<body><freejoint/><geom size=".1"/></body>'
    figure = figure_of(f"<mujoco><worldbody>{one}{one}</worldbody></mujoco>")

    def moving(first: float, second: float) -> Timeline:
        """From 0 to 1 s, straight on along x at 1 m/s; the second body as fast along y."""
        states = [[first + t, 0, 1, 1, 0, 0, 0, 5, second + t, 1, 1, 0, 0, 0] for t in (0.0, 1.0)]
        slope = np.eye(14)[0] + np.eye(14)[8]
        return Timeline(tuple(Frame.key(float(t), state) for t, state in enumerate(states)), np.stack([slope, slope]))

    place = following(figure, moving(0.0, 0.0), moving(7.0, -3.0), LENGTH)
    np.testing.assert_allclose(place.turn, [1, 0, 0, 0], atol=1e-12)
    np.testing.assert_allclose(place.shift, [1 + LENGTH - 7, 0, 0], atol=1e-12)


def axes(q: Array) -> Array:
    """(3, 3) the rotation matrix of a unit quaternion."""
    return np.stack([quat.rotated(q, e) for e in np.eye(3)], axis=1)


def test_a_walk_continues_the_way_that_its_trunk_faces_whichever_foot_is_ahead():
    """At a step the pelvis turns 4 degrees one way and the chest as much the other: the walk goes straight on."""
    figure = Figure(figure_spec("human").compile())
    assert [figure.links[i].name for i in trunk(figure)] == ["root", "spine"]
    spine = figure_of(SPINE)
    assert [spine.links[i].name for i in trunk(spine)] == ["root", "chest"]
    for way in (0.0, 1.2, -2.9):
        still = np.zeros((2, figure.width))
        before, after = Timeline(step(figure, 4.0, way), still), Timeline(step(figure, -4.0, 0.0), still)
        place = following(figure, before, after, LENGTH)
        np.testing.assert_allclose(heading(axes(place.turn)), way, atol=1e-9)


def step(figure: Figure, pelvis: float, way: float) -> tuple[Frame, Frame]:
    """Two frames of one pose, the pelvis turned by some degrees off its way [rad] and the chest as much back."""
    qpos, off = np.array(figure.model.qpos0), np.radians(pelvis)
    qpos[3:7] = quat.from_rotation_vector([0, 0, way + off])
    spine = next(link for link in figure.links if link.name == "spine")
    qpos[spine.qpos : spine.qpos + 4] = quat.from_rotation_vector([0, 0, -2 * off])
    state = figure.to_state(qpos)
    return Frame.key(0.0, state), Frame.key(1.0, state)


def test_a_figure_that_stands_fixed_is_not_moved(rng):
    ball = figure_of('<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>')
    one, two = (raw_timeline(ball, random_keys(ball, rng)) for _ in range(2))
    np.testing.assert_array_equal(following(ball, one, two, 1.0).timeline(ball, two).rows, two.rows)


def test_a_transition_that_is_none_is_refused(rng):
    figure = figure_of(TINY)
    before, after = sides(figure, rng)
    with pytest.raises(TimelineError, match="takes time"):
        bridge(figure, before, before)
    now = replace(
        after, frames=tuple(replace(f, time=f.time - after.times[0] + before.times[-1]) for f in after.frames)
    )
    with pytest.raises(TimelineError, match="takes time"):
        bridge(figure, before, now)
    with pytest.raises(TimelineError, match="at least 4 variable frames, not 2"):
        bridge(figure, before, after, variable=2)
    begin = bridge(figure, before, after)
    ends = begin.frames[:2], begin.frames[-2:]
    assert len(Timeline(ends[0] + ends[1], begin.end_slope, "held").frames) == 4
    key = Frame.key(begin.times[1], begin.states[1]), Frame.key(begin.times[-2], begin.states[-2])
    for frames in (
        ends[0][:1] + ends[1][1:],
        ends[0] + ends[1][1:],
        (begin.frames[0], key[0], *begin.frames[2:]),
        (*begin.frames[:-2], key[1], begin.frames[-1]),
    ):
        with pytest.raises(TimelineError, match="held ends need a variable frame next to each end"):
            Timeline(frames, begin.end_slope, "held")
