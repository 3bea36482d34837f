"""Forces of a motion, and groups of further columns of a table, named after joints and bodies, with their units.

Torques and wrench are MuJoCo's `mj_inverse` of qpos, qvel and qacc without contacts. They include the model's springs,
dampers, friction loss, gravity compensation, fluid, tendons and constraints. The ground reactions are those of
`support`: forces within friction cones at the points in contact that supply as much of the root's wrench as possible.
Where neither a stance nor a flight determines them, they and the torques that depend on them are nan. Columns:

velocities  left_hip.wx [rad/s]: MuJoCo's qvel; free joints in world axes, their rotation and ball joints in body axes
torques     left_hip.tx [N m]: joint torques, qfrc_inverse minus the ground reactions, in body axes
wrench      root.fx [N], root.mx [N m], com.x [m]: qfrc_inverse at the free root, moment about the centre of mass
ground      left_foot.fx [N], left_foot.cop.x [m], left_foot.mx [N m]: ground reaction on each foot, its centre of
            pressure and moment about that; unsupplied.fx [N], unsupplied.mx [N m]: the remaining wrench

Forces and moments are in world axes unless stated otherwise. Unknown values are nan, and so is the
centre of pressure without contact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.figure.algebra import applied, cross
from dynsplines.solver.figure.dynamics import RootWrench, inverse_dynamics
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import set_qpos
from dynsplines.solver.penalty import Support
from dynsplines.solver.penalty.ground.support import Reactions

from ..clip import load as clip
from ..errors import UserError, unknown
from ..motion import Sampled, samples_at

Columns = dict[str, Array]
ALL = "all"
AXES = "xyz"
PASSIVE = 1e4  # [1] weight of joints without a motor, whose torques the constraints have to supply
LARGE = 0.01  # fraction of the largest torque above which constraint forces are reported
EQUALITIES_AND_LIMITS = int(mujoco.mjtDisableBit.mjDSBL_EQUALITY | mujoco.mjtDisableBit.mjDSBL_LIMIT)
CONSTRAINT_NOTE = (
    "torques include forces of joint limits and equality constraints: up to {size:.3g} {unit} at {joint}, {time:.2f} s"
)
UNKNOWN_NOTE = "the support of the figure is unknown in {share:.0%} of the instants: forces there are nan"


@dataclass(frozen=True)
class Foot:
    """The ground reaction on a body, in world axes.

    force   (3, T) [N], zero without contact
    centre  (3, T) [m] of pressure: mean of the points in contact, weighted by normal force; nan without contact
    moment  (3, T) [N m] about the centre, about the normal alone on level ground; nan without contact
    """

    name: str
    force: Array
    centre: Array
    moment: Array


@dataclass(frozen=True)
class Forces:
    """The forces of a sampled.

    samples  the same times of the motion; support  None for a figure without a free root
    model    the motion's model, or one with the same joints whose forces are evaluated
    """

    sampled: Sampled
    samples: Samples
    support: Support | None
    model: mujoco.MjModel

    @classmethod
    def of(cls, sampled: Sampled, model: mujoco.MjModel | None = None) -> Forces:
        """Return the forces of a motion in its model, or in another one with the same joints."""
        support = clip.clip_from_motion(sampled.motion).context.support
        samples = samples_at(sampled.figure, sampled.motion.path, sampled.time)
        stiff = None if support is None else support.stiff
        return cls(sampled, samples, stiff, sampled.model if model is None else model)

    @cached_property
    def has_known_support(self) -> Mask:
        """(T,) whether the forces that carry the figure are known; always, for a figure without stances and flights."""
        if self.support is None or not self.support.has_intervals:
            return np.ones(self.samples.count, bool)
        return self.support.known(self.samples.t)

    @cached_property
    def inverse(self) -> Array:
        """(T, nv) MuJoCo's qfrc_inverse without contacts: the joint forces as if the ground exerted none."""
        return inverse_dynamics(self.model, self.sampled.qpos, self.sampled.qvel, self.sampled.qacc)

    @cached_property
    def wrench(self) -> RootWrench | None:
        """Force and moment at the free root, and the centre of mass; all forces of the model are included."""
        if self.support is None:
            return None
        out, root = RootWrench(self.samples, self.support.root), self.support.root
        dof = self.sampled.figure.links[root].dof
        links = self.samples.links
        out.force = np.ascontiguousarray(self.inverse[:, dof : dof + 3].T)
        moment = applied(links.rotation[:, :, [root]], self.inverse[:, dof + 3 : dof + 6].T[:, None])[:, 0]
        out.moment = moment - cross(out.centre - links.anchor[:, root], out.force)
        return out

    @cached_property
    def _reactions(self) -> Reactions | None:
        return None if self.support is None else self.support.reactions(self.samples, self.wrench)

    @cached_property
    def rest(self) -> Array:
        """(6, T) [N, N m] force and moment at the root that the ground does not supply; nan where unknown."""
        support = self.support
        if support is None:
            return np.zeros((6, self.samples.count))
        units = np.repeat([support.unit, support.unit * support.length], 3)[:, None]
        return np.where(self.has_known_support, support.rest(self.samples, self.wrench) * units, np.nan)

    @cached_property
    def feet(self) -> tuple[Foot, ...]:
        """The ground reactions of all bodies with a stance."""
        if self.support is None or self._reactions is None:
            return ()
        links = self._links
        return tuple(self._foot(int(link)) for link in np.unique(links))

    @property
    def _links(self) -> Index:
        assert self.support is not None
        return np.array([footing.point.link for footing in self.support.footings], np.intp)

    def _foot(self, link: int) -> Foot:
        assert self.support is not None and self._reactions is not None
        reactions, count, figure = self._reactions, self.samples.count, self.sampled.figure
        indices = np.flatnonzero(self._links[reactions.footing] == link)
        at, place, force = reactions.at[indices], reactions.place[:, indices], reactions.force[:, indices]
        normals = np.array([self.support.footings[i].normal for i in reactions.footing[indices]]).reshape(-1, 3).T
        press = np.maximum(np.sum(normals * force, axis=0), 0)
        total = np.bincount(at, press, count)
        whole = np.array([np.bincount(at, part, count) for part in force])
        with np.errstate(invalid="ignore", divide="ignore"):
            centre = np.array([np.bincount(at, press * part, count) for part in place]) / total
        away = place - centre[:, at]
        moment = np.array([np.bincount(at, part, count) for part in cross(away, force)])
        loaded = total > 0
        name = figure.body_name(link)
        return Foot(
            name,
            np.where(self.has_known_support, whole, np.nan),
            np.where(self.has_known_support & loaded, centre, np.nan),
            np.where(self.has_known_support & loaded, moment, np.nan),
        )

    @cached_property
    def torques(self) -> Array:
        """(T, nv) MuJoCo's qfrc_inverse minus the ground reactions, from the motors; at a free root, the remaining
        wrench."""
        return motor_torques(self.sampled.model, self.sampled.qpos, self._joint_torques)

    @property
    def _joint_torques(self) -> Array:
        """(T, nv) the same, as if every joint had a motor."""
        out = self.inverse.copy()
        reactions, model = self._reactions, self.sampled.model
        if self.support is None or reactions is None:
            return out
        data, jacobian = mujoco.MjData(model), np.zeros((3, model.nv))
        bodies = [self.sampled.figure.links[link].body for link in self._links]
        order = np.argsort(reactions.at, kind="stable")
        posed = -1
        for i in order:
            t = int(reactions.at[i])
            if t != posed:
                set_qpos(model, data, self.sampled.qpos[t])
                posed = t
            mujoco.mj_jac(model, data, jacobian, None, reactions.place[:, i], bodies[reactions.footing[i]])
            out[t] -= reactions.force[:, i] @ jacobian
        return np.where(self.has_known_support[:, None], out, np.nan)


