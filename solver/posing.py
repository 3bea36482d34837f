"""Posing: where sites are to be and how bodies are to be turned becomes a whole pose of the joints that are free.

Damped least squares (K. Levenberg 1944; D. W. Marquardt 1963) in the tangent space of MuJoCo's configurations: the
pose nearest to a given one that meets its goals, within the joints' ranges, knees and elbows bent the right way. Goals
and bounds have multipliers (M. R. Hestenes 1969; R. T. Rockafellar 1973), so that they are met exactly at weights that
leave the search its way.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import mujoco
import numpy as np

from . import quaternion as quat
from .figure import Figure, JointKind
from .frame import Mask
from .penalty.bend import BendLimits, bent
from .quaternion import Array, Index

MET, EXACT = 1e-6, 1e-9  # [m, rad] a goal that is missed by no more is met; what is aimed at
COARSE, FIRM, FIRMEST = 30.0, 1e2, 1e5  # weight of the goals beside one radian of a joint, at first, then, at most
FIRMER = 30.0  # weight of ranges and bends beside that of the goals
TRUNK = 6.0  # a radian of a joint of the trunk, where limbs branch off, in radians of a limb's joint
PER_METRE = 5.0  # a metre of the root or a slide, in the same
STRAIGHT = 3.0  # a radian of knees and elbows sideways and twisted, in the same
BENT = np.radians([15, 50, 90])  # how far knees and elbows are bent to begin with: a straight limb cannot shorten
INSIDE = 1e-4  # [rad, m] how far inside its range a joint stays
STARTS, SPREAD = 8, 0.4  # other poses to begin with where one leads nowhere, and how far away they are [rad]
AGREEING, ALIKE = 3, 1e-4  # so many starts that miss by the same, and what counts as the same, tell that none will do
ROUNDS, STALLED = 20, 0.7  # of the multipliers, and the share of what is missed that is left when they lead nowhere
STEPS, FIRST_DAMPING, MOST_DAMPING = 60, 1e-3, 1e8
SETTLED = 1e-9  # share of what is left that a step gains where a descent ends
SMALLEST_STEP, DIFFERENCE = 1e-11, 1e-6


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
class SiteGoal:
    """A site at a place in the world: position (3,) [m], NaN along the axes that are free."""

    name: str
    position: Array

    def body(self, model: mujoco.MjModel) -> int:
        return int(model.site_bodyid[model.site(self.name).id])

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (data.site(self.name).xpos - self.position)[self._given]

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSite(model, data, rows, None, model.site(self.name).id)
        return rows[self._given]

    @cached_property
    def _given(self) -> Mask:
        return ~np.isnan(self.position)


@dataclass(frozen=True, eq=False)
class BodyGoal:
    """A body turned as said: its rotation in the world (4,) wxyz, or None for upright as at rest, the heading free."""

    name: str
    rotation: Array | None = None

    def body(self, model: mujoco.MjModel) -> int:
        return int(model.body(self.name).id)

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        here = data.body(self.name).xquat
        if self.rotation is not None:
            return quat.rotation_vector(quat.product(here, quat.inverse(self.rotation)))
        up = quat.rotated(quat.product(here, quat.inverse(_at_rest(model, self.body(model)))), [0.0, 0, 1])
        tilt = np.cross([0.0, 0, 1], up)
        length = float(np.linalg.norm(tilt))
        if length < 1e-12:
            return np.array([0.0 if up[2] > 0 else np.pi, 0.0])
        return tilt[:2] * np.arctan2(length, up[2]) / length

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, data, None, rows, self.body(model))
        return rows if self.rotation is not None else rows[:2]


@dataclass(frozen=True, eq=False)
class Posed:
    """A pose and how far it misses each goal.

    qpos     (nq,) of the whole figure
    fixed    (nq,) the entries that the goals depend on: of the joints from the root to them
    missed   (n,) [m or rad], of every goal
    """

    qpos: Array
    fixed: Mask
    missed: Array

    @property
    def is_met(self) -> bool:
        return bool(np.all(self.missed <= MET))


def posed(figure: Figure, qpos: Array, free: Mask, goals: Sequence[Goal], bends: BendLimits | None = None) -> Posed:
    """The pose nearest to qpos (nq,) that meets the goals, by the entries `free` (nq,) alone; else the one that
    misses them least. What meets them already stays as it is.

    bends  knees and elbows on ball joints, and how far they may go
    """
    search = _Search(figure, np.array(qpos, float), np.asarray(free, bool), tuple(goals), bends)
    best = search.result(search.home)
    if best.is_met or not search.dofs.size:
        return best
    found = [search.descended(start) for start in search.bent_starts()]
    met = [pose for pose in found if pose.is_met]
    if met:
        return min(met, key=lambda pose: search.distance(pose.qpos))
    found.append(search.descended(search.rest_start()))
    if found[-1].is_met:
        return found[-1]
    for start in search.starts_around():
        least = sorted(float(pose.missed.max()) for pose in found)
        if len(found) >= AGREEING and least[AGREEING - 1] < least[0] + ALIKE:
            break
        found.append(search.descended(start))
        if found[-1].is_met:
            return found[-1]
    return min([best, *found], key=lambda pose: float(pose.missed.max()))


def chain(figure: Figure, body: int) -> list[int]:
    """The links from a body's own up to the root's."""
    links, link = [], int(figure.body_link[body])
    while link:
        links.append(link)
        link = figure.links[link].parent
    return links


def entries(figure: Figure, link: int) -> slice:
    """The columns of qpos that belong to a link's joint."""
    size = {JointKind.FREE: 7, JointKind.BALL: 4, JointKind.HINGE: 1, JointKind.SLIDE: 1}
    own = figure.links[link]
    return slice(own.qpos, own.qpos + size[own.kind])


