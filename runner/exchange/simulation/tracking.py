"""How far `mj_step` of an exported scene deviates from the motion, with `ctrl` interpolated between the keys.

The first second is simulated from the first key. A scene that stays within 0.05 rad and 5 cm follows its motion.
Otherwise smaller time steps are tried. If none suffices, the note names the joint that deviates first, and likely
causes.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.surface.touch import movers, solids

from ...clip import load as clip
from ...scene.compose import quietly
from ..forces import Forces
from ..trajectory import SampledTrajectory
from .scene import FREE, SLIDE, TIMESTEPS, Simulation

DURATION = 1.0  # [s] simulated
ANGLE, DISTANCE = 0.05, 0.05  # [rad] and [m] largest deviations of a scene that follows its motion
DEEP = 0.01  # [m] least penetration in the motion that is reported as pushing the figure away
APART = 0.01  # [m] or [rad] least violation of equality constraints that is reported
GAP, FAR = 0.01, 10.0  # [m] least initial height above the ground that is reported, and largest that is measured
FINER = (5e-4, TIMESTEPS[0])  # [s] smaller time steps to try
EXCEEDED = 0.01  # [m] or [rad] least excess of a joint's range that is reported
UNSUPPLIED = 0.05  # fraction of the weight from which a force at the root without supplying contact is reported

Control = Callable[[mujoco.MjData], Array]


@dataclass(frozen=True)
class Tracking:
    """Deviations of a simulated scene from its motion.

    time    (S,) [s] of the steps
    angle   (S, nv) [rad] of the joints, nan for translations
    length  (S, nv) [m] of the joints, nan for rotations
    fell    whether the simulation became unstable
    """

    time: Array
    angle: Array
    length: Array
    fell: bool

    @property
    def is_within(self) -> bool:
        """Whether the scene follows its motion."""
        return not self.fell and self.worst <= 1

    @property
    def worst(self) -> float:
        """The largest deviation, relative to the allowed one."""
        return float(max(np.nanmax(self.angle, initial=0) / ANGLE, np.nanmax(self.length, initial=0) / DISTANCE))

    @property
    def leaves(self) -> tuple[int, int]:
        """The first step beyond the allowed deviation, or the last, and the degree of freedom that deviates most."""
        share = np.fmax(self.angle / ANGLE, self.length / DISTANCE)
        beyond = np.flatnonzero((share > 1).any(axis=1))
        step = int(beyond[0]) if beyond.size else len(share) - 1
        return step, int(np.nanargmax(share[step]))


def tracked(
    simulation: Simulation, trajectory: SampledTrajectory, control: Array | None = None, duration: float = DURATION
) -> Tracking:
    """Simulate a scene from its first key; control: (T, nu) `ctrl` at the keys, by default the simulation's."""
    model, aims = simulation.model, simulation.control if control is None else control
    first = float(trajectory.time[0])
    last = min(first + duration, float(trajectory.time[-1]))
    data = started(model, trajectory, aims)
    is_length = np.zeros(model.nv, bool)
    for kind, dof in zip(model.jnt_type.tolist(), model.jnt_dofadr.tolist(), strict=True):
        is_length[dof : dof + (3 if kind == FREE else int(kind == SLIDE))] = True
    times, errors, fell = [first], [np.zeros(model.nv)], False
    with quietly():
        while data.time < last and not fell:
            before = data.time
            data.ctrl = between(trajectory.time, aims, before)
            mujoco.mj_step(model, data)
            fell = data.time <= before or not np.isfinite(data.qpos).all()  # MuJoCo resets an unstable simulation
            if not fell:
                times.append(data.time)
                errors.append(np.abs(difference(model, trajectory, data)))
    deviations = np.array(errors)
    return Tracking(
        np.array(times), np.where(is_length, np.nan, deviations), np.where(is_length, deviations, np.nan), fell=fell
    )