def motor_torques(model: mujoco.MjModel, qpos: Array, torques: Array) -> Array:
    """Return the torques (T, nv) of joints with motors, which also move those without one through equality constraints.

    Args:
        qpos: The poses, (T, nq).
        torques: The torques t that the motion needs at every joint, (T, nv). They are B u + Jᵀ λ with the motors'
            torques u and the forces λ of the constraints. Of several λ, the one with the smallest motor torques is
            returned. If no constraint moves a joint, or an actuator is not on a joint, they are returned unchanged.
    """
    is_on_joint = model.actuator_trntype == int(mujoco.mjtTrn.mjTRN_JOINT)
    if not model.neq or not model.nu or not is_on_joint.all():
        return torques
    driven = np.isin(model.dof_jntid, model.actuator_trnid[:, 0])
    is_free = model.jnt_type[model.dof_jntid] == int(mujoco.mjtJoint.mjJNT_FREE)
    data, out = mujoco.MjData(model), torques.copy()
    for t in np.flatnonzero(np.isfinite(torques).all(axis=1)):
        set_qpos(model, data, qpos[t])
        mujoco.mj_makeConstraint(model, data)
        rows = _equality_rows(model, data)
        passive = ~driven & ~is_free & (rows != 0).any(axis=0)
        if passive.any():
            weight = np.where(passive, PASSIVE, 1.0) * ~is_free
            multipliers = np.linalg.lstsq((weight * rows).T, weight * torques[t], rcond=None)[0]
            out[t] -= np.where(is_free, 0.0, multipliers @ rows)
    return out


