"""Inverse kinematics: poses that meet target positions of points and target rotations of bodies.

The pose nearest to a given pose is computed by damped least squares (K. Levenberg 1944; D. W. Marquardt 1963) in the
tangent space of MuJoCo's configurations. Joints stay within their ranges, and knees and elbows bend the right way.
Goals and bounds have multipliers (M. R. Hestenes 1969; R. T. Rockafellar 1973). They are therefore met exactly at
weights that keep the least-squares problem well conditioned.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol
from weakref import WeakKeyDictionary

import mujoco
import numpy as np

from . import quaternion as quat
from .array import Array, Index, Mask
from .cache import Cache, cache_key
from .figure.figure import Figure, JointKind
from .penalty.joints.bend import ALONG, FLAT, BendLimits, bent
from .surface.points import Point

# [m, rad] largest residual norm of a goal that counts as met; residual at which the search ends
MET, EXACT = 1e-6, 1e-9
# [rad/m, 1] weights of goals, relative to 1 rad of a limb joint: rough search, first round, upper limit
COARSE, FIRM, FIRMEST = 30.0, 1e2, 1e5
FIRMER = 30.0  # [1] weight of ranges and bend bounds, relative to the weight of goals
TRUNK = 6.0  # [1] weight of a trunk joint (a joint with several child links), relative to a limb joint
PER_METRE = 5.0  # [rad/m] weight of translations of the root and of slides, relative to rotations of a limb joint
STRAIGHT = 3.0  # [1] weight of sideways and twist angles of knees and elbows, relative to rotations of a limb joint
# [rad] smallest flexions of knees and elbows in starting poses; straight limbs have a singular Jacobian
BENT = np.radians([15, 50, 90])
ONE_SIDED = 0.25  # [1] a hinge bends one way if its rest value is within this share of its range from an end
INSIDE = 1e-5  # [rad, m] margin of joints from the ends of their ranges
STARTS, SPREAD = 12, 0.4  # [1] largest number of starting poses; [rad] standard deviation of random rotations in them
ALIKE = 2e-3  # [1] rough poses whose costs differ by no more than this share are taken to be the same
HOPELESS = 0.05  # [m, rad] largest residual of a rough pose that is refined further
# [1] largest number of multiplier updates; ratio of successive residuals that counts as no progress
ROUNDS, STALLED = 20, 0.7
# [1] largest number of steps of a descent; initial, smallest and largest damping
STEPS, FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 60, 1e-3, 1e-12, 1e8
# [1] divisor of damping after a step that reduces the cost; multiplier of damping after any other step
BOLDER, MORE_CAREFUL = 5, 8
ROUGHLY, SETTLED = 1e-3, 1e-9  # [1] relative decrease of the cost at which a descent ends: rough search, exact search
SMALLEST_STEP = 1e-11  # [rad, m] norm of a step at which a descent ends
MOST_REMEMBERED = 1000  # [1] largest number of cached poses of a figure
SQUARED = 3e3  # [1] largest weight for which normal equations are accurate enough
# [1] smallest sine of a tilt with a defined direction; smallest squared norm of a Jacobian column in damping
UPRIGHT, UNSEEN = 1e-12, 1e-12
NARROW = 1e-9  # [rad, m] smallest range or rotation angle in a division

Part = tuple[Array, Array]  # residuals (k,) and their Jacobian (k, n)


class Goal(Protocol):
    """A target for a pose."""

    @property
    def name(self) -> str:
        """The site's or body's name in the model."""
        ...

    def body(self, model: mujoco.MjModel) -> int:
        """Return MuJoCo's id of the body that the goal applies to."""
        ...

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """Return the residual, current minus requested value, (k,) [m or rad]."""
        ...

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """Return the Jacobian of the residual with respect to the degrees of freedom, (k, nv)."""
        ...


