"""Which of several timelines of one clip is best, E of all of them summed over the same samples.

A search sums E over the spans of its own frames. A path may be found that is good at those samples and bad between
them, where a sharp term has no sample, a knee that snaps through its own lower leg; the next round's frames tell.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .frame import Timeline
from .objective import Objective
from .quaternion import Array
from .subdivision import path_of

AS_GOOD = 1e-6  # of E
FINER = 3  # parts of the spans between the frames of all timelines


def best(objective: Objective, timelines: Sequence[Timeline]) -> Timeline:
    """The one of least E, the first of those that are as good."""
    if len(timelines) == 1:
        return timelines[0]
    times = common_grid(timelines)
    values = [objective.value(path_of(timeline), times) for timeline in timelines]
    bound = min(values) * (1 + AS_GOOD)
    return next(timeline for timeline, value in zip(timelines, values, strict=True) if value <= bound)


def common_grid(timelines: Sequence[Timeline]) -> Array:
    """Edges [s] of spans that are finer than those of any of the timelines."""
    edges = np.unique(np.concatenate([timeline.times for timeline in timelines]))
    share = np.arange(FINER) / FINER
    return np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])
