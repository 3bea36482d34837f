"""What contact points stay out of: something solid and fixed in the world, and how deep spheres are in it (eq. 12)."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..array import Array

UPRIGHT = 0.7  # a face whose normal rises by more looks up: one can stand on it
GROUNDED = 0.01  # [m] what reaches down to so much over the floor stands on it


class Surface(Protocol):
    """Something solid and fixed in the world."""

    @property
    def name(self) -> str: ...

    def depth(self, points: Array, radius: Array) -> tuple[Array, Array]:
        """Penetration depth of spheres, for penalties, and its gradient; through a box's sides κ times the distance.

        points  (3, n, S) centres [m];  radius  (n,) [m]
        Returns the depth (n, S) [m], 0 outside, and its gradient (3, n, S).
        """
        ...

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        """Whether spheres are inside at all, that is, have a depth: points (3, ...), radius (...) -> (...)."""
        ...

    def inside(self, points: Array) -> Array:
        """True depth of points (3, ...) [m]: the distance to the nearest way out, 0 outside."""
        ...

    def height(self, points: Array) -> Array:
        """Signed height of points (3, ...) over the surface [m], infinite where the surface is not below them."""
        ...

    def up(self, points: Array) -> Array:
        """The gradient of `height` at points (3, p) where it is finite, (3, p)."""
        ...
