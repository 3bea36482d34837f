"""Stances: points that stay in one place on the ground for a time, specified by a clip or inferred from its keyframes.

The paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array
from ..curve.frame import Timeline
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface import Plane, Surface
from ..surface.heights import height_above
from ..surface.points import Point, placed, places_of
from .thresholds import Thresholds

HELD = 10.0  # [1] weight of stances of posed keyframes, which meet positions only approximately


@dataclass(frozen=True)
class Stance:
    """A planted point in a time interval, with a linear drift.

    Attributes:
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
class Rest:
    """A point that rests from `first` to `last` [s] on a plane, or else on any surface below it.

    rolls  whether a sphere may roll on the ground like a wheel; otherwise its centre rests
    """

    point: Point
    first: float
    last: float
    ground: Plane | None = None
    rolls: bool = False


def stances(figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]) -> tuple[Stance, ...]:
    """Return the stances inferred from keyframes.

    In both of two neighbouring keyframes, the point is near a surface and every joint from the root to the point is
    set. The two positions are close to each other (12 mm and 5 cm for an adult, see `Thresholds`), and the point moves
    slower than 0.35 m/s.
    """
    if not points or not surfaces:
        return ()
    states, limits = keys.states, Thresholds.of(figure)
    samples = Samples.still(figure, states)
    centres, radii = places_of(points, samples)
    height = height_above(surfaces, centres, radii[:, None])
    low, exact = (
        (np.abs(height) < limits.near_surface) & placed(figure, keys.known, points),
        placed(figure, keys.fixed, points),
    )
    result = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        drift = min(limits.same_spot, limits.fast * (last - first))
        for i, point in enumerate(points):
            spot, landed = centres[:, i, k], centres[:, i, k + 1]
            if low[i, k] and low[i, k + 1] and np.linalg.norm(landed - spot) < drift:
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
    centres, _ = places_of(points, Samples.still(figure, states))
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
