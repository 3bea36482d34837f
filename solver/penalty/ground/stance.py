"""The penalty on planted points that leave their places."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...contacts.stance import Stance
from ...figure.algebra import applied
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point
from ..block import Block
from ..penalty import Normalization, Penalty


@dataclass(frozen=True)
class StancePenalty(Penalty):
    """Σ over stances of weight times squared distance [m²] of the point from its target, during the stance."""

    stances: tuple[Stance, ...]

    name = "attach.stance"
    normalization = Normalization(1e-4, length_power=2, is_violation=True, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        stance, at = self._during(samples.t)
        if not stance.size:
            return
        links, positions, spots, drifts = self._arrays
        link, since = links[stance], samples.t[at] - self._times[0][stance]
        x, rotation = samples.links.poses(link * samples.count + at)
        offset = applied(rotation, positions[:, stance])
        away = x + offset - spots[:, stance] - drifts[:, stance] * since
        at, link, axes = along_axes(at, link)
        yield Block(
            at, away.ravel(), (of_point(at, link, np.tile(offset, 3), axes),), np.tile(self._weights[stance], 3)
        )

    def _during(self, t: Array) -> tuple[Index, Index]:
        """Return the pairs of a stance and a sample within it: two index arrays (p,), for sample times t (S,) [s]."""
        first, last = self._times
        order = np.argsort(t, kind="stable")
        rising = t[order]
        begin, end = np.searchsorted(rising, first, "left"), np.searchsorted(rising, last, "right")
        active = np.flatnonzero(end > begin)
        begin, counts = begin[active], (end - begin)[active]
        place = np.arange(counts.sum()) + np.repeat(begin - (np.cumsum(counts) - counts), counts)
        return np.repeat(active, counts), order[place]

    @cached_property
    def _times(self) -> tuple[Array, Array]:
        """The start and end times of the stances, (n,) [s] each."""
        return np.array([s.first for s in self.stances]), np.array([s.last for s in self.stances])

    @cached_property
    def _weights(self) -> Array:
        """The weights of the stances, (n,)."""
        return np.array([s.weight for s in self.stances])

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array]:
        """The links (n,), the points in their frames [m], the initial targets [m] and the drifts [m/s], (3, n) each."""
        links = np.array([s.point.link for s in self.stances], np.intp)
        drifts = [(s.landed - s.spot) / (s.last - s.first) for s in self.stances]
        positions, spots = [s.point.position for s in self.stances], [s.spot for s in self.stances]
        return links, np.array(positions).T, np.array(spots).T, np.array(drifts).T
