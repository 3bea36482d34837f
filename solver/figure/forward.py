"""Forward kinematics of single configurations by MuJoCo, and the bounding boxes of geoms in them."""

from __future__ import annotations

import mujoco
import numpy as np

from ..array import Array, Index


def kinematics(model: mujoco.MjModel, qpos: Array | None = None) -> mujoco.MjData:
    """Return the positions of bodies, geoms and sites in a configuration (nq,), by default at rest."""
    data = mujoco.MjData(model)
    set_qpos(model, data, model.qpos0 if qpos is None else qpos)
    return data


def set_qpos(model: mujoco.MjModel, data: mujoco.MjData, qpos: Array) -> None:
    """Compute the same in existing data, together with what Jacobians and collisions need."""
    data.qpos[:] = qpos
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)


def boxes(model: mujoco.MjModel, data: mujoco.MjData, geoms: Index) -> tuple[Array, Array]:
    """Return the centres and half the extents of the bounding boxes of geoms, along the world's axes, (n, 3) [m]."""
    middle, half = np.split(model.geom_aabb[geoms], 2, axis=1)
    turn = data.geom_xmat[geoms].reshape(-1, 3, 3)
    centre = data.geom_xpos[geoms] + np.einsum("nij,nj->ni", turn, middle)
    return centre, np.einsum("nij,nj->ni", np.abs(turn), half)
