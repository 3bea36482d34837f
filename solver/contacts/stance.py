"""Stances: points that stay in one place on the ground for a time, specified by a clip or inferred from its keyframes.

The paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array
from ..surface import Plane
from ..surface.points import Point
from .keyframe_points import KeyframePoints

HELD = 10.0  # [1] weight of stances of posed keyframes, which meet positions only approximately


@dataclass(frozen=True)
class Stance:
    """A point that stays at a position in the world or on another link, in a time interval, with a linear drift.

    Attributes:
        first: The start of the interval [s]; minus infinity: of the motion.
        last: The end of the interval [s]; infinity: of the motion.
        spot: The position at the start, (3,) [m]; NaN along unconstrained axes of the world.
        landed: The position at the end, (3,) [m], which differs from `spot` by the drift.
        weight: The weight relative to other stances [1].
        link: The link in whose axes the positions are; 0: the world.
        slack: The distance from the position without cost, at the start and the end [m]. If a keyframe puts a held body
            out of the limb's reach, only a stretched limb approaches the position; without slack it would whip to this
            pose and back.
    """

    point: Point
    first: float
    last: float
    spot: Array
    landed: Array
    weight: float = 1.0
    link: int = 0
    slack: tuple[float, float] = (0.0, 0.0)

    def place(self, t: Array) -> Array:
        """Return the target position of the point at times t (S,) [s], (3, S) [m], in the axes of the link."""
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
    return tuple(stance_between(soles, i, k, 1.0 if is_exact[i, k] else HELD) for k, i in np.argwhere(stays.T).tolist())


def stance_between(points: KeyframePoints, i: int, k: int, weight: float = 1.0) -> Stance:
    """Return the stance of point i from keyframe k to the next."""
    first, last = points.keys.times[k : k + 2].tolist()
    spot, landed = np.array(points.centres[:, i, k]), np.array(points.centres[:, i, k + 1])
    return Stance(points.points[i], first, last, spot, landed, weight)