@dataclass(frozen=True, eq=False)
class PointGoal:
    """A target position for a point of a body.

    Attributes:
        index: MuJoCo's id of the body.
        offset: The position of the point in the body's frame, (3,) [m].
        position: The target in the world, (3,) [m]; NaN along unconstrained axes.
    """

    name: str
    index: int
    offset: Array
    position: Array

    @classmethod
    def of(cls, figure: Figure, point: Point, position: Array | None = None) -> PointGoal:
        """Return the goal that a point of the figure is at a position (3,) [m]; None: at the origin."""
        body = figure.links[point.link].body
        offset = quat.rotated(quat.inverse(figure.body_turn[body]), point.position - figure.body_offset[body])
        return cls(point.name, body, offset, np.zeros(3) if position is None else np.array(position, float))

    def body(self, model: mujoco.MjModel) -> int:
        return self.index

    def place(self, data: mujoco.MjData) -> Array:
        """Return the current position of the point in the world, (3,) [m]."""
        return data.xpos[self.index] + data.xmat[self.index].reshape(3, 3) @ self.offset

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (self.place(data) - self.position)[self._given]

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jac(model, data, rows, None, self.place(data), self.index)
        return rows[self._given]

    @cached_property
    def _given(self) -> Mask:
        return ~np.isnan(self.position)


@dataclass(frozen=True, eq=False)
class BodyGoal:
    """A target rotation for a body.

    Attributes:
        rotation: The target in the world, a wxyz quaternion (4,); None: upright as in the rest pose, with any heading.
        index: MuJoCo's id of the body; None: the body is identified by its name.
    """

    name: str
    rotation: Array | None = None
    index: int | None = None

    def body(self, model: mujoco.MjModel) -> int:
        return int(model.body(self.name).id) if self.index is None else self.index

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        here = data.xquat[self.body(model)]
        if self.rotation is not None:
            return quat.rotation_vector(quat.product(here, quat.inverse(self.rotation)))
        up = quat.rotated(quat.product(here, quat.inverse(_at_rest(model, self.body(model)))), [0.0, 0, 1])
        tilt = np.cross([0.0, 0, 1], up)
        length = float(np.linalg.norm(tilt))
        if length < UPRIGHT:
            return np.array([0.0 if up[2] > 0 else np.pi, 0.0])
        return tilt[:2] * np.arctan2(length, up[2]) / length

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, data, None, rows, self.body(model))
        return rows if self.rotation is not None else rows[:2]


@dataclass(frozen=True, eq=False)
class GraspGoal:
    """A target that makes a point of one body coincide with a point of another.

    Attributes:
        index: MuJoCo's id of the grasping body.
        offset: The grasping point in the frame of its body, (3,) [m].
        held: MuJoCo's id of the grasped body.
        spot: The grasped point in the frame of its body, (3,) [m].
    """

    name: str
    index: int
    offset: Array
    held: int
    spot: Array

    @classmethod
    def of(cls, figure: Figure, point: Point, link: int, spot: Array) -> GraspGoal:
        """Return the goal that a point coincides with a position (3,) [m] in the frame of a link."""
        hand, grip = PointGoal.of(figure, point), PointGoal.of(figure, Point(point.name, link, spot))
        return cls(point.name, hand.index, hand.offset, grip.index, grip.offset)

    def body(self, model: mujoco.MjModel) -> int:
        return self.index

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        hand, spot = self._places(data)
        return hand - spot

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows, back = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        hand, spot = self._places(data)
        mujoco.mj_jac(model, data, rows, None, hand, self.index)
        mujoco.mj_jac(model, data, back, None, spot, self.held)
        return rows - back

    def _places(self, data: mujoco.MjData) -> tuple[Array, Array]:
        ends = ((self.index, self.offset), (self.held, self.spot))
        hand, spot = (data.xpos[body] + data.xmat[body].reshape(3, 3) @ offset for body, offset in ends)
        return hand, spot


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


