"""Edits that keep the curve: retimed, trimmed and repeated timelines against samples of the one they came from."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL_TREE, TINY, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from problems import PERIOD, loop
from random_models import TIMES, evenly, random_keys

from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns, raw_timeline
from dynsplines.solver.edit.retime import repeated, retimed, trimmed

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
    fast = retimed(timeline, speed)
    t = np.linspace(FIRST, LAST, 37)
    at = np.clip(FIRST + (t - FIRST) / speed, *path_of(fast).span)
    for order in range(3):
        assert_close(path_of(fast).at(at, order) / speed**order, path_of(timeline).at(t, order))
    assert fast.times[0] == FIRST
    np.testing.assert_allclose(np.diff(fast.times) * speed, np.diff(timeline.times), rtol=1e-12)
    np.testing.assert_array_equal(fast.fixed, timeline.fixed)
    assert fast.ends == ends
    assert_close(retimed(fast, 1 / speed).rows, timeline.rows)


@pytest.mark.parametrize("speed", [0.0, -1.0, np.nan, np.inf])
def test_a_speed_that_is_none_is_refused(speed):
    with pytest.raises(TimelineError, match="speed must be a number above 0"):
        retimed(random_timeline(0, "free"), speed)


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 1000), st.sampled_from(ENDS), st.floats(FIRST, LAST), st.floats(FIRST, LAST))
def test_a_trimmed_motion_is_the_same_inside(seed, ends, a, b):
    timeline = random_timeline(seed, ends)
    first, last = min(a, b), max(a, b)
    if last - first < 1e-3:
        last = first + 1e-3 if first < 1 else last
        first = last - 1e-3
    part = trimmed(timeline, first, last)
    t = np.linspace(*path_of(part).span, 37)
    np.testing.assert_allclose(path_of(part).span, [first, last], rtol=0, atol=2e-9)
    assert_close(path_of(part).at(t), path_of(timeline).at(t))
    assert_close(path_of(part).at(t, 1), path_of(timeline).at(t, 1))
    assert part.ends == "free"
    assert part.frames[0].is_key
    assert part.frames[-1].is_key
    inside = [frame for frame in timeline.frames if part.times[0] < frame.time < part.times[-1]]
    assert list(part.frames[1:-1]) == inside


@pytest.mark.parametrize("ends", ENDS)
def test_trimmed_at_its_own_frames_it_is_the_same_up_to_acceleration(ends):
    timeline = random_timeline(3, ends)
    for first, last in ((FIRST, LAST), (TIMES[1], LAST), (TIMES[1] + 4e-10, TIMES[2] - 4e-10)):
        part = trimmed(timeline, first, last)
        assert part.times[0] in TIMES
        t = np.linspace(*path_of(part).span, 50)
        for order in range(3):
            assert_close(path_of(part).at(t, order), path_of(timeline).at(t, order))


@pytest.mark.parametrize(
    ("first", "last", "words"),
    [
        (0.5, 0.5, "ends after it begins"),
        (0.9, 0.3, "ends after it begins, not from 0.9 to 0.3 s"),
        (np.nan, 1.0, "ends after it begins"),
        (-0.1, 0.5, "not inside 0 to 1.3 s"),
        (0.5, 1.31, "not inside"),
        (2, 3, "not inside"),
    ],
)
def test_an_interval_that_is_not_in_the_motion_is_refused(first, last, words):
    with pytest.raises(TimelineError, match=words):
        trimmed(random_timeline(0, "free"), first, last)


@pytest.mark.parametrize("turns", [0, 1])
@pytest.mark.parametrize("count", [1, 3])
def test_a_repeated_loop_continues_period_by_period(rng, turns, count):
    figure = FIGURE_OF_A_HOP
    timeline = evenly(loop(figure, turns, partial=False), 1)
    unknowns = Unknowns.of(figure, timeline)
    timeline = timeline.with_rows(unknowns.rows(unknowns.start + 0.05 * rng.normal(size=unknowns.size)))
    many, seam = repeated(figure, timeline, count), Seam.of(figure, timeline)
    t = np.linspace(0, PERIOD, 41)
    for number in range(count):
        at = np.clip(t + PERIOD * number, 0, path_of(many).span[1])
        assert_close(path_of(many).at(at), seam.moved(path_of(timeline).at(t), number))
        for order in (1, 2):
            assert_close(path_of(many).at(at, order), path_of(timeline).at(t, order) * seam.signs**number)
    assert len(many.frames) == count * (len(timeline.frames) - 1) + 1
    assert Seam.of(figure, many).discontinuity(path_of(many)).max() < 1e-9
    np.testing.assert_allclose(Seam.of(figure, many).travel, count * seam.travel, atol=1e-12)
    again = Unknowns.of(figure, many)
    np.testing.assert_allclose(again.rows(again.start), many.rows, atol=1e-9)


def test_only_loops_are_repeated_and_at_least_once():
    with pytest.raises(
        TimelineError, match="only a loop, with ends = 'periodic', can be repeated; these are 'clamped'"
    ):
        repeated(FIGURE, random_timeline(0, "clamped"), 2)
    with pytest.raises(TimelineError, match="at least once, not 0 times"):
        repeated(FIGURE, random_timeline(0, "periodic"), 0)
