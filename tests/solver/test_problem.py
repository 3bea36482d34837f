"""What a problem is asked with: the bounds of its settings, and how many variable frames it begins with, by hand."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from figures import TINY, figure_of

from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import OvershootPenalty, TrackingPenalty
from dynsplines.solver.problem import SPACING, Guides, Settings, guide_of


@pytest.mark.parametrize("name", ["variable", "frames", "max_evaluations", "tolerance", "batch", "threshold"])
def test_the_least_that_may_be_requested_is_taken_and_less_is_refused(name):
    bounds: dict[str, Any] = {
        "variable": (0, -1),
        "frames": (0, -1),
        "max_evaluations": (1, 0),
        "tolerance": (1e-300, 0.0),
        "batch": (1e-300, 0.0),
        "threshold": (0.0, -1e-300),
    }
    least, less = bounds[name]
    assert getattr(Settings(**{name: least}), name) == least
    with pytest.raises(ValueError, match="settings: "):
        Settings(**{name: less})


def counts(settings: Settings, *spans: float, in_windows: bool = False) -> list[int]:
    """How many frames a segment begins with; that they are evenly spaced."""
    times = 3.0 + np.cumsum([0.0, *spans])
    found = settings.beginning(times, in_windows=in_windows)
    out = []
    for a, b in pairwise(times):
        own = found[(found > a) & (found < b)]
        np.testing.assert_allclose(np.diff([a, *own, b]), (b - a) / (own.size + 1))
        out.append(own.size)
    assert sum(out) == found.size
    return out


def test_a_segment_begins_with_two_frames_and_with_more_only_where_it_is_longer_than_three_spacings():
    """The frames that the spacing asks for are one fewer than its spans."""
    assert counts(Settings(), 3 * SPACING, 2.9 * SPACING, 0.5 * SPACING) == [2, 2, 2]
    assert counts(Settings(), 3.01 * SPACING, 4 * SPACING, 4.01 * SPACING) == [3, 3, 4]
    assert counts(Settings(), 9.5 * SPACING, 1.0 * SPACING) == [9, 2]
    assert counts(Settings(), 9.5 * SPACING, 1.0 * SPACING, in_windows=True) == [9, 3]


def test_a_budget_that_long_segments_would_break_leaves_them_as_they_are():
    spans = (9.5 * SPACING, SPACING)
    assert counts(Settings(frames=11), *spans) == [9, 2]
    assert counts(Settings(frames=10), *spans) == [2, 2]
    assert counts(Settings(frames=0), *spans) == [2, 2]


@pytest.mark.parametrize("variable", [0, 1, 5])
def test_a_given_number_applies_in_every_segment_however_long(variable):
    assert counts(Settings(variable=variable), 5.0, 0.001, 0.3) == [variable] * 3
    assert Settings(variable=variable, frames=2).in_each(3, in_windows=False) == variable


def test_in_windows_a_budget_is_shared_out_between_two_and_three_a_segment():
    assert [Settings(frames=n).in_each(10, in_windows=True) for n in (None, 5, 19, 20, 29, 30, 90)] == [
        3, 2, 2, 2, 2, 3, 3,
    ]  # fmt: skip
    assert [Settings(frames=n).in_each(10, in_windows=False) for n in (None, 0, 30)] == [2, 2, 2]


def test_limits_are_the_last_of_the_guides_that_have_a_weight():
    figure = figure_of(TINY)
    states = figure.to_state(np.tile(figure.model.qpos0, (9, 1)))
    recorded = RecordedMotion(figure, np.arange(9.0), states, np.ones_like(states))
    limit, tracking = OvershootPenalty((), figure=figure), TrackingPenalty(recorded)
    for penalties in ((limit, tracking), (tracking, limit)):
        guides = guide_of(Objective.of(figure, [(penalty, 1.0) for penalty in penalties]))
        assert isinstance(guides, Guides)
        assert guides.parts == (tracking, limit)
        assert guide_of(Objective.of(figure, [(tracking, 1.0), (limit, 0.0)])) is tracking
    assert guide_of(Objective.of(figure, [(limit, 0.0)])) is None
