"""The support of a figure over time, inferred from keyframes: standing feet, and flights between them.

A segment between two keyframes is a stance if a point of a sole rests on one spot in both, see `stances`. It is a
flight if nothing can carry the figure there. Otherwise it is unknown, because a foot may touch down and lift off in
between.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..array import Array, Mask
from ..curve.frame import Timeline
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..figure.wrench import RootWrench
from ..surface import Plane, Surface
from ..surface.points import TIE, Point, placed, places_of
from .stance import Rest, Stance
from .thresholds import Thresholds

PUSHED = 0.2  # least mean speed of the centre of mass before and after a flight, relative to take-off and landing
TURNED = 0.3  # rotation of search directions, as a fraction of the angle between them, so that no two points tie
Interval = tuple[float, float]


@dataclass(frozen=True)
class Footing:
    """A point that a surface may push from `first` to `last` [s], along its unit normal (3,) and by friction."""

    point: Point
    first: float
    last: float
    normal: Array


def footings(
    figure: Figure,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    stances: Sequence[Stance | Rest],
    body: Sequence[Point] = (),
) -> tuple[Footing, ...]:
    """Return the footings of feet that stand from one keyframe to the next.

    These are the points of the sole and the `body` that touch a surface in one of the two keyframes. Points inside the
    convex hull of the others are omitted.
    """
    feet = {point.link for point in points}
    every = (*points, *(point for point in body if point.link in feet))
    if not points or not surfaces:
        return ()
    spots = _Spots.of(figure, keys, every, surfaces)
    links = np.array([point.link for point in every])
    begin, end = np.array([s.first for s in stances]), np.array([s.last for s in stances])
    standing = np.array([s.point.link for s in stances])
    result = []
    for k, (first, last) in enumerate(zip(keys.times[:-1], keys.times[1:], strict=True)):
        for link in np.unique(standing[(begin <= first) & (last <= end)]):
            on, at = np.nonzero(spots.touches[:, k : k + 2] & (links == link)[:, None])
            if on.size:
                outer, normal = spots.outermost(int(link), on, k + at)
                result += [
                    Footing(Point(every[i].name, int(link), p), float(first), float(last), normal) for i, p in outer
                ]
    return tuple(result)


@dataclass(frozen=True)
class _Spots:
    """Contact of points in keyframes: touches (n, K), centres (3, n, K), over (n, K) index of the surface."""

    samples: Samples
    points: Sequence[Point]
    surfaces: Sequence[Surface]
    touches: Mask
    centres: Array
    over: NDArray[np.intp]

    @classmethod
    def of(cls, figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]) -> _Spots:
        samples = Samples.still(figure, keys.states)
        centres, _, _ = places_of(points, samples)
        height, over = _heights(figure, keys, points, surfaces)
        touches = (np.abs(height) < Thresholds.of(figure).near_surface) & placed(figure, keys.known, points)
        return cls(samples, points, surfaces, touches, centres, over)

    def outermost(
        self, link: int, points: NDArray[np.intp], keys: NDArray[np.intp]
    ) -> tuple[list[tuple[int, Array]], Array]:
        """Return a link's outermost contact points in keyframes (m,), and the unit normal (3,) of the surface. A point
        is its index and its position of contact (3,) in the link's axes."""
        normal = _normal(self.surfaces[int(self.over[points[0], keys[0]])])
        radius = np.array([self.points[i].radius for i in points])
        touched = self.centres[:, points, keys] - radius * normal[:, None]
        touched -= self.samples.links.x[:, link, keys]
        rotation = self.samples.links.rotation[:, :, link, keys]
        local = np.einsum("ijp,ip->jp", rotation, touched)
        directions = rotation[:, :, 0].T @ _around(normal)
        reach = local.T @ directions
        outer = np.unique(np.argmax(reach >= reach.max(axis=0) - TIE, axis=0))
        return [(int(points[i]), local[:, i]) for i in outer], normal


