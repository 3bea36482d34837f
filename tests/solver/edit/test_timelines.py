"""Edits that keep the curve."""

import numpy as np
import pytest
from figures import BALL_TREE, TINY, figure_of
from hypothesis import example, given, settings
from hypothesis import strategies as st
from problems import PERIOD, loop
from random_models import TIMES, evenly, random_keys

from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns
from dynsplines.solver.edit import timelines
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
        (lambda: timelines.trim(random_timeline(0, "free"), 0.5, 0.5), "ends before it begins"),
        (
            lambda: timelines.trim(random_timeline(0, "free"), 0.9, 0.3),
            "the interval from 0.9 to 0.3 s ends before it begins",
        ),
        (lambda: timelines.trim(random_timeline(0, "free"), np.nan, 1.0), "ends before it begins"),
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


ARM_AND_BALL = """<mujoco><worldbody><body><joint axis="0 1 0"/><geom size=".1" pos="0 0 1"/></body>
<body><freejoint/><geom size=".1"/></body></worldbody></mujoco>"""