def refined(simulation: Simulation, trajectory: SampledTrajectory) -> tuple[Simulation, Tracking]:
    """Return the scene with the largest tried time step for which it follows its motion, else unchanged.

    None is tried if a free joint, which has no actuator, deviates first, or if geoms penetrate in the motion.
    """
    first, model = tracked(simulation, trajectory), simulation.model
    if first.is_within or model.jnt_type[model.dof_jntid[first.leaves[1]]] == FREE or _depths(simulation, trajectory):
        return simulation, first
    for timestep in FINER:
        if timestep < simulation.model.opt.timestep:
            finer = simulation.with_timestep(timestep)
            tracking = tracked(finer, trajectory)
            if tracking.is_within:
                line = f"the scene to simulate has time steps of {timestep:g} s: larger ones leave the motion"
                return replace(finer, notes=(*finer.notes, line)), tracking
    return simulation, first


def started(model: mujoco.MjModel, trajectory: SampledTrajectory, aims: Array) -> mujoco.MjData:
    """Return the state at the first key."""
    data = mujoco.MjData(model)
    data.time, data.qpos, data.qvel, data.ctrl = trajectory.time[0], trajectory.qpos[0], trajectory.qvel[0], aims[0]
    return data


def between(times: Array, rows: Array, time: float) -> Array:
    """Interpolate rows linearly to a time."""
    after = int(np.clip(np.searchsorted(times, time, side="right"), 1, len(times) - 1))
    share = np.clip((time - times[after - 1]) / (times[after] - times[after - 1]), 0, 1)
    return (1 - share) * rows[after - 1] + share * rows[after]


def difference(model: mujoco.MjModel, trajectory: SampledTrajectory, data: mujoco.MjData) -> Array:
    """Return the deviation (nv,) of a state from the motion: [m] of translations, [rad] of rotations."""
    wanted, out = between(trajectory.time, trajectory.qpos, data.time), np.zeros(model.nv)
    mujoco.mj_normalizeQuat(model, wanted)
    mujoco.mj_differentiatePos(model, out, 1.0, wanted, data.qpos)
    return out


def note(tracking: Tracking, simulation: Simulation, trajectory: SampledTrajectory) -> str:
    """Return a note on how far the scene follows its motion, and on the reasons if it does not."""
    angle, length = np.nanmax(tracking.angle, initial=0), np.nanmax(tracking.length, initial=0)
    lasts = tracking.time[-1] - tracking.time[0]
    size = f"{_rounded(angle)} rad"
    if np.isfinite(tracking.length).any():
        size += f", {_rounded(100 * length)} cm"
    if tracking.is_within:
        return f"mj_step of the scene stays within {size} of the motion for {lasts:.2g} s"
    at, dof = tracking.leaves
    name = simulation.model.joint(int(simulation.model.dof_jntid[dof])).name
    off = f"{100 * DISTANCE:g} cm" if np.isfinite(tracking.length[at, dof]) else f"{ANGLE:g} rad"
    then = "MuJoCo stops the simulation" if tracking.fell else f"up to {size} after {lasts:.2g} s"
    when = tracking.time[at] - tracking.time[0]
    reason = "; ".join(_reasons(tracking, simulation, trajectory))
    return f"mj_step of the scene leaves the motion: '{name}' by {off} after {when:.2f} s, {then}; {reason}"


def _rounded(value: float) -> str:
    return f"{value:.2g}" if value >= 1e-4 else f"{value:.0e}"


def _depths(simulation: Simulation, trajectory: SampledTrajectory, deepest: float = DEEP) -> list[str]:
    """Return the two geoms that penetrate deepest in the first second of the motion, if by more than `deepest` [m]."""
    model, data = simulation.model, mujoco.MjData(simulation.model)
    out = list[str]()
    for time, qpos in zip(
        trajectory.time[trajectory.time <= trajectory.time[0] + DURATION], trajectory.qpos, strict=False
    ):
        data.qpos = qpos
        mujoco.mj_fwdPosition(model, data)
        contact = min(data.contact, key=lambda each: each.dist, default=None)
        if contact is not None and -contact.dist > deepest:
            deepest = -contact.dist
            names = [model.geom(geom).name or model.body(int(model.geom_bodyid[geom])).name for geom in contact.geom]
            out = [f"the motion has '{names[0]}' and '{names[1]}' {100 * deepest:.2g} cm in each other at {time:.2f} s"]
    return out


