"""Steps: legs that swing while another leg stands, and hops on one leg."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, Mask, segments_at
from ..figure.figure import Figure
from .contact import Contact
from .keyframe_points import KeyframePoints


@dataclass(frozen=True, eq=False)
class Steps:
    """The legs that take a step, over time.

    Attributes:
        times: The limits of the intervals, (n + 1,) [s].
        stepping: Which links belong to a leg that takes a step in each interval, (L, n).
        placing: Which links of legs place a foot, (L,): all but a foot with several sole points, which turns by itself.
    """

    times: Array
    stepping: Mask
    placing: Mask

    @classmethod
    def of(cls, soles: KeyframePoints, standing: Sequence[Contact]) -> Steps:
        """Return the legs that take a step between keyframes.

        Such a leg moves a point by more than 8 cm (for an adult) from one keyframe to the next. It takes the step while
        the point of another leg stands, and none of its own. The links that carry both legs, such as the pelvis, do not
        belong to it.
        """
        key_times, path = soles.keys.times, soles.figure.tables.path > 0
        begin, end = key_times[[0, -1]]
        bounds = [t for stance in standing for t in (stance.first, stance.last) if begin < t < end]
        times = np.unique([*key_times, *bounds])
        stepping = np.zeros((len(path), times.size - 1), bool)
        legs = np.asarray(path[soles.links].any(axis=0) & ~path[soles.links].all(axis=0))
        placing = legs & (np.bincount(soles.links, minlength=legs.size) < 2)
        if not soles.points or not standing:
            return cls(times, stepping, placing)
        first, last = np.array([stance.first for stance in standing]), np.array([stance.last for stance in standing])
        feet = np.array([stance.point.link for stance in standing])
        is_same_leg = same_leg(soles.figure)
        strides = soles.strides
        for k, segment in enumerate(segments_at(key_times, times[:-1]).tolist()):
            stands = np.unique(feet[(first <= times[k]) & (times[k + 1] <= last)])
            for link in np.unique(soles.links[strides[:, segment]]).tolist():
                if stands.size and not is_same_leg[link, stands].any():
                    stepping[:, k] |= path[link] & ~path[stands].any(axis=0)
        return cls(times, stepping, placing)

    def at(self, links: Index, t: Array) -> Mask:
        """Return which of the links (l,) belong to a leg that takes a step at times t (S,) [s], (l, S)."""
        return self.stepping[np.ix_(links, segments_at(self.times, t))]


def same_leg(figure: Figure) -> Mask:
    """Return which pairs of links are in one chain, one carrying the other, (L, L)."""
    path = figure.tables.path > 0
    return path | path.T
