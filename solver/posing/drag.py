"""Pose of a standing figure that is dragged by one point, by damped least squares from the previous pose.

The priorities are, from the highest: soles, joint ranges with floor and balance, dragged point. The dragging force is
bounded, so an unreachable target moves neither the soles nor the centre of mass beyond the support polygon.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import mujoco
import numpy as np

from ..array import Array, Index, Mask
from ..figure.figure import Figure
from ..penalty.joints.bend import BendLimits
from ..tolerances import NEGLIGIBLE, TINY
from .goals import Goal, PointGoal
from .inverse_kinematics import Posed, PoseSearch
from .least_squares import Part, Residuals, join

# Weights relative to one radian of a limb's joint.
TARGET_WEIGHT, MAX_MISS = 100.0, 0.02  # [1/m]; [m] distance to the target beyond which the force is constant
FIXED_WEIGHT, RANGE_WEIGHT, LIMIT_WEIGHT = 3e3, 3e3, 1e3  # [1/m], [1/rad], [1/m]

RESTART_MISS, RESTART_COST = 0.005, 0.9  # [m] that triggers restarts; relative cost below which one is accepted
RESTART_BENDS = np.radians([12, 30, 70])  # flexion of knees and elbows: of all, then of the dragged limb
STIFFNESS = 0.1, 1.0, 1.0, 1.0, 1.0  # factors of the constraints' weights in successive descents, as many as needed
FIXED_MISS = 3e-4  # [m] largest residual of fixed goals
STEPS, MAX_STEP = 14, 0.5  # per descent; [rad, m] of any degree of freedom
MIN_GAIN, MIN_STEP = 1e-4, 1e-5  # limits of convergence [1], [rad, m]
NEAR_FLOOR = 0.05  # [m] height below which a body's clearance is linearise


@dataclass(frozen=True, eq=False)
class SupportPolygon:
    """Limit: the centre of mass of a tree stays above a convex polygon.

    Attributes:
        root: MuJoCo's id of the tree's root body.
        corners: The corners of the polygon, counterclockwise, (k, 2) [m].
    """

    root: int
    corners: Array

    @classmethod
    def of(cls, root: int, points: Array, share: float = 0.8) -> SupportPolygon | None:
        """Return the convex hull of contact points (n, 3) [m], scaled by `share` [1] about its centroid, by default for
        the centre of mass in a drag; None if they are collinear."""
        from scipy.spatial import ConvexHull  # slow to import

        rays = points[1:, :2] - points[0, :2]
        if len(points) < 3 or np.linalg.eigvalsh(rays.T @ rays)[0] < NEGLIGIBLE**2:
            return None
        corners = points[ConvexHull(points[:, :2]).vertices, :2]
        return cls(root, share * corners + (1 - share) * _centroid(corners))

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the excess (k,) [m] over every edge and its Jacobian (k, nv)."""
        normals, distances = self._edges
        return normals @ self._centre(data) - distances, normals @ self._rows(model, data)

    def linearise_away(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the vector from the nearest point of the polygon to the centre of mass (2,) [m], 0 inside, and its
        Jacobian (2, nv)."""
        edges, to_centre = self._sides, self._centre(data) - self.corners
        if (edges[:, 0] * to_centre[:, 1] > edges[:, 1] * to_centre[:, 0]).all():
            return np.zeros(2), np.zeros((2, model.nv))
        squares = np.maximum(np.einsum("ij,ij->i", edges, edges), TINY)
        along = np.clip(np.einsum("ij,ij->i", edges, to_centre) / squares, 0, 1)
        away = to_centre - along[:, None] * edges
        k = int(np.argmin(np.einsum("ij,ij->i", away, away)))
        across = np.eye(2) - (np.outer(edges[k], edges[k]) / squares[k] if 0 < along[k] < 1 else 0.0)
        return away[k], across @ self._rows(model, data)

    def excess(self, data: mujoco.MjData) -> float:
        """Return the distance [m] of the centre of mass beyond the polygon, negative inside."""
        normals, distances = self._edges
        return float((normals @ self._centre(data) - distances).max())

    @cached_property
    def _sides(self) -> Array:
        """The vectors from the corners to the next ones, (k, 2) [m]."""
        return np.roll(self.corners, -1, axis=0) - self.corners

    @cached_property
    def _edges(self) -> tuple[Array, Array]:
        """The outward unit normals of the edges (k, 2), and their distances from the origin (k,) [m]."""
        normals = self._sides[:, ::-1] * [1.0, -1.0] / np.linalg.norm(self._sides, axis=1)[:, None]
        return normals, np.einsum("ij,ij->i", normals, self.corners)

    def _centre(self, data: mujoco.MjData) -> Array:
        return np.asarray(data.subtree_com[self.root, :2])

    def _rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """Return the Jacobian of the horizontal position of the centre of mass, (2, nv)."""
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSubtreeCom(model, data, rows, self.root)
        return rows[:2]


def _centroid(corners: Array) -> Array:
    """Return the centroid (2,) of the area of a convex polygon with corners (n, 2) in order."""
    a, b = corners[1:-1] - corners[0], corners[2:] - corners[0]
    areas = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.asarray(corners[0] + areas @ (a + b) / (3 * areas.sum()))


@dataclass(frozen=True, eq=False)
class Balance:
    """Goal: the centre of mass of a tree is above the support polygon of points at their current positions.

    Attributes:
        root: MuJoCo's id of the tree's root body.
        points: The points of feet; their target positions are not used.
        share: The size of the permitted polygon, relative to the support polygon; 0: its centroid.
    """

    name: str
    root: int
    points: tuple[PointGoal, ...]
    share: float

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [point.index for point in self.points]

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return self.linearise(model, data)[0]

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the vector from the polygon to the centre of mass (2,) [m], 0 inside, and its Jacobian (2, nv) for
        feet at rest."""
        places = np.concatenate([point.places(data) for point in self.points])
        polygon = SupportPolygon.of(self.root, places, self.share)
        return (np.zeros(2), np.zeros((2, model.nv))) if polygon is None else polygon.linearise_away(model, data)


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


def drag_pose(
    figure: Figure,
    home: Array,
    free: Mask,
    target: Goal,
    bends: BendLimits | None = None,
    *,
    begin: Array,
    fixed: Sequence[Goal] = (),
    limits: Sequence[SupportPolygon | FloorClearance] = (),
    preferred: Sequence[tuple[float, Goal]] = (),
    limb: Mask | None = None,
    range_shares: Mapping[int, float] | None = None,
) -> Posed:
    """Return the pose nearest to `home` that meets the target or approaches it.

    A straight limb has no gradient that bends it, and a hand that passes its shoulder can get stuck. If the target is
    missed, the descent is therefore repeated with bent knees and elbows.

    Args:
        home: The preferred pose, (nq,).
        free: Entries that may change, (nq,).
        bends: Limits of knees and elbows on ball joints.
        begin: The previous pose, from which the descent starts, (nq,).
        fixed: Goals with precedence over the limits, which have precedence over the target.
        limits: The floor, and the support polygon of the centre of mass.
        preferred: Pairs of a weight [1/rad or 1/m] and a goal that is met approximately.
        limb: Entries of the dragged limb, for restarts that bend it more, (nq,).
        range_shares: By link, the share of its range that a joint may use.
    """
    goals = (target, *fixed)
    search = PoseSearch(
        figure,
        np.array(home, float),
        np.asarray(free, bool),
        goals,
        bends,
        range_shares=range_shares,
        preferred=preferred,
    )
    if not search.dofs.size:
        return search.result(search.home)
    begin = np.array(begin, float)
    best, cost = _descend(search, limits, search.clip(begin))
    result = search.result(best)
    if result.missed[0] > RESTART_MISS:
        for start in _restarts(search, begin, limb):
            pose, other = _descend(search, limits, start)
            if other < RESTART_COST * cost:
                result, cost = search.result(pose), other
    return result


def _restarts(search: PoseSearch, begin: Array, limb: Mask | None) -> list[Array]:
    least, *more = RESTART_BENDS
    bent = search.bend(begin, least)
    starts = [] if np.array_equal(bent, search.bend(begin, 0.0)) else [bent]
    if limb is not None and limb.any():
        starts += [np.where(limb, search.bend(search.home, angle), bent) for angle in more]
    return starts


def _descend(search: PoseSearch, limits: Sequence[SupportPolygon | FloorClearance], qpos: Array) -> tuple[Array, float]:
    """Return the pose (nq,) after the descents from another, and its cost."""
    cost, target_size = 0.0, search.goals[0].residual(search.model, search.data).size

    def residuals(qpos: Array, stiffness: float) -> Residuals:
        distance, (off, by_off), (over, by_over) = search.linearise(qpos)
        miss = float(np.linalg.norm(off[:target_size]))
        weights = np.full(off.size, stiffness * FIXED_WEIGHT)
        weights[:target_size] = TARGET_WEIGHT * np.sqrt(min(1.0, MAX_MISS / max(miss, MAX_MISS)))
        parts: list[Part] = [distance, (weights * off, weights[:, None] * by_off)]
        two_sided = sum(values.size for values, _ in parts)
        parts.append((stiffness * RANGE_WEIGHT * over, stiffness * RANGE_WEIGHT * by_over))
        for limit in limits:
            values, rows = limit.linearise(search.model, search.data)
            parts.append((stiffness * LIMIT_WEIGHT * values, stiffness * LIMIT_WEIGHT * rows[:, search.dofs]))
        constant = TARGET_WEIGHT**2 * max(miss * MAX_MISS - MAX_MISS**2, 0.0)
        return Residuals(*join(parts), two_sided, constant)

    for stiffness in STIFFNESS:
        cost_of = partial(residuals, stiffness=stiffness)
        qpos, cost = search.minimise(cost_of, qpos, STEPS, longest=MAX_STEP, settled=MIN_GAIN, smallest=MIN_STEP)
        if stiffness == 1 and search.result(qpos).missed[1:].max(initial=0.0) < FIXED_MISS:
            break
    return qpos, cost
