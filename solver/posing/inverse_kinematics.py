"""Poses that meet target positions and rotations, by damped least squares from several starting poses.

The pose nearest to a given pose is computed (K. Levenberg 1944; D. W. Marquardt 1963) in the tangent space of MuJoCo's
configurations. Goals and bounds have multipliers (M. R. Hestenes 1969; R. T. Rockafellar 1973). They are therefore met
exactly at weights that keep the least-squares problem well conditioned.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import mujoco
import numpy as np

from ..array import Array, Index, Mask
from ..cache import Cache, cache_key
from ..figure.figure import Figure, JointKind
from ..figure.model import set_qpos
from ..penalty.joints.bend import BendLimits
from ..tolerances import NEGLIGIBLE, NEWTON_STEPS, ROUNDING, SINGLE
from .bounds import Bends, Ranges
from .goals import Goal, entries_of, moved_by
from .least_squares import Part, Residuals, join, minimise

STARTS = 24  # [1] largest number of starting poses
MOST_CACHED = 1000  # [1] largest number of cached poses
# [m, rad] largest residual norm of a goal that counts as met
MET = SINGLE
# [rad/m, 1] weights of goals, relative to 1 rad of a limb joint: rough search, first round, upper limit
COARSE, FIRM, FIRMEST = 30.0, 1e2, 1e5
FIRMER = 30.0  # [1] weight of ranges and bend bounds, relative to the weight of goals
TRUNK = 6.0  # [1] weight of a trunk joint (a joint with several child links), relative to a limb joint
PER_METRE = 5.0  # [rad/m] weight of translations of the root and of slides, relative to rotations of a limb joint
# [rad] smallest flexions of knees and elbows in starting poses; straight limbs have a singular Jacobian
BENT = np.radians([15, 50, 90])
SPREAD = 0.4  # [rad] standard deviation of random rotations in starting poses
HOPELESS = 0.05  # [m, rad] largest residual of a rough pose that is refined further
# [1] largest number of multiplier updates; ratio of successive residuals that counts as no progress
ROUNDS, STALLED = 20, 0.7


@dataclass(frozen=True, eq=False)
class Posed:
    """A pose and the residuals of its goals.

    Attributes:
        qpos: The pose of the whole figure, (nq,).
        fixed: The mask of the entries that the goals depend on, (nq,): the joints from the root to their bodies.
        missed: The residual norm of every goal, (n,) [m or rad].
        starts: The number of starting poses tried if no pose met the goals; otherwise 0.
    """

    qpos: Array
    fixed: Mask
    missed: Array
    starts: int = 0

    @property
    def is_met(self) -> bool:
        return bool(np.all(self.missed <= MET))

    @property
    def worst(self) -> float:
        """The largest residual norm [m or rad]."""
        return float(self.missed.max(initial=0.0))


class PoseSearch:
    """Least squares over the n free degrees of freedom that the goals depend on.

    Args:
        home: The pose from which distances are measured, (nq,).
        free: The mask of the entries of qpos that may change, (nq,).
        bends: The knees and elbows on ball joints, with their bounds.
        range_shares: The permitted share of a joint's range, by the index of its link.
        preferred: Pairs of a weight [1/rad or 1/m] and a goal that is met approximately.
    """

    def __init__(
        self,
        figure: Figure,
        home: Array,
        free: Mask,
        goals: tuple[Goal, ...],
        bends: BendLimits | None,
        range_shares: Mapping[int, float] | None = None,
        preferred: Sequence[tuple[float, Goal]] = (),
    ) -> None:
        self.figure, self.model, self.home, self.goals = figure, figure.model, home, goals
        self.preferred = preferred
        self.data = mujoco.MjData(self.model)
        links = sorted({link for goal in goals for link in moved_by(figure, goal)})
        self.fixed = entries_of(figure, goals)
        free = free & self.fixed
        self.dofs, self.weights = self._freedoms(links, free)
        self.joints = [
            i for i in links if figure.links[i].kind is not JointKind.FREE and free[figure.links[i].columns].all()
        ]
        self.ranges = Ranges.of(figure, self.joints, self.dofs)
        if range_shares:
            self.ranges = self.ranges.narrow({figure.links[i].qpos: share for i, share in range_shares.items()}, home)
        self.bends = None if bends is None else Bends.of(figure, bends, free)

    def _freedoms(self, links: list[int], free: Mask) -> tuple[Index, Array]:
        """Return the free columns of qvel (n,), and their weights in the distance from home (n,)."""
        dofs, weights = [], []
        for i in links:
            link = self.figure.links[i]
            turn = TRUNK if self.figure.tables.children[i] > 1 else 1.0
            shift = {JointKind.FREE: 3, JointKind.SLIDE: 1}.get(link.kind, 0)
            for k in range(link.kind.freedom):  # rotations share one entry of the mask
                if free[link.qpos + min(k, shift)]:
                    dofs.append(link.dof + k)
                    weights.append(PER_METRE if k < shift else turn)
        return np.array(dofs, np.intp), np.array(weights)

    def bent_starts(self) -> list[Array]:
        """Return the starting poses: home clipped, with knees and elbows bent by each angle of BENT."""
        starts = [self.bend(self.home, angle) for angle in BENT]
        return starts[:1] if np.array_equal(starts[0], starts[-1]) else starts

    def starts_around(self, count: int) -> Iterator[Array]:
        """Return `count` further starting poses.

        The first is the rest pose of the joints, the second the middle of their ranges, both with knees and elbows
        bent. All others are random.
        """
        rest, middle, rng = np.array(self.home), np.array(self.home), np.random.default_rng(0)
        for i in self.joints:
            rest[self.figure.links[i].columns] = self.model.qpos0[self.figure.links[i].columns]
        middle[self.ranges.simple] = self.ranges.limits.mean(axis=1)
        yield from (self.bend(rest, BENT[0]), self.bend(middle, BENT[1]))[:count]
        turns = self.weights != PER_METRE
        for number in range(count - 2):
            start = self.move(self.home if number % 2 else rest, SPREAD * rng.normal(size=self.dofs.size) * turns)
            start[self.ranges.simple] = rng.uniform(*self.ranges.limits.T)
            yield start if self.bends is None else self.bends.bend(start, rng.uniform(BENT[0], BENT[-1]))

    def clip(self, qpos: Array) -> Array:
        """Return qpos (nq,) with hinges and slides clipped to their ranges."""
        return self.ranges.bend(qpos, -np.inf)

    def bend(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) clipped to the ranges, with every knee and elbow bent by at least `least` [rad]."""
        start = self.ranges.bend(qpos, least)
        return start if self.bends is None else self.bends.bend(start, least)

    def result(self, qpos: Array) -> Posed:
        self._place(qpos)
        missed = [np.linalg.norm(goal.residual(self.model, self.data)) for goal in self.goals]
        return Posed(qpos, self.fixed, np.array(missed, float))

    def rough_minimum(self, qpos: Array) -> tuple[Array, float]:
        """Return a pose that meets the goals approximately, at a small weight of the goals, and its cost."""
        return self._nearest(qpos, COARSE, None, NEGLIGIBLE)

    def rough_minimum_near(self, qpos: Array) -> Array:
        """Return a pose near qpos, instead of near home, that meets the goals approximately."""
        home, self.home = self.home, qpos
        try:
            return self._nearest(qpos, COARSE, None, NEGLIGIBLE)[0]
        finally:
            self.home = home

    def refine(self, qpos: Array) -> Posed:
        """Return the minimum nearest to a pose; the pose itself if its residual exceeds HOPELESS."""
        rough = self.result(qpos)
        return self.minimum(qpos) if rough.worst <= HOPELESS else rough

    def minimum(self, qpos: Array) -> Posed:
        """Return the minimum nearest to a pose, with multipliers updated until the goals are met."""
        weight, last, shifts = FIRM, np.inf, None
        for _ in range(ROUNDS):
            qpos, _ = self._nearest(qpos, weight, shifts, ROUNDING)
            off, over = (values for values, _ in self.linearise(qpos)[1:])
            shifts = (
                (off, np.maximum(over, 0)) if shifts is None else (off + shifts[0], np.maximum(over + shifts[1], 0))
            )
            worst = max(np.abs(off).max(initial=0), over.max(initial=0))
            if worst <= ROUNDING:
                break
            if worst > STALLED * last:  # a nearly straight limb bends only at a large weight
                if weight >= FIRMEST or worst > HOPELESS:
                    break
                weight *= 10
                shifts = shifts[0] / 100, shifts[1] / 100
            last = worst
        return self.result(qpos)

    def _nearest(
        self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None, settled: float
    ) -> tuple[Array, float]:
        """Return the least-squares pose and its cost; `shifts` are added to the residuals of goals and bounds."""
        firm = FIRMER * weight

        def residuals(qpos: Array) -> Residuals:
            near, (off, by_off), (over, by_over) = self.linearise(qpos)
            if shifts is not None:
                off, over = off + shifts[0], over + shifts[1]
            parts = [near, (weight * off, weight * by_off), (firm * over, firm * by_over)]
            return Residuals(*join(parts), near[0].size + off.size)

        return self.minimise(residuals, qpos, NEWTON_STEPS, settled=settled)

    def minimise(
        self,
        residuals: Callable[[Array], Residuals],
        qpos: Array,
        steps: int,
        **limits: float,
    ) -> tuple[Array, float]:
        """Return the pose of least cost near a pose (nq,), and its cost; `minimise` has these limits."""
        return minimise(residuals, self.move, self.weights, qpos, steps, **limits)

    def _place(self, qpos: Array) -> None:
        set_qpos(self.model, self.data, qpos)

    def move(self, qpos: Array, step: Array) -> Array:
        """Return qpos (nq,) moved by a step (n,) of the free degrees of freedom; all other entries are unchanged."""
        velocity, there = np.zeros(self.model.nv), np.array(qpos)
        velocity[self.dofs] = step
        mujoco.mj_integratePos(self.model, there, velocity, 1.0)
        return there

    @cached_property
    def _by_near(self) -> Array:
        """The Jacobian of the weighted distance from home, (n, n)."""
        return np.diag(self.weights)

    def linearise(self, qpos: Array) -> tuple[Part, Part, Part]:
        """Return three residuals of a pose (nq,), each with its Jacobian.

        Returns:
            The weighted distance from home, including sideways and twist angles of knees and elbows, and the preferred
            goals; the residuals of the goals; and the excess over bounds, which is negative within them.
        """
        self._place(qpos)
        from_home = np.zeros(self.model.nv)
        mujoco.mj_differentiatePos(self.model, from_home, 1.0, self.home, qpos)
        near, off = [(self.weights * from_home[self.dofs], self._by_near)], []
        for goal in self.goals:
            missed, rows = goal.linearise(self.model, self.data)
            off.append((missed, rows[:, self.dofs]))
        for weight, goal in self.preferred:
            values, rows = goal.linearise(self.model, self.data)
            near.append((weight * values, weight * rows[:, self.dofs]))
        over = [self.ranges.linearise(qpos)]
        if self.bends is not None:
            crooked, beyond = self.bends.linearise(qpos, self.model.nv)
            near.append((crooked[0], crooked[1][:, self.dofs]))
            over.append((beyond[0], beyond[1][:, self.dofs]))
        return join(near), join(off), join(over)


