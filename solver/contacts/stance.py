"""Stances: points that stay in one place on the ground for a time, specified by a clip or inferred from its keyframes.

The paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..array import Array, Mask
from ..curve.spline import path_of
from ..figure.kinematics import Samples
from ..surface import Plane
from ..surface.points import Point
from .grasp import Grasp
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


class _Unheld(NamedTuple):
    """A part of a segment in which nothing holds an object that lies at keyframe `key`.

    Attributes:
        grasp: The grasp that begins or ends the hold at its other end.
        hold: The time of this end [s].
    """

    key: int
    grasp: Grasp
    hold: float


def resting_objects(
    keyframes: KeyframePoints, links: Sequence[int], grasps: Sequence[Grasp] = ()
) -> tuple[Stance, ...]:
    """Return the stances of objects before and after holds, three points per object.

    An object with equal poses in two neighbouring keyframes rests between them. In a segment in which a hold begins or
    ends, it also rests between the hold and a keyframe at which it lies: its pose is the same in the keyframe on the
    other side, or there is none. A hand must be near it at this end of the hold. Otherwise the object may be in flight,
    as if thrown.

    Args:
        keyframes: Any points at the keyframes.
        links: The objects: links with a separate kinematic tree.
        grasps: All grasps.
    """
    inferred: list[Stance] = []
    for link in links:
        arm, name = keyframes.limits.object_arm, keyframes.figure.links[link].name
        points = keyframes.with_points([Point(name, link, arm * axis) for axis in np.eye(3)])
        is_set = np.logical_and.reduce(points.is_known)
        stays: Mask = np.logical_and.reduce(points.moves < points.limits.same_place) & is_set[:-1] & is_set[1:]
        inferred += [_stance(points, i, k) for k in np.flatnonzero(stays).tolist() for i in range(3)]
        for part in _unheld(points, stays, is_set, [grasp for grasp in grasps if grasp.link == link]):
            if _is_near(points, part, link):
                first, last = sorted((float(keyframes.keys.times[part.key]), part.hold))
                places = points.centres[:, :, part.key].T.copy()
                inferred += [Stance(p, first, last, at, at) for p, at in zip(points.points, places, strict=True)]
    return tuple(inferred)


def _unheld(points: KeyframePoints, stays: Mask, is_set: Mask, grasps: Sequence[Grasp]) -> Iterator[_Unheld]:
    """Yield the parts of segments before and after holds of one object, given by its points.

    Args:
        stays: The segments in which it rests, (K − 1,).
        is_set: The keyframes that place it, (K,).
        grasps: Its grasps.
    """
    for k, start, end in points.segments():
        holds = [grasp for grasp in grasps if grasp.first < end and start < grasp.last]
        if not holds or stays[k]:
            continue
        first, last = min(holds, key=lambda grasp: grasp.first), max(holds, key=lambda grasp: grasp.last)
        if first.first - start > points.limits.lift_off and is_set[k] and _lies(stays, k - 1):
            yield _Unheld(k, first, first.first)
        if end - last.last > points.limits.lift_off and is_set[k + 1] and _lies(stays, k + 1):
            yield _Unheld(k + 1, last, last.last)


def _lies(stays: Mask, beyond: int) -> bool:
    """Return whether an object lies in the segment beyond a keyframe, or there is none."""
    return not 0 <= beyond < stays.size or bool(stays[beyond])


def _is_near(points: KeyframePoints, part: _Unheld, link: int) -> bool:
    """Return whether the hand is near the object at the end of the hold, on the spline through the keyframes."""
    at = np.array([part.hold])
    samples = Samples(points.figure, *path_of(points.keys).motion(at))
    grasp, links = part.grasp, points.samples.links
    hand, _ = samples.links.points(np.array([grasp.point.link]), grasp.point.position[:, None])
    spot = grasp.spot(at)
    place: Array = links.x[:, link, part.key]
    if spot is not None:
        place = place + links.rotation[:, :, link, part.key] @ spot[:, 0]
    return float(np.linalg.norm(hand[:, 0, 0] - place)) < points.limits.at_hand


def _stance(points: KeyframePoints, i: int, k: int, weight: float = 1.0) -> Stance:
    """Return the stance of point i from keyframe k to the next."""
    first, last = points.keys.times[k : k + 2].tolist()
    spot, landed = np.array(points.centres[:, i, k]), np.array(points.centres[:, i, k + 1])
    return Stance(points.points[i], first, last, spot, landed, weight)
