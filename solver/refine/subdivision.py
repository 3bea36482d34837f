"""Subdivision: a variable frame at the middle of each badly approximated segment (step 5 of the paper's figure 5).

A criterion returns one number per segment between neighbouring frames; the segments with the largest are split.
"residual" is the paper's criterion. "weak", from the weak form, predicts how much a split would reduce E. The paper
argues against "objective" and "resolution" (§2); they are included only for comparison.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.quadrature import gauss_nodes
from ..curve.spline import path_of
from ..objective import Objective
from ..search.descent import optimised
from .euler_lagrange import WeakForm, residual


def midpoints(timeline: Timeline) -> Array:
    """Return the middle of every segment, (M − 1,) [s]."""
    times = timeline.times
    return (times[1:] + times[:-1]) / 2


def by_residual(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ |R| dt over every segment, (M − 1,), with R the residual of the Euler-Lagrange equation of E."""
    return residual(objective, path_of(timeline)).deviation()


def by_weak_form(objective: Objective, timeline: Timeline) -> Array:
    """Return the predicted reduction of E by a variable frame in the middle of every segment."""
    return WeakForm(objective, path_of(timeline)).decrements(midpoints(timeline))


def by_objective(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ f dt over every segment."""
    t, w = gauss_nodes(np.asarray(timeline.times), 6)
    density = objective.density(objective.samples(path_of(timeline), t))
    return (w * density).reshape(-1, 6).sum(axis=1)


def by_resolution(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ |y − y_fine| dt per segment, with y_fine the optimum at twice the resolution (Welch & Witkin 1992)."""
    fine = optimised(objective, split(timeline, midpoints(timeline)))
    t, w = gauss_nodes(np.asarray(timeline.times), 6)
    apart = np.linalg.norm(path_of(timeline).at(t) - path_of(fine).at(t), axis=1)
    return (w * apart).reshape(-1, 6).sum(axis=1)


CRITERIA: dict[str, Callable[[Objective, Timeline], Array]] = {
    "weak": by_weak_form,
    "residual": by_residual,
    "objective": by_objective,
    "resolution": by_resolution,
}


def split(timeline: Timeline, times: Array) -> Timeline:
    """Return the timeline with variable frames at `times` [s], on its curve, which does not change."""
    states = path_of(timeline).at(times)
    return timeline.inserted(Frame.many(times, states, np.zeros(states.shape, bool)))
