"""Variable frames at equal distances."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.refine.subdivision import split


def evenly(timeline: Timeline, count: int) -> Timeline:
    """The timeline with `count` variable frames at equal distances inside every segment."""
    times = timeline.times
    inner = times[:-1, None] + np.arange(1, count + 1) * (np.diff(times)[:, None] / (count + 1))
    return split(timeline, inner.ravel()) if count else timeline
