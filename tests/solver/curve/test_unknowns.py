"""Frames, timelines and their unknowns."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, BALL_TREE, figure_of
from random_models import TIMES, distance_from_key, evenly, mask_without, masks_by_name, random_keys
from scipy.interpolate import CubicSpline

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.spline import Path, Spline, path_of
from dynsplines.solver.curve.unknowns import Unknowns, raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration, RootAcceleration, Torque, UnitMagnitude

KINDS = [
    "whole",
    "a joint free, what hangs on it fixed",
    "root orientation free",
    "root position free on single axes",
    "any",
]


def prepared(figure: Figure, keys: list[Frame], ends: str, rng: np.random.Generator) -> Timeline:
    slope = rng.normal(size=(2, figure.width)) if ends == "clamped" else None
    return evenly(raw_timeline(figure, keys, ends, slope), 1)


def random_x(unknowns: Unknowns, rng: np.random.Generator) -> np.ndarray:
    x = rng.normal(size=unknowns.size)
    return 10 * x / np.linalg.norm(x) if x.size else x


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
@pytest.mark.parametrize("kind", KINDS)
def test_every_x_meets_the_keyframes_the_start_is_the_timeline_and_the_map_has_its_transpose(figure, rng, kind, ends):
    keys = random_keys(figure, rng, masks_by_name(figure, kind, rng))
    if ends == "periodic":
        last = Frame.key(TIMES[-1], keys[0].state, keys[0].fixed & keys[-1].fixed)
        keys[-1] = last
    timeline = prepared(figure, keys, ends, rng)
    unknowns = Unknowns.of(figure, timeline)
    for _ in range(2):
        path = Path(Spline(timeline.times, ends), unknowns.rows(x := random_x(unknowns, rng)))
        for key, state in zip(keys, path.at(TIMES), strict=True):
            assert distance_from_key(figure, state, key) <= 1e-12
    np.testing.assert_allclose(unknowns.rows(unknowns.start), timeline.rows, atol=1e-11)
    np.testing.assert_allclose(Unknowns.of(figure, timeline.with_rows(path.rows)).start, x, atol=1e-12)
    x, g = rng.normal(size=unknowns.size), rng.normal(size=timeline.rows.shape)
    linear = unknowns.rows(x) - unknowns.rows(0 * x)
    np.testing.assert_allclose(np.sum(g * linear), unknowns.pulled_back(g) @ x, rtol=1e-11, atol=1e-11)
    assert unknowns.size > 0


def test_x_holds_the_unfixed_entries_and_the_free_end_slopes_and_nothing_else(figure, rng):
    keys = random_keys(figure, rng, {1: mask_without(figure, "root x", "root turn")})
    raw, width = raw_timeline(figure, keys), figure.width
    assert Unknowns.of(figure, raw).size == 5 + 2 * width
    assert Unknowns.of(figure, evenly(raw, 2)).size == 5 + 2 * width + 6 * width
    clamped = raw_timeline(figure, keys, "clamped", np.zeros((2, width)))
    assert Unknowns.of(figure, clamped).size == 5
    unknowns = Unknowns.of(figure, evenly(raw, 1))
    assert unknowns.row_of.shape == (unknowns.size,)
    np.testing.assert_array_equal(unknowns.rows(unknowns.start).ravel()[unknowns.place], unknowns.start)


def test_the_raw_timeline_of_whole_keyframes_is_the_natural_spline(figure, rng):
    raw = raw_timeline(figure, random_keys(figure, rng))
    np.testing.assert_allclose(path_of(raw).at([TIMES[0], TIMES[-1]], 2), 0, atol=1e-9)
    for columns in figure.tables.quaternion_columns.T:
        track = raw.states[:, columns]
        np.testing.assert_allclose(np.linalg.norm(track, axis=1), 1, atol=1e-12)
        assert np.all(np.sum(track[1:] * track[:-1], axis=1) >= 0)


def test_an_entry_missing_from_one_keyframe_starts_on_the_spline_of_its_neighbours(figure, rng):
    keys = random_keys(figure, rng, {1: mask_without(figure, "root z")})
    raw = raw_timeline(figure, keys)
    others = [0, 2, 3]
    times = np.array(TIMES)
    expected = CubicSpline(times[others], [keys[i].state[2] for i in others], bc_type="natural")(times[1])
    np.testing.assert_allclose(raw.states[1, 2], expected, atol=1e-12)


def test_what_no_keyframe_says_starts_at_the_rest_pose(figure, rng):
    joint = figure.links[2].name
    mask = mask_without(figure, "root", "root x", "root y", "root z", joint)
    raw = raw_timeline(figure, random_keys(figure, rng, dict.fromkeys(range(4), mask)))
    rest = np.array(figure.model.qpos0)
    for qpos in figure.to_qpos(raw.states):
        np.testing.assert_allclose(qpos[~mask], rest[~mask], atol=1e-12)


def test_a_half_fixed_quaternion_is_refused_by_place_and_name(figure, rng):
    mask = np.ones(figure.width, bool)
    mask[4] = False
    keys = random_keys(figure, rng, {1: mask})
    with pytest.raises(TimelineError, match=r"keyframe 2 \(t = 0\.4 s\): the quaternion of 'root' is fixed in part"):
        raw_timeline(figure, keys)


def test_a_zero_quaternion_is_refused_unless_it_is_left_out(figure, rng):
    keys = random_keys(figure, rng)
    state = keys[2].state.copy()
    state[3:7] = 0
    keys[2] = Frame.key(keys[2].time, state)
    with pytest.raises(TimelineError, match=r"keyframe 3 \(t = 1 s\): the quaternion of 'root' is zero"):
        raw_timeline(figure, keys)
    keys[2] = Frame.key(keys[2].time, state, mask_without(figure, "root"))
    assert np.all(np.isfinite(raw_timeline(figure, keys).rows))


def test_a_state_of_the_wrong_width_is_refused(figure):
    keys = [Frame.key(t, np.ones(figure.width + 1)) for t in TIMES]
    with pytest.raises(TimelineError, match=f"keyframe 1 .*: {figure.width + 1} entries, .* qpos has {figure.width}"):
        raw_timeline(figure, keys)


def test_clamped_ends_without_slopes_and_unknown_ends_are_refused(figure, rng):
    keys = random_keys(figure, rng)
    with pytest.raises(TimelineError, match="clamped ends need end_slope of shape"):
        raw_timeline(figure, keys, "clamped")
    with pytest.raises(TimelineError, match="clamped ends need end_slope of shape"):
        raw_timeline(figure, keys, "clamped", np.zeros(3))
    with pytest.raises(TimelineError, match="not one of 'free', 'clamped', 'clamped start', 'clamped end', 'periodic'"):
        raw_timeline(figure, keys, "looped")


def test_a_quaternion_laid_on_the_other_hemisphere_takes_its_clamped_slope_along(figure, rng):
    keys, slope = random_keys(figure, rng), rng.normal(size=(2, figure.width))
    mirrored, mirrored_slope = keys[-1].state.copy(), slope.copy()
    mirrored[3:7] *= -1
    same = raw_timeline(figure, keys, "clamped", slope)
    signs = np.ones(figure.width)
    before = figure.to_state(keys[-1].state)
    after = figure.to_state(mirrored)
    for columns in figure.tables.quaternion_columns.T:
        signs[columns] = np.sign(before[columns] @ after[columns])
    mirrored_slope[1] *= signs
    assert (signs < 0).any()
    flipped = raw_timeline(figure, [*keys[:-1], Frame.key(keys[-1].time, mirrored)], "clamped", mirrored_slope)
    np.testing.assert_allclose(flipped.rows, same.rows, atol=1e-12)


def test_a_clamped_turn_by_more_than_half_a_circle_ends_with_its_slope():
    figure = figure_of(BALL)
    turns = [quat.from_rotation_vector([0, 0, np.radians(angle)]) for angle in (0, 100, 200, 300)]
    keys = [Frame.key(float(i), [0, 0, 1, *turn]) for i, turn in enumerate(turns)]
    slope = np.zeros((2, 7))
    slope[1, 3:] = quat.product(turns[-1], np.array([0, 0, 0, 0.5]))
    path = path_of(raw_timeline(figure, keys, "clamped", slope))
    np.testing.assert_allclose(path.at(np.array([0.0, 3.0]), 1), slope, atol=1e-12)


def test_a_loop_closes_whatever_the_length_and_sign_of_its_quaternions(figure, rng):
    keys = random_keys(figure, rng)
    state = keys[0].state.copy()
    for columns in figure.tables.quaternion_columns.T:
        state[columns] *= -2.5
    keys[-1] = Frame.key(TIMES[-1], state)
    raw = raw_timeline(figure, keys, "periodic")
    np.testing.assert_allclose(figure.to_qpos(raw.states[-1])[:3], keys[0].state[:3], atol=1e-12)


def test_the_objective_does_not_feel_the_sign_of_a_whole_track(figure, rng):
    penalties = (CovariantAcceleration(), UnitMagnitude(), RootAcceleration(), Torque())
    objective = Objective.of(figure, [(penalty, 1.0) for penalty in penalties])
    path = path_of(raw_timeline(figure, random_keys(figure, rng)))
    expected = objective.value(path)
    for columns in figure.tables.quaternion_columns.T:
        rows = path.rows.copy()
        rows[:, columns] *= -1
        np.testing.assert_allclose(objective.value(Path(path.spline, rows)), expected, rtol=1e-10)


@pytest.mark.parametrize("degrees", [150.0, 182.0])
def test_a_joint_that_hardly_turns_stays_put_while_the_whole_figure_turns_half_round(degrees):
    figure = figure_of(BALL_TREE, "world")
    shoulder = figure.model.joint("shoulder").qposadr[0]
    keys = []
    for time, turn, bend in ((0.0, 0.0, -4.0), (1.0, degrees, 4.0)):
        qpos = np.array(figure.model.qpos0)
        qpos[3:7] = quat.from_rotation_vector([0, 0, np.radians(turn)])
        qpos[shoulder : shoulder + 4] = quat.from_rotation_vector([0, 0, np.radians(bend)])
        keys.append(Frame.key(time, qpos))
    path = path_of(raw_timeline(figure, keys))
    along = figure.to_qpos(path.at(np.linspace(0, 1, 50)))[:, shoulder : shoulder + 4]
    assert np.degrees(quat.angle_between(along, [1.0, 0, 0, 0])).max() < 15


SLOPE = np.arange(6.0).reshape(2, 3)


def three_frames() -> tuple[Frame, ...]:
    return (Frame.key(0.0, [1, 2, 3]), Frame.key(0.5, [4, 5, 6], [True, False, False]), Frame.variable(1.25, [7, 8, 9]))


def keys_at(*times: float) -> Timeline:
    return Timeline(tuple(Frame.key(t, [1, 2, 3]) for t in times), SLOPE)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: keys_at(0.0), "at least 2 frames, not 1"),
        (lambda: keys_at(), "at least 2 frames, not 0"),
        (lambda: keys_at(0.0, 2.0, 1.0), "frame 3 is at t = 1 s, not after frame 2 at t = 2 s"),
        (lambda: keys_at(0.0, 1.0, 1.0), "frame 3 is at t = 1 s, not after frame 2 at t = 1 s"),
        (lambda: Timeline((Frame.key(0, [1, 2]), Frame.key(1, [1, 2, 3])), SLOPE), r"different lengths: \[2, 3\]"),
        (lambda: Timeline(three_frames(), SLOPE[:, :2]), r"\(2, 2\), not \(2, 3\)"),
        (lambda: Timeline(three_frames(), SLOPE, "loop"), "'loop': not one of 'free', 'clamped', 'clamped start'"),
        (lambda: Timeline(three_frames(), SLOPE).with_rows(np.zeros((3, 3))), r"\(3, 3\), not \(5, 3\)"),
    ],
)
def test_frames_that_make_no_timeline_are_refused(make, text):
    with pytest.raises(TimelineError, match=text):
        make()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_entries_and_times_that_are_no_numbers_are_refused(bad):
    with pytest.raises(TimelineError, match=r"t = 0\.5 s holds entries that are not finite"):
        Frame.key(0.5, [1, bad, 3])
    with pytest.raises(TimelineError, match="not finite"):
        Frame.key(bad, [1, 2, 3])


@pytest.mark.parametrize(
    ("state", "fixed"), [([1, 2, 3], [True, False]), ([[1, 2]], [[True, True]]), (1.0, True), ([1.0], True)]
)
def test_a_state_and_a_mask_that_are_no_vectors_of_one_length_are_refused(state, fixed):
    with pytest.raises(TimelineError, match="must be vectors of one length"):
        Frame(0.0, np.array(state), np.array(fixed))


def test_no_array_of_a_frame_or_a_timeline_can_be_written_to():
    timeline = Timeline(three_frames(), SLOPE)
    frame = timeline.frames[0]
    arrays = [frame.state, frame.fixed, timeline.end_slope, timeline.times, timeline.states, timeline.fixed]
    for array in [*arrays, timeline.rows]:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0


def test_a_frame_does_not_follow_the_array_it_was_made_from():
    state, mask = np.array([1.0, 2, 3]), np.array([True, False, True])
    frame = Frame.key(0, state, mask)
    state[:], mask[:] = 9, False
    np.testing.assert_array_equal(frame.state, [1, 2, 3])
    np.testing.assert_array_equal(frame.fixed, [True, False, True])


def test_inserted_frames_fall_in_order_of_time_and_the_old_timeline_stays():
    timeline = Timeline(three_frames(), SLOPE, "clamped")
    more = timeline.inserted([Frame.variable(1.0, [0, 0, 0]), Frame.variable(0.25, [1, 1, 1])])
    np.testing.assert_array_equal(more.times, [0, 0.25, 0.5, 1.0, 1.25])
    np.testing.assert_array_equal(more.states[[0, 2, 4]], timeline.states)
    np.testing.assert_array_equal(more.states[[1, 3]], [[1, 1, 1], [0, 0, 0]])
    np.testing.assert_array_equal(more.end_slope, SLOPE)
    assert more.ends == "clamped"
    assert (more.variable_count, timeline.variable_count) == (3, 1)
    assert len(timeline.frames) == 3


def test_many_frames_are_the_frames_one_by_one_and_no_less_strict():
    states, fixed = np.arange(6.0).reshape(3, 2), np.eye(3, 2) > 0
    for frame, t, state, mask in zip(Frame.many([0, 1, 2], states, fixed), (0.0, 1.0, 2.0), states, fixed, strict=True):
        assert isinstance(frame.time, float)
        assert frame.time == t
        np.testing.assert_array_equal(frame.state, state)
        np.testing.assert_array_equal(frame.fixed, mask)
        assert not frame.state.flags.writeable
        assert not frame.fixed.flags.writeable
    states[1, 1] = np.nan
    with pytest.raises(TimelineError, match="t = 1 s holds entries that are not finite"):
        Frame.many([0, 1, 2], states, fixed)
    with pytest.raises(TimelineError, match="do not match"):
        Frame.many([0, 1], np.zeros((3, 2)), fixed)
