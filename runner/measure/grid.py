"""A motion on a fine grid: what reports look at, *between* the samples that the optimiser saw."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples

from ..clip.load import Clip
from ..motion import continuous, samples_at

RATE = 1000.0  # [1/s], between the samples that the optimiser saw


@dataclass(frozen=True)
class Grid:
    """One motion on the fine grid: times (T,) [s], samples, qpos (T, nq)."""

    time: Array
    samples: Samples
    qpos: Array

    @classmethod
    def of(cls, clip: Clip, timeline: Timeline, rate: float = RATE) -> Grid:
        first, last = float(timeline.times[0]), float(timeline.times[-1])
        time = np.linspace(first, last, max(2, round((last - first) * rate) + 1))
        samples = samples_at(clip.figure, path_of(timeline), time)
        return cls(time, samples, continuous(clip.figure, clip.figure.to_qpos(samples.y)))
