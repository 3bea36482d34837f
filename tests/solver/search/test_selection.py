"""The samples that paths are judged by: finer than any of them, and close about moments at which a joint flips."""

from __future__ import annotations

import numpy as np
import pytest
from figures import ONE_BALL, figure_of
from hinged import hinged

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration
from dynsplines.solver.search import selection
from dynsplines.solver.search.selection import (
    EQUAL_WITHIN,
    MIN_SPACING,
    OFFSETS,
    SUBDIVISIONS,
    common_grid,
    select_best,
)

QUATERNIONS = figure_of(ONE_BALL).tables.quaternion_columns.T


def line(times: Array, start: Array, end: Array) -> Timeline:
    """Frames on the straight line between two quaternions as numbers, not as rotations: the spline through them."""
    share = (times - times[0]) / (times[-1] - times[0])
    states = start + share[:, None] * (end - start)
    frames = Frame.many(times, states, np.ones(states.shape, bool))
    return Timeline(tuple(frames), np.tile((end - start) / (times[-1] - times[0]), (2, 1)))


@pytest.mark.parametrize("short", [1e-2, 1e-3])
@pytest.mark.parametrize("where", [0.3, 0.71])
def test_about_the_moment_at_which_a_quaternion_passes_zero_are_samples_as_close_as_it_is_short(short, where):
    """On a line that passes nought at a distance the joint turns half round in about distance over speed."""
    aside = np.array([0, short, 0, 0])
    way = np.array([2.0, 0, 0, 0])
    timeline = line(np.array([1.0, 1.5, 3.0]), aside - where * way, aside + (1 - where) * way)
    edges = common_grid([timeline], QUATERNIONS)
    moment = 2.0 * short / 2.0  # [s] of a line that makes 2 in 2 s
    middle = 1.0 + 2.0 * where
    for about in OFFSETS:
        assert np.abs(edges - (middle + about * moment)).min() < 1e-9
    assert np.all(np.diff(edges) > MIN_SPACING / SUBDIVISIONS)
    assert edges[0] == 1.0
    assert edges[-1] == 3.0
    alone = common_grid([timeline])
    assert alone.size < edges.size
    np.testing.assert_allclose(alone[::SUBDIVISIONS], [1, 1.5, 3])


@pytest.mark.parametrize("length", [0.09, 0.11])
def test_a_quaternion_that_stays_longer_than_a_tenth_is_no_flip(length):
    aside, way = np.array([0, length, 0, 0]), np.array([2.0, 0, 0, 0])
    timeline = line(np.array([0.0, 2.0]), aside - 0.5 * way, aside + 0.5 * way)
    assert (common_grid([timeline], QUATERNIONS).size > 1 + SUBDIVISIONS) == (length < 0.1)


def bent(by: float) -> Timeline:
    """Two frames of two hinges at rest, and one between them that is off."""
    times, states = np.array([0.0, 1, 2]), np.array([[0.0, 0], [by, 0], [0, 0]])
    return Timeline(tuple(Frame.many(times, states, np.ones((3, 2), bool))), np.zeros((2, 2)), "clamped")


def test_the_best_is_the_first_of_those_whose_e_is_as_good_as_the_least():
    """E of a hinge is the square of how far it is off."""
    objective = Objective.of(hinged(), [(CovariantAcceleration(), 1.0)])
    hair = 1 + 0.5 * EQUAL_WITHIN
    least, within, beyond, far = (bent(by) for by in (1.0, np.sqrt(hair), np.sqrt(1 + 2 * EQUAL_WITHIN), 2.0))
    for timelines, wanted in (
        ((far, least, within), least),
        ((far, within, least), within),
        ((beyond, least, far), least),
        ((least, beyond), least),
        ((far,), far),
    ):
        assert select_best(objective, timelines) is wanted


def test_paths_whose_equal_samples_would_be_too_many_are_judged_all_the_same():
    even = Quadrature("uniform", 50)
    objective = Objective.of(hinged(), [(CovariantAcceleration(), 1.0)], quadrature=even)
    close = []
    for by in (2.0, 1.0):
        times, states = np.array([0.0, 1e-3, 10, 20]), np.array([[0.0, 0], [0, 0], [by, 0], [0, 0]])
        close.append(Timeline(tuple(Frame.many(times, states, np.ones((4, 2), bool))), np.zeros((2, 2)), "clamped"))
    with pytest.raises(ValueError, match="uniform quadrature would take"):
        objective.value(path_of(close[0]), common_grid(close))
    assert select_best(objective, close) is close[1]


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_a_path_whose_e_is_no_number_is_the_worst(monkeypatch, order):
    timelines = [bent(1.0), bent(2.0)]
    values = {id(timelines[0]): 3.0, id(timelines[1]): np.nan}
    monkeypatch.setattr(selection, "path_of", lambda timeline: timeline)
    monkeypatch.setattr(Objective, "value", lambda self, path, times=None: values[id(path)])
    objective = Objective.of(hinged(), [(CovariantAcceleration(), 1.0)])
    assert select_best(objective, [timelines[i] for i in order]) is timelines[0]
