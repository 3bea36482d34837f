"""A box. The depth of a point inside considers every face as an exit.

The distances to the faces are joined smoothly as d = (Σ_i (κ_i d_i)⁻²)^(-1/2): zero on the boundary, positive inside,
and dominated by the nearest face. The face that points up has κ = 1, the others κ = 4: they count as four times as far
away, because a foot inside a step should leave through the top. Outside, d = κ_i d_i of the face farthest from the
point, as the point enters the box only when it has passed all faces.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..array import Array, Index
from ..tolerances import TINY
from .surface import DEEP, UPRIGHT


@dataclass(frozen=True)
class Box:
    """A solid box.

    Attributes:
        centre: The centre, (3,) [m].
        axes: The axes as columns, (3, 3).
        half: Half sizes, (3,) [m].
        buried: Whether there is no exit downwards.
        sideways: κ, the factor on distances to faces that do not point up [1].
    """

    name: str
    centre: Array
    axes: Array
    half: Array
    buried: bool = True
    sideways: float = 4.0

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        local = self._local(points)
        size, radii = self.half[:, None, None] + radius[:, None], radius.repeat(points.shape[2])
        inside = self._within(local, size)
        depth, gradient = np.full(inside.shape, -np.inf if margin else 0.0), np.zeros(points.shape)
        flat, slopes = local.reshape(3, -1), gradient.reshape(3, -1)
        _, _, kappa, inward = self._faces
        if margin:  # the face that separates a sphere from the box by the largest distance
            which = np.flatnonzero(self._within(local, size + margin) & ~inside)
            exits = self._exits(flat.take(which, axis=1), radii.take(which))
            face = np.argmin(exits, axis=0)
            value = exits[face, np.arange(face.size)]
            face, which, value = (array[value <= 0] for array in (face, which, value))
            depth.put(which, kappa[face, 0] * value)
            slopes[:, which] = inward[:, face]
        which = np.flatnonzero(inside)
        if which.size:
            near = self._exits(flat.take(which, axis=1), radii.take(which))
            near *= kappa
            np.divide(1, near, out=near)
            squared = near * near
            value = 1 / np.sqrt(np.add.reduce(squared, axis=0))
            near *= squared
            depth.put(which, value)
            slopes[:, which] = (inward @ near) * (value * value * value)
        return depth, gradient

    def _exits(self, local: Array, radii: Array) -> Array:
        """Return how far spheres would have to move out through each face, (f, p) [m]; negative if they are outside."""
        outward, size, _, _ = self._faces
        return np.add.outer(size, radii) - outward @ local

    @cached_property
    def _faces(self) -> tuple[Array, Array, Array, Array]:
        """The exits: the faces' outward axes (f, 3) in box coordinates, their distances from the centre (f,), κ (f, 1),
        and κ times the inward axes in the world (3, f)."""
        outward = np.concatenate([np.eye(3), -np.eye(3)])
        rise = outward @ self.axes[2]
        is_exit = ~((rise < -UPRIGHT) & self.buried)
        kappa = np.where(rise > UPRIGHT, 1.0, self.sideways)[is_exit, None]
        return outward[is_exit], np.tile(self.half, 2)[is_exit], kappa, -self.axes @ (kappa * outward[is_exit]).T

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        return self._within(self._local(points), self.half.reshape(3, *[1] * (points.ndim - 1)) + radius)

    @staticmethod
    def _within(local: Array, half: Array) -> NDArray[np.bool_]:
        return np.logical_and.reduce(np.abs(local) < half)

    def inside(self, points: Array) -> Array:
        local = self._local(points)
        nearest = np.full(points.shape[1:], np.inf)
        for axis in range(3):
            for sign in (1.0, -1.0):
                if not (self.buried and sign * self.axes[2, axis] < -UPRIGHT):
                    nearest = np.minimum(nearest, self.half[axis] - sign * local[axis])
        return np.where(self._within(local, self.half.reshape(3, *[1] * (points.ndim - 1))), nearest, 0.0)

    def distance(self, points: Array) -> Array:
        """Return the signed distance of points (3, ...) [m]; inside, it is minus that to the nearest exit."""
        outside = np.maximum(np.abs(self._local(points)) - self.half.reshape(3, *[1] * (points.ndim - 1)), 0)
        return np.linalg.norm(outside, axis=0) - self.inside(points)

    def _local(self, points: Array) -> Array:
        away = points.reshape(3, -1) - self.centre[:, None]
        return (self.axes.T @ away).reshape(points.shape)

    @cached_property
    def _top(self) -> tuple[int, float]:
        """The axis of the face that points up, and the sign of the direction along this axis."""
        axis = int(np.argmax(np.abs(self.axes[2])))
        return axis, float(np.sign(self.axes[2, axis]))

    @cached_property
    def _sides(self) -> tuple[int, int]:
        """The two other axes."""
        across, along = (axis for axis in range(3) if axis != self._top[0])
        return across, along

    def up(self, points: Array) -> Array:
        top, sign = self._top
        return np.repeat((self.axes[:, top] * sign)[:, None], points.shape[1], axis=1)

    def height(self, points: Array) -> Array:
        local = self._local(points)
        top, sign = self._top
        across, along = self._sides
        over = (np.abs(local[across]) <= self.half[across]) & (np.abs(local[along]) <= self.half[along])
        height = local[top] * sign - self.half[top]
        bottom = -DEEP if self.buried else max(-DEEP, -2 * self.half[top])
        return np.where(over & (height >= bottom), height, np.inf)

    def beside(self, points: Array, radius: Array, most: Array) -> tuple[Index, Array]:
        """Return the spheres beside the box whose lowest points are near its top.

        Args:
            points: Centres, (3, n, S) [m].
            radius: Radii, (n,) [m].
            most: Spheres at least this far from the top are omitted, (n, S) [m].

        Returns:
            Flat indices of the spheres, (p,), and their distances from the top, (p,) [m].
        """
        local = self._local(points)
        top, sign = self._top
        across, along = (np.maximum(np.abs(local[axis]) - self.half[axis], 0) for axis in self._sides)
        over = local[top] - sign * (self.half[top] + radius[:, None])
        squared = across * across + along * along
        which = np.flatnonzero((squared > 0) & (squared + over * over < most * most))
        return which, np.hypot(np.sqrt(squared.take(which)), over.take(which))

    def away(self, points: Array, radius: Array) -> Array:
        """Return the unit vectors (3, p) to the lowest points of spheres from the nearest points of the top.

        Args:
            points: Centres, (3, p) [m].
            radius: Radii, (p,) [m].
        """
        local = self._local(points)
        top, sign = self._top
        local[top] -= sign * (self.half[top] + radius)
        for axis in self._sides:
            local[axis] -= np.clip(local[axis], -self.half[axis], self.half[axis])
        return self.axes @ (local / np.maximum(np.linalg.norm(local, axis=0), TINY))
