"""Stances: a sole point with the same position in two neighbouring keyframes keeps it between them.

Stances are inferred from keyframes only. The paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...contacts.thresholds import Thresholds
from ...curve.frame import Timeline
from ...figure.algebra import applied
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point
from ...surface import Surface
from ...surface.points import Point, placed, places_of
from ..block import Block
from ..penalty import Normalization, Penalty, Role

HELD = 10.0  # [1] weight of stances of posed keyframes, which meet positions only approximately


@dataclass(frozen=True)
class Stance:
    """A planted point in a time interval, with a linear drift.

    Attributes:
        point: The point.
        first: The start of the interval [s].
        last: The end of the interval [s].
        spot: The position at the start, (3,) [m].
        landed: The position at the end, (3,) [m], which differs from `spot` by the drift.
        weight: The weight relative to other stances [1].
    """

    point: Point
    first: float
    last: float
    spot: Array
    landed: Array
    weight: float = 1.0

    def place(self, t: Array) -> Array:
        """Return the target position of the point at times t (S,) [s], (3, S) [m]."""
        share = (t - self.first) / (self.last - self.first)
        return self.spot[:, None] + (self.landed - self.spot)[:, None] * share


@dataclass(frozen=True)
class StancePenalty(Penalty):
    """Σ over stances of weight times squared distance [m²] of the point from its target, during the stance."""

    stances: tuple[Stance, ...]

    name = "attach.stance"
    role = Role.CONTACT
    normalization = Normalization(1e-4, length_power=2, is_violation=True, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        stance, at = self._during(samples.t)
        if not stance.size:
            return
        links, positions, spots, drifts = self._arrays
        link, since = links[stance], samples.t[at] - self._times[0][stance]
        x, rotation = samples.links.poses(link * samples.count + at)
        arm = applied(rotation, positions[:, stance])
        away = x + arm - spots[:, stance] - drifts[:, stance] * since
        at, link, axes = along_axes(at, link)
        yield Block(at, away.ravel(), (of_point(at, link, np.tile(arm, 3), axes),), np.tile(self._weights[stance], 3))

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


def stances(figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]) -> tuple[Stance, ...]:
    """Return the stances inferred from keyframes.

    In both of two neighbouring keyframes, the point is near a surface and every joint from the root to the point is
    set. The two positions are close to each other (12 mm and 5 cm for an adult, see `Thresholds`).
    """
    if not points or not surfaces:
        return ()
    states, limits = keys.states, Thresholds.of(figure)
    samples = Samples.still(figure, states)
    centres, _, _ = places_of(points, samples)
    radius = np.array([point.radius for point in points])[:, None]
    height = np.min([surface.height(centres) for surface in surfaces], axis=0) - radius
    low, exact = (
        (np.abs(height) < limits.near_surface) & placed(figure, keys.known, points),
        placed(figure, keys.fixed, points),
    )
    result = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        for i, point in enumerate(points):
            spot, landed = centres[:, i, k], centres[:, i, k + 1]
            if low[i, k] and low[i, k + 1] and np.linalg.norm(landed - spot) < limits.same_spot:
                weight = 1.0 if exact[i, k] and exact[i, k + 1] else HELD
                result.append(Stance(point, float(first), float(last), spot.copy(), landed.copy(), weight))
    return tuple(result)


def resting_objects(figure: Figure, keys: Timeline, links: Sequence[int]) -> tuple[Stance, ...]:
    """Return the stances of objects with equal poses in two neighbouring keyframes, three points per object.

    An object is a link with a separate kinematic tree.
    """
    limits = Thresholds.of(figure)
    points = [Point(figure.links[link].name, link, limits.object_arm * axis) for link in links for axis in np.eye(3)]
    if not points:
        return ()
    states = keys.states
    centres, _, _ = places_of(points, Samples.still(figure, states))
    is_set = placed(figure, keys.known, points)
    resting: list[Stance] = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        for i, point in enumerate(points):
            here, there = centres[:, i, k], centres[:, i, k + 1]
            trio = slice(i - i % 3, i - i % 3 + 3)
            moved = np.linalg.norm(centres[:, trio, k + 1] - centres[:, trio, k], axis=0)
            if is_set[i, k] and is_set[i, k + 1] and np.all(moved < limits.same_place):
                resting.append(Stance(point, float(first), float(last), here.copy(), there.copy()))
    return tuple(resting)
