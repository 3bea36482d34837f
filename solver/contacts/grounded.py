"""Intervals between keyframes on the ground in which the figure stays near it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..array import Array
from ..curve.frame import Timeline
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface import Surface
from ..surface.heights import FAR, heights
from ..surface.points import Point, places_of
from .footing import Interval
from .thresholds import Thresholds

AWAY = 0.25  # [1] fraction of the segment to a keyframe in the air during which a grounded body stays low


def grounded_intervals(
    figure: Figure,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    flights: Sequence[Interval] = (),
) -> tuple[Interval, ...]:
    """Return the segments between two keyframes that both touch the ground, without those in flights."""
    down = clearance(figure, keys, points, surfaces) < Thresholds.of(figure).touching
    segments = zip(keys.times[:-1].tolist(), keys.times[1:].tolist(), down[:-1] & down[1:], strict=True)
    return tuple(
        (first, last)
        for first, last, both in segments
        if both and not any(begin < last and first < end for begin, end in flights)
    )


def open_intervals(
    figure: Figure,
    root: int,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    flights: Sequence[Interval] = (),
) -> tuple[Interval, ...]:
    """Return intervals next to keyframes that touch the ground and leave the height of a free link to the search.

    Such an interval extends to the neighbouring keyframe if this touches the ground, else over a part of the segment.
    Intervals that overlap flights are omitted.
    """
    is_open = ~keys.fixed[:, figure.links[root].qpos + 2]
    if not is_open.any():
        return ()
    down = clearance(figure, keys, points, surfaces) < Thresholds.of(figure).touching
    is_open &= down
    intervals: list[Interval] = []
    for k in np.flatnonzero(is_open[:-1] | is_open[1:]).tolist():
        (first, last), begins, ends = keys.times[k : k + 2].tolist(), is_open[k], is_open[k + 1]
        part = 1.0 if down[k] and down[k + 1] else AWAY
        if begins:
            intervals.append((first, first + part * (last - first)))
        elif ends:
            intervals.append((last - part * (last - first), last))
    return tuple(one for one in intervals if not any(begin < one[1] and one[0] < end for begin, end in flights))


def clearance(figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]) -> Array:
    """Return the height (K,) [m] of the lowest point above the ground at keyframes; FAR without ground."""
    if not points or not surfaces:
        return np.full(keys.times.size, FAR)
    centres, _, _ = places_of(points, Samples.still(figure, keys.states))
    return heights(surfaces, centres, np.array([point.radius for point in points]))[0].min(axis=0)
