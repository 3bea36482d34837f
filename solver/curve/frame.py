"""Frames and timelines.

A frame is the state of a figure at one time, with a mask of its fixed entries. A keyframe has every entry fixed, a
partial keyframe some, and a variable frame none (§2 of the paper). A timeline is a sequence of frames in order of time.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..array import Array, Mask, freeze, frozen_mask


class TimelineError(ValueError):
    """Invalid frames of a timeline: too few, out of order, or with entries that are not finite."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The state of the figure at one time.

    Attributes:
        time: [s].
        state: The figure's state, (N,): metres, radians and quaternions wxyz of any length > 0.
        fixed: Entries that the animator set, (N,). A fixed joint means its rotation *relative to the parent*, in any
            coordinates of the state. A quaternion is fixed as a whole or not at all.
        posed: Other entries that posing computed for the keyframe, such as a planted foot or a bent knee, (N,). The
            search starts there and may change them. Contacts are inferred from them as from fixed entries.
    """

    time: float
    state: Array
    fixed: Mask
    posed: Mask | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "time", float(self.time))
        object.__setattr__(self, "state", freeze(self.state))
        object.__setattr__(self, "fixed", frozen_mask(self.fixed))
        if self.state.ndim != 1 or self.state.shape != self.fixed.shape:
            raise TimelineError(f"state {self.state.shape} and fixed {self.fixed.shape} must be vectors of one length")
        if self.posed is not None:
            posed = np.asarray(self.posed, bool)
            if posed.shape != self.fixed.shape:
                raise TimelineError(f"state {self.state.shape} and posed {posed.shape} must be vectors of one length")
            posed = posed & ~self.fixed
            object.__setattr__(self, "posed", frozen_mask(posed) if posed.any() else None)
        if not np.isfinite(self.time) or not np.all(np.isfinite(self.state)):
            raise TimelineError(f"the frame at t = {self.time:g} s holds entries that are not finite numbers")

    @classmethod
    def key(cls, time: float, state: ArrayLike, fixed: ArrayLike | None = None) -> Frame:
        """Return a keyframe; a partial one if `fixed` (N,) is specified."""
        state = np.asarray(state, float)
        return cls(time, state, np.ones(state.shape, bool) if fixed is None else np.asarray(fixed, bool))

    @classmethod
    def variable(cls, time: float, state: ArrayLike) -> Frame:
        state = np.asarray(state, float)
        return cls(time, state, np.zeros(state.shape, bool))

    @classmethod
    def _of_checked(cls, time: float, state: Array, fixed: Mask, posed: Mask | None = None) -> Frame:
        """Return a frame from read-only arrays of finite numbers, without checks or copies."""
        frame = object.__new__(cls)
        frame.__dict__.update(time=time, state=state, fixed=fixed, posed=posed)
        return frame

    @classmethod
    def many(
        cls, times: ArrayLike, states: ArrayLike, fixed: ArrayLike, posed: Sequence[Mask | None] | None = None
    ) -> list[Frame]:
        """Return frames.

        Args:
            times: (K,) [s].
            states: (K, N).
            fixed: Masks, (K, N).
            posed: The mask (N,) or None of each frame; None: no entry is posed.

        Raises:
            TimelineError: The shapes do not match, or entries are not finite.
        """
        times, states, fixed = np.array(times, float), freeze(states), frozen_mask(fixed)
        if states.ndim != 2 or states.shape != fixed.shape or times.shape != states.shape[:1]:
            raise TimelineError(f"times {times.shape}, states {states.shape} and fixed {fixed.shape} do not match")
        good = np.isfinite(times) & np.isfinite(states).all(axis=1)
        if not good.all():
            raise TimelineError(f"the frame at t = {times[~good][0]:g} s holds entries that are not finite numbers")
        return list(map(cls._of_checked, times.tolist(), states, fixed, posed or [None] * len(states)))

    @property
    def known(self) -> Mask:
        """The specified entries, fixed or posed, (N,)."""
        return self.fixed if self.posed is None else self.fixed | self.posed

    @property
    def is_variable(self) -> bool:
        """Whether no entry is fixed."""
        return not self.fixed.any()

    @property
    def is_key(self) -> bool:
        """Whether every entry is fixed."""
        return bool(self.fixed.all())


ENDS = ("free", "clamped", "clamped start", "clamped end", "periodic")


@dataclass(frozen=True, eq=False)
class Timeline:
    """Frames in order of time, with the end conditions of their spline.

    Attributes:
        frames: At least two frames at rising times.
        end_slope: y' at the first and the last frame [state/s], (2, N). Free slopes start the search from these values.
            Periodic ends store the jumps of y' and y'' from the end to the start instead. The jumps are zero except for
            entries that the seam turns and quaternions that return as −q.
        ends: "free": both end slopes are unknowns. "clamped": they are `end_slope`. "clamped start", "clamped end": one
            is `end_slope`, the other an unknown. "periodic": the last frame repeats the first, with its free roots
            moved and turned as in the two frames, and the curve is C² across the seam.
    """

    frames: tuple[Frame, ...]
    end_slope: Array
    ends: str = "free"

    def __post_init__(self) -> None:
        object.__setattr__(self, "frames", tuple(self.frames))
        if len(self.frames) < 2:
            raise TimelineError(f"a timeline needs at least 2 frames, not {len(self.frames)}")
        times = self.times
        if not (times[1:] > times[:-1]).all():
            i = int(np.argmin(times[1:] > times[:-1]))
            a, b = times[i], times[i + 1]
            raise TimelineError(
                f"frame {i + 2} is at t = {b:g} s, not after frame {i + 1} at t = {a:g} s; times must rise"
            )
        widths = {frame.state.size for frame in self.frames}
        if len(widths) > 1:
            raise TimelineError(f"the frames' states have different lengths: {sorted(widths)}")
        object.__setattr__(self, "end_slope", freeze(self.end_slope))
        if self.end_slope.shape != (2, self.width):
            raise TimelineError(f"end_slope has shape {self.end_slope.shape}, not (2, {self.width})")
        if self.ends not in ENDS:
            raise TimelineError(f"ends = {self.ends!r}: not one of {', '.join(map(repr, ENDS))}")

    @property
    def free_slopes(self) -> tuple[bool, bool]:
        """Whether the slopes at the start and at the end are unknowns."""
        return self.ends in ("free", "clamped end"), self.ends in ("free", "clamped start")

    @property
    def at_rest(self) -> tuple[bool, bool]:
        """Whether the slopes at the start and at the end are given as zero."""
        start, end = ~self.end_slope.any(axis=1) & ~np.array(self.free_slopes) & (self.ends != "periodic")
        return bool(start), bool(end)

    @property
    def width(self) -> int:
        """N, the number of entries of a state."""
        return self.frames[0].state.size

    @cached_property
    def times(self) -> Array:
        """The times of the frames, (M,) [s]."""
        return freeze([frame.time for frame in self.frames])

    @cached_property
    def states(self) -> Array:
        """The states of the frames, (M, N)."""
        return freeze([frame.state for frame in self.frames])

    @cached_property
    def fixed(self) -> Mask:
        """The fixed entries, (M, N)."""
        return frozen_mask([frame.fixed for frame in self.frames])

    @cached_property
    def known(self) -> Mask:
        """The specified entries, see `Frame.known`, (M, N)."""
        return frozen_mask([frame.known for frame in self.frames])

    @cached_property
    def rows(self) -> Array:
        """The frames' states and below them `end_slope`, (M + 2, N); the spline is linear in these."""
        return freeze(np.concatenate([self.states, self.end_slope]))

    @cached_property
    def of_times(self) -> dict[str, Any]:
        """A cache for values that depend on times and ends only, shared between timelines with the same."""
        return {}

    @property
    def variable_count(self) -> int:
        """The number of variable frames."""
        return int(np.count_nonzero(~self.fixed.any(axis=1)))

    def with_rows(self, rows: ArrayLike) -> Timeline:
        """Return a timeline of the same times and masks with other states and end slopes, rows (M + 2, N)."""
        rows = np.asarray(rows, float)
        if rows.shape != (len(self.frames) + 2, self.width):
            raise TimelineError(f"rows have shape {rows.shape}, not {self.rows.shape} as the timeline's")
        posed = [frame.posed for frame in self.frames]
        moved = Timeline(tuple(Frame.many(self.times, rows[:-2], self.fixed, posed)), rows[-2:], self.ends)
        moved.of_times.update(self.of_times)
        return moved

    def insert(self, variable: Iterable[Frame]) -> Timeline:
        """Return the timeline with more frames, at times that have none."""
        return Timeline(tuple(sorted((*self.frames, *variable), key=lambda f: f.time)), self.end_slope, self.ends)