def _aloft(simulation: Simulation, trajectory: SampledTrajectory) -> list[str]:
    """Return the initial height of a figure with a free root above the ground."""
    model, data = simulation.model, mujoco.MjData(simulation.model)
    root, still = trajectory.figure.root, solids(trajectory.model)
    if root is None or not root.is_free or not still:
        return []
    data.qpos = trajectory.qpos[0]
    mujoco.mj_kinematics(model, data)
    figure_geoms = [
        geom for geom in movers(trajectory.model) if model.body_rootid[model.geom_bodyid[geom]] == root.body
    ]
    gap = min(
        (mujoco.mj_geomDistance(model, data, geom, solid, FAR, None) for geom in figure_geoms for solid in still),
        default=0.0,
    )
    return [f"it begins {100 * gap:.2g} cm above the ground"] if GAP < gap < FAR else []


def _reasons(tracking: Tracking, simulation: Simulation, trajectory: SampledTrajectory) -> list[str]:
    """Return reasons in the motion that actuators cannot compensate, else those that tests reveal."""
    model, out = simulation.model, _depths(simulation, trajectory) or _aloft(simulation, trajectory)
    data = started(model, trajectory, simulation.control)
    with quietly():
        mujoco.mj_forward(model, data)
    equality = np.abs(data.efc_pos[: data.ne])
    if equality.size and equality.max() > APART:
        out.append(f"equality constraints are violated by {equality.max():.2g} at the first key")
    forces = Forces.of(trajectory, model)
    early = trajectory.time <= trajectory.time[0] + DURATION
    unknown = float(np.mean(~forces.has_known_support[early]))
    if unknown > 0:
        out.append(f"at {unknown:.0%} of the instants no contact is known that carries the figure")
    if forces.support is not None and forces.has_known_support[early].any():
        deficit = np.linalg.norm(forces.rest[:3, early & forces.has_known_support], axis=0).max() / forces.support.unit
        if deficit > UNSUPPLIED:
            out.append(
                f"the motion needs a force at the root that no contact supplies, up to {deficit:.0%} of its weight"
            )
    if clip.clip_from_motion(trajectory.saved).context.schedule.grasped:
        out.append("nothing holds what the figure carries")
    if np.any(model.jnt_type == FREE):
        out.append("nothing balances it")
    out += _exceeded(model, trajectory)
    return out or _tested(tracking, simulation, trajectory)


def _exceeded(model: mujoco.MjModel, trajectory: SampledTrajectory) -> list[str]:
    """Return the hinge or slide that exceeds its range most, if joint limits exert forces."""
    if model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_LIMIT):
        return []
    scalar = np.flatnonzero(model.jnt_limited.astype(bool) & (model.jnt_type >= SLIDE))
    if not scalar.size:
        return []
    qpos, (low, high) = trajectory.qpos[:, model.jnt_qposadr[scalar]], model.jnt_range[scalar].T
    beyond = np.maximum(low - qpos, qpos - high).max(axis=0)
    most = int(beyond.argmax())
    name, kind = model.joint(int(scalar[most])).name, int(model.jnt_type[scalar[most]])
    size = f"{100 * beyond[most]:.2g} cm" if kind == SLIDE else f"{beyond[most]:.2g} rad"
    return [f"the motion has '{name}' {size} beyond its range"] if beyond[most] > EXCEEDED else []


def _tested(before: Tracking, simulation: Simulation, trajectory: SampledTrajectory) -> list[str]:
    """Return the changes with which the scene follows its motion: no contacts, or smaller time steps."""
    model = copy.copy(simulation.model)
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    if tracked(replace(simulation, model=model), trajectory).is_within:
        return _depths(simulation, trajectory, 0.0) or ["contacts push it away"]
    finest = tracked(simulation.with_timestep(FINER[-1]), trajectory)
    if finest.worst < before.worst / 2:
        return [f"its time step is too large; {FINER[-1]:g} s reduces the error to {finest.worst / before.worst:.0%}"]
    return ["its actuators do not hold it"]
