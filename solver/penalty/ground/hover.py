"""Bodies that do not float: between keyframes that touch the ground, the lowest point of the body stays near it.

The paper leaves floating to future work (§6). The cost stops growing with the height, because a body that rises
far leaps. It keeps growing where the keyframes do not specify the height of the body, because they specify no leap.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...array import Array, Index, Mask, segments_at
from ...contacts.footing import Interval, within
from ...contacts.keyframe_points import KeyframePoints
from ...contacts.thresholds import Thresholds
from ...curve.frame import Timeline
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.size import Size
from ...figure.wrenches import of_point
from ...surface import Surface
from ...surface.heights import clearance_gradients, clearances
from ...surface.points import Point, arrays_of
from ..allowance import Allowance
from ..block import Block
from ..penalty import Normalization, Penalty

NEAR = 0.01  # [m] height that the body of an adult may gain in one step of the search
NEGLIGIBLE = 1e-9  # of the lowest point's share
TINY = 1e-300  # [m] a residual that is zero
FIRM = 10.0  # times as much a body is held down that nothing else holds to a height
SHARPEST = 0.2  # [1] smallest blend, relative to the one between keyframes that are close in time


@dataclass(frozen=True)
class HoverPenalty(Penalty):
    """reach² (1 − exp(−(low/reach)²)) [m²] in given intervals, and 10 low² in `firm` intervals.

    low is a smooth minimum of the heights h of the points: max(0, −b log Σ exp(−h/b) − allowed). For n points of the
    same height, it is lower than the exact minimum by b log n, so such a height costs nothing. Between keyframes a time
    T > `long` apart, the smoothing length b is `blend` times (long/T)², and at least a fifth of `blend`. In `firm`
    intervals, it is a fifth of `blend`.

    Attributes:
        intervals: The intervals (first, last) [s] in which the body stays near the ground.
        reach: The height from which the body counts as being in the air [m].
        blend: The smoothing length of the minimum between keyframes that are close in time [m].
        firm: The intervals (first, last) [s] in which the body must not leave the ground.
        allowed: Heights of the lowest point that are tolerated, (K,) [m]; None: none.
        key_times: The times of the keyframes, (K,) [s]; None: all are close in time.
        long: The time between keyframes from which they specify the motion between them poorly [s].
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    intervals: tuple[Interval, ...]
    reach: float = Thresholds.float_reach
    blend: float = Thresholds.float_blend
    firm: tuple[Interval, ...] = ()
    allowed: Allowance | None = None
    key_times: Array | None = None
    long: float = Thresholds.long

    name = "grounded"
    normalization = Normalization(1e-4, length_power=2, is_violation=True)

    def allowing(self, figure: Figure, keys: Timeline) -> HoverPenalty:
        """Return the penalty for these keyframes.

        It tolerates the heights that keyframes fix, such as that of a foot that just left the ground. This is limited
        to keyframes whose neighbours are so near that there is no time for a stance between them.
        """
        if not self.points or not self.surfaces:
            return self
        points = KeyframePoints.of(figure, keys, self.points, self.surfaces)
        low, is_fixed = np.maximum(points.heights.min(axis=0), 0), points.is_fixed.all(axis=0)
        short = np.pad(np.diff(keys.times) <= points.limits.shortly, 1, constant_values=True)
        allowed = Allowance(keys.times, low * (is_fixed & short[:-1] & short[1:]))
        return replace(self, allowed=allowed, key_times=keys.times, long=points.limits.long)

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points."""
        return arrays_of(self.points)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        at = self._during(samples.t)
        if not at.size:
            return
        links, positions, radius = self._arrays
        centre, offset = samples.links.points(links, positions)
        if at.size < samples.count:
            centre, offset = centre[:, :, at], offset[:, :, at]
        height, origin = clearances(self.surfaces, centre, radius)
        least, firm = height.min(axis=0), within(self.firm, samples.t[at])
        blend = self._blend(samples.t[at], firm)
        which, pair = np.nonzero(height < least + blend * np.log(1 / NEGLIGIBLE))
        share = np.exp((least[pair] - height[which, pair]) / blend[pair])
        total = np.bincount(pair, share, at.size)
        allowed = 0.0 if self.allowed is None else self.allowed.at(samples.t[at])
        lowest = least - blend * np.log(total) - allowed
        value, slope = self._faded(lowest, firm)
        near = lowest > -NEAR * Size.of(samples.figure).length
        high, chosen = np.flatnonzero(near), np.flatnonzero(near[pair])
        which, pair, share = which[chosen], pair[chosen], (share / total[pair] * slope[pair])[chosen]
        up = clearance_gradients(self.surfaces, origin[which, pair], centre[:, which, pair], radius[which])
        changes = of_point(at[pair], links[which], offset[:, which, pair], share * up)
        yield Block(at[high], value[high], (changes,), one_sided=True, of=np.searchsorted(high, pair))

    def _blend(self, t: Array, firm: Mask) -> Array:
        """Return the smoothing lengths [m] at times t (S,) [s], some of them firm, (S,)."""
        share = np.ones(t.size)
        if self.key_times is not None:
            share = (self.long / np.diff(self.key_times))[segments_at(self.key_times, t)] ** 2
        return self.blend * np.clip(np.where(firm, 0, share), SHARPEST, 1)

    def _faded(self, lowest: Array, firm: Mask) -> tuple[Array, Array]:
        """Residuals (P,) [m] of heights (P,), some of them firm, and how fast they grow with these."""
        share = (lowest / self.reach) ** 2
        value = np.where(lowest > 0, self.reach * np.sqrt(-np.expm1(-share)), lowest)
        slope = np.where(lowest > 0, lowest * np.exp(-share) / np.maximum(value, TINY), 1.0)
        root = np.sqrt(FIRM)
        return np.where(firm, root * lowest, value), np.where(firm, root, slope)

    def _during(self, t: Array) -> Index:
        """The samples of times t (S,) in the intervals."""
        inside = within((*self.intervals, *self.firm), t)
        return np.flatnonzero(inside) if self.points and self.surfaces else np.zeros(0, np.intp)
