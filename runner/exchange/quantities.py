"""Groups of further columns of a table, named after joints and bodies, with their units.

angles      left_hip.rx [deg]: rotation vectors of ball joints and free roots; angles of hinges as knee.r [deg]
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

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.dynamics import inverse_dynamics
from dynsplines.solver.figure.figure import JointKind

from ..errors import UserError, list_names, unknown
from ..measure.forces import Forces
from ..motion import Sampled
from .robot import joint_name

Columns = dict[str, Array]
ALL = "all"
AXES = "xyz"
LARGE = 0.01  # fraction of the largest torque above which constraint forces are reported
EQUALITIES_AND_LIMITS = int(mujoco.mjtDisableBit.mjDSBL_EQUALITY | mujoco.mjtDisableBit.mjDSBL_LIMIT)
CONSTRAINT_NOTE = (
    "torques include forces of joint limits and equality constraints: up to {size:.3g} {unit} at {joint}, {time:.2f} s"
)


def angles(forces: Forces) -> Columns:
    """Return rotation vectors, at most half a turn long, of ball joints and free roots, and angles of hinges."""
    model, qpos, out = forces.sampled.model, forces.sampled.qpos, {}
    for joint in range(model.njnt):
        kind, first = JointKind(model.jnt_type[joint]), int(model.jnt_qposadr[joint])
        name = joint_name(model, joint)
        if kind is JointKind.HINGE:
            out[f"{name}.r [deg]"] = np.degrees(qpos[:, first])
        elif kind is not JointKind.SLIDE:
            last = first + kind.width
            out |= _vector(f"{name}.r", "deg", np.degrees(quat.rotation_vector(qpos[:, last - 4 : last])))
    return out


def velocities(forces: Forces) -> Columns:
    """Return MuJoCo's qvel."""
    units = ("m/s", "rad/s")
    sampled, letters = forces.sampled, {"free": "v w", "ball": "w", "hinge": "v", "slide": "v"}
    return _by_dof(sampled.model, sampled.qvel, letters, units)


def torques(forces: Forces) -> Columns:
    """Return the torques of all joints except free ones."""
    units = ("N", "N m")
    return _by_dof(forces.sampled.model, forces.torques, {"ball": "t", "hinge": "t", "slide": "f"}, units)


def wrench(forces: Forces) -> Columns:
    """Return the external wrench at the free root; raises UserError without a free root."""
    root_wrench, figure = forces.wrench, forces.sampled.figure
    if root_wrench is None or figure.root is None:
        raise UserError("the figure has no free root, so no wrench moves it from outside")
    name = figure.links[root_wrench.root].name
    return (
        _vector(f"{name}.f", "N", root_wrench.force.T)
        | _vector(f"{name}.m", "N m", root_wrench.moment.T)
        | _vector("com.", "m", root_wrench.centre.T)
    )


def ground(forces: Forces) -> Columns:
    """Return the ground reactions of every foot that stands; raises UserError if there is none."""
    if not forces.feet:
        raise UserError("no stance is known, so the ground reaction force is unknown; add a [[contact]]")
    out: Columns = {}
    for foot in forces.feet:
        out |= _vector(f"{foot.name}.f", "N", foot.force)
        out |= _vector(f"{foot.name}.cop.", "m", foot.centre)
        out |= _vector(f"{foot.name}.m", "N m", foot.moment)
    return out | _vector("unsupplied.f", "N", forces.rest[:, :3]) | _vector("unsupplied.m", "N m", forces.rest[:, 3:])


GROUPS: dict[str, Callable[[Forces], Columns]] = {
    "angles": angles,
    "velocities": velocities,
    "torques": torques,
    "wrench": wrench,
    "ground": ground,
}


def groups_of(text: str) -> tuple[str, ...]:
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
        except UserError as missing:
            if ALL not in groups:
                raise UserError(f"{sampled.name}: {missing}") from None
            notes.append(f"no columns `{group}`: {missing}")
    if {"torques", "ground"} & set(wanted) and not forces.has_known_support.all():
        notes.append(_unknown_note(forces))
    if "torques" in wanted:
        notes.extend(constraint_notes(forces))
    return out, notes


def _unknown_note(forces: Forces) -> str:
    """Return the note on instants at which the support of the figure is unknown."""
    unknown_at = ~forces.has_known_support
    first = int(unknown_at.argmax())
    bodies = list_names(f"'{body}'" for body, touches in forces.touches_elsewhere.items() if touches[first])
    touches = "" if not bodies else f", where {bodies} touch something without a [[contact]]"
    return (
        f"the support of the figure is unknown in {unknown_at.mean():.0%} of the instants, first at "
        f"{forces.samples.t[first]:.2f} s{touches}: forces there are nan"
    )


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
            joint=joint_name(model, joint),
            time=sampled.time[at],
        )
    ]


def _vector(name: str, unit: str, values: Array) -> Columns:
    """Return three columns for an array (T, 3)."""
    return {f"{name}{axis} [{unit}]": row for axis, row in zip(AXES, values.T, strict=True)}


def _by_dof(model: mujoco.MjModel, values: Array, letters: dict[str, str], units: tuple[str, str]) -> Columns:
    """Return columns for (T, nv); `letters` by kind of joint, `units` of translations and rotations."""
    kinds, out = ("free", "ball", "slide", "hinge"), {}
    for joint in range(model.njnt):
        kind, dof = kinds[int(model.jnt_type[joint])], int(model.jnt_dofadr[joint])
        name = joint_name(model, joint)
        if kind not in letters:
            continue
        if kind in ("slide", "hinge"):
            out[f"{name}.{letters[kind]} [{units[kind == 'hinge']}]"] = values[:, dof]
            continue
        for part, letter in enumerate(letters[kind].split()):
            unit = units[0] if kind == "free" and part == 0 else units[1]
            out |= _vector(f"{name}.{letter}", unit, values[:, dof + 3 * part : dof + 3 * part + 3])
    return out
