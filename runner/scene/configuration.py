"""Configurations qpos of a model: their kinematics, and checks for untrusted input."""

from __future__ import annotations

from collections.abc import Iterator

import mujoco
import numpy as np

from dynsplines.solver.array import Array

from ..system.quantity import LARGEST

SHORTEST = 1e-6  # [1] minimum norm of a quaternion
QUATERNION = {mujoco.mjtJoint.mjJNT_FREE: 3, mujoco.mjtJoint.mjJNT_BALL: 0}  # offset of the quaternion in a joint


def posed(model: mujoco.MjModel, qpos: Array) -> Iterator[mujoco.MjData]:
    """Yield the kinematics of configurations (T, nq), one after another in the same MjData: copy what is needed."""
    data = mujoco.MjData(model)
    for row in qpos:
        data.qpos[:] = row
        mujoco.mj_kinematics(model, data)
        yield data


def first_wrong(model: mujoco.MjModel, time: Array, qpos: Array) -> tuple[int, str] | None:
    """Return index and reason of the first invalid keyframe, time (K,) [s] and qpos (K, nq); None if all are valid."""
    entries = np.column_stack([time, qpos])
    checks = [
        (np.isfinite(entries).all(axis=1), "an entry is not a finite number"),
        ((np.abs(entries) <= LARGEST).all(axis=1), "an entry is too large"),
    ]
    for joint in range(model.njnt):
        kind = mujoco.mjtJoint(int(model.jnt_type[joint]))
        if kind in QUATERNION:
            start = int(model.jnt_qposadr[joint]) + QUATERNION[kind]
            with np.errstate(over="ignore"):
                is_unit = np.linalg.norm(qpos[:, start : start + 4], axis=1) >= SHORTEST
            checks.append((is_unit, f"the quaternion of '{model.joint(joint).name or f'joint {joint}'}' is zero"))
    wrong = [(int(np.argmin(well)), problem) for well, problem in checks if not well.all()]
    return min(wrong, key=lambda each: each[0], default=None)
