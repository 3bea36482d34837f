"""The points that can support a figure over time, inferred from its stances.

A segment between two keyframes is a stance if a point of a sole rests on one spot in both, see `stance`. It is a flight
if nothing can support the figure there, see `flight`. Otherwise its support is unknown, because a foot may touch down
and lift off in between.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, Mask
from ..surface import Plane, Surface
from ..surface.points import TIE, Point
from .keyframe_points import KeyframePoints
from .stance import Rest, Stance

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
    soles: KeyframePoints, stances: Sequence[Stance | Rest], body: Sequence[Point] = ()
) -> tuple[Footing, ...]:
    """Return the footings of feet that stand from one keyframe to the next.

    These are the points of the sole and the `body` that touch a surface in one of the two keyframes. Points inside the
    convex hull of the others are omitted.
    """
    feet = set(soles.links.tolist())
    spots = soles.with_points((*soles.points, *(point for point in body if point.link in feet)))
    begin, end = np.array([s.first for s in stances]), np.array([s.last for s in stances])
    standing = np.array([s.point.link for s in stances])
    result = []
    for k, first, last in spots.segments():
        for link in np.unique(standing[(begin <= first) & (last <= end)]).tolist():
            on, at = np.nonzero(spots.is_near[:, k : k + 2] & (spots.links == link)[:, None])
            if on.size:
                outer, normal = _outermost(spots, link, on, k + at)
                result += [Footing(Point(spots.points[i].name, link, p), first, last, normal) for i, p in outer]
    return tuple(result)


def _outermost(spots: KeyframePoints, link: int, points: Index, keys: Index) -> tuple[list[tuple[int, Array]], Array]:
    """Return a link's outermost contact points in keyframes (m,), and the unit normal (3,) of the surface.

    A point is its index and its position of contact (3,) in the link's axes.
    """
    normal = _normal(spots.surfaces[int(spots.nearest[points[0], keys[0]])])
    touched = spots.centres[:, points, keys] - spots.radii[points] * normal[:, None]
    touched -= spots.samples.links.x[:, link, keys]
    rotation = spots.samples.links.rotation[:, :, link, keys]
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


def _normal(surface: Surface) -> Array:
    return surface.normal if isinstance(surface, Plane) else np.array([0.0, 0, 1])
