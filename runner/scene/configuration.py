"""Configurations qpos of a model: their kinematics, and checks for untrusted input."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.model import joint_names, set_qpos
from dynsplines.solver.tolerances import SINGLE

from ..system.quantity import LARGEST


def kinematics_of(model: mujoco.MjModel, qpos: Array) -> Iterator[mujoco.MjData]:
    """Yield the kinematics of configurations (T, nq), one after another in the same MjData: copy what is needed."""
    data = mujoco.MjData(model)
    for row in qpos:
        set_qpos(model, data, row)
        yield data


def quaternions(model: mujoco.MjModel) -> dict[int, slice]:
    """Return the columns of qpos of each quaternion, by joint."""
    turning = np.flatnonzero(np.isin(model.jnt_type, (JointKind.FREE, JointKind.BALL))).tolist()
    ends = {joint: int(model.jnt_qposadr[joint]) + JointKind(model.jnt_type[joint]).width for joint in turning}
    return {joint: slice(end - 4, end) for joint, end in ends.items()}


def first_wrong(model: mujoco.MjModel, time: Array, qpos: Array) -> tuple[int, str] | None:
    """Return index and reason of the first invalid keyframe, time (K,) [s] and qpos (K, nq); None if all are valid."""
    entries = np.column_stack([time, qpos])
    checks = [
        (np.isfinite(entries).all(axis=1), "an entry is not a finite number"),
        ((np.abs(entries) <= LARGEST).all(axis=1), "an entry is too large"),
    ]
    for joint, columns in quaternions(model).items():
        with np.errstate(over="ignore"):
            is_unit = np.linalg.norm(qpos[:, columns], axis=1) >= SINGLE
        checks.append((is_unit, f"the quaternion of '{model.joint(joint).name or f'joint {joint}'}' is zero"))
    wrong = [(int(np.argmin(well)), problem) for well, problem in checks if not well.all()]
    return min(wrong, key=lambda fault: fault[0], default=None)


def unlike_joints(model: mujoco.MjModel, names: Sequence[str]) -> str | None:
    """Return how the joints of a file's qpos differ from the model's, in their order; None if they are the same."""
    in_model, in_clips = [str(model.joint(i).name) for i in range(model.njnt)], joint_names(model)
    if list(names) in (in_model, in_clips):
        return None
    return f"its joints are {', '.join(names)}; the figure's {', '.join(in_clips)}"
