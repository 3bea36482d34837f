"""Which of several timelines of one clip is best, E of all of them summed over the same samples.

A search sums E over the spans of its own frames. A path may be found that is good at those samples and bad between
them, where a sharp term has no sample, a knee that snaps through its own lower leg; the next round's frames tell.
Sharpest of all is a quaternion whose four numbers pass nought at a small distance: the joint turns half round in the
moment that they take for it. So there are samples about every such moment, as close as it is short.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.quadrature import Quadrature
from ..curve.spline import Path, path_of
from ..objective import Objective

AS_GOOD = 1e-6  # of E
FINER = 3  # parts of the spans between the frames of all timelines
AT_ONCE = 100  # spans between frames whose looks are held at once
LOOKS = 32  # at a path between two of its frames, for quaternions that are short
SHORT = 0.1  # length of a quaternion from which on it turns its joint fast
LEAST = 1e-4  # of the time between two looks, the shortest moment that is told
CLOSEST = 1e-9  # [s] between edges
ABOUT = np.array([-10, -3, -1, -0.3, 0, 0.3, 1, 3, 10])  # where samples are, in the moments that it takes


def best(objective: Objective, timelines: Sequence[Timeline]) -> Timeline:
    """The one of least E, the first of those that are as good."""
    if len(timelines) == 1:
        return timelines[0]
    is_uneven = objective.quadrature.kind == "gauss"  # equal samples as close as those would be a million
    times = common_grid(timelines, objective.figure.tables.quaternion_columns.T if is_uneven else ())
    objective = _summable(objective, times)
    values = [objective.value(path_of(timeline), times) for timeline in timelines]
    values = [value if np.isfinite(value) else np.inf for value in values]
    bound = min(values) * (1 + AS_GOOD)
    return next(timeline for timeline, value in zip(timelines, values, strict=True) if value <= bound)


def _summable(objective: Objective, times: Array) -> Objective:
    """The same, summed by Gauss's rule where equal samples in spans so short would be too many."""
    try:
        objective.quadrature.nodes(times)
    except ValueError:
        return replace(objective, quadrature=Quadrature())
    return objective


def common_grid(timelines: Sequence[Timeline], quaternions: Sequence[Index] | Index = ()) -> Array:
    """Edges [s] of spans that are finer than those of any of the timelines; quaternions: their columns, (4,) each."""
    edges = np.concatenate([timeline.times for timeline in timelines])
    flips = [flip for timeline in timelines for flip in _flips(timeline, quaternions)]
    edges = np.unique(np.concatenate([edges, *flips]))
    edges = edges[np.append(True, np.diff(edges) > CLOSEST)]
    share = np.arange(FINER) / FINER
    return np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])


def _flips(timeline: Timeline, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Times [s] about every moment at which a quaternion of a path is short, as it would be on straight ways."""
    if not len(quaternions):
        return
    path, edges = path_of(timeline), timeline.times
    for first in range(0, edges.size - 1, AT_ONCE):
        for found in _flips_of(path, edges[first : first + AT_ONCE + 1], quaternions):
            yield found[(found > edges[0]) & (found < edges[-1])]


def _flips_of(path: Path, edges: Array, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Between some of the frames."""
    times = np.append((edges[:-1, None] + np.arange(LOOKS) / LOOKS * np.diff(edges)[:, None]).ravel(), edges[-1])
    states, step = path.at(times), np.diff(times)
    for columns in quaternions:
        q = states[:, columns]
        way = np.diff(q, axis=0)
        squared = np.maximum(np.einsum("ij,ij->i", way, way), np.finfo(float).tiny)
        share = np.clip(-np.einsum("ij,ij->i", q[:-1], way) / squared, 0, 1)
        length = np.linalg.norm(q[:-1] + share[:, None] * way, axis=1)
        moment = np.clip(length / np.sqrt(squared), LEAST, 1) * step
        for i in np.flatnonzero(length < SHORT):
            yield times[i] + share[i] * step[i] + ABOUT * moment[i]
