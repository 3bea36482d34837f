"""A plane: the half space below it. Its depth is the paper's distance below the floor (eq. 12)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..array import Array
from .surface import FAR, UPRIGHT


@dataclass(frozen=True)
class Plane:
    """The half space below an infinite plane through `point` (3,) [m] with the unit `normal` (3,)."""

    name: str
    point: Array
    normal: Array

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        depth = radius[:, None] - self._over(points)
        near = depth > -margin
        return np.where(near, depth, FAR if margin else 0.0), np.multiply.outer(-self.normal, near)

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        return self._over(points) < radius

    def height(self, points: Array) -> Array:
        over = self._over(points)
        return over if self.normal[2] > UPRIGHT else np.full_like(over, np.inf)

    def up(self, points: Array) -> Array:
        return np.repeat(self.normal[:, None], points.shape[1], axis=1)

    def inside(self, points: Array) -> Array:
        return np.maximum(-self._over(points), 0)

    def _over(self, points: Array) -> Array:
        """Return the signed distance of points (3, ...) from the plane [m]."""
        return np.einsum("i,i...->...", self.normal, points) - self.normal @ self.point