def posed(
    figure: Figure,
    qpos: Array,
    free: Mask,
    goals: Sequence[Goal],
    bends: BendLimits | None = None,
    starts: int = STARTS,
    beyond: float = 0.0,
) -> Posed:
    """Return the pose nearest to qpos that meets the goals; if none does, the pose with the smallest residual.

    A pose that already meets the goals is returned unchanged.

    Args:
        qpos: The initial pose, (nq,).
        free: The mask of the entries of qpos that may change, (nq,).
        bends: The knees and elbows on ball joints, with their bounds.
        beyond: The permitted excess of hinges and ball joints over their ranges [rad].
    """
    free, there = np.asarray(free, bool), np.array(qpos, float)
    fixed, missed, tried = np.zeros(figure.width, bool), np.zeros(len(goals)), 0
    for group in _apart(figure, free, goals):
        pose = _known(figure, there, free, tuple(goals[i] for i in group), bends, beyond, starts)
        there, fixed, tried = np.where(pose.fixed, pose.qpos, there), fixed | pose.fixed, max(tried, pose.starts)
        missed[group] = pose.missed
    return Posed(there, fixed, missed, tried)


_poses: WeakKeyDictionary[Figure, Cache[Posed]] = WeakKeyDictionary()


def _known(
    figure: Figure,
    home: Array,
    free: Mask,
    goals: tuple[Goal, ...],
    bends: BendLimits | None,
    beyond: float,
    starts: int,
) -> Posed:
    """Return the pose for goals that share free joints, from the cache if possible. Joints that the goals do not depend
    on are set to the rest pose, so that they do not change the cache key. Editing a clip repeats most of its poses."""
    goal_key = reached(figure, goals)
    home, free = np.where(goal_key, home, figure.model.qpos0), free & goal_key
    key = cache_key((home, free, goals, bends, beyond, starts))
    poses = _poses.setdefault(figure, Cache(MOST_REMEMBERED))
    return poses.get(key, lambda: _posed(PoseSearch(figure, home, free, goals, bends, beyond), starts))


def _posed(search: PoseSearch, starts: int) -> Posed:
    """Return the pose for goals that share free joints."""
    best = search.result(search.home)
    if best.is_met or not search.dofs.size:
        return best
    near = [search.roughly(start) for start in search.bent_starts()[:starts]]
    poses: list[Posed] = []
    last = 0.0
    for rough, cost in sorted(near, key=lambda pair: pair[1]):
        if cost > (1 + ALIKE) * last:  # otherwise the same as the previous rough pose
            poses.append(search.followed(rough))
            if poses[-1].is_met:
                return poses[-1]
        last = cost
    for start in search.starts_around(starts - len(near)):
        poses.append(search.followed(search.around(start)))
        if poses[-1].is_met:
            return poses[-1]
    closest = search.exactly(min(poses, key=lambda pose: pose.worst).qpos)
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
        links = {i for i in moved_by(figure, goal) if free[entries(figure, i)].any()}
        touched = [group for group in groups if group[0] & links]
        groups = [group for group in groups if not group[0] & links]
        merged = sorted(i for _, members in touched for i in members)
        groups.append((links.union(*(members for members, _ in touched)), [*merged, number]))
    return [members for _, members in groups]


def chain(figure: Figure, body: int) -> list[int]:
    """Return the links from the link of a body up to the root."""
    links, link = [], int(figure.body_link[body])
    while link:
        links.append(link)
        link = figure.links[link].parent
    return links


def moved_by(figure: Figure, goal: Goal) -> set[int]:
    """Return the links whose joints a goal depends on."""
    links = set(chain(figure, goal.body(figure.model)))
    return links | set(chain(figure, goal.held)) if isinstance(goal, GraspGoal) else links


def reached(figure: Figure, goals: Sequence[Goal]) -> Mask:
    """Return the mask of the entries of qpos that goals depend on, (nq,): the joints from the root to their bodies."""
    mask = np.zeros(figure.width, bool)
    for link in {link for goal in goals for link in moved_by(figure, goal)}:
        mask[entries(figure, link)] = True
    return mask


def limb(figure: Figure, body: int) -> list[int]:
    """Return the links from the link of a body towards the root, up to the first link with several children."""
    links = chain(figure, body)
    forks = [i for i, link in enumerate(links) if i > 0 and figure.tables.children[link] > 1]
    return links[: forks[0]] if forks else links


