"""Data that formats exchange: a motion at equal time steps in MuJoCo's layout, and the content of a recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure

from ..motion import Saved, sampled
from ..scene.assets import Scene
from ..system.quantity import positive


@dataclass(frozen=True)
class SampledTrajectory:
    """A motion at equal time steps, to be written to a file, in MuJoCo's order and units.

    Attributes:
        saved: The source motion, with its keyframes, frames and scene.
        fps: Samples per second [1/s].
        time: Times (T,) [s].
        qpos: Configurations (T, nq); quaternions are wxyz, unit and sign-continuous.
        qvel: Velocities (T, nv).
        qacc: Accelerations (T, nv).
        notes: Lines for the user, which the writer extends.
        columns: Groups of further columns of a table.
    """

    saved: Saved
    fps: float
    time: Array
    qpos: Array
    qvel: Array
    qacc: Array
    notes: list[str] = field(default_factory=list)
    columns: Sequence[str] = ()

    @classmethod
    def of(cls, saved: Saved, fps: float | None = None, columns: Sequence[str] = ()) -> SampledTrajectory:
        """Return a saved motion at its rate or at another.

        Raises UserError for an invalid rate, and for more samples than memory allows.
        """
        rate = saved.fps if fps is None else positive(fps, "fps =")
        at = sampled(saved.figure, saved.timeline, rate)
        return cls(saved, rate, at.time, at.qpos, at.qvel, at.qacc, columns=columns)

    @property
    def figure(self) -> Figure:
        """The figure: a MuJoCo model as a tree of links."""
        return self.saved.figure

    @property
    def model(self) -> mujoco.MjModel:
        """The figure in its scene, as a compiled model."""
        return self.saved.figure.model

    @property
    def name(self) -> str:
        """The name of the motion."""
        return self.saved.name

    @cached_property
    def bodies(self) -> Bodies:
        """Positions, orientations and velocities of all bodies."""
        return Bodies.of(self.model, self.qpos, self.qvel)


@dataclass(frozen=True)
class Bodies:
    """The motion of all body frames in world axes; the first body is the world.

    Attributes:
        position: Positions (T, nbody, 3) [m].
        rotation: Orientations (T, nbody, 4), wxyz and sign-continuous.
        velocity: Velocities (T, nbody, 3) of the origins [m/s].
        spin: Angular velocities (T, nbody, 3) [rad/s].
    """

    position: Array
    rotation: Array
    velocity: Array
    spin: Array

    @classmethod
    def of(cls, model: mujoco.MjModel, qpos: Array, qvel: Array) -> Bodies:
        """Return the motion of the bodies, by MuJoCo's kinematics of every sample."""
        data = mujoco.MjData(model)
        position, rotation, velocity, spin = (np.zeros((len(qpos), model.nbody, width)) for width in (3, 4, 3, 3))
        for i in range(len(qpos)):
            data.qpos, data.qvel = qpos[i], qvel[i]
            mujoco.mj_fwdPosition(model, data)
            mujoco.mj_fwdVelocity(model, data)
            position[i], rotation[i], spin[i] = data.xpos, data.xquat, data.cvel[:, :3]
            offset = data.xpos - data.subtree_com[model.body_rootid]  # from the point that cvel refers to
            velocity[i] = data.cvel[:, 3:] + np.cross(spin[i], offset)
        return cls(position, quat.aligned(rotation), velocity, spin)


@dataclass(frozen=True)
class Recording:
    """The content of a file that was read, in MuJoCo's order and units.

    Attributes:
        time: Times (T,) [s], rising.
        qpos: Configurations (T, nq) of the figure.
        scene: The figure that the file contains, such as the hierarchy of a BVH file; None for the caller's figure.
        fps: The sampling rate [1/s], if the file states it more exactly than its times.
        notes: Lines for the user on how the file was read.
        assumed_layout: The root's quaternions and vertical axis, if only the format's documentation states them.
    """

    time: Array
    qpos: Array
    scene: Scene | None = None
    fps: float | None = None
    notes: tuple[str, ...] = ()
    assumed_layout: str | None = None