def _at_rest(model: mujoco.MjModel, body: int) -> Array:
    """(4,) a body's orientation in the world at rest."""
    turn = np.array([1.0, 0, 0, 0])
    while body:
        turn = quat.product(model.body_quat[body], turn)
        body = int(model.body_parentid[body])
    return quat.normalised(turn)


class _Search:
    """Least squares over the free degrees of freedom that the goals depend on."""

    def __init__(self, figure: Figure, home: Array, free: Mask, goals: tuple[Goal, ...], bends: BendLimits | None):
        self.figure, self.model, self.home, self.goals = figure, figure.model, home, goals
        self.data = mujoco.MjData(self.model)
        links = sorted({link for goal in goals for link in chain(figure, goal.body(self.model))})
        self.fixed = np.zeros(figure.width, bool)
        for link in links:
            self.fixed[entries(figure, link)] = True
        free = free & self.fixed
        self.dofs, self.weights = self._freedoms(links, free)
        self.joints = [
            i for i in links if figure.links[i].kind is not JointKind.FREE and free[entries(figure, i)].all()
        ]
        self.ranged = [link for link in links if self._is_ranged(link) and free[entries(figure, link)].all()]
        self.bends = None if bends is None else _Bends.of(figure, bends, free)

    def _is_ranged(self, link: int) -> bool:
        return bool(self.model.jnt_limited[self.figure.links[link].joint])

    def _freedoms(self, links: list[int], free: Mask) -> tuple[Index, Array]:
        """The free columns of qvel (n,), and what each weighs in the distance from home (n,)."""
        dofs, weights = [], []
        for i in links:
            link = self.figure.links[i]
            turn = TRUNK if np.count_nonzero(self.figure.tables.parents[1:] == i) > 1 else 1.0
            size = {JointKind.FREE: 6, JointKind.BALL: 3, JointKind.HINGE: 1, JointKind.SLIDE: 1}[link.kind]
            shift = {JointKind.FREE: 3, JointKind.SLIDE: 1}.get(link.kind, 0)
            for k in range(size):  # a dof of a position has an entry of its own, those of a turn have one for all
                if free[link.qpos + min(k, shift)]:
                    dofs.append(link.dof + k)
                    weights.append(PER_METRE if k < shift else turn)
        return np.array(dofs, np.intp), np.array(weights)

    def bent_starts(self) -> list[Array]:
        """Poses to begin with: home with knees and elbows bent by so much at least."""
        return [self.home] if self.bends is None else [self.bends.begun(self.home, angle) for angle in BENT]

    def rest_start(self) -> Array:
        """The pose of home with the joints that are free as the model has them at rest, all but the root's, and bent a
        little: a limb that home has turned far round may be stuck there."""
        start = np.array(self.home)
        for i in self.joints:
            start[entries(self.figure, i)] = self.model.qpos0[entries(self.figure, i)]
        return start if self.bends is None else self.bends.begun(start, BENT[0])

    def starts_around(self) -> list[Array]:
        """Others, scattered around the first."""
        first, rng = self.bent_starts()[0], np.random.default_rng(0)
        turns = self.weights != PER_METRE
        steps = SPREAD * rng.normal(size=(STARTS, self.dofs.size)) * turns
        return [self._moved(first, step) for step in steps]

    def distance(self, qpos: Array) -> float:
        """How far a pose is from home, knees and elbows sideways and twisted included."""
        residuals = self._linearised(qpos)[0][0]
        return float(residuals @ residuals)

    def result(self, qpos: Array) -> Posed:
        self._place(qpos)
        missed = [np.linalg.norm(goal.missed(self.model, self.data)) for goal in self.goals]
        return Posed(qpos, self.fixed, np.array(missed, float))

    def descended(self, qpos: Array) -> Posed:
        """The nearest minimum from a pose: at goals that weigh little, then with multipliers until they are met."""
        qpos = self._levenberg(qpos, COARSE, None)
        weight, last, shifts = FIRM, np.inf, None
        for _ in range(ROUNDS):
            qpos = self._levenberg(qpos, weight, shifts)
            off, over = (values for values, _ in self._linearised(qpos)[1:])
            shifts = (
                (off, np.maximum(over, 0)) if shifts is None else (off + shifts[0], np.maximum(over + shifts[1], 0))
            )
            worst = max(np.abs(off).max(initial=0), over.max(initial=0))
            if worst <= EXACT:
                break
            if worst > STALLED * last:  # a nearly straight limb buckles under enough weight only
                if weight >= FIRMEST:
                    break
                weight *= 10
                shifts = shifts[0] / 100, shifts[1] / 100
            last = worst
        return self.result(qpos)

    def _levenberg(self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None) -> Array:
        """Least squares from a pose, the goals and bounds shifted by their multipliers."""
        damping = FIRST_DAMPING
        residuals, rows = self._weighed(qpos, weight, shifts)
        cost = float(residuals @ residuals)
        for _ in range(STEPS):
            size = np.sqrt(damping * np.maximum(np.einsum("rn,rn->n", rows, rows), 1e-12))
            system = np.vstack([rows, np.diag(size)])
            step = np.asarray(np.linalg.lstsq(system, np.append(-residuals, 0 * size), rcond=None)[0], float)
            there = self._moved(qpos, step)
            residuals_there, rows_there = self._weighed(there, weight, shifts)
            cost_there = float(residuals_there @ residuals_there)
            if cost_there < cost:
                settled = cost - cost_there <= SETTLED * cost and damping <= FIRST_DAMPING
                qpos, residuals, rows, cost = there, residuals_there, rows_there, cost_there
                damping = max(damping / 5, 1e-12)
                if settled:
                    break
            else:
                damping *= 8
            if np.linalg.norm(step) < SMALLEST_STEP or damping > MOST_DAMPING:
                break
        return qpos

    def _place(self, qpos: Array) -> None:
        self.data.qpos[:] = qpos
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)

    def _moved(self, qpos: Array, step: Array) -> Array:
        """qpos with its free degrees of freedom moved by a step (n,); the rest stays to the bit."""
        velocity, there = np.zeros(self.model.nv), np.array(qpos)
        velocity[self.dofs] = step
        mujoco.mj_integratePos(self.model, there, velocity, 1.0)
        return there

    def _weighed(self, qpos: Array, weight: float, shifts: tuple[Array, Array] | None) -> Part:
        """All residuals (r,) of least squares and their derivatives by the free degrees of freedom (r, n)."""
        near, (off, by_off), (over, by_over) = self._linearised(qpos)
        if shifts is not None:
            off, over = off + shifts[0], over + shifts[1]
        firm = FIRMER * weight * (over > 0)
        return (
            np.concatenate([near[0], weight * off, firm * over]),
            np.concatenate([near[1], weight * by_off, firm[:, None] * by_over]),
        )

    def _linearised(self, qpos: Array) -> tuple[Part, Part, Part]:
        """How far a pose is from home, from the goals, and over its bounds (below zero: within), with derivatives."""
        self._place(qpos)
        from_home = np.zeros(self.model.nv)
        mujoco.mj_differentiatePos(self.model, from_home, 1.0, self.home, qpos)
        near, off = [(self.weights * from_home[self.dofs], np.diag(self.weights))], []
        for goal in self.goals:
            missed, rows = goal.missed(self.model, self.data), goal.rows(self.model, self.data)
            off.append((missed, rows[:, self.dofs]))
        over = [self._over_ranges(qpos)]
        if self.bends is not None:
            crooked, beyond = self.bends.linearised(qpos, self.model.nv)
            near.append((crooked[0], crooked[1][:, self.dofs]))
            over.append((beyond[0], beyond[1][:, self.dofs]))
        return _joined(near), _joined(off), _joined(over)

    def _over_ranges(self, qpos: Array) -> Part:
        """How far joints are over the ends of their ranges (k,) [rad, m], and the derivatives (k, n)."""
        links = [self.figure.links[i] for i in self.ranged]
        limits = self.model.jnt_range[[link.joint for link in links]].reshape(-1, 2)
        balls = np.array([link.kind is JointKind.BALL for link in links], bool)
        columns, dofs = (np.array([getattr(link, name) for link in links], np.intp) for name in ("qpos", "dof"))
        turn = quat.rotation_vector(qpos[columns[balls, None] + np.arange(4)])
        angle = np.linalg.norm(turn, axis=-1)
        at, margin = qpos[columns[~balls]], np.minimum(INSIDE, np.diff(limits[~balls], axis=1)[:, 0] / 4)
        over = np.concatenate([
            angle - (limits[balls, 1] - INSIDE), at - (limits[~balls, 1] - margin), limits[~balls, 0] + margin - at
        ])  # fmt: skip
        rows = np.zeros((over.size, self.model.nv))
        ball, simple = np.arange(angle.size), angle.size + np.arange(at.size)
        rows[ball[:, None], dofs[balls, None] + np.arange(3)] = turn / np.maximum(angle, 1e-9)[:, None]
        rows[simple, dofs[~balls]], rows[simple + at.size, dofs[~balls]] = 1.0, -1.0
        return over, rows[:, self.dofs]


