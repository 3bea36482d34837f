"""Where the path is badly approximated: a variable frame at the middle of the segment (step 5 of the paper's figure 5).

Criteria give every segment between neighbouring frames one number; the largest are split. "residual" is the paper's;
"weak" estimates how much E would fall; "objective" and "resolution" are the two that the paper argues against (§2).
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
    """(M − 1,) the middle of every segment [s]."""
    times = timeline.times
    return (times[1:] + times[:-1]) / 2


def by_residual(objective: Objective, timeline: Timeline) -> Array:
    """∫ |R| dt over every segment: the paper's criterion."""
    return residual(objective, path_of(timeline)).deviation()


def by_weak_form(objective: Objective, timeline: Timeline) -> Array:
    """The decrease of E that a variable frame in the middle of every segment promises."""
    return WeakForm.of(objective, path_of(timeline)).decrements(midpoints(timeline))


def by_objective(objective: Objective, timeline: Timeline) -> Array:
    """∫ f dt over every segment."""
    t, w = gauss_nodes(np.asarray(timeline.times), 6)
    density = objective.density(objective.samples(path_of(timeline), t))
    return (w * density).reshape(-1, 6).sum(axis=1)


def by_resolution(objective: Objective, timeline: Timeline) -> Array:
    """∫ |y − y_fine| dt against the optimum at twice the resolution (Welch & Witkin 1992)."""
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
    """With variable frames inserted at the given times on the present curve, which stays as it is."""
    states = path_of(timeline).at(times)
    return timeline.inserted(Frame.many(times, states, np.zeros(states.shape, bool)))


def evenly(timeline: Timeline, count: int) -> Timeline:
    """With `count` variable frames at equal distances inside every segment."""
    times = timeline.times
    inner = times[:-1, None] + np.arange(1, count + 1) * (np.diff(times)[:, None] / (count + 1))
    return split(timeline, inner.ravel()) if count else timeline
