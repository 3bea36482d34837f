"""The data of the charts, stored in the motion file so that `plot` never solves again."""

from __future__ import annotations

from typing import Any

import numpy as np

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.refine.euler_lagrange import residual
from dynsplines.solver.solution import Solution
from dynsplines.solver.surface.heights import height_above
from dynsplines.solver.surface.points import places_of

from ..clip.build import Clip
from ..motion import even_times, samples_at

RATE = 250.0  # [1/s] of the samples, finer than the resolution of a chart
FAR = 10.0  # [m] height of a point without a surface below it
TENTHS = 10  # number of equal parts of the clip's duration, as in the paper's figure 10


def curves(clip: Clip, motion: Solution) -> dict[str, dict[str, Any]]:
    """Return the curves of the raw spline, "before", and of the motion, "after", as lists.

    These are "time" [s], "height" [m] by contact point, "shortest" and "longest" quaternion [1], and "EL over tenths".
    """
    before = _side(clip, motion, motion.raw)
    return {"before": before, "after": before if motion.is_raw else _side(clip, motion, motion.timeline)}


def _side(clip: Clip, motion: Solution, timeline: Timeline) -> dict[str, Any]:
    path = path_of(timeline)
    time = even_times(path.span, RATE)
    samples = samples_at(clip.figure, path, time)
    length = np.linalg.norm(samples.q, axis=0)
    if not length.size:
        length = np.ones((1, time.size))
    return {
        "time": time.round(6).tolist(),
        "height": contact_heights(clip, samples),
        "shortest": length.min(axis=0).round(6).tolist(),
        "longest": length.max(axis=0).round(6).tolist(),
        "EL over tenths": residual(motion.objective, path).shares(TENTHS).tolist(),
    }


def contact_heights(clip: Clip, samples: Samples) -> dict[str, list[float]]:
    """Return the heights of contact points above their surfaces [m], (T,) by name; FAR without a surface below."""
    points, surfaces = clip.context.points, clip.context.surfaces
    if not points or not surfaces:
        return {}
    centres, radii = places_of(points, samples)
    height = height_above(surfaces, centres, radii[:, None])
    rows = np.where(np.isfinite(height), height, FAR).round(5)
    return {point.name: row.tolist() for point, row in zip(points, rows, strict=True)}
