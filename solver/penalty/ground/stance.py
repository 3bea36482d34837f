"""Stances: a point of the sole that two neighbouring keyframes put on the same spot stays there in between.

The keyframes are the only input. This goes beyond the paper, which leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...curve.frame import Timeline
from ...figure.algebra import applied
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point
from ...surface import Surface
from ...surface.points import Point, placed, places_of
from ..block import Block
from ..penalty import Normalization, Penalty, Role

NEAR_SURFACE = 0.012  # [m] by which a sole that stands may be off its surface in a keyframe
SAME_SPOT = 0.05  # [m] that keyframes may put a standing point apart
SAME_PLACE = 0.001  # [m] that keyframes may put an object apart that lies: it has no reason to drift
ARM = 0.2  # [m] from an object's origin to the points that fix its pose: half the size of what a person carries
HELD = 10.0  # factor of the weight of a stance of a posed keyframe, which holds no point exactly


@dataclass(frozen=True)
class Stance:
    """One point at rest: from its spot (3,) [m] at time `first` [s] to `landed` at `last`, the same but for drift.

    weight  of this stance among the others
    """

    point: Point
    first: float
    last: float
    spot: Array
    landed: Array
    weight: float = 1.0

    def place(self, t: Array) -> Array:
        """Where the point should be at times t (S,): (3, S)."""
        share = (t - self.first) / (self.last - self.first)
        return self.spot[:, None] + (self.landed - self.spot)[:, None] * share


@dataclass(frozen=True)
class StancePenalty(Penalty):
    """Σ over stances of their weight times the squared distance [m²] of the point from its spot, while they last."""

    stances: tuple[Stance, ...]

    name = "attach.stance"
    role = Role.CONTACT
    normalization = Normalization(1e-4, is_violation=True, is_sharp=True)

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
        """The pairs of a stance and a sample at times t (S,) that it holds for, (p,) each."""
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
        """When the stances begin and end, (n,) each."""
        return np.array([s.first for s in self.stances]), np.array([s.last for s in self.stances])

    @cached_property
    def _weights(self) -> Array:
        """(n,)"""
        return np.array([s.weight for s in self.stances])

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array]:
        """Links (n,), the points' positions on them, their spots and drifts per second, (3, n) each."""
        links = np.array([s.point.link for s in self.stances], np.intp)
        drifts = [(s.landed - s.spot) / (s.last - s.first) for s in self.stances]
        positions, spots = [s.point.position for s in self.stances], [s.spot for s in self.stances]
        return links, np.array(positions).T, np.array(spots).T, np.array(drifts).T


def stances(figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]) -> tuple[Stance, ...]:
    """The stances that a timeline of keyframes implies: a point within 12 mm of a surface in two neighbouring ones,
    on spots less than 5 cm apart, and both keyframes set every joint from the root to the point."""
    if not points or not surfaces:
        return ()
    states = keys.states
    samples = Samples.still(figure, states)
    centres, _, _ = places_of(points, samples)
    radius = np.array([point.radius for point in points])[:, None]
    height = np.min([surface.height(centres) for surface in surfaces], axis=0) - radius
    low, exact = (
        (np.abs(height) < NEAR_SURFACE) & placed(figure, keys.known, points),
        placed(figure, keys.fixed, points),
    )
    result = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        for i, point in enumerate(points):
            spot, landed = centres[:, i, k], centres[:, i, k + 1]
            if low[i, k] and low[i, k + 1] and np.linalg.norm(landed - spot) < SAME_SPOT:
                weight = 1.0 if exact[i, k] and exact[i, k + 1] else HELD
                result.append(Stance(point, float(first), float(last), spot.copy(), landed.copy(), weight))
    return tuple(result)


def resting_objects(figure: Figure, keys: Timeline, links: Sequence[int]) -> tuple[Stance, ...]:
    """Return stances of objects that two neighbouring keyframes put in the same pose: three points of each.

    An object is a link with a kinematic tree of its own.
    """
    points = [Point(figure.links[link].name, link, ARM * axis) for link in links for axis in np.eye(3)]
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
            if is_set[i, k] and is_set[i, k + 1] and np.all(moved < SAME_PLACE):
                resting.append(Stance(point, float(first), float(last), here.copy(), there.copy()))
    return tuple(resting)
