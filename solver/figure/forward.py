"""Forward kinematics of single configurations by MuJoCo."""

from __future__ import annotations

import mujoco

from ..array import Array


def kinematics(model: mujoco.MjModel, qpos: Array | None = None) -> mujoco.MjData:
    """Return the positions of bodies, geoms and sites in a configuration (nq,), by default at rest."""
    data = mujoco.MjData(model)
    if qpos is not None:
        data.qpos[:] = qpos
    mujoco.mj_kinematics(model, data)
    return data
