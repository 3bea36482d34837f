"""Windows of a timeline, solved as separate clips while the rest stays as it is.

The influence of a keyframe fades within a few segments. Long clips are solved window by window, from beginning to end,
in linear time and bounded memory. A window consists of solved segments that are fixed, segments whose solution is kept,
and look-ahead segments that the next window solves again from their present state. Its objective includes all of these,
so that one side of a boundary does not improve at the cost of the other. The frames of all windows form one timeline
with one C² spline, and the keyframes stay exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import Path

KEPT, AHEAD, BEHIND = 40, 4, 3  # segments of a window that are kept, look-ahead segments, and fixed ones before it
LARGEST = 125_000  # segments times squared columns above which a clip is solved in windows
PINNED = 0.1  # [1] position of a second fixed frame, relative to the first span of a window, which fixes the slope


def is_long(raw: Timeline) -> bool:
    """Return whether a clip should be solved in windows, because its matrices would not fit in the cache."""
    segments = len(raw.frames) - 1
    return raw.ends != "periodic" and segments > KEPT + AHEAD and segments * raw.width**2 > LARGEST


class Window(NamedTuple):
    """A part by the indices of keyframes: from `begin` to `end`, fixed before `first`."""

    begin: int
    first: int
    end: int


def windows(segments: int) -> list[Window]:
    """Return windows of nearly equal size, which together contain every segment."""
    count = -(-segments // KEPT)
    edges = [segments * k // count for k in range(count + 1)]
    ends = [min(b + AHEAD, segments) for b in edges[1:]]
    return [Window(max(a - BEHIND, 0), a, end) for a, end in zip(edges[:-1], ends, strict=True)]


@dataclass(frozen=True, eq=False)
class SearchPart:
    """A part of a timeline as a separate clip.

    Attributes:
        whole: The timeline.
        timeline: The frames of the part. Those until `since` are fixed.
        since: The beginning of the interval in which frames may move [s].
        until: The end of the part [s].
        sides: Whether the part begins, and ends, with the whole.
        outside_terms: The contribution of the other segments to the terms of E, (terms,).
    """

    whole: Timeline
    timeline: Timeline
    since: float
    until: float
    sides: tuple[bool, bool]
    outside_terms: Array

    @classmethod
    def of(cls, whole: Path, timeline: Timeline, keys: Array, window: Window, terms: Array) -> SearchPart:
        """Return a part of a timeline, with its ends. If they are not clamped, a second fixed frame near the beginning
        of the part fixes the slope there.

        Args:
            whole: The path of the timeline.
            timeline: The timeline.
            keys: The times of its keyframes, (K,) [s].
            window: The part.
            terms: The contributions of all segments between keyframes to the terms of E, (K − 1, terms).
        """
        begin, first, end = keys[list(window)].tolist()
        sides = window.begin == 0, window.end == keys.size - 1
        since = first if window.begin < window.first else -np.inf
        inside = [frame for frame in timeline.frames if begin <= frame.time <= end]
        frames = [f if since < f.time else Frame.key(f.time, f.state) for f in inside]
        if not sides[0] and timeline.ends != "clamped":
            near = begin + PINNED * (frames[1].time - begin)
            frames.insert(1, Frame.key(near, whole.at(np.array([near]))[0]))
        slopes = np.where(np.array(sides)[:, None], timeline.end_slope, whole.at(np.array([begin, end]), 1))
        outside = terms.sum(axis=0) - terms[window.begin : window.end].sum(axis=0)
        return cls(timeline, Timeline(tuple(frames), slopes, timeline.ends), since, end, sides, outside)

    def put_back(self, solved: Timeline) -> Timeline:
        """Return the whole timeline with the solved part. Frames that are fixed only in the part keep their masks."""
        outside = [frame for frame in self.whole.frames if not self.since < frame.time <= self.until]
        inside = [frame for frame in solved.frames if self.since < frame.time <= self.until]
        slopes = np.where(np.array(self.sides)[:, None], solved.end_slope, self.whole.end_slope)
        frames = sorted((*outside, *inside), key=lambda frame: frame.time)
        return Timeline(tuple(frames), slopes, self.whole.ends)