def _joined(parts: Sequence[Part]) -> Part:
    return np.concatenate([values for values, _ in parts]), np.concatenate([rows for _, rows in parts])


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

    def linearised(self, qpos: Array, nv: int) -> tuple[Part, Part]:
        """How far the joints are sideways and twisted (2 n,), how far over their bounds (5 n,), with rows (..., nv)."""
        steps = quat.from_rotation_vector(DIFFERENCE * np.concatenate([np.zeros((1, 3)), np.eye(3), -np.eye(3)]))
        angles = self._angles(quat.product(qpos[self.columns], steps[:, None]))
        by = np.zeros((*angles.shape[::2], nv))
        slopes = np.moveaxis((angles[:, 1:4] - angles[:, 4:]) / (2 * DIFFERENCE), 1, 2)
        np.put_along_axis(by, np.broadcast_to(self.dofs, slopes.shape), slopes, axis=2)
        flexion, sideways, twist = angles[:, 0]
        limits = self.limits
        over = [limits.least - flexion]
        for value, bound in ((sideways, limits.sideways), (twist, limits.twist)):
            over += [value - bound, -value - bound]
        crooked = STRAIGHT * np.concatenate([sideways, twist]), STRAIGHT * np.concatenate([by[1], by[2]])
        return crooked, (np.concatenate(over) + INSIDE, np.concatenate([-by[0], by[1], -by[1], by[2], -by[2]]))

    def _angles(self, q: Array) -> Array:
        return bent(self.figure, self.limits.joints, q)
