"""The samples that paths are judged by: finer than any of them, and close about moments at which a joint flips."""

from __future__ import annotations

import numpy as np
import pytest
from figures import ONE_BALL, figure_of

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.search.judgement import ABOUT, CLOSEST, FINER, common_grid

QUATERNIONS = figure_of(ONE_BALL).tables.quaternion_columns.T


def line(times: Array, start: Array, end: Array) -> Timeline:
    """Frames on the straight line between two quaternions as numbers, not as rotations: the spline through them."""
    share = (times - times[0]) / (times[-1] - times[0])
    states = start + share[:, None] * (end - start)
    frames = Frame.many(times, states, np.ones(states.shape, bool))
    return Timeline(tuple(frames), np.tile((end - start) / (times[-1] - times[0]), (2, 1)))


def test_spans_are_a_third_of_those_between_all_frames_of_all_timelines():
    one = line(np.array([0.0, 1, 2]), np.array([1.0, 0, 0, 0]), np.array([0.8, 0.6, 0, 0]))
    other = line(np.array([0.0, 0.5, 2]), np.array([1.0, 0, 0, 0]), np.array([0.8, 0, 0.6, 0]))
    for quaternions in ((), QUATERNIONS):  # none of them is short
        edges = common_grid([one, other], quaternions)
        np.testing.assert_allclose(edges[::FINER], [0, 0.5, 1, 2])
        np.testing.assert_allclose(np.diff(edges), np.repeat([0.5, 0.5, 1], FINER) / FINER)


@pytest.mark.parametrize("short", [1e-2, 1e-3])
@pytest.mark.parametrize("where", [0.3, 0.71])
def test_about_the_moment_at_which_a_quaternion_passes_nought_are_samples_as_close_as_it_is_short(short, where):
    """On a line that passes nought at a distance the joint turns half round in about distance over speed."""
    aside = np.array([0, short, 0, 0])
    way = np.array([2.0, 0, 0, 0])
    timeline = line(np.array([1.0, 1.5, 3.0]), aside - where * way, aside + (1 - where) * way)
    edges = common_grid([timeline], QUATERNIONS)
    moment = 2.0 * short / 2.0  # [s] of a line that makes 2 in 2 s
    middle = 1.0 + 2.0 * where
    for about in ABOUT:
        assert np.abs(edges - (middle + about * moment)).min() < 1e-9
    assert np.all(np.diff(edges) > CLOSEST / FINER)
    assert edges[0] == 1.0
    assert edges[-1] == 3.0
    alone = common_grid([timeline])
    assert alone.size < edges.size
    np.testing.assert_allclose(alone[::FINER], [1, 1.5, 3])


@pytest.mark.parametrize("length", [0.09, 0.11])
def test_a_quaternion_that_stays_longer_than_a_tenth_is_no_flip(length):
    aside, way = np.array([0, length, 0, 0]), np.array([2.0, 0, 0, 0])
    timeline = line(np.array([0.0, 2.0]), aside - 0.5 * way, aside + 0.5 * way)
    assert (common_grid([timeline], QUATERNIONS).size > 1 + FINER) == (length < 0.1)


def test_a_flip_at_the_very_ends_puts_no_sample_outside_the_clip():
    aside, way = np.array([0, 1e-2, 0, 0]), np.array([2.0, 0, 0, 0])
    for where in (0.0, 1.0):
        timeline = line(np.array([0.0, 1.0]), aside - where * way, aside + (1 - where) * way)
        edges = common_grid([timeline], QUATERNIONS)
        assert edges[0] == 0.0
        assert edges[-1] == 1.0
        assert np.all(np.diff(edges) > 0)
        assert edges.size > 1 + FINER