def _equality_rows(model: mujoco.MjModel, data: mujoco.MjData) -> Array:
    """Return the Jacobian (n, nv) of the active equality constraints."""
    jacobian = np.zeros((data.nefc, model.nv))
    if mujoco.mj_isSparse(model):
        mujoco.mju_sparse2dense(jacobian, data.efc_J, data.efc_J_rownnz, data.efc_J_rowadr, data.efc_J_colind)
    else:
        jacobian[:] = data.efc_J.reshape(data.nefc, model.nv)
    return jacobian[data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)]


def velocities(forces: Forces) -> Columns:
    """Return MuJoCo's qvel."""
    units = ("m/s", "rad/s")
    sampled, letters = forces.sampled, {"free": "v w", "ball": "w", "hinge": "v", "slide": "v"}
    return _by_dof(sampled.model, sampled.qvel, letters, units)


def torques(forces: Forces) -> Columns:
    """Return the torques of all joints except free ones."""
    units = ("N", "N m")
    return _by_dof(forces.sampled.model, forces.torques, {"ball": "t", "hinge": "t", "slide": "f"}, units)


class Unavailable(Exception):
    """A group that a motion has no values for: the reason, and what to do."""


def wrench(forces: Forces) -> Columns:
    """Return the external wrench at the free root; raises Unavailable without a free root."""
    root_wrench, figure = forces.wrench, forces.sampled.figure
    if root_wrench is None or figure.root is None:
        raise Unavailable("the figure has no free root, so no wrench moves it from outside", "omit `wrench`")
    name = figure.links[root_wrench.root].name
    return (
        _vector(f"{name}.f", "N", root_wrench.force)
        | _vector(f"{name}.m", "N m", root_wrench.moment)
        | _vector("com.", "m", root_wrench.centre)
    )


def ground(forces: Forces) -> Columns:
    """Return the ground reactions of every foot with a stance; raises Unavailable if there is none."""
    if not forces.feet:
        raise Unavailable(
            "no stance is known, so the ground reaction force is unknown", "add a [[contact]], or omit `ground`"
        )
    out: Columns = {}
    for foot in forces.feet:
        out |= _vector(f"{foot.name}.f", "N", foot.force)
        out |= _vector(f"{foot.name}.cop.", "m", foot.centre)
        out |= _vector(f"{foot.name}.m", "N m", foot.moment)
    return out | _vector("unsupplied.f", "N", forces.rest[:3]) | _vector("unsupplied.m", "N m", forces.rest[3:])


