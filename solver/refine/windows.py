"""Long clips solved window by window, from beginning to end, in linear time and bounded memory.

The influence of a keyframe fades within a few segments. A window consists of solved segments that are fixed, segments
whose solution is kept, and look-ahead segments that the next window solves again from their present state. Its
objective includes all of these, so that one side of a boundary does not improve at the cost of the other. The frames of
all windows form one timeline with one C² spline, and the keyframes stay exact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import path_of
from ..objective import Objective, segment_integrals

KEPT, AHEAD, BEHIND = 40, 4, 3  # segments of a window that are kept, look-ahead segments, and fixed ones before it
FRAMES_A_SEGMENT = 4  # typical number of frames per segment, to estimate the size of a matrix in `is_long`
LARGEST = 2_500_000  # entries of a banded matrix above which a clip is solved in windows
PINNED = 0.1  # [1] position of a second fixed frame, relative to the first span of a window, which fixes the slope


def is_long(raw: Timeline) -> bool:
    """Return whether a clip should be solved in windows, because its matrices would not fit in the cache."""
    segments = len(raw.frames) - 1
    entries = FRAMES_A_SEGMENT * segments * 5 * raw.width**2
    return raw.ends != "periodic" and segments > KEPT + AHEAD and entries > LARGEST


@dataclass(frozen=True)
class Window:
    """A window of segments: fixed from `fixed_from`, solved from `first` to `solved_to`, look-ahead up to `last`."""

    fixed_from: int
    first: int
    solved_to: int
    last: int


def windows(segments: int) -> list[Window]:
    """Return windows of nearly equal size. Every segment is kept by one of them."""
    count = -(-segments // KEPT)
    edges = [segments * k // count for k in range(count + 1)]
    return [Window(max(a - BEHIND, 0), a, b, min(b + AHEAD, segments)) for a, b in pairwise(edges)]


class Assembly:
    """The whole clip while its windows are being solved: the solved part, and the initial state of the rest."""

    def __init__(self, objective: Objective, raw: Timeline, start: Timeline) -> None:
        self.objective, self.raw = objective, raw
        self.frames = list(start.frames)
        self.end_slope = np.array(start.end_slope)
        self.key_times = raw.times
        self.first_path = path_of(start)
        self.solved_path = self.first_path
        self.parts = segment_integrals(objective, self.first_path, self.key_times)

    def timeline(self) -> Timeline:
        """Return the whole clip at present."""
        return Timeline(tuple(self.frames), self.end_slope, self.raw.ends)

    def outside_terms(self, window: Window) -> Array:
        """Return the contribution of the segments outside a window to the terms of E, (terms,)."""
        return self.parts.sum(axis=0) - self.parts[window.fixed_from : window.last].sum(axis=0)

    def opened(self, window: Window) -> Timeline:
        """Return a window as a separate clip, with its solved frames fixed."""
        begin, first, end = (self.key_times[i] for i in (window.fixed_from, window.first, window.last))
        frames = [f for f in self.frames if begin <= f.time <= end]
        part = [
            Frame.key(f.time, f.state) if f.time <= first and window.fixed_from < window.first else f for f in frames
        ]
        if window.fixed_from > 0:
            # a second frame near the cut also fixes the slope
            near = begin + PINNED * (frames[1].time - begin)
            part.insert(1, Frame.key(near, self.solved_path.at(np.array([near]))[0]))
        slopes = np.vstack([self.solved_path.at(np.array([begin]), 1), self.first_path.at(np.array([end]), 1)])
        for side, at_end in enumerate((window.fixed_from == 0, window.last == len(self.key_times) - 1)):
            if at_end:
                slopes[side] = self.end_slope[side]
        return Timeline(tuple(part), slopes, self.raw.ends)

    def around(self, window: Window) -> Callable[[Timeline], Timeline]:
        """Return a function that inserts a solved window into the present clip."""
        return partial(self._with_window, tuple(self.frames), self.end_slope, window)

    def frame_budget(self, window: Window, budget: int) -> int:
        """Return the number of variable frames of a window, for a budget of the whole clip."""
        segments = len(self.key_times) - 1
        first, last = self.key_times[window.first], self.key_times[window.last]
        others = sum(f.is_variable for f in self.frames if not first < f.time < last)
        return min(round(budget * (window.last - window.first) / segments), budget - others)

    def close(self, window: Window, solved: Timeline) -> None:
        """Replace the window's frames by its solution; that of its look-ahead segments starts the next window."""
        whole = self.around(window)(solved)
        self.frames, self.end_slope = list(whole.frames), np.array(whole.end_slope)
        self.solved_path = path_of(solved)
        from_ = max(window.first - 1, 0)
        times = self.key_times[from_ : window.last + 1]
        self.parts[from_ : window.last] = segment_integrals(self.objective, self.solved_path, times)

    def _with_window(self, frames: tuple[Frame, ...], end_slope: Array, window: Window, solved: Timeline) -> Timeline:
        """Return the clip with a window inserted. Frames that are fixed only in the window keep their masks."""
        first = self.key_times[window.first] if window.first else -np.inf
        last = self.key_times[window.last]
        before, after = (f for f in frames if f.time <= first), (f for f in frames if f.time > last)
        slopes = np.array(end_slope)
        if window.fixed_from == 0:
            slopes[0] = solved.end_slope[0]
        if window.last == len(self.key_times) - 1:
            slopes[1] = solved.end_slope[1]
        inside = (f for f in solved.frames if first < f.time <= last)
        return Timeline((*before, *inside, *after), slopes, self.raw.ends)
