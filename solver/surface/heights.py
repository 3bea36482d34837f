"""How high spheres are over what one can stand on."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..array import Array, Index
from .surface import Surface

DEEP = 0.15  # [m] below its top, a point is beside a surface or under it, not over it
FAR = 1e3  # [m]


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
