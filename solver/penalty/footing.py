"""What carries the figure when, read off the keyframes: feet that stand, and flights between them.

A segment between two keyframes is a stance if a point of a sole rests on one spot in both, see `stances`; a flight if
nothing can carry the figure there; and else unknown: a foot may come and go in between.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..figure import Figure
from ..frame import Mask, Timeline
from ..kinematics import Samples
from ..quaternion import Array
from ..surface import Plane, Surface
from ..wrench import RootWrench
from .contact import Contact, Point
from .planted import NEAR_SURFACE, Stance, placed

HIGHEST = 1.25  # [m] that a centre of mass rises in a flight that nobody asked for
STRAY = 0.15  # [m] that keyframes in the air may be off the free fall between the ends of the flight
Interval = tuple[float, float]


@dataclass(frozen=True)
class Footing:
    """A point that a surface may push from `first` to `last` [s], along its unit normal (3,) and by friction across."""

    point: Point
    first: float
    last: float
    normal: Array


def footings(
    figure: Figure,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    stances: Sequence[Stance],
) -> tuple[Footing, ...]:
    """A foot that stands from one keyframe to the next may push with every point that touches in one of them."""
    if not points or not surfaces:
        return ()
    height, over = _heights(figure, keys, points, surfaces)
    touches = (np.abs(height) < NEAR_SURFACE) & placed(figure, keys.fixed, points)
    found = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        standing = {stance.point.link for stance in stances if stance.first <= first and last <= stance.last}
        for i, point in enumerate(points):
            on = [j for j in (k, k + 1) if touches[i, j]]
            if on and point.link in standing:
                found.append(Footing(point, float(first), float(last), _normal(surfaces[over[i, on[0]]])))
    return tuple(found)


def flights(
    figure: Figure,
    root: int,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    stances: Sequence[Stance],
    body: Sequence[Point] = (),
) -> tuple[Interval, ...]:
    """The flights that a timeline of keyframes implies.

    A flight goes from the keyframe in which the last foot leaves, or in which the clip begins in the air, to that in
    which the first foot lands or the clip ends. No foot stands on one spot in two of its neighbouring keyframes, all
    of them fix the feet, and no other point of the `body` touches a surface. A foot that leaves has stood before, and
    is no more flat on the ground; a foot that lands stands afterwards. The free fall through both ends rises by no
    more than 1.25 m and passes keyframes in between within 15 cm.
    """
    if not points or not surfaces or not figure.gravity.any():
        return ()
    seen = _Keys.of(figure, keys, points, surfaces, stances, body)
    times, rising = np.asarray(keys.times), _rising(figure, root, keys)
    found, first = [], 0
    for k in range(times.size - 1):
        if not seen.free[k]:
            first = k + 1
        elif k + 2 == times.size or seen.touched[k + 1] or not seen.free[k + 1]:
            some = slice(first, k + 2)
            if seen.leaves(first) and seen.lands(k + 1) and _falls(figure, times[some], rising[some]):
                found.append((float(times[first]), float(times[k + 1])))
            first = k + 1
    return tuple(found)


@dataclass(frozen=True)
class _Keys:
    """What keyframes say of contact: free (K − 1,) segments that nothing carries; touched, flat (K,): whether a foot
    touches there, and with all its points."""

    free: Mask
    touched: Mask
    flat: Mask

    @classmethod
    def of(
        cls,
        figure: Figure,
        keys: Timeline,
        points: Sequence[Point],
        surfaces: Sequence[Surface],
        stances: Sequence[Stance],
        body: Sequence[Point],
    ) -> _Keys:
        low = np.abs(_heights(figure, keys, points, surfaces)[0]) < NEAR_SURFACE
        known = placed(figure, keys.fixed, points).all(axis=0)
        feet = [np.array([p.link == link for p in points]) for link in sorted({p.link for p in points})]
        flat = np.any([low[foot].all(axis=0) for foot in feet if foot.sum() > 1] or [0 * known], axis=0)
        others = [point for point in body if point.link not in {p.link for p in points}]
        if others:
            known &= ~np.any(_heights(figure, keys, others, surfaces)[0] < NEAR_SURFACE, axis=0)
        begin, end = keys.times[:-1], keys.times[1:]
        carried = np.any([(s.first < end) & (begin < s.last) for s in stances] or [np.zeros(begin.size, bool)], axis=0)
        return cls(~carried & known[:-1] & known[1:], low.any(axis=0), flat)

    def leaves(self, k: int) -> bool:
        """Whether a flight may begin at a keyframe."""
        return not self.touched[k] or (not self.flat[k] and (k == 0 or not self.free[k - 1]))

    def lands(self, k: int) -> bool:
        """Whether a flight may end at a keyframe."""
        return not self.touched[k] or k == self.free.size or not self.free[k]


def _heights(
    figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]
) -> tuple[Array, NDArray[np.intp]]:
    """Points' heights over the nearest surface below them at keyframes, and which that is, (n, K) each."""
    samples = Samples(figure, keys.states, 0 * keys.states, 0 * keys.states)
    centres, _, _ = Contact(tuple(points), ()).centres(samples)
    heights = np.array([surface.height(centres) for surface in surfaces])
    heights -= np.array([point.radius for point in points])[:, None]
    over = np.argmin(heights, axis=0)
    return np.take_along_axis(heights, over[None], axis=0)[0], over


def _normal(surface: Surface) -> Array:
    """The way up from a surface."""
    return surface.normal if isinstance(surface, Plane) else np.array([0.0, 0, 1])


def _rising(figure: Figure, root: int, keys: Timeline) -> Array:
    """(K,) [m] how high, against gravity, the centre of mass is."""
    samples = Samples(figure, keys.states, 0 * keys.states, 0 * keys.states)
    return -figure.gravity @ RootWrench(samples, root).centre / np.linalg.norm(figure.gravity)


def _falls(figure: Figure, times: Array, height: Array) -> bool:
    """Whether heights of a centre of mass at times (k,) look like one free fall."""
    g, t = float(np.linalg.norm(figure.gravity)), times - times[0]
    speed = (height[-1] - height[0]) / t[-1] + g * t[-1] / 2
    rise = speed**2 / (2 * g) if 0 < speed < g * t[-1] else 0.0
    path = height[0] + speed * t - g * t**2 / 2
    return bool(rise + min(height[0] - height[-1], 0) <= HIGHEST and np.abs(height - path).max() <= STRAY)
