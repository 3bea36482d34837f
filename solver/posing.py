"""Posing: where sites are to be and how bodies are to be turned becomes a whole pose of the joints that are free.

Damped least squares (K. Levenberg 1944; D. W. Marquardt 1963) in the tangent space of MuJoCo's configurations: the
pose nearest to a given one that meets its goals, within the joints' ranges, knees and elbows bent the right way. Goals
and bounds have multipliers (M. R. Hestenes 1969; R. T. Rockafellar 1973), so that they are met exactly at weights that
leave the search its way.
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

MET, EXACT = 1e-6, 1e-9  # [m, rad] a goal that is missed by no more is met; what is aimed at
COARSE, FIRM, FIRMEST = 30.0, 1e2, 1e5  # weight of the goals beside one radian of a joint, at first, then, at most
FIRMER = 30.0  # weight of ranges and bends relative to that of the goals
TRUNK = 6.0  # a radian of a joint of the trunk, where limbs branch off, in radians of a limb's joint
PER_METRE = 5.0  # a metre of the root or a slide, in the same
STRAIGHT = 3.0  # a radian of knees and elbows sideways and twisted, in the same
BENT = np.radians([15, 50, 90])  # how far knees and elbows are bent to begin with: a straight limb cannot shorten
ONE_SIDED = 0.25  # share of its range from an end within which a hinge that rests there is a knee: it bends one way
INSIDE = 1e-5  # [rad, m] how far inside its range a joint stays
STARTS, SPREAD = 12, 0.4  # poses to begin with at most, and how far scattered ones without a range are away [rad]
ALIKE = 2e-3  # share by which the costs of two rough poses differ that are one
HOPELESS = 0.05  # [m, rad] by which a rough pose misses its goals where none that meets them is near
ROUNDS, STALLED = 20, 0.7  # of the multipliers, and the share of what is missed that is left when they lead nowhere
STEPS, FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 60, 1e-3, 1e-12, 1e8
BOLDER, MORE_CAREFUL = 5, 8  # times less damping after a step that leads down, and times more after another
ROUGHLY, SETTLED = 1e-3, 1e-9  # share of what is left that a step gains where a descent ends: the first, the others
SMALLEST_STEP = 1e-11
MOST_REMEMBERED = 1000  # poses of a figure
SQUARED = 3e3  # weight up to which normal equations are exact enough
UPRIGHT, UNSEEN = 1e-12, 1e-12  # sine of a tilt that has no direction; square of a row that no joint has a part in
NARROW = 1e-9  # [rad, m] a range or a turn that is none

Part = tuple[Array, Array]  # values (k,) and their derivatives (k, n)


class Goal(Protocol):
    """What is to hold of a pose."""

    @property
    def name(self) -> str:
        """The site's or body's name in the model."""
        ...

    def body(self, model: mujoco.MjModel) -> int:
        """MuJoCo's id of the body that it is about."""
        ...

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """(k,) what is missing [m or rad]."""
        ...

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """(k, nv) how that changes with the joints."""
        ...


