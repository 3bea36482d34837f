"""A path carried over to keyframes that were edited: through all of them, as it was where nothing was, searched on."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hinged import hinge_keys, hinged
from oracles import aligned

from dynsplines.clip import load as clips
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.refine.subdivision import split
from dynsplines.solver.refine.warm_start import warm_start


@pytest.fixture(scope="module")
def clip():
    return clips.load("run_and_step")


@pytest.fixture(scope="module")
def found(clip):
    """A solution whose quaternions have almost exactly length one."""
    unit = [(penalty, 100 * weight if penalty.name == "unit" else weight) for penalty, weight in clip.problem.penalties]
    settings = replace(clip.settings, max_evaluations=40, frames=0)
    return inbetween(replace(clip.problem, penalties=unit, settings=settings))


def met(figure, timeline, keys):
    """How far a path misses what keyframes fix, rotations by either quaternion."""
    qpos = figure.to_qpos(path_of(timeline).at(np.array([key.time for key in keys])))
    worst = 0.0
    for pose, key in zip(qpos, keys, strict=True):
        state = np.array(key.state)
        for columns in figure.tables.quaternion_columns.T:
            state[columns] *= np.sign(state[columns] @ pose[columns]) / np.linalg.norm(state[columns])
        worst = max(worst, float(np.abs(pose - state)[key.fixed].max(initial=0.0)))
    return worst


def edited(clip, name):
    keys = list(clip.keys)
    if name == "moved":
        state = np.array(keys[3].state)
        state[2] += 0.05
        keys[3] = replace(keys[3], state=state)
    elif name == "later":
        keys[3] = replace(keys[3], time=keys[3].time + 0.04)
    elif name == "less":
        del keys[4]
    elif name == "more":
        half = Frame.key(0.3, 0.5 * (keys[2].state + keys[3].state))
        keys.insert(3, half)
    elif name == "free":
        fixed = np.array(keys[5].fixed)
        fixed[7:11] = False
        keys[5] = replace(keys[5], fixed=fixed)
    return keys


@pytest.mark.parametrize("name", ["same", "moved", "later", "less", "more", "free"])
def test_it_runs_through_every_keyframe(clip, found, name):
    keys = edited(clip, name)
    problem = replace(clip.problem, keys=keys)
    begin = warm_start(clip.figure, found.timeline, clip.keys, keys, problem.raw)
    assert met(clip.figure, begin, keys) < 1e-9
    assert begin.variable_count >= len(keys) - 1


def test_where_nothing_was_edited_it_is_the_path_that_was_found(clip, found):
    begin = warm_start(clip.figure, found.timeline, clip.keys, clip.keys, clip.problem.raw)
    t = np.linspace(0.0, 2.2, 60)
    a, b = (clip.figure.to_qpos(path_of(line).at(t)) for line in (found.timeline, begin))
    np.testing.assert_allclose(
        a, aligned(clip.figure, b, a), atol=1e-3
    )  # quaternions at keyframes are of length one again


@pytest.mark.parametrize(
    ("new", "old"),
    [
        ([1.0, 1.7, 3.0], [0.0, 2.0]),  # other times, and other in number: all of it between its ends
        ([0.2, 0.9, 1.4, 2.6], [0.0, 0.5, 1.4, 2.0]),  # as many: each by its number
        ([-0.5, 0.5, 0.8, 1.4, 2.3], [0.5, 1.4]),  # those of one time stay, and what is beyond is as far away
    ],
)
def test_variable_frames_lie_between_keyframes_as_they_did_and_move_with_them(rng, new, old):
    figure, before = hinged(), hinge_keys()
    found = split(raw_timeline(figure, before), np.array([0.2, 0.35, 0.9, 1.7]))
    shaken = [replace(f, state=f.state + 0.1 * rng.normal(size=2)) if f.is_variable else f for f in found.frames]
    found = Timeline(tuple(shaken), found.end_slope, found.ends)
    keys = [Frame.key(t, rng.normal(size=figure.width)) for t in new]
    begin = warm_start(figure, found, before, keys, raw_timeline(figure, keys))
    old, there = np.array(old), np.array(new)
    same = there[np.isin(there, old)] if len(new) != len(before) else there
    same = same if same.size else there[[0, -1]]

    def back(t):
        """The time before the edit that a time stands for."""
        return np.interp(t, same, old) + np.minimum(t - same[0], 0) + np.maximum(t - same[-1], 0)

    def was(t):
        return path_of(found).at(np.clip(back(t), 0.0, 2.0))

    t = begin.times
    moved = np.array([key.state for key in keys]) - was(there)
    more = np.array([np.interp(t, there, column) for column in moved.T]).T
    np.testing.assert_allclose(begin.states, was(t) + more, atol=1e-12)
    for a, b in pairwise(new):
        inner, given = t[(t > a) & (t < b)], back(np.array([a, b]))
        kept = [x for x in (0.2, 0.35, 0.9, 1.7) if given[0] < x < given[1]]
        kept = [x for x in kept if 0.15 < (x - given[0]) / (given[1] - given[0]) < 0.85]
        expected = kept if kept else back(a + (b - a) * np.array([1, 2]) / 3)
        np.testing.assert_allclose(back(inner), expected, atol=1e-12)
