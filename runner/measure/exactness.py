"""The error of a motion at its keyframes."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of

from ..clip.build import Clip


def keyframe_error(clip: Clip, timeline: Timeline) -> float:
    """Return the largest error of a fixed entry of qpos at its key time: [m] or [rad]; quaternions have no unit."""
    figure = clip.figure
    times = np.array([key.time for key in clip.keys])
    reached = figure.to_qpos(path_of(timeline).at(times))
    worst = 0.0
    for key, qpos in zip(clip.keys, reached, strict=True):
        specified = key.state.copy()
        for columns in figure.tables.quaternion_columns.T:
            specified[columns] /= np.linalg.norm(specified[columns])
            if specified[columns] @ qpos[columns] < 0:
                specified[columns] *= -1
        worst = max(worst, float(np.abs(specified - qpos)[key.fixed].max(initial=0.0)))
    return worst
