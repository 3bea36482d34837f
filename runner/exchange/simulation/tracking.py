"""How far `mj_step` of an exported scene deviates from the motion, with `ctrl` interpolated between the keys.

The first second is simulated from the first key. A scene that stays within 0.05 rad and 5 cm follows its motion.
Otherwise smaller time steps are tried. If none suffices, the note names the joint that deviates first.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import mujoco
import numpy as np
from scipy.interpolate import make_interp_spline

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import JointKind

from ...system.mujoco_warnings import quietly
from ..trajectory import SampledTrajectory
from .scene import TIMESTEPS, Simulation

DURATION = 1.0  # [s] simulated
ANGLE, DISTANCE = 0.05, 0.05  # [rad] and [m] largest deviations of a scene that follows its motion
DEEP = 0.01  # [m] least penetration in the motion that is reported as pushing the figure away
FINER = (5e-4, TIMESTEPS[0])  # [s] smaller time steps to try


@dataclass(frozen=True)
class Tracking:
    """Deviations of a simulated scene from its motion.

    time       (S,) [s] of the steps
    deviation  (S, nv) [m] of translations, [rad] of rotations
    is_length  (nv,) whether a degree of freedom is a translation
    fell       whether the simulation became unstable
    """

    time: Array
    deviation: Array
    is_length: Mask
    fell: bool

    @property
    def share(self) -> Array:
        """The deviations (S, nv), relative to the allowed ones."""
        return self.deviation / np.where(self.is_length, DISTANCE, ANGLE)

    @property
    def is_within(self) -> bool:
        """Whether the scene follows its motion."""
        return not self.fell and bool(np.all(self.share <= 1))

    @property
    def leaves(self) -> tuple[int, int]:
        """The first step beyond the allowed deviation, or the last, and the degree of freedom that deviates most."""
        beyond = np.flatnonzero((self.share > 1).any(axis=1))
        step = int(beyond[0]) if beyond.size else len(self.time) - 1
        return step, int(self.share[step].argmax())


def tracked(simulation: Simulation, trajectory: SampledTrajectory) -> Tracking:
    """Simulate a scene from its first key."""
    model, (first, end) = simulation.model, trajectory.time[[0, -1]].tolist()
    last = min(first + DURATION, end)
    aims, poses = (make_interp_spline(trajectory.time, rows, k=1) for rows in (simulation.control, trajectory.qpos))
    data = mujoco.MjData(model)
    data.time, data.qpos, data.qvel, data.ctrl = first, trajectory.qpos[0], trajectory.qvel[0], aims(first)
    is_length = np.zeros(model.nv, bool)
    for kind, dof in zip(model.jnt_type.tolist(), model.jnt_dofadr.tolist(), strict=True):
        is_length[dof : dof + (3 if kind == JointKind.FREE else int(kind == JointKind.SLIDE))] = True
    times, errors, fell = [first], [np.zeros(model.nv)], False
    with quietly():
        while data.time < last and not fell:
            before = data.time
            data.ctrl = aims(before)
            mujoco.mj_step(model, data)
            fell = data.time <= before or not np.isfinite(data.qpos).all()  # MuJoCo resets an unstable simulation
            if not fell:
                times.append(data.time)
                pose, error = poses(min(data.time, end)), np.zeros(model.nv)
                mujoco.mj_normalizeQuat(model, pose)
                mujoco.mj_differentiatePos(model, error, 1.0, pose, data.qpos)
                errors.append(np.abs(error))
    return Tracking(np.array(times), np.array(errors), is_length, fell)


def refined(simulation: Simulation, trajectory: SampledTrajectory) -> tuple[Simulation, Tracking]:
    """Return the scene with the largest tried time step for which it follows its motion, else unchanged.

    None is tried if a free joint, which has no actuator, deviates first.
    """
    first, model = tracked(simulation, trajectory), simulation.model
    if first.is_within or model.jnt_type[model.dof_jntid[first.leaves[1]]] == JointKind.FREE:
        return simulation, first
    for timestep in FINER:
        if timestep < simulation.model.opt.timestep:
            finer = simulation.with_timestep(timestep)
            tracking = tracked(finer, trajectory)
            if tracking.is_within:
                line = f"the scene to simulate has time steps of {timestep:g} s: larger ones leave the motion"
                return replace(finer, notes=(*finer.notes, line)), tracking
    return simulation, first


def note(tracking: Tracking, simulation: Simulation, trajectory: SampledTrajectory) -> str:
    """Return a note on how far the scene follows its motion."""
    is_length, lasts = tracking.is_length, tracking.time[-1] - tracking.time[0]
    size = f"{_rounded(tracking.deviation[:, ~is_length].max(initial=0))} rad"
    if is_length.any():
        size += f", {_rounded(100 * tracking.deviation[:, is_length].max())} cm"
    if tracking.is_within:
        return f"mj_step of the scene stays within {size} of the motion for {lasts:.2g} s"
    at, dof = tracking.leaves
    name = simulation.model.joint(int(simulation.model.dof_jntid[dof])).name
    off = f"{100 * DISTANCE:g} cm" if is_length[dof] else f"{ANGLE:g} rad"
    then = "MuJoCo stops the simulation" if tracking.fell else f"up to {size} after {lasts:.2g} s"
    when = tracking.time[at] - tracking.time[0]
    where = "".join(f"; {line}" for line in _deepest(simulation, trajectory))
    return f"mj_step of the scene leaves the motion: '{name}' by {off} after {when:.2f} s, {then}{where}"


def _rounded(value: float) -> str:
    return f"{value:.2g}" if value >= 1e-4 else f"{value:.0e}"


def _deepest(simulation: Simulation, trajectory: SampledTrajectory) -> list[str]:
    """Return the two geoms that penetrate deepest in the first second of the motion, if by more than `DEEP`."""
    model, data = simulation.model, mujoco.MjData(simulation.model)
    out, deepest = list[str](), DEEP
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
