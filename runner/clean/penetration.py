"""Depths of a figure in its surroundings along a path, and penetrations between the samples of a search."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.array import Array, runs
from dynsplines.solver.curve.spline import Path

from ..clip.tracking.penalties import LONGEST_PANEL, NEXT_TO, POINTS, Ground
from ..measure.depths import bunches, depths
from ..motion import even_times, sample_runs

RATE = 240.0  # [1/s] of the samples
DEEP = 0.001  # [m] least depth that a search should prevent
SHALLOW = LONGEST_PANEL / POINTS  # [s] between samples of a search, which so evaluates longer penetrations


def depth(ground: Ground, path: Path, times: Array) -> Array:
    """Return the largest depth (T,) [m] of body and soles at times (T,)."""
    body, found = bunches((*ground.clear, *ground.points)), list[Array]()
    for samples in sample_runs(ground.figure, path, times):
        found.append(np.zeros(samples.count))
        for surface in ground.surfaces:
            for _, at, deep in depths(body, surface, samples):
                found[-1][at] = np.maximum(found[-1][at], deep.max(axis=0))
    return np.concatenate(found)


def missed_edge_times(ground: Ground, path: Path, frames: Array) -> Array:
    """Return times (k,) [s] for more frames beyond those at `frames` (M,) [s], where a foot passes through an edge
    unseen."""
    times = even_times(path.span, RATE)
    deep = depth(ground, path, times)
    missed_times = list[float]()
    for first, end in runs(deep > DEEP):
        if (end - first) / RATE > SHALLOW:
            continue
        worst = float(times[first + deep[first:end].argmax()])
        after = int(np.clip(np.searchsorted(frames, worst), 1, frames.size - 1))
        about = frames[max(0, after - 2) : after + 2]
        wanted = [worst] if np.abs(frames - worst).min() > NEXT_TO else (0.5 * (about[1:] + about[:-1])).tolist()
        missed_times += [t for t in wanted if np.abs(frames - t).min() > NEXT_TO]
    return np.unique(missed_times)