def find_pose(
    figure: Figure,
    qpos: Array,
    free: Mask,
    goals: Sequence[Goal],
    bends: BendLimits | None = None,
    starts: int = STARTS,
    preferred: Sequence[tuple[float, Goal]] = (),
) -> Posed:
    """Return the pose nearest to qpos that meets the goals; if none does, the pose with the smallest residual.

    A pose that already meets the goals is returned unchanged.

    Args:
        qpos: The initial pose, (nq,).
        free: The mask of the entries of qpos that may change, (nq,).
        bends: The knees and elbows on ball joints, with their bounds.
        preferred: Pairs of a weight [1/rad or 1/m] and a goal that is met approximately.
    """
    free, there = np.asarray(free, bool), np.array(qpos, float)
    fixed, missed, tried = np.zeros(figure.width, bool), np.zeros(len(goals)), 0
    for group in _apart(figure, free, goals):
        pose = _find(figure, there, free, tuple(goals[i] for i in group), bends, starts, tuple(preferred))
        there, fixed, tried = np.where(pose.fixed, pose.qpos, there), fixed | pose.fixed, max(tried, pose.starts)
        missed[group] = pose.missed
    return Posed(there, fixed, missed, tried)


_poses = Cache[Posed](MOST_CACHED)


def _find(
    figure: Figure,
    home: Array,
    free: Mask,
    goals: tuple[Goal, ...],
    bends: BendLimits | None,
    starts: int,
    preferred: tuple[tuple[float, Goal], ...],
) -> Posed:
    """Return the pose for goals that share free joints, from the cache if possible. Joints that the goals do not depend
    on are set to the rest pose, so that they do not change the cache key. Editing a clip repeats most of its poses."""
    goal_key = entries_of(figure, goals)
    home, free = np.where(goal_key, home, figure.model.qpos0), free & goal_key
    key = cache_key((figure.digest, home, free, goals, bends, starts, preferred))
    return _poses.get(key, lambda: _pose(PoseSearch(figure, home, free, goals, bends, preferred=preferred), starts))


