"""The penalty on points that leave their positions: stances, grasps, closed loops and targets at single times.

A target represents a keyframe given by positions that the solver has to reach. The paper has keyframes of joint angles
only.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...array import Array, Index, Mask, pairs_within
from ...contacts.stance import Stance
from ...figure.algebra import applied
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point
from ...surface.points import Point
from ..block import Block
from ..penalty import Normalization, Penalty

TINY = 1e-12  # [m] least distance in a division


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
class Attachment(Penalty):
    """Σ over stances, while they last, of weight times squared distance [m²] of the point from its position.

    Only the distance beyond the slack of the stance counts. If every stance lasts for an instant, E contains the sum
    over the instants instead of an integral.
    """

    stances: tuple[Stance, ...]
    term_name: str = "attach.stance"

    @classmethod
    def at_instants(cls, placed: Sequence[Placed]) -> Attachment:
        """Return the penalty on points that are not at their targets."""
        stances = (Stance(p.point, p.time, p.time, p.target, p.target) for p in placed)
        return cls(tuple(stances), "attach.placement")

    @property
    def name(self) -> str:
        return self.term_name

    @cached_property
    def normalization(self) -> Normalization:
        is_interval = not self.instants.size and all(np.isfinite([s.first, s.last]).all() for s in self.stances)
        return Normalization(1e-4, length_power=2, is_violation=True, is_sharp=is_interval)

    @cached_property
    def instants(self) -> Array:
        return np.unique([s.first for s in self.stances if s.first == s.last])

    def displacements(self, samples: Samples) -> tuple[Index, Index, Array]:
        """Return the displacements of points from their positions.

        Returns:
            The stances (p,), a sample during each (p,), and the displacements (3, p) [m], zero along free axes.
        """
        stance, at = pairs_within(samples.t, self._arrays.first, self._arrays.last)
        return stance, at, self._vectors(samples, stance, at)[2]

    def residuals(self, samples: Samples) -> Iterator[Block]:
        arrays = self._arrays
        stance, at = pairs_within(samples.t, arrays.first, arrays.last)
        if not stance.size:
            return
        offset, spot, away = self._vectors(samples, stance, at)
        value, (when, link, direction) = away.ravel(), along_axes(at, arrays.links[stance])
        if arrays.has_slack:
            length = np.maximum(np.linalg.norm(away, axis=0), TINY)
            share = np.tile(np.maximum(1 - arrays.slack_at(samples.t[at], stance) / length, 0), 3)
            along = np.tile(away / length, 3)
            direction = share * direction + (share > 0) * (1 - share) * (away / length).ravel() * along
            value = share * value
        changes = [of_point(when, link, np.tile(offset, 3), direction)]
        if arrays.is_on_links:
            changes.append(of_point(when, np.tile(arrays.others[stance], 3), np.tile(spot, 3), -direction))
        weight = np.tile(arrays.weights[stance], 3)
        if not arrays.is_whole:
            rows = np.flatnonzero(arrays.is_constrained[:, stance])
            when, value, weight = when[rows], value[rows], weight[rows]
            changes = [part.select(rows) for part in changes]
        yield Block(when, value, tuple(changes), weight)

    def _vectors(self, samples: Samples, stance: Index, at: Index) -> tuple[Array, Array, Array]:
        """Return vectors (3, p) [m] of stances (p,) at samples (p,).

        These are the offsets of the points on their links, those of the positions on the other links, and the
        displacements from the positions to the points, zero along free axes.
        """
        arrays = self._arrays
        origin, rotation = samples.links.poses(arrays.links[stance] * samples.count + at)
        offset = applied(rotation, arrays.points[:, stance])
        spot = arrays.spots[:, stance] + arrays.drifts[:, stance] * (samples.t[at] - arrays.since[stance])
        away = origin + offset - spot
        if arrays.is_on_links:
            origin, rotation = samples.links.poses(arrays.others[stance] * samples.count + at)
            away += spot
            spot = applied(rotation, spot)
            away -= origin + spot
        return offset, spot, away if arrays.is_whole else away * arrays.is_constrained[:, stance]

    @cached_property
    def _arrays(self) -> _Arrays:
        return _Arrays.of(self.stances)


class _Arrays(NamedTuple):
    """The values of n stances.

    Attributes:
        first: The start times, (n,) [s].
        last: The end times, (n,) [s].
        since: The times since which positions drift, (n,) [s].
        links: The links of the points, (n,).
        others: The links of the positions, (n,).
        points: The points on their links, (3, n) [m].
        spots: The initial positions, (3, n) [m], zero along free axes.
        drifts: The drifts, (3, n) [m/s].
        is_constrained: The axes that are not free, (3, n).
        slack: The slack at the start and its growth, (2, n) [m, m/s].
        weights: The weights, (n,).
        has_slack: Whether a stance has slack.
        is_on_links: Whether a position is not in the world.
        is_whole: Whether no axis is free.
    """

    first: Array
    last: Array
    since: Array
    links: Index
    others: Index
    points: Array
    spots: Array
    drifts: Array
    is_constrained: Mask
    slack: Array
    weights: Array
    has_slack: bool
    is_on_links: bool
    is_whole: bool

    @classmethod
    def of(cls, stances: Sequence[Stance]) -> _Arrays:
        first, last = (np.array([getattr(s, name) for s in stances]) for name in ("first", "last"))
        length = np.where(last > first, last - first, 1.0)
        points, spots, landed = (
            np.array([vector(s) for s in stances]).reshape(-1, 3).T
            for vector in (lambda s: s.point.position, lambda s: s.spot, lambda s: s.landed)
        )
        slack, then = np.array([s.slack for s in stances]).reshape(-1, 2).T
        others = np.array([s.link for s in stances], np.intp)
        return cls(
            first=first,
            last=last,
            since=np.where(np.isfinite(first), first, 0.0),
            links=np.array([s.point.link for s in stances], np.intp),
            others=others,
            points=points,
            spots=np.nan_to_num(spots),
            drifts=np.nan_to_num(landed - spots) / length,
            is_constrained=~np.isnan(spots),
            slack=np.array([slack, (then - slack) / length]),
            weights=np.array([s.weight for s in stances]),
            has_slack=bool(slack.any() or then.any()),
            is_on_links=bool(others.any()),
            is_whole=not np.isnan(spots).any(),
        )

    def slack_at(self, t: Array, stance: Index) -> Array:
        """Return the slack (P,) [m] of stances (P,) at times t (P,) [s]."""
        start, growth = self.slack[:, stance]
        return start + growth * (t - self.since[stance])
