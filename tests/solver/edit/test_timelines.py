"""Edits that keep the curve, and a second motion after a first, with a transition that takes over y, y' and y''."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import BALL, BALL_TREE, TINY, figure_of
from gradients import RESIDUALS, SMOOTH, assert_dense, every_penalty, taylor_slope
from hypothesis import example, given, settings
from hypothesis import strategies as st
from oracles import kinematics
from problems import HOP_TERMS as TERMS
from problems import PERIOD, hop, loop
from random_models import TIMES, evenly, random_keys, random_qpos

from dynsplines.scene.compose import figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns
from dynsplines.solver.edit import timelines
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.search.descent import optimise
from dynsplines.solver.tolerances import ROUNDING

FIGURE_OF_A_HOP = figure_of(TINY)
FIGURE = figure_of(BALL_TREE)
ENDS = ["free", "clamped", "periodic"]
FIRST, LAST = TIMES[0], TIMES[-1]


def random_timeline(seed: int, ends: str) -> Timeline:
    """Some motion with variable frames off the raw spline."""
    rng = np.random.default_rng(seed)
    keys = random_keys(FIGURE, rng)
    if ends == "periodic":
        keys[-1] = Frame.key(LAST, keys[0].state + np.array([0.7, -0.2, *np.zeros(FIGURE.width - 2)]))
    slope = rng.normal(size=(2, FIGURE.width)) if ends == "clamped" else None
    timeline = evenly(raw_timeline(FIGURE, keys, ends, slope), 1)
    unknowns = Unknowns.of(FIGURE, timeline)
    return timeline.with_rows(unknowns.rows(unknowns.start + 0.05 * rng.normal(size=unknowns.size)))


def assert_close(got: np.ndarray, wanted: np.ndarray) -> None:
    assert np.abs(got - wanted).max() <= 1e-9 * max(1.0, np.abs(wanted).max())


@settings(deadline=None, max_examples=30)
@given(st.integers(0, 1000), st.sampled_from(ENDS), st.floats(0.02, 50))
def test_a_retimed_motion_is_the_motion_at_other_times(seed, ends, speed):
    timeline = random_timeline(seed, ends)
    fast = timelines.retime(timeline, speed)
    t = np.linspace(FIRST, LAST, 37)
    at = np.clip(FIRST + (t - FIRST) / speed, *path_of(fast).span)
    for order in range(3):
        assert_close(path_of(fast).at(at, order) / speed**order, path_of(timeline).at(t, order))
    assert fast.times[0] == FIRST
    np.testing.assert_allclose(np.diff(fast.times) * speed, np.diff(timeline.times), rtol=1e-12)
    np.testing.assert_array_equal(fast.fixed, timeline.fixed)
    assert fast.ends == ends
    assert_close(timelines.retime(fast, 1 / speed).rows, timeline.rows)


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 1000), st.sampled_from(ENDS), st.floats(FIRST, LAST), st.floats(FIRST, LAST))
@example(0, "free", TIMES[1] + ROUNDING / 2, TIMES[2] - ROUNDING / 2)
@example(0, "free", TIMES[1] - ROUNDING / 2, TIMES[2] + ROUNDING / 2)
def test_a_trimmed_motion_is_the_same_inside(seed, ends, a, b):
    timeline = random_timeline(seed, ends)
    first, last = min(a, b), max(a, b)
    if last - first < 1e-3:
        last = first + 1e-3 if first < 1 else last
        first = last - 1e-3
    part = timelines.trim(timeline, first, last)
    t = np.linspace(*path_of(part).span, 37)
    np.testing.assert_allclose(path_of(part).span, [first, last], rtol=0, atol=2e-9)
    assert_close(path_of(part).at(t), path_of(timeline).at(t))
    assert_close(path_of(part).at(t, 1), path_of(timeline).at(t, 1))
    assert part.ends == "free"
    assert part.frames[0].is_key
    assert part.frames[-1].is_key
    assert np.diff(part.times).min() > ROUNDING
    inside = [frame for frame in timeline.frames if part.times[0] < frame.time < part.times[-1]]
    assert list(part.frames[1:-1]) == inside


@pytest.mark.parametrize("way", ["straight", "spinning", "circle"])
@pytest.mark.parametrize("count", [1, 3])
def test_a_repeated_loop_continues_period_by_period(rng, way, count):
    figure = FIGURE_OF_A_HOP
    timeline = evenly(loop(figure, way), 1)
    unknowns = Unknowns.of(figure, timeline)
    timeline = timeline.with_rows(unknowns.rows(unknowns.start + 0.05 * rng.normal(size=unknowns.size)))
    many, seam = timelines.repeat(figure, timeline, count), Seam.of(figure, timeline)
    t = np.linspace(0, PERIOD, 41)
    for number in range(count):
        at = np.clip(t + PERIOD * number, 0, path_of(many).span[1])
        assert_close(path_of(many).at(at), seam.move(path_of(timeline).at(t), number))
        for order in (1, 2):
            assert_close(path_of(many).at(at, order), seam.linear(path_of(timeline).at(t, order), number))
    assert len(many.frames) == count * (len(timeline.frames) - 1) + 1
    assert Seam.of(figure, many).discontinuity(path_of(many)).max() < 1e-9
    first = timeline.states[0]
    np.testing.assert_allclose(Seam.of(figure, many).move(first), seam.move(first, count), atol=1e-12)
    fast = path_of(timelines.retime(many, 2.0))
    for order in range(3):
        assert_close(
            fast.at(np.append(t, many.times[-1]) / 2, order) / 2**order,
            path_of(many).at(np.append(t, many.times[-1]), order),
        )
    again = Unknowns.of(figure, many)
    np.testing.assert_allclose(again.rows(again.start), many.rows, atol=1e-9)


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda: timelines.retime(random_timeline(0, "free"), 0.0), "speed must be a number above 0"),
        (lambda: timelines.retime(random_timeline(0, "free"), np.nan), "speed must be a number above 0"),
        (lambda: timelines.trim(random_timeline(0, "free"), 0.5, 0.5), "ends after it begins"),
        (
            lambda: timelines.trim(random_timeline(0, "free"), 0.9, 0.3),
            "ends after it begins, not from 0.9 to 0.3 s",
        ),
        (lambda: timelines.trim(random_timeline(0, "free"), np.nan, 1.0), "ends after it begins"),
        (lambda: timelines.trim(random_timeline(0, "free"), -0.1, 0.5), "not inside 0 to 1.3 s"),
        (lambda: timelines.trim(random_timeline(0, "free"), 0.5, 1.31), "not inside"),
        (
            lambda: timelines.repeat(FIGURE, random_timeline(0, "clamped"), 2),
            "only a loop, .* can be repeated; these are 'cla",
        ),
        (lambda: timelines.repeat(FIGURE, random_timeline(0, "periodic"), 0), "at least once, not 0 times"),
    ],
)
def test_wrong_speeds_intervals_and_counts_are_refused(edit, words):
    with pytest.raises(TimelineError, match=words):
        edit()


LENGTH = 0.4


def sides(figure: Figure, rng: np.random.Generator) -> tuple[Timeline, Timeline]:
    """A motion, and another that begins a transition later, placed and signed to follow it."""
    settings = Settings(variable=2, frames=0)
    before = inbetween(Problem(figure, hop(2), TERMS, settings)).timeline
    after = inbetween(Problem(figure, random_keys(figure, rng), TERMS, settings)).timeline
    after = timelines.signed_like(
        figure, before, timelines.following(figure, before, after, LENGTH).timeline(figure, after)
    )
    shift = before.times[-1] + LENGTH - after.times[0]
    frames = tuple(replace(frame, time=frame.time + shift) for frame in after.frames)
    return before, Timeline(frames, after.end_slope)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_both_motions_keep_their_curves_and_the_whole_is_smooth_to_the_second_derivative(rng, coordinates):
    figure = figure_of(TINY, coordinates)
    before, after = sides(figure, rng)
    begin = timelines.bridge(figure, before, after, variable=5)
    objective = Objective.of(figure, TERMS).renormalise(path_of(begin))
    between = optimise(objective, begin)
    assert objective.value(path_of(between)) < 0.9 * objective.value(path_of(begin))
    whole = path_of(timelines.join(before, between, after))
    for part in (before, between, after):
        t = np.linspace(*path_of(part).span, 150)
        for order in range(3):
            wanted = path_of(part).at(t, order)
            assert np.abs(whole.at(t, order) - wanted).max() < 1e-9 * max(1, np.abs(wanted).max())
    for at in path_of(between).span:
        near, far = whole.at(at - 1e-7, 2), whole.at(at + 1e-7, 2)
        assert np.abs(near - far).max() < 1e-3 * np.abs(whole.at(np.linspace(*whole.span, 99), 2)).max()


def test_the_gradient_and_the_step_under_held_ends_are_exact(rng):
    figure = figure_of(TINY)
    begin = timelines.bridge(figure, *sides(figure, rng), variable=5)
    assert begin.variable_count == 5
    objective = Objective.of(figure, every_penalty(figure)).renormalise(path_of(begin))
    problem = objective.on(begin)
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9
    smooth = [(RESIDUALS[name][0], 1.0) for name in SMOOTH]
    assert_dense(Objective.of(figure, smooth).renormalise(path_of(begin)).on(begin), SMOOTH, x, rtol=1e-3)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_placed_figure_is_turned_and_shifted_as_a_whole(rng, coordinates):
    model = mujoco.MjModel.from_xml_string(BALL_TREE)
    figure = Figure(model, coordinates)
    place = timelines.Placement(quat.from_rotation_vector([0, 0, 0.7]), np.array([1.0, -2, 0]))
    qpos = random_qpos(figure, rng)
    turn = np.stack([quat.rotate(place.turn, e) for e in np.eye(3)], axis=1)
    before = kinematics(model, qpos)
    after = kinematics(model, figure.to_qpos(place.states(figure, figure.to_state(qpos))))
    np.testing.assert_allclose(after.xpos[1:], before.xpos[1:] @ turn.T + place.shift, atol=1e-9)
    rotations = (data.xmat[1:].reshape(-1, 3, 3) for data in (after, before))
    np.testing.assert_allclose(next(rotations), turn @ next(rotations), atol=1e-9)
    timeline = raw_timeline(figure, random_keys(figure, rng))
    t = np.linspace(0, 1.3, 30)
    wanted = place.states(figure, path_of(timeline).at(t))
    np.testing.assert_allclose(path_of(place.timeline(figure, timeline)).at(t), wanted, atol=1e-10)


def axes(q: Array) -> Array:
    """(3, 3) the rotation matrix of a unit quaternion."""
    return np.stack([quat.rotate(q, e) for e in np.eye(3)], axis=1)


def test_a_walk_continues_the_way_that_its_trunk_faces_whichever_foot_is_ahead():
    """At a step the pelvis turns 4 degrees one way and the chest as much the other: the walk goes straight on."""
    figure = Figure(figure_spec("human").compile())
    assert [figure.links[i].name for i in timelines.trunk(figure)] == ["root", "spine"]
    for way in (0.0, 1.2, -2.9):
        still = np.zeros((2, figure.width))
        before, after = Timeline(step(figure, 4.0, way), still), Timeline(step(figure, -4.0, 0.0), still)
        place = timelines.following(figure, before, after, LENGTH)
        np.testing.assert_allclose(timelines.heading(axes(place.turn)), way, atol=1e-9)


ARM_AND_BALL = """<mujoco><worldbody><body><joint axis="0 1 0"/><geom size=".1" pos="0 0 1"/></body>
<body><freejoint/><geom size=".1"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(("text", "moves"), [(TINY, True), (BALL, True), (ARM_AND_BALL, False)])
def test_a_motion_follows_at_the_mean_velocity_of_both_and_as_high_as_before(rng, text, moves):
    """Beside an arm on a base, everything stays."""
    figure = figure_of(text)
    place = figure.tables.position_columns[:, 0]
    before, after = (raw_timeline(figure, random_keys(figure, rng)) for _ in range(2))
    moved = timelines.following(figure, before, after, LENGTH).timeline(figure, after)
    if not moves:
        np.testing.assert_array_equal(moved.rows, after.rows)
        return
    (end, end_d), (start, start_d) = (
        path_of(part).motion(np.array([t]))[:2, 0, place]
        for part, t in ((before, before.times[-1]), (moved, moved.times[0]))
    )
    np.testing.assert_allclose(start[:2], (end + LENGTH * (end_d + start_d) / 2)[:2], atol=1e-12)
    assert start[2] == after.states[0, place[2]]


def step(figure: Figure, pelvis: float, way: float) -> tuple[Frame, Frame]:
    """Two frames of one pose, the pelvis turned by some degrees off its way [rad] and the chest as much back."""
    qpos, off = np.array(figure.model.qpos0), np.radians(pelvis)
    qpos[3:7] = quat.from_rotation_vector([0, 0, way + off])
    spine = next(link for link in figure.links if link.name == "spine")
    qpos[spine.qpos : spine.qpos + 4] = quat.from_rotation_vector([0, 0, -2 * off])
    state = figure.to_state(qpos)
    return Frame.key(0.0, state), Frame.key(1.0, state)