@dataclass(frozen=True, eq=False)
class PointGoal:
    """A point fixed on a body, offset (3,) [m] in its axes, at a place in the world: position (3,) [m], NaN along the
    axes that are free."""

    name: str
    index: int
    offset: Array
    position: Array

    @classmethod
    def of(cls, figure: Figure, point: Point, position: Array | None = None) -> PointGoal:
        """A sole point or another, at a place."""
        body = figure.links[point.link].body
        offset = quat.rotated(quat.inverse(figure.body_turn[body]), point.position - figure.body_offset[body])
        return cls(point.name, body, offset, np.zeros(3) if position is None else np.array(position, float))

    def body(self, model: mujoco.MjModel) -> int:
        return self.index

    def place(self, data: mujoco.MjData) -> Array:
        """(3,) [m] where the point is."""
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
    """The requested rotation of a body: in the world (4,) wxyz, or None for upright as at rest, the heading free.

    index  MuJoCo's id of the body; None for the one of that name
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
class HoldGoal:
    """A point of one body where another one is held: offsets (3,) [m] in the axes of both."""

    name: str
    index: int
    offset: Array
    held: int
    spot: Array

    @classmethod
    def of(cls, figure: Figure, point: Point, link: int, spot: Array) -> HoldGoal:
        """A point that is to be at a spot (3,) [m] of a link, in its axes."""
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
    """A pose and how far it misses each goal.

    qpos     (nq,) of the whole figure
    fixed    (nq,) the entries that the goals depend on: of the joints from the root to them
    missed   (n,) [m or rad], of every goal
    starts   how many poses were begun with where none led to it
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
        """[m or rad] by how much the goal is missed that is missed most."""
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
    """The pose nearest to qpos (nq,) that meets the goals, by the entries `free` (nq,) alone; else the one that
    misses them least. What meets them already stays as it is.

    bends   knees and elbows on ball joints, and how far they may go
    starts  how many poses to begin with, at most
    beyond  [rad] how far hinges and ball joints may be beyond their ranges
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
    """The pose for goals that depend on one another, found or remembered; what they do not depend on is at rest.

    So it depends on nothing but its arguments: editing a clip repeats most of its poses.
    """
    goal_key = reached(figure, goals)
    home, free = np.where(goal_key, home, figure.model.qpos0), free & goal_key
    key = cache_key((home, free, goals, bends, beyond, starts))
    poses = _poses.setdefault(figure, Cache(MOST_REMEMBERED))
    return poses.get(key, lambda: _posed(PoseSearch(figure, home, free, goals, bends, beyond), starts))


def _posed(search: PoseSearch, starts: int) -> Posed:
    """The pose for goals that depend on one another."""
    best = search.result(search.home)
    if best.is_met or not search.dofs.size:
        return best
    near = [search.roughly(start) for start in search.bent_starts()[:starts]]
    poses: list[Posed] = []
    last = 0.0
    for rough, cost in sorted(near, key=lambda pair: pair[1]):
        if cost > (1 + ALIKE) * last:  # else it leads where the one before did
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
    """qpos (nq,) with hinges without a range, of the entries `which` (nq,), in the turn nearest to a pose (nq,)."""
    out, limited = np.array(qpos), figure.model.jnt_limited
    columns = [link.qpos for link in figure.links[1:] if link.kind is JointKind.HINGE and not limited[link.joint]]
    unlimited = np.array([column for column in columns if which[column]], np.intp)
    out[unlimited] += 2 * np.pi * np.round((near[unlimited] - out[unlimited]) / (2 * np.pi))
    return out


def _apart(figure: Figure, free: Mask, goals: Sequence[Goal]) -> list[list[int]]:
    """The goals in groups that no free joint has a part in two of, by index."""
    groups: list[tuple[set[int], list[int]]] = []
    for number, goal in enumerate(goals):
        links = {i for i in moved_by(figure, goal) if free[entries(figure, i)].any()}
        touched = [group for group in groups if group[0] & links]
        groups = [group for group in groups if not group[0] & links]
        merged = sorted(i for _, members in touched for i in members)
        groups.append((links.union(*(members for members, _ in touched)), [*merged, number]))
    return [members for _, members in groups]


def chain(figure: Figure, body: int) -> list[int]:
    """The links from a body's own up to the root's."""
    links, link = [], int(figure.body_link[body])
    while link:
        links.append(link)
        link = figure.links[link].parent
    return links


def moved_by(figure: Figure, goal: Goal) -> set[int]:
    """The links whose joints a goal depends on."""
    links = set(chain(figure, goal.body(figure.model)))
    return links | set(chain(figure, goal.held)) if isinstance(goal, HoldGoal) else links


def reached(figure: Figure, goals: Sequence[Goal]) -> Mask:
    """(nq,) the entries that goals depend on: of the joints from the root to them."""
    mask = np.zeros(figure.width, bool)
    for link in {link for goal in goals for link in moved_by(figure, goal)}:
        mask[entries(figure, link)] = True
    return mask


def limb(figure: Figure, body: int) -> list[int]:
    """The links from a body's own towards the root, up to where another limb branches off."""
    links = chain(figure, body)
    forks = [i for i, link in enumerate(links) if i > 0 and figure.tables.children[link] > 1]
    return links[: forks[0]] if forks else links


