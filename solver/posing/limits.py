"""The floor and balance: limits of a dragged figure, and a preference of other poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from ..array import Array, Index
from .goals import PointGoal
from .least_squares import Part

SUPPORT_SHARE = 0.8  # size of the polygon for the centre of mass in a drag, relative to the support polygon
MIN_SUPPORT = 1e-3  # [m] width below which contact points form no polygon
NEAR_FLOOR = 0.05  # [m] height below which a body's clearance is linearise


@dataclass(frozen=True, eq=False)
class SupportPolygon:
    """Limit: the centre of mass c of a tree stays above a convex polygon, normals · c <= distances.

    Attributes:
        root: MuJoCo's id of the tree's root body.
        normals: The outward unit normals of the edges, (k, 2).
        distances: The distances of the edges from the origin, (k,) [m].
    """

    root: int
    normals: Array
    distances: Array

    @classmethod
    def of(cls, root: int, points: Array, share: float = SUPPORT_SHARE) -> SupportPolygon | None:
        """Return the polygon inside the convex hull of contact points (n, 3) [m], or None if they are collinear."""
        from scipy.spatial import ConvexHull  # slow to import

        rays = points[1:, :2] - points[0, :2]
        if len(points) < 3 or np.linalg.eigvalsh(rays.T @ rays)[0] < MIN_SUPPORT**2:
            return None
        hull = ConvexHull(points[:, :2])
        normals, distances = hull.equations[:, :2], -hull.equations[:, 2]
        centre = points[hull.vertices, :2].mean(axis=0)
        return cls(root, normals, share * distances + (1 - share) * normals @ centre)

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the excess (k,) [m] over every edge and its Jacobian (k, nv)."""
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSubtreeCom(model, data, rows, self.root)
        return self.normals @ data.subtree_com[self.root, :2] - self.distances, self.normals @ rows[:2]

    def excess(self, data: mujoco.MjData) -> float:
        """Return the distance [m] of the centre of mass beyond the polygon, negative inside."""
        return float((self.normals @ data.subtree_com[self.root, :2] - self.distances).max())


@dataclass(frozen=True, eq=False)
class Balance:
    """Goal: the centre of mass of a tree is above the support polygon of points at their current positions.

    Attributes:
        root: MuJoCo's id of the tree's root body.
        points: The points of feet; their target positions are not used.
        share: The size of the permitted polygon, relative to the support polygon.
    """

    name: str
    root: int
    points: tuple[PointGoal, ...]
    share: float = 1.0

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [point.index for point in self.points]

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return self.linearise(model, data)[0]

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the largest excess (1,) [m] over an edge, 0 inside, and its Jacobian (1, nv) for feet at rest."""
        places = np.concatenate([point.places(data) for point in self.points])
        polygon = SupportPolygon.of(self.root, places, self.share)
        if polygon is None:
            return np.zeros(1), np.zeros((1, model.nv))
        values, rows = polygon.linearise(model, data)
        k = int(values.argmax())
        return (values[[k]], rows[[k]]) if values[k] > 0 else (np.zeros(1), np.zeros((1, model.nv)))


@dataclass(frozen=True, eq=False)
class FloorClearance:
    """Limit: the lowest sphere of every body stays above a plane.

    Attributes:
        bodies: MuJoCo's id of the body of each sphere, sorted, (n,).
        offsets: The centres of the spheres in the frames of the bodies, (n, 3) [m].
        radii: The radii of the spheres, (n,) [m].
        allowed: The permitted depths of the spheres, (n,) [m].
        normal: The unit normal of the plane, (3,).
        level: The distance of the plane from the origin [m].
    """

    bodies: Index
    offsets: Array
    radii: Array
    allowed: Array
    normal: Array
    level: float

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the depths (k,) [m] of bodies, negative above the plane, and their Jacobian (k, nv), 0 far above."""
        centres, first = self._centres(data), self._first
        depth = self._depth(centres)
        values, ends = np.maximum.reduceat(depth, first), np.append(first[1:], len(depth))
        rows, jacobian = np.zeros((values.size, model.nv)), np.empty((3, model.nv))
        for body in np.flatnonzero(values > -NEAR_FLOOR):
            deepest = first[body] + int(np.argmax(depth[first[body] : ends[body]]))
            mujoco.mj_jac(model, data, jacobian, None, centres[deepest], self.bodies[deepest])
            rows[body] = -self.normal @ jacobian
        return values, rows

    def depth(self, data: mujoco.MjData) -> Array:
        """Return the depth (n,) [m] of every sphere beyond the permitted one, negative above the plane."""
        return self._depth(self._centres(data))

    @cached_property
    def _first(self) -> Index:
        return np.flatnonzero(np.diff(self.bodies, prepend=-1))

    def _centres(self, data: mujoco.MjData) -> Array:
        turns = data.xmat[self.bodies].reshape(-1, 3, 3)
        return data.xpos[self.bodies] + (turns @ self.offsets[:, :, None])[:, :, 0]

    def _depth(self, centres: Array) -> Array:
        return self.level + self.radii - self.allowed - centres @ self.normal
