"""Selection of the timeline of least E among several of one clip.

A search sums E over samples between its own frames. Its path may violate a sharp term between these samples: a knee can
pass through its own lower leg within one span. The sharpest case is a quaternion whose four components pass close to
zero, where the joint turns by half a turn in a moment. E is therefore compared on samples common to all timelines, with
more samples around every such moment, at distances proportional to its duration.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.quadrature import Quadrature
from ..curve.spline import Path, path_of
from ..figure.figure import Figure
from ..objective import Objective

EQUAL_WITHIN = 1e-6  # [1] relative difference of E below which two timelines are equally good
SUBDIVISIONS = 3  # parts of each span between the frames of all timelines
SPANS_AT_ONCE = 100  # spans between frames whose samples are in memory at once
SAMPLES_PER_SPAN = 32  # samples between two frames, to detect short quaternions
SHORT = 0.1  # norm of a quaternion below which its joint turns fast
MIN_DURATION = 1e-4  # [1] shortest moment that is resolved, relative to the time between two samples
MIN_SPACING = 1e-9  # [s] between edges
OFFSETS = np.array([-10, -3, -1, -0.3, 0, 0.3, 1, 3, 10])  # [1] offsets of added samples, in durations of the moment


def select_best(objective: Objective, timelines: Sequence[Timeline]) -> Timeline:
    """Return the timeline of least E.

    Args:
        objective: E.
        timelines: Timelines of one clip; the first of several that are equally good is returned.
    """
    if len(timelines) == 1:
        return timelines[0]
    is_uneven = objective.quadrature.kind == "gauss"  # uniform samples as dense as those would be a million
    times = common_grid(timelines, objective.figure.tables.quaternion_columns.T if is_uneven else ())
    objective = _summable(objective, times)
    values = [objective.value(path_of(timeline), times) for timeline in timelines]
    values = [value if np.isfinite(value) else np.inf for value in values]
    bound = min(values) * (1 + EQUAL_WITHIN)
    return next(timeline for timeline, value in zip(timelines, values, strict=True) if value <= bound)


def is_resolved(figure: Figure, timeline: Timeline) -> bool:
    """Return whether E of a timeline needs no more samples: no quaternion of its path is short, see the module."""
    return not any(True for _ in _flips(timeline, figure.tables.quaternion_columns.T))


def _summable(objective: Objective, times: Array) -> Objective:
    """Return the objective, with Gauss's rule if uniform samples in such short spans would be too many."""
    try:
        objective.quadrature.nodes(times)
    except ValueError:
        return replace(objective, quadrature=Quadrature())
    return objective


def common_grid(timelines: Sequence[Timeline], quaternions: Sequence[Index] | Index = ()) -> Array:
    """Return the edges [s] of spans that are finer than those of any of the timelines.

    Args:
        quaternions: The columns (4,) of each quaternion to sample around moments at which it is short.
    """
    edges = np.concatenate([timeline.times for timeline in timelines])
    flips = [flip for timeline in timelines for flip in _flips(timeline, quaternions)]
    edges = np.unique(np.concatenate([edges, *flips]))
    edges = edges[np.append(True, np.diff(edges) > MIN_SPACING)]
    share = np.arange(SUBDIVISIONS) / SUBDIVISIONS
    return np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])


def _flips(timeline: Timeline, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Yield times [s] around every moment at which a quaternion of the path is short."""
    if not len(quaternions):
        return
    path, edges = path_of(timeline), timeline.times
    for first in range(0, edges.size - 1, SPANS_AT_ONCE):
        for times in _flips_between(path, edges[first : first + SPANS_AT_ONCE + 1], quaternions):
            yield times[(times > edges[0]) & (times < edges[-1])]


def _flips_between(path: Path, edges: Array, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Yield these times between neighbouring edges [s], with each quaternion linear between two samples of the path."""
    share = np.arange(SAMPLES_PER_SPAN) / SAMPLES_PER_SPAN
    times = np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])
    states, step = path.at(times), np.diff(times)
    for columns in quaternions:
        q = states[:, columns]
        change = np.diff(q, axis=0)
        squared = np.maximum(np.einsum("ij,ij->i", change, change), np.finfo(float).tiny)
        share = np.clip(-np.einsum("ij,ij->i", q[:-1], change) / squared, 0, 1)
        length = np.linalg.norm(q[:-1] + share[:, None] * change, axis=1)
        duration = np.clip(length / np.sqrt(squared), MIN_DURATION, 1) * step
        for i in np.flatnonzero(length < SHORT):
            yield times[i] + share[i] * step[i] + OFFSETS * duration[i]