def _around(normal: Array, count: int = 8) -> Array:
    """Return unit vectors (3, count) across a normal (3,) in all directions."""
    across = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    across /= np.linalg.norm(across)
    angle = 2 * np.pi * (np.arange(count) + TURNED) / count
    both = np.column_stack([across, np.cross(normal, across)])
    return np.asarray(both @ np.array([np.cos(angle), np.sin(angle)]), float)


def within(intervals: tuple[tuple[float, float], ...], t: Array) -> Mask:
    """(S,) whether times t (S,) lie in one of the intervals."""
    edges = np.reshape(intervals, (-1, 2))
    return np.any((edges[:, :1] <= t) & (t <= edges[:, 1:]), axis=0)


def flights(
    figure: Figure,
    root: int,
    keys: Timeline,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    stances: Sequence[Stance | Rest],
    body: Sequence[Point] = (),
) -> tuple[Interval, ...]:
    """Return the flights that a timeline of keyframes implies.

    A flight begins at the keyframe in which the last foot leaves the ground, or at the start of the clip in the air. It
    ends at the keyframe in which the first foot lands, or at the end of the clip. No foot stands on one spot in two
    neighbouring keyframes of it, all keyframes fix the feet, and no other point of the `body` touches a surface. A foot
    that leaves has stood before and is no longer flat on the ground; a foot that lands stands afterwards.

    The free fall through both ends rises by at most 0.6 m and passes within 15 cm of the keyframes in between (for an
    adult, see `Thresholds`). In the segments before and after, the centre of mass rises and sinks with at least a fifth
    of its speeds at take-off and landing, as it does in a push-off and a landing. Keyframes that set the legs but no
    height are ignored in a flight between others that imply a push-off and a landing.
    """
    if not points or not surfaces or not figure.gravity.any():
        return ()
    with_height = np.flatnonzero(_tell_height(figure, root, keys, points))
    if with_height.size < 2:
        return ()
    keys = Timeline(tuple(keys.frames[i] for i in with_height), keys.end_slope, keys.ends)
    contact = _Keys.of(figure, keys, points, surfaces, stances, body)
    times, rising = np.asarray(keys.times), _rising(figure, root, keys)
    intervals, first = [], 0
    for k in range(times.size - 1):
        if not contact.free[k]:
            first = k + 1
        elif k + 2 == times.size or contact.touched[k + 1] or not contact.free[k + 1]:
            is_told = contact.leaves(first) and contact.lands(k + 1) and not contact.leaves_room(times, first, k + 1)
            if (
                with_height[k + 1] - with_height[first] > k + 1 - first
            ):  # some keyframes are ignored, so a foot that touches must push
                is_told &= not contact.ends_down(first, k + 1)
            if is_told and _falls(figure, times, rising, first, k + 1):
                intervals.append((float(times[first]), float(times[k + 1])))
            first = k + 1
    return tuple(intervals)


