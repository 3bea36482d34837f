"""The points that can support a figure over time, inferred from its stances.

A segment between two keyframes is a stance if a point of a sole rests on one spot in both, see `stance`. It is a flight
if nothing can support the figure there, see `flight`. Otherwise its support is unknown, because a foot may touch down
and lift off in between.
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
from ..surface import Plane, Surface
from ..surface.points import TIE, Point, placed, places_of
from .stance import Rest, Stance
from .thresholds import Thresholds

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
        centres, _ = places_of(points, samples)
        height, over = heights_of(figure, keys, points, surfaces)
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


def heights_of(
    figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface]
) -> tuple[Array, NDArray[np.intp]]:
    """Return heights of points above the nearest surface below them at keyframes, and its index, (n, K) each."""
    centres, radii = places_of(points, Samples.still(figure, keys.states))
    heights = np.array([surface.height(centres) for surface in surfaces]) - radii[:, None]
    over = np.argmin(heights, axis=0)
    return np.take_along_axis(heights, over[None], axis=0)[0], over


def _normal(surface: Surface) -> Array:
    return surface.normal if isinstance(surface, Plane) else np.array([0.0, 0, 1])
