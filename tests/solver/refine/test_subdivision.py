"""Subdivision, the Euler-Lagrange residual, and warm starts."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import pytest
from figures import BALL, FLOOR, TINY, figure_of, hinge_keys, hinged
from gradients import RESIDUALS, assert_squares, some_samples
from oracles import aligned
from problems import hop, slider, turning
from random_models import distance_from_key, evenly

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Collision, CovariantAcceleration, Normalization, Penalty, RootAcceleration
from dynsplines.solver.penalty.block import Block, Dense, every
from dynsplines.solver.refine.subdivision import NODES, decrements, midpoints, residual, split
from dynsplines.solver.refine.warm_start import warm_start
from dynsplines.solver.surface.points import Point


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


def edited() -> dict[str, list[Frame]]:
    """Keyframes of two hops after one edit each."""
    keys = hop(2)
    up, free, signs = 0.05 * np.eye(11)[2], np.arange(11) < 7, np.where(np.arange(11) < 3, 1, -1)
    return {
        "same": keys,
        "same, with other signs of quaternions": [replace(key, state=key.state * signs) for key in keys],
        "moved": [*keys[:3], replace(keys[3], state=keys[3].state + up), *keys[4:]],
        "later": [*keys[:3], replace(keys[3], time=keys[3].time + 0.04), *keys[4:]],
        "less": [*keys[:4], *keys[5:]],
        "more": [*keys[:3], Frame.key(0.6, 0.5 * (keys[2].state + keys[3].state)), *keys[3:]],
        "free": [*keys[:5], replace(keys[5], fixed=free), *keys[6:]],
    }


@pytest.mark.parametrize("name", edited())
def test_a_warm_start_runs_through_every_keyframe_and_is_the_path_before_where_nothing_was_edited(name, rng):
    figure, before, keys = figure_of(TINY), hop(2), edited()[name]
    found = evenly(raw_timeline(figure, before), 1)
    rows = found.rows + 0.05 * rng.normal(size=found.rows.shape) * np.pad(~found.fixed, ((0, 2), (0, 0)))
    found = found.with_rows(rows)
    begin = warm_start(figure, found, before, keys, raw_timeline(figure, keys))
    for key, state in zip(keys, path_of(begin).at(np.array([key.time for key in keys])), strict=True):
        assert distance_from_key(figure, state, key) < 1e-9
    assert begin.variable_count >= len(keys) - 1
    if name.startswith("same"):
        t = np.linspace(0, keys[-1].time, 60)
        a, b = (figure.to_qpos(path_of(line).at(t)) for line in (found, begin))
        np.testing.assert_allclose(a, aligned(figure, b, a), atol=1e-9)


@dataclass(frozen=True)
class BySweeps(CovariantAcceleration):
    """The covariant acceleration without a curvature of its own."""

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for block in super().residuals(samples):
            yield replace(block, curved=None) if isinstance(block, Dense) else block


def test_the_curvature_of_a_residual_without_one_of_its_own_is_twice_the_square_of_its_jacobian(figure, rng):
    _, residuals = RESIDUALS["covariant"]
    assert_squares(BySweeps(), residuals, some_samples(figure, rng), rng)


class Entry(Penalty):
    """Squares of the first entry of the state and its derivatives."""

    name, normalization = "entry", Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for order, weight in enumerate((20.0, 2.5, 0.15)):
            yield every(samples, np.zeros(1, int), order, weight=weight)


@pytest.mark.parametrize("chosen", [slice(2, 3), slice(None)], ids=["one frame", "frames everywhere"])
def test_the_weak_form_promises_what_a_frame_moved_alone_brings_where_e_is_quadratic(rng, chosen):
    """A slide whose frames do not lie where its energy would have them, with a penalty of y besides."""
    problem = slider(np.linspace(0, 3, 4), 2)
    timeline = problem.timeline
    timeline = timeline.with_rows(timeline.rows + 0.1 * rng.normal(size=timeline.rows.shape))
    terms: list[tuple[Penalty, float]] = [(RootAcceleration(), 1.0), (Entry(), 1.0)]
    objective = Objective.of(problem.objective.figure, terms)
    candidates = midpoints(timeline)[chosen]
    finer, brought = split(timeline, candidates), []
    for row in np.searchsorted(finer.times, candidates):
        values = []
        for by in (-1.0, 0.0, 1.0):
            rows = np.array(finer.rows)
            rows[row] += by
            values.append(objective.value(path_of(finer.with_rows(rows))))
        slope, bent = (values[2] - values[0]) / 2, values[2] - 2 * values[1] + values[0]
        brought.append(slope**2 / (2 * bent))
    promised = decrements(objective, path_of(timeline), candidates)
    np.testing.assert_allclose(promised, brought, rtol=2e-3)


def test_the_weak_form_ranks_the_segment_that_dips_into_the_floor_first():
    figure = figure_of(BALL)
    heights = [0.5, 0.4, 0.5, 0.12, 0.12, 0.5, 0.4]
    raw = raw_timeline(figure, [Frame.key(float(i), [0, 0, z, 1, 0, 0, 0]) for i, z in enumerate(heights)])
    contact = Collision((Point("ball", 1, np.zeros(3), 0.1),), (FLOOR,))
    objective = Objective.of(figure, [(RootAcceleration(), 1.0), (contact, 50.0)]).renormalise(path_of(raw))
    assert np.argmax(decrements(objective, path_of(raw), midpoints(raw))) == 3
