"""Placements: soft target positions of points at single times.

They represent keyframes given by positions that the solver has to reach. The paper has keyframes of joint angles only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...figure.algebra import applied
from ...figure.kinematics import Samples
from ...figure.wrenches import of_point
from ...surface.points import Point
from ..block import Block
from ..penalty import Momentary, Normalization


@dataclass(frozen=True, eq=False)
class Placed:
    """A target position for a point at one time.

    Attributes:
        time: The time [s].
        target: The target in the world, (3,) [m]; NaN along unconstrained axes.
    """

    point: Point
    time: float
    target: Array


@dataclass(frozen=True)
class Placement(Momentary):
    """Σ over placed points of the squared distance [m²] from the target along its constrained axes."""

    placed: tuple[Placed, ...]

    name = "attach.placement"
    normalization = Normalization(1e-4, length_power=2, is_violation=True)

    @cached_property
    def times(self) -> Array:
        """The times of the targets, (n,) [s]."""
        return np.array([p.time for p in self.placed])

    def away(self, samples: Samples) -> tuple[Index, Array]:
        """Return the points with a sample at their time (p,), and their offsets from the targets (3, p) [m]."""
        which, at = self.pairs(samples)
        return which, self._offsets(samples, which, at)[2]

    def residuals(self, samples: Samples) -> Iterator[Block]:
        which, at = self.pairs(samples)
        if not which.size:
            return
        flat, offset, away = self._offsets(samples, which, at)
        axis, pair = np.nonzero(self._arrays[3][:, which])
        at, link, point_offset = at[pair], flat[pair] // samples.count, offset[:, pair]
        yield Block(at, away[axis, pair], (of_point(at, link, point_offset, np.eye(3)[:, axis]),))

    def _offsets(self, samples: Samples, which: Index, at: Index) -> tuple[Index, Array, Array]:
        """Return the state of p pairs of a placed point and a sample.

        Returns:
            The flat indices link · S + sample (p,); the vectors from the links' origins to the points (3, p) [m]; and
            the offsets from the targets (3, p) [m], zero along unconstrained axes.
        """
        links, positions, targets, specified = self._arrays
        flat = links[which] * samples.count + at
        x, rotation = samples.links.poses(flat)
        offset = applied(rotation, positions[:, which])
        return flat, offset, (x + offset - targets[:, which]) * specified[:, which]

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array]:
        """The links (n,), the points in their frames, the targets, and the masks of constrained axes, (3, n) each."""
        targets = np.array([p.target for p in self.placed], float).reshape(-1, 3).T
        specified = ~np.isnan(targets)
        positions = np.array([p.point.position for p in self.placed]).reshape(-1, 3).T
        links = np.array([p.point.link for p in self.placed], np.intp)
        return links, positions, np.where(specified, targets, 0.0), specified.astype(float)