def entries(figure: Figure, link: int) -> slice:
    """The columns of qpos that belong to a link's joint."""
    size = {JointKind.FREE: 7, JointKind.BALL: 4, JointKind.HINGE: 1, JointKind.SLIDE: 1}
    joint = figure.links[link]
    return slice(joint.qpos, joint.qpos + size[joint.kind])


def _at_rest(model: mujoco.MjModel, body: int) -> Array:
    """(4,) a body's orientation in the world at rest."""
    turn = np.array([1.0, 0, 0, 0])
    while body:
        turn = quat.product(model.body_quat[body], turn)
        body = int(model.body_parentid[body])
    return quat.normalised(turn)


class PoseSearch:
    """Least squares over the free degrees of freedom that the goals depend on.

    range_shares  by link, the share of its range that a joint may use
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
        """The free columns of qvel (n,), and what each weighs in the distance from home (n,)."""
        dofs, weights = [], []
        for i in links:
            link = self.figure.links[i]
            turn = TRUNK if self.figure.tables.children[i] > 1 else 1.0
            size = {JointKind.FREE: 6, JointKind.BALL: 3, JointKind.HINGE: 1, JointKind.SLIDE: 1}[link.kind]
            shift = {JointKind.FREE: 3, JointKind.SLIDE: 1}.get(link.kind, 0)
            for k in range(size):  # a dof of a position has an entry of its own, those of a turn have one for all
                if free[link.qpos + min(k, shift)]:
                    dofs.append(link.dof + k)
                    weights.append(PER_METRE if k < shift else turn)
        return np.array(dofs, np.intp), np.array(weights)

    def bent_starts(self) -> list[Array]:
        """Poses to begin with: home with knees and elbows bent by so much at least; home itself if it has none."""
        starts = [self.begun(self.home, angle) for angle in BENT]
        return starts[:1] if np.array_equal(starts[0], starts[-1]) else starts

    def starts_around(self, count: int) -> Iterator[Array]:
        """Others, as many: the pose at rest, for a limb that home has turned far round, and the middle of the ranges,
        knees and elbows bent a little; then scattered ones."""
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
        """qpos inside the ranges of hinges and slides."""
        return self.ranges.begun(qpos, -np.inf)

    def begun(self, qpos: Array, least: float) -> Array:
        """qpos inside the ranges of hinges and slides, every knee and elbow bent the right way by so much at least."""
        start = self.ranges.begun(qpos, least)
        return start if self.bends is None else self.bends.begun(start, least)

    def result(self, qpos: Array) -> Posed:
        self._place(qpos)
        missed = [np.linalg.norm(goal.missed(self.model, self.data)) for goal in self.goals]
        return Posed(qpos, self.fixed, np.array(missed, float))

    def roughly(self, qpos: Array) -> tuple[Array, float]:
        """A pose that nearly meets goals that weigh little, and what it costs."""
        return self._levenberg(qpos, COARSE, None, ROUGHLY)

    def around(self, qpos: Array) -> Array:
        """A pose near a start, wherever home is, that nearly meets the goals."""
        home, self.home = self.home, qpos
        try:
            return self._levenberg(qpos, COARSE, None, ROUGHLY)[0]
        finally:
            self.home = home

    def followed(self, qpos: Array) -> Posed:
        """The nearest minimum from a rough pose, or that pose itself if it is so far off that none near it will do."""
        rough = self.result(qpos)
        return self.exactly(qpos) if rough.worst <= HOPELESS else rough

    def exactly(self, qpos: Array) -> Posed:
        """The nearest minimum from a pose: with multipliers until the goals are met."""
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
            if worst > STALLED * last:  # a nearly straight limb buckles under enough weight only
                if weight >= FIRMEST or worst > HOPELESS:
                    break
                weight *= 10
                shifts = shifts[0] / 100, shifts[1] / 100
            last = worst
        return self.result(qpos)

    def _levenberg(
        self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None, settled: float, steps: int = STEPS
    ) -> tuple[Array, float]:
        """Least squares from a pose, the goals and bounds shifted by their multipliers; and what is left."""
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
        """qpos with its free degrees of freedom moved by a step (n,); the rest stays to the bit."""
        velocity, there = np.zeros(self.model.nv), np.array(qpos)
        velocity[self.dofs] = step
        mujoco.mj_integratePos(self.model, there, velocity, 1.0)
        return there

    def _weighed(self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None) -> Part:
        """All residuals (r,) of least squares and their derivatives by the free degrees of freedom (r, n)."""
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
        """(n, n) how the weighed distance from home changes with a step."""
        return np.diag(self.weights)

    def linearised(self, qpos: Array) -> tuple[Part, Part, Part]:
        """How far a pose is from home, from the goals, and over its bounds (below zero: within), with derivatives."""
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
    """(n,) what minimises |residuals + rows · step|² + damping Σ size² step², every unknown in its own size.

    is_exact  by orthogonal rather than normal equations, for weights that are far apart
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
    """a × b, (..., 3)."""
    return a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]]


