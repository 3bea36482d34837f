"""Surfaces that contact points stay out of: the scene's planes and boxes, and how deep a sphere is in them (eq. 12).

A plane's depth is the paper's distance below the floor. A point inside a box has a way out through every face; the
distances to the faces are joined smoothly as d = (Σ_i (κ_i d_i)⁻²)^(-1/2): zero on the boundary, positive inside and
led by the nearest face. The face that looks up has κ = 1, the others κ = 4: the way out of a step that a foot can
take is on top of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from .quaternion import Array

SIDEWAYS = 4.0
UPRIGHT = 0.7


class Surface(Protocol):
    """Something solid and fixed in the world."""

    @property
    def name(self) -> str: ...

    def depth(self, points: Array, radius: Array) -> tuple[Array, Array]:
        """How deep spheres are inside, for penalties, and the gradient; through a box's sides κ times the distance.

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


@dataclass(frozen=True)
class Plane:
    """The half space under an infinite plane through `point` (3,) [m] with the unit `normal` (3,)."""

    name: str
    point: Array
    normal: Array

    def depth(self, points: Array, radius: Array) -> tuple[Array, Array]:
        depth = np.maximum(radius[:, None] - self._over(points), 0)
        return depth, np.multiply.outer(-self.normal, depth > 0)

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
        """Signed distance of points (3, ...) from the plane [m]."""
        return np.einsum("i,i...->...", self.normal, points) - self.normal @ self.point


@dataclass(frozen=True)
class Box:
    """A solid box: centre (3,) [m], axes (3, 3) by columns, half sizes (3,) [m]; buried: no way out downwards."""

    name: str
    centre: Array
    axes: Array
    half: Array
    buried: bool = True

    def depth(self, points: Array, radius: Array) -> tuple[Array, Array]:
        local = self._local(points)
        inside = self._within(local, self.half[:, None, None] + radius[:, None])
        depth, gradient = np.zeros(inside.shape), np.zeros(points.shape)
        which = np.flatnonzero(inside)
        if not which.size:
            return depth, gradient
        outward, size, kappa, inward = self._faces
        near = np.add.outer(size, radius.repeat(inside.shape[1]).take(which))
        near -= outward @ local.reshape(3, -1).take(which, axis=1)
        near *= kappa
        np.divide(1, near, out=near)
        squared = near * near
        value = 1 / np.sqrt(np.add.reduce(squared, axis=0))
        near *= squared
        depth.put(which, value)
        gradient.reshape(3, -1)[:, which] = (inward @ near) * (value * value * value)
        return depth, gradient

    @cached_property
    def _faces(self) -> tuple[Array, Array, Array, Array]:
        """The ways out: faces' outward axes (f, 3) in the box's own, distances from the centre (f,), κ (f, 1), and κ
        times the inward axes in the world (3, f)."""
        outward = np.concatenate([np.eye(3), -np.eye(3)])
        rise = outward @ self.axes[2]
        kept = ~((rise < -UPRIGHT) & self.buried)
        kappa = np.where(rise > UPRIGHT, 1.0, SIDEWAYS)[kept, None]
        return outward[kept], np.tile(self.half, 2)[kept], kappa, -self.axes @ (kappa * outward[kept]).T

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

    def up(self, points: Array) -> Array:
        top = int(np.argmax(np.abs(self.axes[2])))
        return np.repeat((self.axes[:, top] * np.sign(self.axes[2, top]))[:, None], points.shape[1], axis=1)

    def _local(self, points: Array) -> Array:
        """Points (3, ...) in the box's own axes."""
        away = points.reshape(3, -1) - self.centre[:, None]
        return (self.axes.T @ away).reshape(points.shape)

    def height(self, points: Array) -> Array:
        single = [1] * (points.ndim - 1)
        local = self._local(points)
        top = int(np.argmax(np.abs(self.axes[2])))
        over = np.all(np.abs(np.delete(local, top, 0)) <= np.delete(self.half, top).reshape(2, *single), axis=0)
        return np.where(over, local[top] * np.sign(self.axes[2, top]) - self.half[top], np.inf)


def static_surfaces(model: mujoco.MjModel) -> tuple[Surface, ...]:
    """Every plane and box welded to the world, whatever its contype."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    ids = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] == 0]
    planes = [_plane(model, data, g) for g in ids if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_PLANE]
    floor = max((p.point[2] for p in planes if p.normal[2] > 0.99), default=-np.inf)
    boxes = [_box(model, data, g, floor) for g in ids if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_BOX]
    return (*planes, *boxes)


def _plane(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> Plane:
    normal = data.geom_xmat[geom].reshape(3, 3)[:, 2].copy()
    return Plane(model.geom(geom).name or f"geom {geom}", data.geom_xpos[geom].copy(), normal)


def _box(model: mujoco.MjModel, data: mujoco.MjData, geom: int, floor: float) -> Box:
    axes = data.geom_xmat[geom].reshape(3, 3).copy()
    centre, half = data.geom_xpos[geom].copy(), np.array(model.geom_size[geom])
    bottom = centre[2] - np.abs(axes[2]) @ half
    return Box(model.geom(geom).name or f"geom {geom}", centre, axes, half, bool(bottom <= floor + 0.01))
