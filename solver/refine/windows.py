"""A long clip is solved window by window, from its beginning to its end, so that time is linear and memory bounded.

What a keyframe does to the motion fades within a few segments. A window has segments to keep; after them some that it
looks ahead to, and that the next window solves again from where this one left them; before them some that were found
already and are held. All of them are in its objective, so nothing is gained on one side of a boundary at the cost of
the other. The frames of all windows are one timeline with one C² spline, and the keyframes stay exact.
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

KEPT, AHEAD, BEHIND = 40, 4, 3  # segments of a window, those it looks ahead to and those held behind it
FRAMES_A_SEGMENT = 4  # that is_long reckons with
LARGEST = 2_500_000  # entries of a banded matrix
PINNED = 0.1


def is_long(raw: Timeline) -> bool:
    """Whether a clip of keyframes is better solved in windows: its matrices would not fit into the cache."""
    segments = len(raw.frames) - 1
    entries = FRAMES_A_SEGMENT * segments * 5 * raw.width**2
    return raw.ends != "periodic" and segments > KEPT + AHEAD and entries > LARGEST


@dataclass(frozen=True)
class Window:
    """Segments by number: held from `held` on, kept from `first` to `kept`, looked ahead to until `last`."""

    held: int
    first: int
    kept: int
    last: int


def windows(segments: int) -> list[Window]:
    """Windows that keep every segment once, of nearly equal size."""
    count = -(-segments // KEPT)
    edges = [segments * k // count for k in range(count + 1)]
    return [Window(max(a - BEHIND, 0), a, b, min(b + AHEAD, segments)) for a, b in pairwise(edges)]


class Assembly:
    """The whole clip while its windows are being solved: what is found, what lies ahead, and the start of the rest."""

    def __init__(self, objective: Objective, raw: Timeline, start: Timeline) -> None:
        self.objective, self.raw = objective, raw
        self.frames = list(start.frames)
        self.end_slope = np.array(start.end_slope)
        self.key_times = raw.times
        self.first_path = path_of(start)
        self.solved_path = self.first_path
        self.parts = segment_integrals(objective, self.first_path, self.key_times)

    def timeline(self) -> Timeline:
        """The whole clip as it stands."""
        return Timeline(tuple(self.frames), self.end_slope, self.raw.ends)

    def elsewhere(self, window: Window) -> Array:
        """(terms,) what the segments outside a window add to the terms of E."""
        return self.parts.sum(axis=0) - self.parts[window.held : window.last].sum(axis=0)

    def opened(self, window: Window) -> Timeline:
        """A window as a clip of its own, its held frames fixed."""
        begin, first, end = (self.key_times[i] for i in (window.held, window.first, window.last))
        frames = [f for f in self.frames if begin <= f.time <= end]
        held = [Frame.key(f.time, f.state) if f.time <= first and window.held < window.first else f for f in frames]
        if window.held > 0:
            # a second frame at the cut holds the slope there as well
            near = begin + PINNED * (frames[1].time - begin)
            held.insert(1, Frame.key(near, self.solved_path.at(np.array([near]))[0]))
        slopes = np.vstack([self.solved_path.at(np.array([begin]), 1), self.first_path.at(np.array([end]), 1)])
        for side, at_end in enumerate((window.held == 0, window.last == len(self.key_times) - 1)):
            if at_end:
                slopes[side] = self.end_slope[side]
        return Timeline(tuple(held), slopes, self.raw.ends)

    def around(self, window: Window) -> Callable[[Timeline], Timeline]:
        """How to make the whole clip of a window, the rest of it as it stands now."""
        return partial(self._with_window, tuple(self.frames), self.end_slope, window)

    def room(self, window: Window, budget: int) -> int:
        """How many variable frames a window may have, of so many in all: its share, or what the others leave."""
        segments = len(self.key_times) - 1
        first, last = self.key_times[window.first], self.key_times[window.last]
        others = sum(f.is_variable for f in self.frames if not first < f.time < last)
        return min(round(budget * (window.last - window.first) / segments), budget - others)

    def close(self, window: Window, solved: Timeline) -> None:
        """Takes over what a window found, the part that it looked ahead to as the start of the next."""
        whole = self.around(window)(solved)
        self.frames, self.end_slope = list(whole.frames), np.array(whole.end_slope)
        self.solved_path = path_of(solved)
        from_ = max(window.first - 1, 0)
        times = self.key_times[from_ : window.last + 1]
        self.parts[from_ : window.last] = segment_integrals(self.objective, self.solved_path, times)

    def _with_window(self, frames: tuple[Frame, ...], end_slope: Array, window: Window, solved: Timeline) -> Timeline:
        """Held frames stay as they were: in a window they count as keyframes."""
        first = self.key_times[window.first] if window.first else -np.inf
        last = self.key_times[window.last]
        before, after = (f for f in frames if f.time <= first), (f for f in frames if f.time > last)
        slopes = np.array(end_slope)
        if window.held == 0:
            slopes[0] = solved.end_slope[0]
        if window.last == len(self.key_times) - 1:
            slopes[1] = solved.end_slope[1]
        inside = (f for f in solved.frames if first < f.time <= last)
        return Timeline((*before, *inside, *after), slopes, self.raw.ends)
