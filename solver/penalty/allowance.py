"""Tolerance of violations in keyframes, interpolated linearly between neighbouring keyframes.

A keyframe that pushes a hand into the hip cannot be changed. If the neighbouring frames were pushed out completely, the
limb would jerk. Between keyframes the interpolated violation is therefore tolerated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, Mask, segments_at
from ..curve.frame import Timeline


@dataclass(frozen=True)
class Allowance:
    """Tolerated excesses of one-sided residuals, linear between keyframes.

    Attributes:
        times: The times of the keyframes, (K,) [s].
        excess: The excess in each keyframe, at least 0, (..., K), in the unit of the residual.
    """

    times: Array
    excess: Array

    @classmethod
    def in_keys(cls, keys: Timeline, excess: Array, is_fixed: Mask) -> Allowance | None:
        """Return the tolerance of positive excesses (..., K) that keyframes fix, (..., K); None without any."""
        excess = np.maximum(excess, 0) * is_fixed
        return cls(keys.times, excess) if excess.any() else None

    def at(self, t: Array) -> Array:
        """Return the tolerated excesses, constant outside the range of the keyframes.

        Args:
            t: Times (S,) [s].

        Returns:
            The excesses (..., S).
        """
        span, share = self._place(t)
        return self.excess[..., span] * (1 - share) + self.excess[..., span + 1] * share

    def of(self, index: Index, t: Array) -> Array:
        """Return the tolerated excesses (..., P) at times t (P,) [s] for entries (P,) of the second-last axis."""
        span, share = self._place(t)
        return self.excess[..., index, span] * (1 - share) + self.excess[..., index, span + 1] * share

    def _place(self, t: Array) -> tuple[Index, Array]:
        """Return the keyframe before each time, and the share of the segment from it to the time."""
        span = segments_at(self.times, t)
        return span, np.clip((t - self.times[span]) / (self.times[span + 1] - self.times[span]), 0, 1)
