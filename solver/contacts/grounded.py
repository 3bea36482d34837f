"""Intervals between keyframes on the ground in which the figure stays near it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..array import Mask
from ..curve.frame import Timeline
from .footing import Interval

AWAY = 0.25  # [1] fraction of the segment to a keyframe in the air during which a grounded body stays low


def grounded_intervals(
    keys: Timeline, down: Mask, is_hop: Mask, flights: Sequence[Interval] = (), lift_off: float = 0.0
) -> tuple[Interval, ...]:
    """Return the segments between two keyframes on the ground, `down` (K,), without hops (K − 1,) and flights.

    If a flight begins or ends between keyframes, the interval between it and the keyframe on the ground is added, but
    for `lift_off` [s] next to the flight.
    """
    is_grounded = down[:-1] & down[1:] & ~is_hop
    segments = zip(keys.times[:-1].tolist(), keys.times[1:].tolist(), is_grounded, strict=True)
    intervals = list(_outside(flights, [(first, last) for first, last, near in segments if near]))
    for begin, end in flights:
        before, after = np.searchsorted(keys.times, begin) - 1, np.searchsorted(keys.times, end, side="right")
        if down[before] and begin - lift_off > keys.times[before]:  # false if no keyframe is before the flight
            intervals.append((float(keys.times[before]), begin - lift_off))
        if after < keys.times.size and down[after] and end + lift_off < keys.times[after]:
            intervals.append((end + lift_off, float(keys.times[after])))
    return tuple(sorted(intervals))


def open_intervals(keys: Timeline, down: Mask, is_open: Mask, flights: Sequence[Interval] = ()) -> tuple[Interval, ...]:
    """Return intervals next to keyframes on the ground, `down` (K,), that leave the root's height free, `is_open` (K,).

    Such an interval extends to the neighbouring keyframe if this touches the ground, else over a part of the segment.
    Intervals that overlap flights are omitted.
    """
    is_open = is_open & down
    intervals: list[Interval] = []
    for k in np.flatnonzero(is_open[:-1] | is_open[1:]).tolist():
        (first, last), begins, ends = keys.times[k : k + 2].tolist(), is_open[k], is_open[k + 1]
        part = 1.0 if down[k] and down[k + 1] else AWAY
        if begins:
            intervals.append((first, first + part * (last - first)))
        elif ends:
            intervals.append((last - part * (last - first), last))
    return _outside(flights, intervals)


def _outside(flights: Sequence[Interval], intervals: Sequence[Interval]) -> tuple[Interval, ...]:
    """Return the intervals that overlap no flight."""
    return tuple(one for one in intervals if not any(begin < one[1] and one[0] < end for begin, end in flights))
