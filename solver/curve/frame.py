"""Frame: the state of a figure at one time, with the entries that are fixed. Timeline: frames in order of time.

A keyframe has every entry fixed, a partial keyframe some, a variable frame none (§2 of the paper). One type serves all.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..array import Array, Mask, frozen, frozen_mask


class TimelineError(ValueError):
    """Frames that make no timeline: too few, out of order, or with entries that are no numbers."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The state of the figure at one time.

    time   [s]
    state  (N,)  a figure's state: metres, radians and quaternions wxyz of any length > 0
    fixed  (N,)  which entries the animator set. A fixed entry of a joint means the rotation *relative to the parent*,
                 whatever coordinates the state is in; quaternions are fixed whole or not at all
    posed  (N,)  which of the others were found for what the keyframe is to do (a foot that stands, a bent knee): the
                 search starts there and may move them, and what keyframes tell, such as where feet stand, they tell too
    """

    time: float
    state: Array
    fixed: Mask
    posed: Mask | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "time", float(self.time))
        object.__setattr__(self, "state", frozen(self.state))
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
        """A keyframe; with `fixed`, a partial one."""
        state = np.asarray(state, float)
        return cls(time, state, np.ones(state.shape, bool) if fixed is None else np.asarray(fixed, bool))

    @classmethod
    def variable(cls, time: float, state: ArrayLike) -> Frame:
        """A variable frame: nothing fixed."""
        state = np.asarray(state, float)
        return cls(time, state, np.zeros(state.shape, bool))

    @classmethod
    def _of_checked(cls, time: float, state: Array, fixed: Mask, posed: Mask | None = None) -> Frame:
        """A frame of finite numbers in read-only arrays, as they are."""
        frame = object.__new__(cls)
        frame.__dict__.update(time=time, state=state, fixed=fixed, posed=posed)
        return frame

    @classmethod
    def many(
        cls, times: ArrayLike, states: ArrayLike, fixed: ArrayLike, posed: Sequence[Mask | None] | None = None
    ) -> list[Frame]:
        """Frames of times (K,), states (K, N) and masks (K, N); posed as frames have it, of every one."""
        times, states, fixed = np.array(times, float), frozen(states), frozen_mask(fixed)
        if states.ndim != 2 or states.shape != fixed.shape or times.shape != states.shape[:1]:
            raise TimelineError(f"times {times.shape}, states {states.shape} and fixed {fixed.shape} do not match")
        good = np.isfinite(times) & np.isfinite(states).all(axis=1)
        if not good.all():
            raise TimelineError(f"the frame at t = {times[~good][0]:g} s holds entries that are not finite numbers")
        return list(map(cls._of_checked, times.tolist(), states, fixed, posed or [None] * len(states)))

    @property
    def known(self) -> Mask:
        """(N,) which entries the frame tells: those that are fixed, and those that were posed."""
        return self.fixed if self.posed is None else self.fixed | self.posed

    @property
    def is_variable(self) -> bool:
        return not self.fixed.any()

    @property
    def is_key(self) -> bool:
        return bool(self.fixed.all())


@dataclass(frozen=True, eq=False)
class Timeline:
    """Frames in order of time, and what holds at the two ends of the clip.

    ends       "free": both end slopes are unknowns; "clamped": they are `end_slope`; "periodic": the last frame repeats
               the first, its free roots as far on and turned as the two frames say, and the curve is C² across the
               seam; "held": y, y' and y'' of both ends stay as they are, for which the variable frames beside them
               make way
    end_slope  (2, N)  y' at the first and the last frame [state/s]; a starting value where the slopes are free. Of a
               periodic clip the jumps of y' and y'' from the end to the start: zero, but for what comes back turned
               and for quaternions that come back as −q
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
        object.__setattr__(self, "end_slope", frozen(self.end_slope))
        if self.end_slope.shape != (2, self.width):
            raise TimelineError(f"end_slope has shape {self.end_slope.shape}, not (2, {self.width})")
        if self.ends not in ("free", "clamped", "periodic", "held"):
            raise TimelineError(f"ends = {self.ends!r}: not one of 'free', 'clamped', 'periodic', 'held'")
        if self.ends == "held" and not (
            len(self.frames) > 3 and self.frames[1].is_variable and self.frames[-2].is_variable
        ):
            raise TimelineError("held ends need a variable frame beside each")

    @property
    def width(self) -> int:
        """N, the number of entries of a state."""
        return self.frames[0].state.size

    @cached_property
    def times(self) -> Array:
        """(M,) [s]"""
        return frozen([frame.time for frame in self.frames])

    @cached_property
    def states(self) -> Array:
        """(M, N)"""
        return frozen([frame.state for frame in self.frames])

    @cached_property
    def fixed(self) -> Mask:
        """(M, N)"""
        return frozen_mask([frame.fixed for frame in self.frames])

    @cached_property
    def known(self) -> Mask:
        """(M, N) which entries the frames tell, see `Frame.known`."""
        return frozen_mask([frame.known for frame in self.frames])

    @cached_property
    def rows(self) -> Array:
        """(M + 2, N): the frames' states and below them what the two ends say; a spline is linear in these."""
        return frozen(np.concatenate([self.states, self.end_slope]))

    @cached_property
    def of_times(self) -> dict[str, Any]:
        """What others keep of the times and ends, shared with the timelines that have the same."""
        return {}

    @property
    def variable_count(self) -> int:
        return int(np.count_nonzero(~self.fixed.any(axis=1)))

    def with_rows(self, rows: ArrayLike) -> Timeline:
        """The same times and masks with other states and end slopes, rows (M + 2, N)."""
        rows = np.asarray(rows, float)
        if rows.shape != (len(self.frames) + 2, self.width):
            raise TimelineError(f"rows have shape {rows.shape}, not {self.rows.shape} as the timeline's")
        posed = [frame.posed for frame in self.frames]
        moved = Timeline(tuple(Frame.many(self.times, rows[:-2], self.fixed, posed)), rows[-2:], self.ends)
        moved.of_times.update(self.of_times)
        return moved

    def inserted(self, variable: Iterable[Frame]) -> Timeline:
        """With more frames, each at a time of its own."""
        return Timeline(tuple(sorted((*self.frames, *variable), key=lambda f: f.time)), self.end_slope, self.ends)
