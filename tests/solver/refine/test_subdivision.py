"""Subdivision, the Euler-Lagrange residual, and warm starts."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from figures import PENALTIES, hinge_keys, hinged
from oracles import aligned
from problems import turning
from random_models import evenly

from dynsplines.clip import load as clips
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature, gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.refine.euler_lagrange import NODES, Residual, residual
from dynsplines.solver.refine.subdivision import CRITERIA, by_objective, by_resolution, midpoints, split
from dynsplines.solver.refine.warm_start import warm_start
from dynsplines.solver.search.descent import optimised


@pytest.fixture(params=[1, 2])
def problem(request, rng) -> tuple[Objective, Timeline]:
    """Variable frames that are off where they should be."""
    figure = hinged()
    timeline = evenly(raw_timeline(figure, hinge_keys()), request.param)
    off = 0.2 * rng.normal(size=timeline.states.shape) * ~timeline.fixed
    frames = Frame.many(timeline.times, timeline.states + off, timeline.fixed)
    timeline = Timeline(tuple(frames), timeline.end_slope, timeline.ends)
    return Objective.of(figure, PENALTIES, quadrature=Quadrature(points=6)), timeline


@pytest.mark.parametrize("name", CRITERIA)
def test_every_segment_has_a_score_of_its_own(name, problem):
    objective, timeline = problem
    scores = CRITERIA[name](objective, timeline)
    assert scores.shape == (timeline.times.size - 1,)
    assert np.all(scores >= 0)
    assert scores.max() > 0


def test_the_segments_shares_add_up_to_e(problem):
    objective, timeline = problem
    assert by_objective(objective, timeline).sum() == pytest.approx(objective.value(path_of(timeline)), rel=1e-9)


def test_how_far_a_segment_is_from_a_finer_optimum_is_the_integral_of_that_distance(problem):
    objective, timeline = problem
    fine = path_of(optimised(objective, split(timeline, midpoints(timeline))))
    t, w = gauss_nodes(np.asarray(timeline.times), 200)
    apart = w * np.linalg.norm(path_of(timeline).at(t) - fine.at(t), axis=1)
    expected = apart.reshape(-1, 200).sum(axis=1)
    np.testing.assert_allclose(by_resolution(objective, timeline), expected, atol=0.05 * expected.max())


def test_the_shares_of_equal_parts_add_up_and_are_those_of_the_density_where_it_is_even(rng):
    edges = np.array([1.0, 1.3, 2.1, 2.2, 3.0])
    t, w = (each.reshape(4, -1) for each in gauss_nodes(edges, 8))
    even = Residual(t, w, np.full((4, 8, 3), 2.0))
    np.testing.assert_allclose(even.size, np.sqrt(12))
    np.testing.assert_allclose(even.deviation(), np.sqrt(12) * np.diff(edges))
    np.testing.assert_allclose(even.shares(10), np.sqrt(12) * 0.2)
    np.testing.assert_allclose(even.shares(), even.shares(10))
    any_of = Residual(t, w, rng.normal(size=(4, 8, 3)))
    np.testing.assert_allclose(any_of.shares(7).sum(), any_of.deviation().sum())
    halves = np.where(t < 2.0, 1.0, 0.0)[:, :, None]
    assert Residual(t, w, halves).shares(4)[[0, -1]] == pytest.approx([0.5, 0.0], abs=1e-9)


def test_the_residual_is_the_derivative_of_the_objective_along_variations_inside_a_span(rng):
    """∫ R·v dt = ∫ g₀·v + g₁·v' + g₂·v'' dt for v = c (t − a)² (b − t)², which vanishes with v' at the span's ends."""
    objective, timeline = turning([40.0, 80.0, 20.0], 1)
    path = path_of(timeline)
    strong, direction = residual(objective, path), rng.normal(size=path.rows.shape[1])
    gradients = objective.sample_gradients(objective.samples(path, gauss_nodes(timeline.times, NODES)[0]))
    for k, (a, b) in enumerate(pairwise(timeline.times)):
        bump = np.polynomial.Polynomial.fromroots([a, a, b, b])
        t, w, inside = strong.t[k], strong.weights[k], slice(k * NODES, (k + 1) * NODES)
        weak = sum(w @ (g[inside] @ direction * bump.deriv(order)(t)) for order, g in enumerate(gradients))
        assert w @ (strong.value[k] @ direction * bump(t)) == pytest.approx(weak, rel=1e-3)


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