GROUPS: dict[str, Callable[[Forces], Columns]] = {
    "velocities": velocities,
    "torques": torques,
    "wrench": wrench,
    "ground": ground,
}


def named(text: str) -> tuple[str, ...]:
    """Return the groups in a comma-separated list, or "all" alone; raises UserError with the list of groups."""
    words = tuple(word.strip() for word in text.split(",") if word.strip())
    for word in words:
        if word != ALL and word not in GROUPS:
            raise UserError(unknown("column group", word, (*GROUPS, ALL)))
    return (ALL,) if ALL in words else tuple(dict.fromkeys(words))


def table(sampled: Sampled, groups: Sequence[str]) -> tuple[Columns, list[str]]:
    """Return the columns (T,) of groups, by heading, and notes on unknown forces.

    A note lists the groups of "all" that the motion has no values for.

    Raises:
        UserError: The motion has no values for another group.
    """
    if not groups:
        return {}, []
    wanted = [group for group in GROUPS if ALL in groups or group in groups]
    forces = Forces.of(sampled)
    out: Columns = {}
    notes = list[str]()
    for group in wanted:
        try:
            out |= GROUPS[group](forces)
        except Unavailable as missing:
            reason, remedy = missing.args
            if ALL not in groups:
                raise UserError(f"{sampled.name}: {reason}; {remedy}") from None
            notes.append(f"no columns `{group}`: {reason}")
    if {"torques", "ground"} & set(wanted) and not forces.has_known_support.all():
        notes.append(UNKNOWN_NOTE.format(share=1 - float(forces.has_known_support.mean())))
    if "torques" in wanted:
        notes.extend(constraint_notes(forces))
    return out, notes


def constraint_notes(forces: Forces) -> list[str]:
    """Return a note on forces of joint limits and equality constraints, if they are a large part of the torques."""
    sampled, model = forces.sampled, forces.sampled.model
    if not (model.neq or model.jnt_limited.any() or model.tendon_limited.any()):
        return []
    free = inverse_dynamics(model, sampled.qpos, sampled.qvel, sampled.qacc, disabled=EQUALITIES_AND_LIMITS)
    size = np.abs(forces.inverse - free)
    at, dof = np.unravel_index(int(size.argmax()), size.shape)
    if size[at, dof] <= LARGE * np.abs(forces.inverse).max():
        return []
    joint = int(model.dof_jntid[dof])
    first = dof - model.jnt_dofadr[joint]
    is_force = model.jnt_type[joint] == JointKind.SLIDE
    is_force |= model.jnt_type[joint] == JointKind.FREE and first < 3
    return [
        CONSTRAINT_NOTE.format(
            size=size[at, dof],
            unit="N" if is_force else "N m",
            joint=model.joint(joint).name or f"joint{joint}",
            time=sampled.time[at],
        )
    ]


def _vector(name: str, unit: str, values: Array) -> Columns:
    """Return three columns for an array (3, T)."""
    return {f"{name}{axis} [{unit}]": row for axis, row in zip(AXES, values, strict=True)}


def _by_dof(model: mujoco.MjModel, values: Array, letters: dict[str, str], units: tuple[str, str]) -> Columns:
    """Return columns for (T, nv); `letters` by kind of joint, `units` of translations and rotations."""
    kinds, out = ("free", "ball", "slide", "hinge"), {}
    for joint in range(model.njnt):
        kind, dof = kinds[int(model.jnt_type[joint])], int(model.jnt_dofadr[joint])
        name = model.joint(joint).name or f"joint{joint}"
        if kind not in letters:
            continue
        if kind in ("slide", "hinge"):
            out[f"{name}.{letters[kind]} [{units[kind == 'hinge']}]"] = values[:, dof]
            continue
        for part, letter in enumerate(letters[kind].split()):
            unit = units[0] if kind == "free" and part == 0 else units[1]
            out |= _vector(f"{name}.{letter}", unit, np.asarray(values[:, dof + 3 * part : dof + 3 * part + 3]).T)
    return out
