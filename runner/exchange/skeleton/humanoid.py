"""A figure with ball joints under common names of motion capture, and the height of its hips."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.forward import kinematics

from ...errors import UserError
from .roles import SIDES

JOINTS = ("spine", *(f"{side}_{part}" for side in SIDES for part in ("shoulder", "elbow", "hip", "knee", "ankle")))


@dataclass(frozen=True, eq=False)
class Humanoid:
    """First columns in qpos of the root and of ball joints, by name; height [m] of the hips above the soles at rest."""

    model: mujoco.MjModel
    root: int
    columns: dict[str, int]
    height: float

    @classmethod
    def of(cls, model: mujoco.MjModel, form: str) -> Humanoid:
        """Return the Humanoid of a figure like the shipped human: at rest upright, facing x, bodies parallel to the
        world."""
        kinds = model.jnt_type.tolist()
        balls = {model.joint(j).name: j for j, kind in enumerate(kinds) if kind == JointKind.BALL}
        missing = [name for name in JOINTS if name not in balls]
        if missing or kinds.count(JointKind.FREE) != 1:
            lacks = f"ball joint '{missing[0]}'" if missing else "one free joint"
            names = ", ".join(model.joint(j).name or "?" for j in range(model.njnt))
            raise UserError(
                f"the format '{form}' is for a person of a free root and the ball joints {', '.join(JOINTS)}; "
                f"the figure has no {lacks}, only: {names}"
            )
        data = kinematics(model)
        bodies = {name: int(model.jnt_bodyid[balls[name]]) for name in JOINTS}
        turned = [name for name, body in bodies.items() if abs(data.xquat[body, 0]) < 1 - 1e-6]
        if turned:
            raise UserError(f"the format '{form}' needs bodies parallel to the world at rest; '{turned[0]}' is turned")
        feet = [bodies[f"{side}_ankle"] for side in SIDES]
        soles = [data.site_xpos[i, 2] for i in range(model.nsite) if int(model.site_bodyid[i]) in feet]
        soles = soles or [data.xpos[foot, 2] for foot in feet]
        hips = np.mean([data.xpos[bodies[f"{side}_hip"], 2] for side in SIDES])
        columns = {name: int(model.jnt_qposadr[joint]) for name, joint in balls.items()}
        return cls(model, int(model.jnt_qposadr[kinds.index(JointKind.FREE)]), columns, float(hips - min(soles)))

    def rotation(self, qpos: Array, joint: str | None = None) -> Array:
        """Return quaternions (T, 4) of a joint, or of the root."""
        start = self.root + 3 if joint is None else self.columns[joint]
        return qpos[:, start : start + 4]

    def posed(self, position: Array, rotation: Array, joints: dict[str, Array]) -> Array:
        """Return qpos (T, nq) for the root's position (T, 3) and rotation (T, 4), and joints' (T, 4), else at rest."""
        qpos = np.tile(self.model.qpos0, (len(position), 1))
        qpos[:, self.root : self.root + 3] = position
        qpos[:, self.root + 3 : self.root + 7] = quat.aligned(rotation)
        for name, local in joints.items():
            start = self.columns[name]
            qpos[:, start : start + 4] = quat.aligned(local)
        return qpos
