"""Stances: points that stay in one place on the ground for a time, specified by a clip or inferred from its keyframes.

The paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array
from ..surface import Plane
from ..surface.points import Point
from .keyframe_points import KeyframePoints

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

    rolls     whether a sphere may roll on the ground like a wheel; otherwise its centre rests
    position  the specified position (3,) [m], from which keyframes may differ a little; None if there is none
    """

    point: Point
    first: float
    last: float
    ground: Plane | None = None
    rolls: bool = False
    position: Array | None = None


def stances(soles: KeyframePoints) -> tuple[Stance, ...]:
    """Return the stances of points inferred from keyframes.

    In both of two neighbouring keyframes, the point is near a surface and every joint from the root to the point is
    set. The two positions are close to each other (12 mm and 5 cm for an adult, see `Thresholds`), and the point moves
    slower than 0.35 m/s.
    """
    limits = soles.limits
    drift = np.minimum(limits.same_spot, limits.fast * np.diff(soles.keys.times))
    stays = soles.is_near[:, :-1] & soles.is_near[:, 1:] & (soles.moves < drift)
    is_exact = soles.is_fixed[:, :-1] & soles.is_fixed[:, 1:]
    return tuple(_stance(soles, i, k, 1.0 if is_exact[i, k] else HELD) for k, i in np.argwhere(stays.T).tolist())


def resting_objects(keyframes: KeyframePoints, links: Sequence[int]) -> tuple[Stance, ...]:
    """Return the stances of objects with equal poses in two neighbouring keyframes, three points per object.

    Args:
        keyframes: Any points at the keyframes.
        links: The objects: links with a separate kinematic tree.
    """
    names, limits = keyframes.figure.links, keyframes.limits
    points = [Point(names[link].name, link, limits.object_arm * axis) for link in links for axis in np.eye(3)]
    objects = keyframes.with_points(points)
    stays = (objects.moves < limits.same_place) & objects.is_known[:, :-1] & objects.is_known[:, 1:]
    stays = stays.reshape(len(links), 3, keyframes.keys.times.size - 1).all(axis=1).repeat(3, axis=0)
    return tuple(_stance(objects, i, k) for k, i in np.argwhere(stays.T).tolist())


def _stance(points: KeyframePoints, i: int, k: int, weight: float = 1.0) -> Stance:
    """Return the stance of point i from keyframe k to the next."""
    first, last = points.keys.times[k : k + 2].tolist()
    spot, landed = np.array(points.centres[:, i, k]), np.array(points.centres[:, i, k + 1])
    return Stance(points.points[i], first, last, spot, landed, weight)
