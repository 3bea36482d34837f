"""Depths of a figure's points in surfaces, for many points at many times.

A point is the centre of a sphere. Points of links whose bounding sphere is far from a surface are omitted. Distances to
planes, boxes and other signed distance fields are exact. The depth in a height field is the distance to its nearest
exit, to first order.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface import Box, Surface
from dynsplines.solver.surface.points import Point

TINY = 1e-12  # [m] least distance in a division


@dataclass(frozen=True, eq=False)
class Bunch:
    """The points of one link: indices (p,), positions on it (3, p) [m], radii (p,) [m], and a bounding sphere."""

    link: int
    which: Index
    places: Array
    radii: Array
    middle: Array
    reach: float


def bunches(points: Sequence[Point]) -> tuple[Bunch, ...]:
    """Return points grouped by their links."""
    links = np.array([point.link for point in points], np.intp)
    out = []
    for link in np.unique(links).tolist():
        which = np.flatnonzero(links == link)
        members = [points[i] for i in which.tolist()]
        places, radii = np.array([point.position for point in members]).T, np.array([point.radius for point in members])
        middle = places.mean(axis=1)
        reach = float((np.linalg.norm(places - middle[:, None], axis=0) + radii).max())
        out.append(Bunch(link, which, places, radii, middle, reach))
    return tuple(out)


def depths(nearby: Sequence[Bunch], surface: Surface, samples: Samples) -> Iterator[tuple[Bunch, Index, Array]]:
    """Yield the bunches near a surface with their samples (k,), and the depths of their points (p, k) [m]."""
    if not nearby:
        return
    links = np.array([bunch.link for bunch in nearby], np.intp)
    around, _ = samples.links.points(links, np.array([bunch.middle for bunch in nearby]).T)
    near = surface.near(around, np.array([[bunch.reach] for bunch in nearby]))
    for bunch, close in zip(nearby, near, strict=True):
        at = np.flatnonzero(close)
        if at.size:
            x, rotation = samples.links.poses(bunch.link * samples.count + at)
            centres = np.einsum("ijk,jp->ipk", rotation, bunch.places) + x[:, None]
            yield bunch, at, depth(surface, centres, bunch.radii)


def depth(surface: Surface, centres: Array, radii: Array) -> Array:
    """Return the depths (p, k) [m] of spheres with centres (3, p, k) and radii (p,) in a surface, at most 0 outside."""
    if isinstance(surface, Box):
        return radii[:, None] - _from_box(surface, centres)
    deep, direction = surface.depth(centres, radii)
    return deep / np.maximum(np.linalg.norm(direction, axis=0), TINY)


def _from_box(box: Box, points: Array) -> Array:
    """Return the signed distance of points (3, ...) from a box; inside, it is minus that to the nearest exit."""
    local = np.tensordot(box.axes.T, points - box.centre.reshape(3, *[1] * (points.ndim - 1)), axes=1)
    half = box.half.reshape(3, *[1] * (points.ndim - 1))
    return np.linalg.norm(np.maximum(np.abs(local) - half, 0), axis=0) - box.inside(points)