@dataclass(frozen=True)
class _Keys:
    """Contact in keyframes.

    free     (K − 1,) segments that nothing carries
    touched  (K,) whether a foot touches;  flat  (K,) and with all its points
    step     (K,) [s] time that the lowest foot needs to or from the middle of a step
    """

    free: Mask
    touched: Mask
    flat: Mask
    step: Array

    @classmethod
    def of(
        cls,
        figure: Figure,
        keys: Timeline,
        points: Sequence[Point],
        surfaces: Sequence[Surface],
        stances: Sequence[Stance | Rest],
        body: Sequence[Point],
    ) -> _Keys:
        height, limits = _heights(figure, keys, points, surfaces)[0], Thresholds.of(figure)
        low = np.abs(height) < limits.near_surface
        known = np.logical_and.reduce(placed(figure, keys.known, points))
        known &= np.logical_or.reduce(low) | (np.min(height, axis=0) > limits.aloft)  # otherwise contact is unknown
        feet = [np.array([p.link == link for p in points]) for link in sorted({p.link for p in points})]
        flat = np.zeros_like(known)
        for foot in feet:
            if foot.sum() > 1:
                flat |= np.logical_and.reduce(low[foot])
        others = [point for point in body if point.link not in {p.link for p in points}]
        if others:
            known &= ~np.logical_or.reduce(_heights(figure, keys, others, surfaces)[0] < limits.near_surface)
        step = limits.step / 2 + height.min(axis=0) / limits.lowering
        begin, end = keys.times[:-1], keys.times[1:]
        carried = np.zeros(begin.size, bool)
        for stance in stances:
            carried |= (stance.first < end) & (begin < stance.last)
        return cls(~carried & known[:-1] & known[1:], np.logical_or.reduce(low), flat, step)

    def leaves(self, k: int) -> bool:
        """Return whether a flight may begin at a keyframe."""
        return not self.touched[k] or (not self.flat[k] and (k == 0 or not self.free[k - 1]))

    def ends_down(self, first: int, last: int) -> bool:
        """Return whether the keyframes begin with `first` or end with `last`, and a foot touches there."""
        return bool((first == 0 and self.touched[first]) or (last == self.free.size and self.touched[last]))

    def leaves_room(self, times: Array, first: int, last: int) -> bool:
        """Return whether there is time for a step between two neighbouring keyframes in the air."""
        if last > first + 1 or self.touched[first] or self.touched[last]:
            return False
        return bool(times[last] - times[first] >= self.step[first] + self.step[last])

    def lands(self, k: int) -> bool:
        """Return whether a flight may end at a keyframe."""
        return not self.touched[k] or k == self.free.size or not self.free[k]


def _heights(
    figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]
) -> tuple[Array, NDArray[np.intp]]:
    """Return heights of points above the nearest surface below them at keyframes, and its index, (n, K) each."""
    samples = Samples.still(figure, keys.states)
    centres, _, _ = places_of(points, samples)
    heights = np.array([surface.height(centres) for surface in surfaces])
    heights -= np.array([point.radius for point in points])[:, None]
    over = np.argmin(heights, axis=0)
    return np.take_along_axis(heights, over[None], axis=0)[0], over


def _normal(surface: Surface) -> Array:
    return surface.normal if isinstance(surface, Plane) else np.array([0.0, 0, 1])


def _rising(figure: Figure, root: int, keys: Timeline) -> Array:
    """Return the height (K,) [m] of the centre of mass, against gravity."""
    samples = Samples.still(figure, keys.states)
    return -figure.gravity @ RootWrench(samples, root).centre / np.linalg.norm(figure.gravity)


def _falls(figure: Figure, times: Array, height: Array, first: int, last: int) -> bool:
    """Return whether heights (K,) of a centre of mass fit a free fall between two keyframes. The segments before and
    after must fit a push-off and a landing."""
    limits = Thresholds.of(figure)
    g, t = float(np.linalg.norm(figure.gravity)), times[first : last + 1] - times[first]
    speed = (height[last] - height[first]) / t[-1] + g * t[-1] / 2
    rise = speed**2 / (2 * g) if 0 < speed < g * t[-1] else 0.0
    path = height[first] + speed * t - g * t**2 / 2
    falls = rise + min(height[first] - height[last], 0) <= limits.rise
    falls &= np.abs(height[first : last + 1] - path).max() <= limits.stray
    if first > 0:
        falls &= height[first] - height[first - 1] >= PUSHED * speed * (times[first] - times[first - 1])
    if last + 1 < times.size:
        falls &= height[last + 1] - height[last] <= PUSHED * (speed - g * t[-1]) * (times[last + 1] - times[last])
    return bool(falls)


def _tell_height(figure: Figure, root: int, keys: Timeline, points: Sequence[Point]) -> Mask:
    """Return whether keyframes set a height, (K,); those that set only the legs do not, and stand where others do."""
    place = figure.links[root].qpos + np.arange(3)
    fixed = np.array(keys.fixed)
    fixed[:, place] = True
    return keys.fixed[:, place[2]] | ~np.logical_and.reduce(placed(figure, fixed, points))
