"""What an edit reaches, counted in segments by hand: where the part is cut out, what of it is held, what is left."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, figure_of

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.objective import Objective, segment_integrals
from dynsplines.solver.penalty import CovariantAcceleration, RootAcceleration
from dynsplines.solver.refine.edit_window import EditWindow

KEYS = np.array([0.0, 0.5, 1.0, 1.75, 2.5, 3.0, 3.5, 4.25, 5.0])  # eight segments, a variable frame in each


def timeline_of(ends: str = "free") -> Timeline:
    rng = np.random.default_rng(3)
    between = 0.5 * (KEYS[1:] + KEYS[:-1])
    states = {t: np.append(rng.normal(size=3), [1, *0.1 * rng.normal(size=3)]) for t in (*KEYS, *between)}
    keys = [Frame.key(t, states[t]) for t in KEYS]
    frames = [*keys, *Frame.many(between, np.array([states[t] for t in between]), np.zeros((8, 7), bool))]
    return Timeline(tuple(sorted(frames, key=lambda frame: frame.time)), rng.normal(size=(2, 7)), ends)


def cut_of(low: float, high: float, keys: Array = KEYS) -> EditWindow:
    found = EditWindow.about(timeline_of(), keys, (low, high))
    assert found is not None
    return found


def test_a_loop_has_no_part_nor_has_an_edit_that_leaves_less_than_three_segments_out():
    assert EditWindow.about(timeline_of("periodic"), KEYS, (1.75, 1.75)) is None
    assert EditWindow.about(timeline_of(), KEYS, (1.75, 2.5)) is not None  # five of eight
    assert EditWindow.about(timeline_of(), KEYS, (1.75, 3.0)) is None  # six
    assert EditWindow.about(timeline_of(), KEYS[:-1], (1.75, 2.5)) is None
    assert EditWindow.about(timeline_of(), KEYS[:5], (0.0, 0.0)) is None
    assert EditWindow.about(timeline_of(), KEYS[:6], (0.0, 0.0)) is not None


@pytest.mark.parametrize("ends", ["free", "clamped"])
@pytest.mark.parametrize("edit", [(0.0, 0.0), (1.75, 2.5), (5.0, 5.0)])
def test_the_part_holds_its_outer_segments_and_begins_and_ends_as_fast_as_the_whole_does(edit, ends):
    timeline = timeline_of(ends)
    cut = EditWindow.about(timeline, KEYS, edit)
    assert cut is not None
    part = cut.part
    own = (timeline.times >= cut.begin) & (timeline.times <= cut.end)
    np.testing.assert_array_equal(part.times, timeline.times[own])
    np.testing.assert_array_equal(part.states, timeline.states[own])
    held = (part.times <= cut.first) | (part.times >= cut.last)
    np.testing.assert_array_equal(part.fixed[held], True)
    np.testing.assert_array_equal(part.fixed[~held], timeline.fixed[own][~held])
    assert part.ends == "clamped"
    slopes = np.array([path_of(timeline).at(np.array([t]), 1)[0] for t in (cut.begin, cut.end)])
    np.testing.assert_allclose(part.end_slope, slopes, atol=1e-9)
    for side, whole in enumerate((cut.begin == 0, cut.end == 5)):
        if whole:
            np.testing.assert_array_equal(part.end_slope[side], timeline.end_slope[side])


@pytest.mark.parametrize("edit", [(0.0, 0.0), (2.5, 2.5), (5.0, 5.0)])
def test_what_lies_elsewhere_costs_what_all_segments_do_but_those_of_the_part_known_or_not(edit):
    timeline, cut = timeline_of(), cut_of(*edit)
    terms = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 2.0)]
    objective = Objective.of(figure_of(BALL), terms)
    every = segment_integrals(objective, path_of(timeline), KEYS)
    own = np.zeros(8, bool)
    own[[i for i in range(8) if cut.begin <= KEYS[i] and KEYS[i + 1] <= cut.end]] = True
    expected = every[~own].sum(axis=0)
    np.testing.assert_allclose(cut.outside_terms(objective, timeline, KEYS), expected, rtol=1e-9)
    np.testing.assert_allclose(cut.outside_terms(objective, timeline, KEYS, every), expected, rtol=1e-9)
    late = KEYS + 5e-10  # a clip's keyframes as a file has them
    assert cut.inside(late) == cut.inside(KEYS) == cut.inside(KEYS - 5e-10)