def entries(figure: Figure, link: int) -> slice:
    """Return the columns of qpos of a link's joint."""
    size = {JointKind.FREE: 7, JointKind.BALL: 4, JointKind.HINGE: 1, JointKind.SLIDE: 1}
    joint = figure.links[link]
    return slice(joint.qpos, joint.qpos + size[joint.kind])


def _at_rest(model: mujoco.MjModel, body: int) -> Array:
    """Return the orientation of a body in the world in the rest pose, a wxyz quaternion (4,)."""
    turn = np.array([1.0, 0, 0, 0])
    while body:
        turn = quat.product(model.body_quat[body], turn)
        body = int(model.body_parentid[body])
    return quat.normalised(turn)


class PoseSearch:
    """Least squares over the n free degrees of freedom that the goals depend on.

    Args:
        home: The pose from which distances are measured, (nq,).
        free: The mask of the entries of qpos that may change, (nq,).
        bends: The knees and elbows on ball joints, with their bounds.
        beyond: The permitted excess of hinges and ball joints over their ranges [rad].
        range_shares: The permitted share of a joint's range, by the index of its link.
    """

    def __init__(
        self,
        figure: Figure,
        home: Array,
        free: Mask,
        goals: tuple[Goal, ...],
        bends: BendLimits | None,
        beyond: float = 0.0,
        range_shares: Mapping[int, float] | None = None,
    ) -> None:
        self.figure, self.model, self.home, self.goals = figure, figure.model, home, goals
        self.data = mujoco.MjData(self.model)
        links = sorted({link for goal in goals for link in moved_by(figure, goal)})
        self.fixed = reached(figure, goals)
        free = free & self.fixed
        self.dofs, self.weights = self._freedoms(links, free)
        self.joints = [
            i for i in links if figure.links[i].kind is not JointKind.FREE and free[entries(figure, i)].all()
        ]
        self.ranges = _Ranges.of(figure, self.joints, self.dofs, beyond)
        if range_shares:
            self.ranges = self.ranges.narrowed({figure.links[i].qpos: share for i, share in range_shares.items()}, home)
        self.bends = None if bends is None else _Bends.of(figure, bends, free)

    def _freedoms(self, links: list[int], free: Mask) -> tuple[Index, Array]:
        """Return the free columns of qvel (n,), and their weights in the distance from home (n,)."""
        dofs, weights = [], []
        for i in links:
            link = self.figure.links[i]
            turn = TRUNK if self.figure.tables.children[i] > 1 else 1.0
            size = {JointKind.FREE: 6, JointKind.BALL: 3, JointKind.HINGE: 1, JointKind.SLIDE: 1}[link.kind]
            shift = {JointKind.FREE: 3, JointKind.SLIDE: 1}.get(link.kind, 0)
            for k in range(size):  # rotations share one entry of the mask
                if free[link.qpos + min(k, shift)]:
                    dofs.append(link.dof + k)
                    weights.append(PER_METRE if k < shift else turn)
        return np.array(dofs, np.intp), np.array(weights)

    def bent_starts(self) -> list[Array]:
        """Return the starting poses: home clipped, with knees and elbows bent by each angle of BENT."""
        starts = [self.begun(self.home, angle) for angle in BENT]
        return starts[:1] if np.array_equal(starts[0], starts[-1]) else starts

    def starts_around(self, count: int) -> Iterator[Array]:
        """Return `count` further starting poses.

        The first is the rest pose of the joints, the second the middle of their ranges, both with knees and elbows
        bent. All others are random.
        """
        rest, middle, rng = np.array(self.home), np.array(self.home), np.random.default_rng(0)
        for i in self.joints:
            rest[entries(self.figure, i)] = self.model.qpos0[entries(self.figure, i)]
        middle[self.ranges.simple] = self.ranges.limits.mean(axis=1)
        yield from (self.begun(rest, BENT[0]), self.begun(middle, BENT[1]))[:count]
        turns = self.weights != PER_METRE
        for number in range(count - 2):
            start = self.moved(self.home if number % 2 else rest, SPREAD * rng.normal(size=self.dofs.size) * turns)
            start[self.ranges.simple] = rng.uniform(*self.ranges.limits.T)
            yield start if self.bends is None else self.bends.begun(start, rng.uniform(BENT[0], BENT[-1]))

    def clipped(self, qpos: Array) -> Array:
        """Return qpos (nq,) with hinges and slides clipped to their ranges."""
        return self.ranges.begun(qpos, -np.inf)

    def begun(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) clipped to the ranges, with every knee and elbow bent by at least `least` [rad]."""
        start = self.ranges.begun(qpos, least)
        return start if self.bends is None else self.bends.begun(start, least)

    def result(self, qpos: Array) -> Posed:
        self._place(qpos)
        missed = [np.linalg.norm(goal.missed(self.model, self.data)) for goal in self.goals]
        return Posed(qpos, self.fixed, np.array(missed, float))

    def roughly(self, qpos: Array) -> tuple[Array, float]:
        """Return a pose that meets the goals approximately, at a small weight of the goals, and its cost."""
        return self._levenberg(qpos, COARSE, None, ROUGHLY)

    def around(self, qpos: Array) -> Array:
        """Return a pose near qpos, instead of near home, that meets the goals approximately."""
        home, self.home = self.home, qpos
        try:
            return self._levenberg(qpos, COARSE, None, ROUGHLY)[0]
        finally:
            self.home = home

    def followed(self, qpos: Array) -> Posed:
        """Return the minimum nearest to a pose; the pose itself if its residual exceeds HOPELESS."""
        rough = self.result(qpos)
        return self.exactly(qpos) if rough.worst <= HOPELESS else rough

    def exactly(self, qpos: Array) -> Posed:
        """Return the minimum nearest to a pose, with multipliers updated until the goals are met."""
        weight, last, shifts = FIRM, np.inf, None
        for _ in range(ROUNDS):
            qpos, _ = self._levenberg(qpos, weight, shifts, SETTLED)
            off, over = (values for values, _ in self.linearised(qpos)[1:])
            shifts = (
                (off, np.maximum(over, 0)) if shifts is None else (off + shifts[0], np.maximum(over + shifts[1], 0))
            )
            worst = max(np.abs(off).max(initial=0), over.max(initial=0))
            if worst <= EXACT:
                break
            if worst > STALLED * last:  # a nearly straight limb bends only at a large weight
                if weight >= FIRMEST or worst > HOPELESS:
                    break
                weight *= 10
                shifts = shifts[0] / 100, shifts[1] / 100
            last = worst
        return self.result(qpos)

    def _levenberg(
        self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None, settled: float, steps: int = STEPS
    ) -> tuple[Array, float]:
        """Return the least-squares pose and its cost; `shifts` are added to the residuals of goals and bounds."""
        damping = FIRST_DAMPING
        residuals, rows = self._weighed(qpos, weight, shifts)
        cost = float(residuals @ residuals)
        for _ in range(steps):
            step = _step(residuals, rows, damping, is_exact=FIRMER * weight > SQUARED)
            there = self.moved(qpos, step)
            residuals_there, rows_there = self._weighed(there, weight, shifts)
            cost_there = float(residuals_there @ residuals_there)
            if cost_there < cost:
                ends = cost - cost_there <= settled * cost and damping <= FIRST_DAMPING
                qpos, residuals, rows, cost = there, residuals_there, rows_there, cost_there
                damping = max(damping / BOLDER, LEAST_DAMPING)
                if ends:
                    break
            else:
                damping *= MORE_CAREFUL
            if np.linalg.norm(step) < SMALLEST_STEP or damping > MOST_DAMPING:
                break
        return qpos, cost

    def _place(self, qpos: Array) -> None:
        self.data.qpos[:] = qpos
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)

    def moved(self, qpos: Array, step: Array) -> Array:
        """Return qpos (nq,) moved by a step (n,) of the free degrees of freedom; all other entries are unchanged."""
        velocity, there = np.zeros(self.model.nv), np.array(qpos)
        velocity[self.dofs] = step
        mujoco.mj_integratePos(self.model, there, velocity, 1.0)
        return there

    def _weighed(self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None) -> Part:
        """Return all weighted residuals (r,) and their Jacobian (r, n) with respect to the free degrees of freedom."""
        near, (off, by_off), (over, by_over) = self.linearised(qpos)
        if shifts is not None:
            off, over = off + shifts[0], over + shifts[1]
        firm = FIRMER * weight * (over > 0)
        return (
            np.concatenate([near[0], weight * off, firm * over]),
            np.concatenate([near[1], weight * by_off, firm[:, None] * by_over]),
        )

    @cached_property
    def _by_near(self) -> Array:
        """The Jacobian of the weighted distance from home, (n, n)."""
        return np.diag(self.weights)

    def linearised(self, qpos: Array) -> tuple[Part, Part, Part]:
        """Return three residuals of a pose (nq,), each with its Jacobian.

        Returns:
            The weighted distance from home, including sideways and twist angles of knees and elbows; the residuals of
            the goals; and the excess over bounds, which is negative within them.
        """
        self._place(qpos)
        from_home = np.zeros(self.model.nv)
        mujoco.mj_differentiatePos(self.model, from_home, 1.0, self.home, qpos)
        near, off = [(self.weights * from_home[self.dofs], self._by_near)], []
        for goal in self.goals:
            missed, rows = goal.missed(self.model, self.data), goal.rows(self.model, self.data)
            off.append((missed, rows[:, self.dofs]))
        over = [self.ranges.linearised(qpos)]
        if self.bends is not None:
            crooked, beyond = self.bends.linearised(qpos, self.model.nv)
            near.append((crooked[0], crooked[1][:, self.dofs]))
            over.append((beyond[0], beyond[1][:, self.dofs]))
        return joined(near), joined(off), joined(over)


def _step(residuals: Array, rows: Array, damping: float, *, is_exact: bool) -> Array:
    """Return the step (n,) that minimises |residuals + rows · step|² + damping Σ size² step².

    Args:
        residuals: The residuals, (r,).
        rows: Their Jacobian, (r, n).
        damping: The damping, relative to the squared size of every unknown, which is the norm of its Jacobian column.
        is_exact: Whether an orthogonal factorisation replaces the normal equations, for weights of very different size.
    """
    squares = damping * np.maximum(np.einsum("rn,rn->n", rows, rows), UNSEEN)
    if not is_exact:
        normal = rows.T @ rows
        normal.flat[:: squares.size + 1] += squares
        try:
            return np.asarray(np.linalg.solve(normal, -(rows.T @ residuals)), float)
        except np.linalg.LinAlgError:
            pass
    system = np.vstack([rows, np.diag(np.sqrt(squares))])
    return np.asarray(np.linalg.lstsq(system, np.append(-residuals, 0 * squares), rcond=None)[0], float)


def _crossed(a: Array, b: Array) -> Array:
    """Return a × b, (..., 3)."""
    return a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]]


def joined(parts: Sequence[Part]) -> Part:
    """Return the concatenated residuals and Jacobians of several parts."""
    return np.concatenate([values for values, _ in parts]), np.concatenate([rows for _, rows in parts])


@dataclass(frozen=True, eq=False)
class _Ranges:
    """The ranges of free joints.

    Attributes:
        balls: The columns of ball joints in qpos, (b, 4).
        turns: The indices of their degrees of freedom among the unknowns, (b, 3).
        most: Their largest rotation angles, (b,) [rad].
        simple: The columns of hinges and slides in qpos, (s,).
        places: The indices of their degrees of freedom among the unknowns, (s,).
        limits: Their lower and upper limits, (s, 2) [rad or m].
        ways: The signs of the bending direction of hinges that bend one way, otherwise 0, (s,).
        count: The number of unknowns, n.
    """

    balls: Index
    turns: Index
    most: Array
    simple: Index
    places: Index
    limits: Array
    ways: Array
    count: int

    @classmethod
    def of(cls, figure: Figure, joints: Sequence[int], dofs: Index, beyond: float) -> _Ranges:
        model = figure.model
        links = [link for i in joints if model.jnt_limited[(link := figure.links[i]).joint]]
        balls = [link for link in links if link.kind is JointKind.BALL]
        simple = [link for link in links if link.kind is not JointKind.BALL]
        limits = model.jnt_range[[link.joint for link in simple]].reshape(-1, 2)
        columns = np.array([link.qpos for link in simple], np.intp)
        share = (model.qpos0[columns] - limits[:, 0]) / np.maximum(np.ptp(limits, axis=1), NARROW)
        hinges = np.array([link.kind is JointKind.HINGE for link in simple], bool)
        directions = hinges * (1.0 * (share < ONE_SIDED) - (share > 1 - ONE_SIDED))
        margin = np.minimum(INSIDE, np.ptp(limits, axis=1) / 4) - beyond * hinges
        return cls(
            np.array([link.qpos for link in balls], np.intp)[:, None] + np.arange(4),
            np.searchsorted(dofs, np.array([link.dof for link in balls], np.intp))[:, None] + np.arange(3),
            model.jnt_range[[link.joint for link in balls], 1] + (beyond - INSIDE),
            columns,
            np.searchsorted(dofs, np.array([link.dof for link in simple], np.intp)),
            limits + np.array([1, -1]) * margin[:, None],
            directions,
            dofs.size,
        )

    def narrowed(self, shares: Mapping[int, float], home: Array) -> _Ranges:
        """Return narrower ranges, which still contain the values at home (nq,).

        Args:
            shares: The permitted share of a range, by the first column of the joint in qpos. Ranges of hinges and
                slides are narrowed towards their middle, those of ball joints towards the rest pose.
            home: The pose, (nq,).
        """
        shares_kept = np.array([shares.get(int(columns[0]), 1.0) for columns in self.balls])
        there = np.linalg.norm(quat.rotation_vector(home[self.balls]), axis=-1)
        most = np.minimum(self.most, np.maximum(shares_kept * self.most, there))
        spare = np.array([1 - shares.get(int(column), 1.0) for column in self.simple])
        margin = np.outer(spare / 2 * np.ptp(self.limits, axis=1), [1, -1])
        low, high = (self.limits + margin).T
        at = np.clip(home[self.simple], *self.limits.T)
        narrow = np.stack([np.minimum(low, at), np.maximum(high, at)], axis=1)
        return replace(self, most=most, limits=np.where(spare[:, None] > 0, narrow, self.limits))

    def begun(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) clipped to the ranges, with one-way hinges bent by at least `least` [rad]."""
        out = np.array(qpos)
        low, high = self.limits.T
        at = out[self.simple]
        at = np.where(self.ways > 0, np.maximum(at, low + least), at)
        at = np.where(self.ways < 0, np.minimum(at, high - least), at)
        out[self.simple] = np.clip(at, low, high)
        return out

    def linearised(self, qpos: Array) -> Part:
        """Return the signed excess of joints over the ends of their ranges (k,) [rad or m], and its Jacobian (k, n)."""
        balls, simple = len(self.balls), self.simple.size
        over, rows = np.empty(balls + 2 * simple), np.zeros((balls + 2 * simple, self.count))
        if balls:
            turn = quat.rotation_vector(qpos[self.balls])
            angle = np.sqrt(np.einsum("bi,bi->b", turn, turn))
            over[:balls] = angle - self.most
            rows[np.arange(balls)[:, None], self.turns] = turn / np.maximum(angle, NARROW)[:, None]
        at, upper = qpos[self.simple], balls + np.arange(simple)
        over[upper], over[upper + simple] = at - self.limits[:, 1], self.limits[:, 0] - at
        rows[upper, self.places], rows[upper + simple, self.places] = 1.0, -1.0
        return over, rows


