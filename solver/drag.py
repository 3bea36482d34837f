"""Pose of a standing figure that is dragged by one point, by damped least squares from the previous pose.

The priorities are, from the highest: soles, joint ranges with floor and balance, dragged point. The dragging force is
bounded, so an unreachable target moves neither the soles nor the centre of mass beyond the support polygon.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
from scipy.spatial import ConvexHull

from .array import Array, Index, Mask
from .figure.algebra import cross
from .figure.figure import Figure
from .penalty.joints.bend import BendLimits
from .posing import Goal, Part, Posed, PoseSearch, joined

# Weights relative to one radian of a limb's joint.
TARGET_WEIGHT, MAX_MISS = 100.0, 0.02  # [1/m]; [m] distance to the target beyond which the force is constant
FIXED_WEIGHT, RANGE_WEIGHT, LIMIT_WEIGHT = 3e3, 3e3, 1e3  # [1/m], [1/rad], [1/m]
SUPPORT_SHARE = 0.8  # size of the polygon for the centre of mass, relative to the support polygon
MIN_SUPPORT = 1e-3  # [m] width below which contact points form no polygon
NEAR_FLOOR = 0.05  # [m] height below which a body's clearance is linearized

RESTART_MISS, RESTART_COST = 0.005, 0.9  # [m] that triggers restarts; relative cost below which one is accepted
RESTART_BENDS = np.radians([12, 30, 70])  # flexion of knees and elbows: of all, then of the dragged limb
STIFFNESS = 0.1, 1.0, 1.0, 1.0, 1.0  # factors of the constraints' weights in successive descents, as many as needed
FIXED_MISS = 3e-4  # [m] largest residual of fixed goals
STEPS, MAX_STEP = 8, 0.5  # per descent; [rad, m] of any degree of freedom
DAMPING, MAX_DAMPING, DECREASE, INCREASE = 0.1, 1e8, 5, 6  # [1] relative to the squared joint weights; factors
POOR_GAIN, MIN_GAIN, MIN_STEP = 0.7, 1e-4, 1e-5  # gain ratio for a correction; limits of convergence [1], [rad, m]
ACTIVE_SETS = 4  # solves per step until the active one-sided residuals no longer change


@dataclass(frozen=True, eq=False)
class FixedPoints:
    """Goal: target positions for n points of one body.

    Attributes:
        index: MuJoCo's id of the body.
        offsets: The points in the frame of the body, (n, 3) [m].
        positions: The targets in the world, (n, 3) [m]; NaN along unconstrained axes.
    """

    name: str
    index: int
    offsets: Array
    positions: Array

    def body(self, model: mujoco.MjModel) -> int:
        return self.index

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (data.xpos[self.index] + self._arms(data) - self.positions)[self._constrained]

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        shift, turn = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, data, shift, turn, self.index)
        return (shift + cross(turn[:, None], self._arms(data).T[:, :, None]).swapaxes(0, 1))[self._constrained]

    def _arms(self, data: mujoco.MjData) -> Array:
        return self.offsets @ data.xmat[self.index].reshape(3, 3).T

    @cached_property
    def _constrained(self) -> Mask:
        return ~np.isnan(self.positions)


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
    def of(cls, root: int, points: Array) -> SupportPolygon | None:
        """Return the polygon inside the convex hull of contact points (n, 3) [m], or None if they are collinear."""
        if len(points) < 3 or np.linalg.matrix_rank(points[1:, :2] - points[0, :2], tol=MIN_SUPPORT) < 2:
            return None
        corners = points[ConvexHull(points[:, :2]).vertices, :2]
        centre = corners.mean(axis=0)
        equations = ConvexHull(centre + SUPPORT_SHARE * (corners - centre)).equations
        return cls(root, equations[:, :2], -equations[:, 2])

    def linearized(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the excess (k,) [m] over every edge and its Jacobian (k, nv)."""
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSubtreeCom(model, data, rows, self.root)
        return self.normals @ data.subtree_com[self.root, :2] - self.distances, self.normals @ rows[:2]

    def excess(self, data: mujoco.MjData) -> float:
        """Return the distance [m] of the centre of mass beyond the polygon, negative inside."""
        return float((self.normals @ data.subtree_com[self.root, :2] - self.distances).max())


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

    def linearized(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the depths (k,) [m] of bodies near the plane, negative above it, and their Jacobian (k, nv)."""
        centres, first = self._centres(data), self._first
        depth = self._depth(centres)
        near = np.flatnonzero(np.maximum.reduceat(depth, first) > -NEAR_FLOOR)
        ends = np.append(first[1:], len(depth))
        values, rows, jacobian = np.empty(near.size), np.empty((near.size, model.nv)), np.empty((3, model.nv))
        for row, body in enumerate(near):
            deepest = first[body] + int(np.argmax(depth[first[body] : ends[body]]))
            mujoco.mj_jac(model, data, jacobian, None, centres[deepest], self.bodies[deepest])
            values[row], rows[row] = depth[deepest], -self.normal @ jacobian
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


@dataclass(frozen=True, eq=False)
class Constraints:
    """Constraints of a drag, by descending priority.

    Attributes:
        preferred: Pairs of a weight [1/rad or 1/m] and a goal that is met approximately.
    """

    fixed: tuple[Goal, ...] = ()
    limits: tuple[SupportPolygon | FloorClearance, ...] = ()
    preferred: tuple[tuple[float, Goal], ...] = ()


def dragged(
    figure: Figure,
    home: Array,
    free: Mask,
    target: Goal,
    constraints: Constraints,
    bends: BendLimits | None = None,
    *,
    begin: Array,
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
        limb: Entries of the dragged limb, for restarts that bend it more, (nq,).
        range_shares: By link, the share of its range that a joint may use.
    """
    goals = (target, *constraints.fixed)
    search = PoseSearch(figure, np.array(home, float), np.asarray(free, bool), goals, bends, range_shares=range_shares)
    if not search.dofs.size:
        return search.result(search.home)
    drag = _Drag(search, constraints)
    begin = np.array(begin, float)
    best, cost = drag.descended(search.clipped(begin))
    result = search.result(best)
    if result.missed[0] > RESTART_MISS:
        for start in _restarts(search, begin, limb):
            pose, other = drag.descended(start)
            if other < RESTART_COST * cost:
                result, cost = search.result(pose), other
    return result


def _restarts(search: PoseSearch, begin: Array, limb: Mask | None) -> list[Array]:
    least, *more = RESTART_BENDS
    bent = search.begun(begin, least)
    starts = [] if np.array_equal(bent, search.begun(begin, 0.0)) else [bent]
    if limb is not None and limb.any():
        starts += [np.where(limb, search.begun(search.home, angle), bent) for angle in more]
    return starts


class _Drag:
    """Levenberg-Marquardt steps with an active set and a second-order correction."""

    def __init__(self, search: PoseSearch, constraints: Constraints) -> None:
        self.search, self.constraints = search, constraints
        self.target_size = search.goals[0].missed(search.model, search.data).size

    def descended(self, qpos: Array) -> tuple[Array, float]:
        """Return the pose (nq,) after the descents from another, and its cost."""
        for stiffness in STIFFNESS:
            here = self._descended(qpos, stiffness)
            qpos = here.qpos
            if stiffness == 1 and self.search.result(qpos).missed[1:].max(initial=0.0) < FIXED_MISS:
                break
        return here.qpos, here.cost

    def _descended(self, qpos: Array, stiffness: float) -> _Linearization:
        damping, here = DAMPING, self._linearized(qpos, stiffness)
        for _ in range(STEPS):
            step, inverse, rows = self._step(here, damping)
            there = self._linearized(self.search.moved(here.qpos, step), stiffness)
            if there.values.size == here.values.size and here.cost - there.cost < POOR_GAIN * here.reduction(step):
                curved = there.values - here.values - here.rows @ step  # fixed soles move joints along curves
                correction = _limited(-inverse @ (rows.T @ curved))
                corrected = self._linearized(self.search.moved(there.qpos, correction), stiffness)
                there = min(there, corrected, key=lambda point: point.cost)
            if there.cost < here.cost:
                has_converged = here.cost - there.cost <= MIN_GAIN * here.cost
                here, damping = there, damping / DECREASE
                if has_converged:
                    break
            else:
                damping *= INCREASE
            if np.abs(step).max() < MIN_STEP or damping > MAX_DAMPING:
                break
        return here

    def _step(self, here: _Linearization, damping: float) -> tuple[Array, Array, Array]:
        """Return a step (n,), the inverse (n, n) of its normal matrix, and the rows (r, n), zero where inactive."""
        active = here.active(here.values)
        for _ in range(ACTIVE_SETS):
            rows = here.rows * active[:, None]
            normal = rows.T @ rows
            normal.flat[:: len(normal) + 1] += damping * self.search.weights**2
            inverse = np.asarray(np.linalg.inv(normal), float)
            step = _limited(-inverse @ (rows.T @ here.values))
            predicted = here.active(here.values + here.rows @ step)
            if np.array_equal(predicted, active):
                break
            active = predicted
        return step, inverse, rows

    def _linearized(self, qpos: Array, stiffness: float) -> _Linearization:
        search = self.search
        distance, (off, by_off), (over, by_over) = search.linearised(qpos)
        miss = float(np.linalg.norm(off[: self.target_size]))
        weights = np.full(off.size, stiffness * FIXED_WEIGHT)
        weights[: self.target_size] = TARGET_WEIGHT * np.sqrt(min(1.0, MAX_MISS / max(miss, MAX_MISS)))
        parts: list[Part] = [distance, (weights * off, weights[:, None] * by_off)]
        for weight, goal in self.constraints.preferred:
            values, rows = goal.missed(search.model, search.data), goal.rows(search.model, search.data)
            parts.append((weight * values, weight * rows[:, search.dofs]))
        two_sided = sum(values.size for values, _ in parts)
        parts.append((stiffness * RANGE_WEIGHT * over, stiffness * RANGE_WEIGHT * by_over))
        for limit in self.constraints.limits:
            values, rows = limit.linearized(search.model, search.data)
            parts.append((stiffness * LIMIT_WEIGHT * values, stiffness * LIMIT_WEIGHT * rows[:, search.dofs]))
        constant = TARGET_WEIGHT**2 * max(miss * MAX_MISS - MAX_MISS**2, 0.0)
        return _Linearization(qpos, *joined(parts), two_sided, constant)


@dataclass(frozen=True, eq=False)
class _Linearization:
    """Weighted residuals at a pose and their Jacobian.

    Attributes:
        qpos: The pose, (nq,).
        values: The residuals, (r,).
        rows: The Jacobian, (r, n).
        two_sided: The number of two-sided residuals, which are first; the others are one-sided.
        constant: The part of the cost, from the target's Huber loss, that the squares omit.
    """

    qpos: Array
    values: Array
    rows: Array
    two_sided: int
    constant: float

    def active(self, values: Array) -> Mask:
        """Return (r,) whether residuals of these values contribute."""
        active = values > 0
        active[: self.two_sided] = True
        return active

    @cached_property
    def cost(self) -> float:
        return self._squared(self.values) + self.constant

    def reduction(self, step: Array) -> float:
        """Return the predicted reduction of the cost by a step (n,)."""
        return self._squared(self.values) - self._squared(self.values + self.rows @ step)

    def _squared(self, values: Array) -> float:
        active = values * self.active(values)
        return float(active @ active)


def _limited(step: Array) -> Array:
    return step * min(1.0, MAX_STEP / max(float(np.abs(step).max()), MAX_STEP))
