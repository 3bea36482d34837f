"""The interface of surfaces: solids fixed in the world, and the depth of spheres in them (eq. 12); and planes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..array import Array

UPRIGHT = 0.7  # [1] cosine of the angle up to which directions are alike: a face that points up can support a figure
DEEP = 0.15  # [m] depth below its top from which a solid no longer supports a point
GROUNDED = 0.01  # [m] maximum gap to the floor of solids that stand on it


class Surface(Protocol):
    """A solid fixed in the world."""

    @property
    def name(self) -> str: ...

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        """Return the penetration depth of spheres, for penalties, and its gradient.

        Through the sides of a box, the depth is κ times the distance.

        Args:
            points: Centres, (3, n, S) [m].
            radius: Radii, (n,) [m].
            margin: Spheres outside by less than this have a negative depth [m].

        Returns:
            Depths (n, S) [m], of spheres farther outside 0, or −∞ with a margin; and gradients (3, n, S).
        """
        ...

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        """Return whether spheres have a positive depth, for points (3, ...) and radii (...)."""
        ...

    def inside(self, points: Array) -> Array:
        """Return the true depth of points (3, ...) [m]: the distance to the nearest exit, 0 outside."""
        ...

    def height(self, points: Array) -> Array:
        """Return the signed height of points (3, ...) above the surface [m]; infinite if it is not below them.

        A point deeper in a solid than `DEEP` entered it through a side, so the solid does not support it.
        """
        ...

    def up(self, points: Array) -> Array:
        """Return the gradient of `height` at points (3, p) where it is finite, (3, p)."""
        ...


@dataclass(frozen=True)
class Plane:
    """The half space below an infinite plane through `point` (3,) [m] with the unit `normal` (3,)."""

    name: str
    point: Array
    normal: Array

    @property
    def is_level(self) -> bool:
        return bool(np.isclose(self.normal[2], 1))

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        depth = radius[:, None] - self._over(points)
        near = depth > -margin
        return np.where(near, depth, -np.inf if margin else 0.0), np.multiply.outer(-self.normal, near)

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
