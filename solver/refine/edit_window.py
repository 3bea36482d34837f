"""The part of a timeline that an edit of a few keyframes affects, as a separate clip with its outer segments fixed.

The influence of a keyframe fades within a few segments. The other segments therefore stay unchanged, and the cost of a
search depends on the length of the part, not on the length of the clip.
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

REACH, HELD = 1, 1  # movable segments on either side of an edit, and fixed segments beyond them
ROUNDING = 1e-9  # [s] tolerance between the time of a keyframe and the end of the part
FEWEST = 3  # segments outside the part below which the whole clip is searched


@dataclass(frozen=True, eq=False)
class EditWindow:
    """The segments of a timeline near an edit.

    Attributes:
        part: Their frames. Those outside [first, last] [s] are fixed.
        begin: The beginning of the part [s].
        first: The beginning of the interval that may move [s].
        last: The end of the interval that may move [s].
        end: The end of the part [s].
        segments: The number of segments between keyframes in the part.
    """

    part: Timeline
    begin: float
    first: float
    last: float
    end: float
    segments: int

    @classmethod
    def about(cls, timeline: Timeline, keys: Array, between: tuple[float, float]) -> EditWindow | None:
        """Return the part that an edit affects, or None for a loop and if the part is nearly the whole clip.

        Args:
            keys: The times of the keyframes, (K,) [s].
            between: The interval that was edited [s].
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
        part_frames = [frame if first < frame.time < until else Frame.key(frame.time, frame.state) for frame in frames]
        slopes = path_of(timeline).at(np.array([begin, end]), 1)
        for side, whole in enumerate((not outer[0], outer[1] == last)):
            if whole:
                slopes[side] = timeline.end_slope[side]
        return cls(Timeline(tuple(part_frames), slopes, "clamped"), begin, first, until, end, outer[1] - outer[0])

    def around(self, timeline: Timeline) -> Callable[[Timeline], Timeline]:
        """Return a function that inserts a solved part into the timeline."""
        return partial(self._put, timeline)

    def _put(self, timeline: Timeline, part: Timeline) -> Timeline:
        """Return the timeline with the part inserted. Frames that are fixed only in the part keep their masks."""
        outside = [frame for frame in timeline.frames if not self.first < frame.time < self.last]
        inside = [frame for frame in part.frames if self.first < frame.time < self.last]
        return Timeline(tuple(sorted((*outside, *inside), key=lambda f: f.time)), timeline.end_slope, timeline.ends)

    def outside_terms(
        self, objective: Objective, timeline: Timeline, keys: Array, segment_terms: Array | None = None
    ) -> Array:
        """Return the contribution of the segments outside the part to the terms of E, (terms,).

        Args:
            objective: E.
            keys: The times of the keyframes, (K,) [s].
            segment_terms: The contributions of all segments between keyframes, if already computed, (segments, terms).
        """
        inside = self.inside(keys)
        if segment_terms is not None:
            return segment_terms.sum(axis=0) - segment_terms[inside].sum(axis=0)
        runs = keys[: inside.start + 1], keys[inside.stop :]
        parts = [segment_integrals(objective, path_of(timeline), run) for run in runs if run.size > 1]
        return np.add.reduce([part.sum(axis=0) for part in parts])

    def inside(self, keys: Array) -> slice:
        """Return the range of segments between keyframes in the part."""
        first, last = np.searchsorted(keys, [self.begin - ROUNDING, self.end - ROUNDING])
        return slice(int(first), int(last))
