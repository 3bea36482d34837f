"""What an edit reaches, counted in segments by hand: where the part is cut out, what of it is held, what is left."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.refine.parts import Part, Window, edited

KEYS = np.array([0.0, 0.5, 1.0, 1.75, 2.5, 3.0, 3.5, 4.25, 5.0])  # eight segments, a variable frame in each


def timeline_of(ends: str = "free") -> Timeline:
    rng = np.random.default_rng(3)
    between = 0.5 * (KEYS[1:] + KEYS[:-1])
    states = {t: np.append(rng.normal(size=3), [1, *0.1 * rng.normal(size=3)]) for t in (*KEYS, *between)}
    keys = [Frame.key(t, states[t]) for t in KEYS]
    frames = [*keys, *Frame.many(between, np.array([states[t] for t in between]), np.zeros((8, 7), bool))]
    return Timeline(tuple(sorted(frames, key=lambda frame: frame.time)), rng.normal(size=(2, 7)), ends)


def raw_of(ends: str = "free", keys: Array = KEYS) -> Timeline:
    frames = tuple(frame for frame in timeline_of(ends).frames if frame.time in keys)
    return Timeline(frames, np.zeros((2, 7)), ends)


def test_a_loop_has_no_part_nor_has_an_edit_that_leaves_less_than_three_segments_out():
    assert edited(raw_of(), []) == []
    assert edited(raw_of("periodic"), [(1.75, 1.75)]) == []
    assert edited(raw_of(), [(1.75, 2.5)]) == [Window(1, 2, 5, 6)]  # five of eight
    assert edited(raw_of(), [(1.75, 3.0)]) == []  # six
    assert edited(raw_of(), [(1.75, 2.5), (1.75, 3.0)]) == []
    assert edited(raw_of(keys=KEYS[:-1]), [(1.75, 2.5)]) == []
    assert edited(raw_of(keys=KEYS[:5]), [(0.0, 0.0)]) == []
    assert edited(raw_of(keys=KEYS[:6]), [(0.0, 0.0)]) == [Window(0, 0, 1, 2)]
    assert edited(raw_of(), [(5.0, 5.0), (0.6, 0.6)]) == [Window(6, 7, 8, 8), Window(0, 0, 3, 4)]


@pytest.mark.parametrize("ends", ["free", "clamped"])
@pytest.mark.parametrize("edit", [(0.0, 0.0), (1.75, 2.5), (5.0, 5.0)])
def test_the_part_holds_its_outer_segments_and_begins_and_ends_as_fast_as_the_whole_does(edit, ends):
    timeline = timeline_of(ends)
    (window,) = edited(raw_of(ends), [edit])
    begin, first, last, end = KEYS[list(window)]
    cut = Part.of(path_of(timeline), timeline, KEYS, window, "clamped", np.zeros((8, 1)))
    part = cut.timeline
    own = (timeline.times >= begin) & (timeline.times <= end)
    np.testing.assert_array_equal(part.times, timeline.times[own])
    np.testing.assert_array_equal(part.states, timeline.states[own])
    held = (part.times <= (first if begin else -1)) | (part.times >= (last if end < 5 else 6))
    np.testing.assert_array_equal(part.fixed[held], True)
    np.testing.assert_array_equal(part.fixed[~held], timeline.fixed[own][~held])
    assert part.ends == "clamped"
    slopes = np.array([path_of(timeline).at(np.array([t]), 1)[0] for t in (begin, end)])
    np.testing.assert_allclose(part.end_slope, slopes, atol=1e-9)
    for side, whole in enumerate((begin == 0, end == 5)):
        if whole:
            np.testing.assert_array_equal(part.end_slope[side], timeline.end_slope[side])
    assert cut.put_back(part).ends == ends
    np.testing.assert_array_equal(cut.put_back(part).rows, timeline.rows)
