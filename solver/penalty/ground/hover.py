"""Bodies that do not float: everywhere, a weak pull draws the lowest point of the body to the ground.

The paper leaves floating to future work (§6). The cost stops growing with the height, because a body that rises far
leaps.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...contacts.contact import Interval, within
from ...contacts.thresholds import Thresholds
from ...figure.dynamics import Size
from ...figure.kinematics import Samples
from ...figure.wrenches import of_point
from ...surface import Surface
from ...surface.heights import clearance_gradients, clearances
from ...surface.points import Point, arrays_of
from ...tolerances import ROUNDING, SMALLEST
from ..block import Block
from ..penalty import Normalization, Penalty, Role

NEAR = 0.01  # [m] height that the body of an adult may gain in one step of the search
FIRM = 10.0  # [1] factor of residuals in intervals in which only the ground carries the body


@dataclass(frozen=True)
class HoverPenalty(Penalty):
    """reach² (1 − exp(−(low/reach)²)) [m²], and 100 times as much in `landed` intervals.

    low is a smooth minimum of the heights h of the points: max(0, −b log Σ exp(−h/b)). For n points of the same height,
    it is lower than the exact minimum by b log n, so such a height costs nothing.

    Attributes:
        reach: The height from which the body counts as being in the air [m].
        blend: The smoothing length b of the minimum [m].
        landed: The intervals (first, last) [s] in which only the ground carries the body.
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    reach: float = Thresholds.away
    blend: float = Thresholds.float_blend
    landed: tuple[Interval, ...] = ()

    name = "grounded"
    role = Role.PHYSICS
    is_sharp = True
    normalization = Normalization(1e-4, length_power=2)

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points."""
        return arrays_of(self.points)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        if not self.points or not self.surfaces:
            return
        links, positions, radius = self._arrays
        centre, offset = samples.links.points(links, positions)
        height, origin = clearances(self.surfaces, centre, radius)
        least = height.min(axis=0)
        which, at = np.nonzero(height < least + self.blend * np.log(1 / ROUNDING))
        share = np.exp((least[at] - height[which, at]) / self.blend)
        total = np.bincount(at, share, samples.count)
        lowest = least - self.blend * np.log(total)
        faded = -np.expm1(-((lowest / self.reach) ** 2))
        value = np.where(lowest > 0, self.reach * np.sqrt(faded), lowest)
        slope = np.where(lowest > 0, lowest * (1 - faded) / np.maximum(value, SMALLEST), 1.0)
        firm = np.where(within(self.landed, samples.t), FIRM, 1.0)
        value, slope = firm * value, firm * slope
        near = lowest > -NEAR * Size.of(samples.figure).length
        high, chosen = np.flatnonzero(near), np.flatnonzero(near[at])
        which, at, share = which[chosen], at[chosen], (share / total[at] * slope[at])[chosen]
        up = clearance_gradients(self.surfaces, origin[which, at], centre[:, which, at], radius[which])
        changes = of_point(at, links[which], offset[:, which, at], share * up)
        yield Block(high, value[high], (changes,), one_sided=True, of=np.searchsorted(high, at))
