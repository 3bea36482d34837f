"""Heights of spheres above the surfaces that can support a figure, and distances from the edges of boxes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..array import Array, Index
from .box import Box
from .surface import Plane, Surface

FAR = 1e3  # [m] height where there is no surface
BESIDE = 0.05  # [m] handicap in height of ground beside a point, relative to ground below it


def height_over(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Array]:
    """Return the signed height of spheres above the highest surface below them, and its gradient.

    Args:
        points: Centres, (3, n, S) [m].
        radius: Radii, (n,) [m].

    Returns:
        Heights (n, S) [m], FAR where no surface is below the sphere, and gradients (3, n, S).
    """
    height, nearest = heights(surfaces, points, radius)
    return height, height_gradients(surfaces, nearest.ravel(), points.reshape(3, -1)).reshape(points.shape)


def clearances(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Index]:
    """Return the height over the ground, or the distance from the top of a box beside the sphere if that is smaller.

    The result is continuous where spheres pass over the edge of a box.

    Returns:
        Clearances (n, S) [m], and for `clearance_gradients` what they are measured from, (n, S): the index of the
        surface below, −1 for none, or the index of the box plus the number of surfaces.
    """
    height, origin = heights(surfaces, points, radius)
    for i, surface in enumerate(surfaces):
        if isinstance(surface, Box):
            which, distance = surface.beside(points, radius, height)
            height.put(which, distance)
            origin.put(which, len(surfaces) + i)
    return height, origin


def clearance_gradients(surfaces: Sequence[Surface], origin: Index, points: Array, radius: Array) -> Array:
    """Return the gradients (3, p) of `clearances` of spheres at `points` (3, p) with radii and origins (p,)."""
    up = height_gradients(surfaces, origin, points)
    for i, surface in enumerate(surfaces):
        if isinstance(surface, Box):
            mine = np.flatnonzero(origin == len(surfaces) + i)
            up[:, mine] = surface.away(points[:, mine], radius[mine])
    return up


def heights(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Index]:
    """Return `height_over` without the gradient, and the index of the surface below, −1 for none, (n, S) each."""
    height, nearest = np.full(points.shape[1:], FAR), np.full(points.shape[1:], -1)
    for i, surface in enumerate(surfaces):
        over = surface.height(points) - radius[:, None]
        lower = over < height
        np.copyto(height, over, where=lower)
        nearest[lower] = i
    return height, nearest


def height_gradients(surfaces: Sequence[Surface], nearest: Index, points: Array) -> Array:
    """Return the gradients (3, p) of the heights of points (3, p) above the surfaces with these indices (p,)."""
    up = np.zeros(points.shape)
    for i, surface in enumerate(surfaces):
        mine = np.flatnonzero(nearest == i)
        if mine.size:
            up[:, mine] = surface.up(points[:, mine])
    return up


def heights_nearby(surfaces: Sequence[Surface], points: Array, radius: Array, reach: float) -> tuple[Array, Array]:
    """Return `height_over` for points of uncertain position, above the surface below them or a higher one nearby.

    Args:
        points: Centres, (3, n, S) [m].
        radius: Radii, (n,) [m].
        reach: The uncertainty of the position [m].

    Returns:
        Heights (n, S) [m], and the points (3, n, S) at which the ground was detected. Without ground the height is FAR.
    """
    angles = np.arange(8) * np.pi / 4
    offsets = reach * np.vstack([np.zeros(3), np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)])
    candidates = [heights(surfaces, points + offset[:, None, None], radius)[0] for offset in offsets]
    best = np.argmin([np.abs(height) + BESIDE * (k > 0) for k, height in enumerate(candidates)], axis=0)
    return np.choose(best, candidates), points + np.moveaxis(offsets[best], -1, 0)


def ground_at(surfaces: Sequence[Surface], point: Array, radius: float, reach: float) -> Plane | None:
    """Return the plane on which a sphere at `point` (3,) rests, or one within `reach` [m]; None if there is none."""
    height, where = heights_nearby(surfaces, point[:, None, None], np.array([radius]), reach)
    if height[0, 0] >= FAR:
        return None
    _, up = height_over(surfaces, where, np.array([radius]))
    gradient = up[:, 0, 0]
    steep = np.linalg.norm(gradient)
    return Plane("ground", where[:, 0, 0] - (height[0, 0] + radius) * gradient / steep**2, gradient / steep)
