"""MJCF of a scene for `mj_step`: contacts, actuators, and a <key> with their targets for every sample.

The motion is simulated from the first key, with `ctrl` interpolated between the keys. A scene that stays within 0.05
rad and 5 cm follows its motion. Otherwise the note names the joint that deviates first. The simulation ends when the
figure is 10 cm from its motion.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np
from scipy.interpolate import make_interp_spline

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import JointKind

from ...motion import Sampled
from ...system.mujoco_warnings import quietly
from ..simulation import Simulation
from .mjcf_keys import write_keys

FOLLOWS = 0.05  # [rad, m] largest deviation of a scene that follows its motion
LOST = 2.0  # [1] deviation at which the figure is lost, relative to the largest of a scene that follows


def write(sampled: Sampled, path: Path) -> list[str]:
    """Write the scene; return notes on what it changes and how far it follows the motion."""
    simulation = Simulation.of(sampled)
    write_keys(simulation.root, sampled, path, simulation.control)
    notes = [
        f"the `ctrl` of each key contains the targets of {simulation.model.nu} position actuators",
        *simulation.notes,
    ]
    return [*notes, note(simulate(simulation, sampled), simulation.model)] if len(sampled.time) > 1 else notes


@dataclass(frozen=True)
class Tracking:
    """Deviations of a simulated scene from its motion.

    time       (S,) [s] of the steps
    deviation  (S, nv) [m] of translations, [rad] of rotations
    is_length  (nv,) whether a degree of freedom is a translation
    is_unstable  whether MuJoCo stopped the simulation
    """

    time: Array
    deviation: Array
    is_length: Mask
    is_unstable: bool

    @property
    def share(self) -> Array:
        """The deviations (S, nv), relative to the allowed ones."""
        return self.deviation / FOLLOWS

    @property
    def is_within(self) -> bool:
        """Whether the scene follows its motion."""
        return not self.is_unstable and bool(np.all(self.share <= 1))

    @property
    def is_lost(self) -> bool:
        """Whether the figure ends far from its motion, as after a fall."""
        return bool((self.share[-1, self.is_length] >= LOST).any())

    @property
    def leaves(self) -> tuple[int, int]:
        """The first step beyond the allowed deviation, or the last, and the degree of freedom that deviates most."""
        beyond = np.flatnonzero((self.share > 1).any(axis=1))
        step = int(beyond[0]) if beyond.size else len(self.time) - 1
        return step, int(self.share[step].argmax())


def simulate(simulation: Simulation, sampled: Sampled) -> Tracking:
    """Simulate a scene from its first key."""
    model, (first, end) = simulation.model, sampled.time[[0, -1]].tolist()
    aims, poses = (make_interp_spline(sampled.time, rows, k=1) for rows in (simulation.control, sampled.qpos))
    data = mujoco.MjData(model)
    data.time, data.qpos, data.qvel, data.ctrl = first, sampled.qpos[0], sampled.qvel[0], aims(first)
    is_length = np.zeros(model.nv, bool)
    for kind, dof in zip(model.jnt_type.tolist(), model.jnt_dofadr.tolist(), strict=True):
        is_length[dof : dof + (3 if kind == JointKind.FREE else int(kind == JointKind.SLIDE))] = True
    times, errors, is_unstable = [first], [np.zeros(model.nv)], False
    with quietly():
        while data.time < end and not is_unstable and errors[-1][is_length].max(initial=0) < LOST * FOLLOWS:
            before = data.time
            data.ctrl = aims(before)
            mujoco.mj_step(model, data)
            is_unstable = data.time <= before or not np.isfinite(data.qpos).all()  # MuJoCo resets a simulation
            if not is_unstable:
                times.append(data.time)
                pose, error = poses(min(data.time, end)), np.zeros(model.nv)
                mujoco.mj_normalizeQuat(model, pose)
                mujoco.mj_differentiatePos(model, error, 1.0, pose, data.qpos)
                errors.append(np.abs(error))
    return Tracking(np.array(times), np.array(errors), is_length, is_unstable)


def note(tracking: Tracking, model: mujoco.MjModel) -> str:
    """Return a note on how far the scene, `model`, follows its motion."""
    is_length, lasts = tracking.is_length, tracking.time[-1] - tracking.time[0]
    size = f"{_round(tracking.deviation[:, ~is_length].max(initial=0))} rad"
    if is_length.any():
        size += f", {_round(100 * tracking.deviation[:, is_length].max())} cm"
    if tracking.is_within:
        return f"mj_step of the scene stays within {size} of the motion for {lasts:.2g} s"
    at, dof = tracking.leaves
    name = model.joint(int(model.dof_jntid[dof])).name
    off = f"{100 * FOLLOWS:g} cm" if is_length[dof] else f"{FOLLOWS:g} rad"
    when, then = tracking.time[at] - tracking.time[0], f"up to {size} after {lasts:.2g} s"
    if tracking.is_unstable:
        then = "MuJoCo stops the simulation"
    elif tracking.is_lost:
        then = f"it falls or drifts, {100 * LOST * FOLLOWS:g} cm off after {lasts:.2f} s"
    return f"mj_step of the scene leaves the motion: '{name}' by {off} after {when:.2f} s, {then}"


def _round(value: float) -> str:
    return f"{value:.2g}" if value >= 1e-4 else f"{value:.0e}"
