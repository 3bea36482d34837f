"""A part of a timeline as a clip of its own, its outer segments held: what an edit of a few keyframes reaches.

What a keyframe does to the motion fades within a few segments, so the others stay as they were found, and a search
costs what the part does and not what the clip does.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import path_of
from ..objective import Objective, segment_integrals

REACH, HELD = 1, 1  # segments on either side of what was edited that move, and beyond them those that are held
ROUNDING = 1e-9  # [s] between the time of a keyframe and that of the part's end
FEWEST = 3  # segments that must be left out, or all of the clip is searched


@dataclass(frozen=True, eq=False)
class Cut:
    """Some segments of a timeline.

    part         their frames, those outside [first, last] [s] held
    begin, end   [s] where the part is cut out
    segments     how many segments between keyframes it has
    """

    part: Timeline
    begin: float
    first: float
    last: float
    end: float
    segments: int

    @classmethod
    def about(cls, timeline: Timeline, keys: Array, between: tuple[float, float]) -> Cut | None:
        """What an edit between two times reaches; None where that is nearly all of the clip, or a loop.

        keys  (K,) [s] times of the keyframes
        """
        if timeline.ends == "periodic":
            return None
        last = keys.size - 1
        low = int(np.searchsorted(keys, between[0], side="right")) - 1
        high = int(np.searchsorted(keys, between[1], side="left"))
        inner = low - REACH, high + REACH
        outer = max(inner[0] - HELD, 0), min(inner[1] + HELD, last)
        if last - (outer[1] - outer[0]) < FEWEST:
            return None
        begin, end = float(keys[outer[0]]), float(keys[outer[1]])
        first = float(keys[inner[0]]) if outer[0] else -np.inf
        until = float(keys[inner[1]]) if outer[1] < last else np.inf
        frames = [frame for frame in timeline.frames if begin <= frame.time <= end]
        held = [frame if first < frame.time < until else Frame.key(frame.time, frame.state) for frame in frames]
        slopes = path_of(timeline).at(np.array([begin, end]), 1)
        for side, whole in enumerate((not outer[0], outer[1] == last)):
            if whole:
                slopes[side] = timeline.end_slope[side]
        return cls(Timeline(tuple(held), slopes, "clamped"), begin, first, until, end, outer[1] - outer[0])

    def around(self, timeline: Timeline) -> Callable[[Timeline], Timeline]:
        """How to make the whole timeline of the part."""
        return partial(self._put, timeline)

    def _put(self, timeline: Timeline, part: Timeline) -> Timeline:
        """Held frames stay as they were: in the part they count as keyframes."""
        outside = [frame for frame in timeline.frames if not self.first < frame.time < self.last]
        inside = [frame for frame in part.frames if self.first < frame.time < self.last]
        return Timeline(tuple(sorted((*outside, *inside), key=lambda f: f.time)), timeline.end_slope, timeline.ends)

    def elsewhere(self, objective: Objective, timeline: Timeline, keys: Array, known: Array | None = None) -> Array:
        """(terms,) what the segments outside the part add to the terms of E.

        known  (segments, terms) what segments between keyframes add, where it is known
        """
        inside = self.inside(keys)
        if known is not None:
            return known.sum(axis=0) - known[inside].sum(axis=0)
        runs = keys[: inside.start + 1], keys[inside.stop :]
        parts = [segment_integrals(objective, path_of(timeline), run) for run in runs if run.size > 1]
        return np.add.reduce([part.sum(axis=0) for part in parts])

    def inside(self, keys: Array) -> slice:
        """Which segments between keyframes the part has."""
        first, last = np.searchsorted(keys, [self.begin - ROUNDING, self.end - ROUNDING])
        return slice(int(first), int(last))
