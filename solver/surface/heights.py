"""How high spheres are over what one can stand on."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..array import Array, Index
from .plane import Plane
from .surface import Surface

DEEP = 0.15  # [m] below its top, a point is beside a surface or under it, not over it
FAR = 1e3  # [m]
BESIDE = 0.05  # [m] that it has to be nearer in height to be taken for ground, what is beside a point and not below it


def height_over(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Array]:
    """Signed height of spheres over the nearest surface that one can stand on below them, and its gradient.

    points  (3, n, S) centres [m];  radius  (n,) [m]
    Returns (n, S) [m], FAR where there is none or it is deep below, and (3, n, S).
    """
    height, nearest = heights(surfaces, points, radius)
    return height, ways_up(surfaces, nearest.ravel(), points.reshape(3, -1)).reshape(points.shape)


def heights(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Index]:
    """`height_over` without the gradient, and which surface each is over, −1 for none, (n, S) each."""
    height, nearest = np.full(points.shape[1:], FAR), np.full(points.shape[1:], -1)
    for i, surface in enumerate(surfaces):
        over = surface.height(points) - radius[:, None]
        lower = (over >= -DEEP) & (over < height)
        np.copyto(height, over, where=lower)
        nearest[lower] = i
    return height, nearest


def ways_up(surfaces: Sequence[Surface], nearest: Index, points: Array) -> Array:
    """(3, p): the gradients of the heights of points (3, p) over the surfaces with these indices (p,)."""
    up = np.zeros(points.shape)
    for i, surface in enumerate(surfaces):
        mine = np.flatnonzero(nearest == i)
        if mine.size:
            up[:, mine] = surface.up(points[:, mine])
    return up


def grounds(surfaces: Sequence[Surface], points: Array, radius: Array, reach: float) -> tuple[Array, Array]:
    """`height_over` for points of uncertain position: over the surface below them, or a higher one within `reach` [m].

    Returns heights (n, S) [m] and where the ground was found that they are over, (3, n, S), FAR and anywhere for none.
    """
    angles = np.arange(8) * np.pi / 4
    offsets = reach * np.vstack([np.zeros(3), np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)])
    candidates = [heights(surfaces, points + offset[:, None, None], radius)[0] for offset in offsets]
    best = np.argmin([np.abs(height) + BESIDE * (k > 0) for k, height in enumerate(candidates)], axis=0)
    return np.choose(best, candidates), points + np.moveaxis(offsets[best], -1, 0)


def ground_at(surfaces: Sequence[Surface], point: Array, radius: float, reach: float) -> Plane | None:
    """The plane that a sphere at `point` (3,) rests on, or one `reach` [m] next to it; None if there is none."""
    height, where = grounds(surfaces, point[:, None, None], np.array([radius]), reach)
    if height[0, 0] >= FAR:
        return None
    _, up = height_over(surfaces, where, np.array([radius]))
    gradient = up[:, 0, 0]
    steep = np.linalg.norm(gradient)
    return Plane("ground", where[:, 0, 0] - (height[0, 0] + radius) * gradient / steep**2, gradient / steep)
