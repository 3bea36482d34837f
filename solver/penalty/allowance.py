"""What keyframes themselves violate is allowed, from one keyframe to the next along a straight line.

A keyframe that pushes a hand into the hip cannot be changed. If the frames next to it were pushed out completely, the
limb would jerk; so between two keyframes the excess that is linearly interpolated between theirs is tolerated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array, Index


@dataclass(frozen=True)
class Allowance:
    """Excesses (..., K), at least 0, at key times (K,) [s], and along straight lines between them."""

    times: Array
    excess: Array

    def at(self, t: Array) -> Array:
        """(..., S) at times t (S,) [s]; before the first and after the last keyframe, what these have."""
        if not self.excess.any():
            return np.zeros((*self.excess.shape[:-1], t.size))
        span, share = self._place(t)
        return self.excess[..., span] * (1 - share) + self.excess[..., span + 1] * share

    def of(self, index: Index, t: Array) -> Array:
        """(..., P): at times t (P,) [s], of entries (P,) of the last axis but that of the keyframes."""
        span, share = self._place(t)
        return self.excess[..., index, span] * (1 - share) + self.excess[..., index, span + 1] * share

    def _place(self, t: Array) -> tuple[Index, Array]:
        """The keyframe before each time, and how far it is from there to the next one."""
        span = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, self.times.size - 2)
        return span, np.clip((t - self.times[span]) / (self.times[span + 1] - self.times[span]), 0, 1)
