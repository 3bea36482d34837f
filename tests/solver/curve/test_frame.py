"""Frames and timelines: what they refuse, and that nobody can change them."""

import numpy as np
import pytest

from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError

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