def joined(parts: Sequence[Part]) -> Part:
    """Several values and their derivatives, one after the other."""
    return np.concatenate([values for values, _ in parts]), np.concatenate([rows for _, rows in parts])


@dataclass(frozen=True, eq=False)
class _Ranges:
    """The free joints that have a range.

    balls, turns    columns of the quaternions of ball joints (b, 4), and where their dofs stand among the unknowns
                    (b, 3); most (b,) [rad] how far they may turn
    simple, places  the same of hinges and slides, (s,) each; limits (s, 2) [rad, m]; ways (s,) ±1 where one rests
                    near an end of its range, so that it bends one way, or 0
    count           how many unknowns there are
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
        """The same with joints, by the first of their columns, kept to a share of their ranges about the middle, balls
        about their rest; as far as they are beyond at home (nq,)."""
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
        """qpos with its hinges and slides inside their ranges, and those that bend one way bent by so much at least."""
        out = np.array(qpos)
        low, high = self.limits.T
        at = out[self.simple]
        at = np.where(self.ways > 0, np.maximum(at, low + least), at)
        at = np.where(self.ways < 0, np.minimum(at, high - least), at)
        out[self.simple] = np.clip(at, low, high)
        return out

    def linearised(self, qpos: Array) -> Part:
        """How far joints are over the ends of their ranges (k,) [rad, m], and the derivatives (k, n)."""
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
    """The knees and elbows among the free joints: columns of their quaternions (n, 4) and dofs (n, 3)."""

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
        """qpos with every joint bent the right way by so much at least."""
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
        """In the joints' own axes: those of the parent, forward, along the limb and lateral (n, 3, 3), and of the child
        its long axis and its lateral one (2, n, 3)."""
        joints = self.limits.joints
        lateral, down = (np.array([getattr(joint, name) for joint in joints]) for name in ("lateral", "long_axis"))
        back = quat.inverse(np.array([self.figure.links[joint.link].turn for joint in joints]))
        forward, down, lateral = (quat.rotated(back, axis) for axis in (np.cross(lateral, down), down, lateral))
        return np.stack([forward, down, lateral], axis=1), np.array([down, lateral])

    def linearised(self, qpos: Array, nv: int) -> tuple[Part, Part]:
        """How far the joints are sideways and twisted (2 n,), how far over their bounds (5 n,), with rows (..., nv)."""
        parent, child = self._axes
        turned = np.einsum("nij,nbi->bnj", quat.matrices(qpos[self.columns]), parent)  # the parent's axes in the child
        (x, z, y), (a, b, q) = np.einsum("bnj,cnj->cbn", turned, child)
        # how these six change with turns about the child's axes, (6, n, 3): dx, dz, dy, da, db, dq
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
