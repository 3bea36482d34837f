"""Subdivision: a variable frame at the middle of each badly approximated segment (step 5 of the paper's figure 5).

A criterion returns one number per segment between neighbouring frames; the segments with the largest are split.
"residual" is the paper's criterion. "weak", from the weak form, predicts how much a split would reduce E.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import path_of
from ..objective import Objective
from .euler_lagrange import WeakForm, residual

# default initial number of variable frames per segment: FEW if the clip is solved as a whole, MORE if in windows
FEW, MORE = 2, 3


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


CRITERIA: dict[str, Callable[[Objective, Timeline], Array]] = {
    "weak": by_weak_form,
    "residual": by_residual,
}


def split(timeline: Timeline, times: Array) -> Timeline:
    """Return the timeline with variable frames at `times` [s], on its curve, which does not change."""
    states = path_of(timeline).at(times)
    return timeline.insert(Frame.many(times, states, np.zeros(states.shape, bool)))