def _pose(search: PoseSearch, starts: int) -> Posed:
    """Return the pose for goals that share free joints."""
    best = search.result(search.home)
    if best.is_met or not search.dofs.size:
        return best
    near = [search.rough_minimum(start) for start in search.bent_starts()[:starts]]
    poses: list[Posed] = []
    last = 0.0
    for rough, cost in sorted(near, key=lambda pair: pair[1]):
        if cost > (1 + NEGLIGIBLE) * last:  # otherwise the same as the previous rough pose
            poses.append(search.refine(rough))
            if poses[-1].is_met:
                return poses[-1]
        last = cost
    for start in search.starts_around(starts - len(near)):
        poses.append(search.refine(search.rough_minimum_near(start)))
        if poses[-1].is_met:
            return poses[-1]
    closest = search.minimum(min(poses, key=lambda pose: pose.worst).qpos)
    return replace(min([best, *poses, closest], key=lambda pose: pose.worst), starts=starts)


def in_winding(figure: Figure, qpos: Array, near: Array, which: Mask) -> Array:
    """Return qpos (nq,) with unlimited hinges shifted by multiples of 2π to be nearest to another pose.

    Args:
        qpos: The pose, (nq,).
        near: The other pose, (nq,).
        which: The mask of the entries that may be shifted, (nq,).
    """
    out, limited = np.array(qpos), figure.model.jnt_limited
    columns = [link.qpos for link in figure.links[1:] if link.kind is JointKind.HINGE and not limited[link.joint]]
    unlimited = np.array([column for column in columns if which[column]], np.intp)
    out[unlimited] += 2 * np.pi * np.round((near[unlimited] - out[unlimited]) / (2 * np.pi))
    return out


def _apart(figure: Figure, free: Mask, goals: Sequence[Goal]) -> list[list[int]]:
    """Return the indices of goals in groups; goals that share free joints are in the same group."""
    groups: list[tuple[set[int], list[int]]] = []
    for number, goal in enumerate(goals):
        links = {i for i in moved_by(figure, goal) if free[figure.links[i].columns].any()}
        touched = [group for group in groups if group[0] & links]
        groups = [group for group in groups if not group[0] & links]
        merged = sorted(i for _, members in touched for i in members)
        groups.append((links.union(*(members for members, _ in touched)), [*merged, number]))
    return [members for _, members in groups]