@dataclass(frozen=True, eq=False)
class _Bends:
    """The knees and elbows among the free joints.

    Attributes:
        limits: The k joints with their bounds.
        columns: The columns of their quaternions in qpos, (k, 4).
        dofs: Their degrees of freedom, (k, 3).
    """

    figure: Figure
    limits: BendLimits
    columns: Index
    dofs: Index

    @classmethod
    def of(cls, figure: Figure, limits: BendLimits, free: Mask) -> _Bends | None:
        joints = tuple(joint for joint in limits.joints if free[entries(figure, joint.link)].all())
        if not joints:
            return None
        links = [figure.links[joint.link] for joint in joints]
        limits = BendLimits(joints, limits.least, limits.sideways, limits.twist)
        columns = np.array([link.qpos for link in links])[:, None] + np.arange(4)
        return cls(figure, limits, columns, np.array([link.dof for link in links])[:, None] + np.arange(3))

    def begun(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) with a flexion of every joint of at least `least` [rad]."""
        out = np.array(qpos)
        flexion = self._angles(qpos[self.columns])[0]
        for joint, columns, angle in zip(self.limits.joints, self.columns, flexion, strict=True):
            if angle < least:
                turn = self.figure.links[joint.link].turn
                axis = quat.rotated(quat.inverse(turn), joint.lateral)
                more = quat.from_rotation_vector((least - angle) * axis)
                out[columns] = quat.product(quat.normalised(out[columns]), more)
        return out

    @cached_property
    def _axes(self) -> tuple[Array, Array]:
        """The axes of parent and child in the frames of the joints.

        Returns:
            The forward, long and lateral axes of the parents (k, 3, 3); the long and lateral axes of the children
            (2, k, 3).
        """
        joints = self.limits.joints
        lateral, down = (np.array([getattr(joint, name) for joint in joints]) for name in ("lateral", "long_axis"))
        back = quat.inverse(np.array([self.figure.links[joint.link].turn for joint in joints]))
        forward, down, lateral = (quat.rotated(back, axis) for axis in (np.cross(lateral, down), down, lateral))
        return np.stack([forward, down, lateral], axis=1), np.array([down, lateral])

    def linearised(self, qpos: Array, nv: int) -> tuple[Part, Part]:
        """Return the weighted sideways and twist angles (2 k,) and the excess over bounds (5 k,), with Jacobians."""
        parent, child = self._axes
        turned = np.einsum("nij,nbi->bnj", quat.matrices(qpos[self.columns]), parent)  # in the child's frame
        (x, z, y), (a, b, q) = np.einsum("bnj,cnj->cbn", turned, child)
        # derivatives with respect to rotations about the child's axes, (6, k, 3): dx, dz, dy, da, db, dq
        slopes = _crossed(child[:, None], turned).reshape(6, x.size, 3)
        planar = np.maximum(np.hypot(x, z), ALONG)
        p = (x * b - z * a) / planar
        both = np.maximum(p**2 + q**2, FLAT)
        flexion, sideways, twist = np.arctan2(x, z), np.arctan2(y, planar), np.arctan2(p, q)
        by_six, square, of_p = np.zeros((3, 6, x.size)), planar**2, q / both / planar
        by_six[0, :2] = z / square, -x / square
        by_six[1, :3] = -y * x / planar, -y * z / planar, planar
        by_six[2, 0], by_six[2, 1] = of_p * (b - p * x / planar), -of_p * (a + p * z / planar)
        by_six[2, 3:] = -of_p * z, of_p * x, -p / both
        by = np.zeros((3, x.size, nv))
        by[:, np.arange(x.size)[:, None], self.dofs] = np.einsum("ksn,snj->knj", by_six, slopes)
        limits = self.limits
        over = [limits.least - flexion]
        for value, bound in ((sideways, limits.sideways), (twist, limits.twist)):
            over += [value - bound, -value - bound]
        crooked = STRAIGHT * np.concatenate([sideways, twist]), STRAIGHT * np.concatenate([by[1], by[2]])
        return crooked, (np.concatenate(over) + INSIDE, np.concatenate([-by[0], by[1], -by[1], by[2], -by[2]]))

    def _angles(self, q: Array) -> Array:
        return bent(self.figure, self.limits.joints, q)
