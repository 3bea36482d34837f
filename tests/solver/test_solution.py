"""What comes out of the verb: seen inside its times and nowhere else; raw only if nothing was searched or changed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from figures import BALL, figure_of
from hinged import PENALTIES, hinge_keys, hinged

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.objective import Objective
from dynsplines.solver.solution import AT_AN_END, Improvement, Solution


def solution() -> Solution:
    figure = hinged()
    raw = raw_timeline(figure, hinge_keys())
    return Solution(figure, Objective.of(figure, PENALTIES), raw, raw)


def test_a_motion_is_seen_from_its_first_keyframe_to_its_last_and_a_rounding_beyond():
    found = solution()
    t = np.array([0.0, 0.7, 2.0])
    np.testing.assert_allclose(found.at(t), path_of(found.timeline).at(t))
    assert found.at(0.7).shape == (1, 2)
    np.testing.assert_allclose(found.at([-AT_AN_END, 2 + 0.9 * AT_AN_END]), found.at([0.0, 2.0]), atol=1e-7)
    for outside in (-1.1 * AT_AN_END, 2 + 1.1 * AT_AN_END):
        with pytest.raises(ValueError, match="from 0 to 2 s; there is nothing to see outside"):
            found.at([0.5, outside])


def test_quaternions_of_a_motion_are_unit():
    figure = figure_of(BALL)
    keys = [Frame.key(t, [0, 0, 1, *(2 + t) * np.array([np.cos(t), 0, np.sin(t), 0])]) for t in (0.0, 1.0, 2.0)]
    raw = raw_timeline(figure, keys)
    found = Solution(figure, Objective.of(figure, PENALTIES), raw, raw).at(np.linspace(0, 2, 9))
    np.testing.assert_allclose(np.linalg.norm(found[:, 3:], axis=1), 1)


def test_it_is_raw_if_nothing_was_evaluated_and_times_states_and_speeds_are_those_of_the_raw_spline():
    found = solution()
    assert found.is_raw
    assert not replace(found, evaluations=1).is_raw
    raw = found.raw
    later = [replace(frame, time=frame.time + (i == 1) * 0.1) for i, frame in enumerate(raw.frames)]
    moved = [replace(frame, state=frame.state + (i == 1) * 0.1) for i, frame in enumerate(raw.frames)]
    for other in (
        Timeline(tuple(later), raw.end_slope, raw.ends),
        Timeline(tuple(moved), raw.end_slope, raw.ends),
        Timeline(raw.frames, raw.end_slope + 0.1, raw.ends),
    ):
        assert not replace(found, timeline=other).is_raw


def test_an_improvement_builds_its_path_once_and_only_when_it_is_requested():
    built, raw = [], solution().raw
    told = Improvement(3, 1, 0.5, {"acceleration.angular": 0.5}, lambda: built.append(1) or raw)
    assert not built
    np.testing.assert_array_equal(told.path.at(raw.times), path_of(raw).at(raw.times))
    assert told.path is told.path
    assert built == [1]
