"""Parts of a timeline, solved as separate clips while the rest stays as it is.

The influence of a keyframe fades within a few segments. An edit therefore moves only the segments near it, and the cost
of a search depends on the length of this part, not on the length of the clip.

Long clips are solved window by window, from beginning to end, in linear time and bounded memory. A window consists of
solved segments that are fixed, segments whose solution is kept, and look-ahead segments that the next window solves
again from their present state. Its objective includes all of these, so that one side of a boundary does not improve at
the cost of the other. The frames of all windows form one timeline with one C² spline, and the keyframes stay exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import Path

KEPT, AHEAD, BEHIND = 40, 4, 3  # segments of a window that are kept, look-ahead segments, and fixed ones before it
LARGEST = 125_000  # segments times squared columns above which a clip is solved in windows
PINNED = 0.1  # [1] position of a second fixed frame, relative to the first span of a window, which fixes the slope
REACH, HELD = 1, 1  # movable segments on either side of an edit, and fixed segments beyond them
FEWEST = 3  # segments outside the part of an edit below which the whole clip is searched


def is_long(raw: Timeline) -> bool:
    """Return whether a clip should be solved in windows, because its matrices would not fit in the cache."""
    segments = len(raw.frames) - 1
    return raw.ends != "periodic" and segments > KEPT + AHEAD and segments * raw.width**2 > LARGEST


class Window(NamedTuple):
    """A part by the indices of keyframes: from `begin` to `end`, fixed before `first` and after `last`."""

    begin: int
    first: int
    last: int
    end: int


def windows(segments: int) -> list[Window]:
    """Return windows of nearly equal size, which together contain every segment."""
    count = -(-segments // KEPT)
    edges = [segments * k // count for k in range(count + 1)]
    ends = [min(b + AHEAD, segments) for b in edges[1:]]
    return [Window(max(a - BEHIND, 0), a, end, end) for a, end in zip(edges[:-1], ends, strict=True)]


def parts_of_edits(raw: Timeline, between: Sequence[tuple[float, float]]) -> list[Window]:
    """Return the parts that edits in intervals [s] affect.

    The list is empty for a loop, and if one of them is nearly the whole clip.
    """
    last, result = len(raw.frames) - 1, list[Window]()
    for interval in between if raw.ends != "periodic" else ():
        low = int(np.searchsorted(raw.times, interval[0], side="right")) - 1 - REACH
        high = int(np.searchsorted(raw.times, interval[1], side="left")) + REACH
        begin, end = max(low - HELD, 0), min(high + HELD, last)
        if last - (end - begin) < FEWEST:
            return []
        result.append(Window(begin, low if begin else 0, high if end < last else last, end))
    return result


@dataclass(frozen=True, eq=False)
class SearchPart:
    """A part of a timeline as a separate clip.

    Attributes:
        whole: The timeline.
        timeline: The frames of the part. Those outside (since, until) are fixed.
        since: The beginning of the interval in which frames may move [s].
        until: The end of this interval [s].
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
    def of(cls, whole: Path, timeline: Timeline, keys: Array, window: Window, ends: str, terms: Array) -> SearchPart:
        """Return a part of a timeline.

        Args:
            whole: The path of the timeline.
            timeline: The timeline.
            keys: The times of its keyframes, (K,) [s].
            window: The part.
            ends: The ends of the part, as those of a timeline. If they are not clamped, a second fixed frame near the
                beginning also fixes the slope there.
            terms: The contributions of all segments between keyframes to the terms of E, (K − 1, terms).
        """
        begin, first, last, end = keys[list(window)].tolist()
        sides = window.begin == 0, window.end == keys.size - 1
        since = first if window.begin < window.first else -np.inf
        until = last if window.last < window.end else np.nextafter(end, np.inf)
        inside = [frame for frame in timeline.frames if begin <= frame.time <= end]
        frames = [f if since < f.time < until else Frame.key(f.time, f.state) for f in inside]
        if not sides[0] and ends != "clamped":
            near = begin + PINNED * (frames[1].time - begin)
            frames.insert(1, Frame.key(near, whole.at(np.array([near]))[0]))
        slopes = np.where(np.array(sides)[:, None], timeline.end_slope, whole.at(np.array([begin, end]), 1))
        outside = terms.sum(axis=0) - terms[window.begin : window.end].sum(axis=0)
        return cls(timeline, Timeline(tuple(frames), slopes, ends), since, until, sides, outside)

    def put_back(self, solved: Timeline) -> Timeline:
        """Return the whole timeline with the solved part. Frames that are fixed only in the part keep their masks."""
        outside = [frame for frame in self.whole.frames if not self.since < frame.time < self.until]
        inside = [frame for frame in solved.frames if self.since < frame.time < self.until]
        slopes = np.where(np.array(self.sides)[:, None], solved.end_slope, self.whole.end_slope)
        frames = sorted((*outside, *inside), key=lambda frame: frame.time)
        return Timeline(tuple(frames), slopes, self.whole.ends)
