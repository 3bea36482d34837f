"""MuJoCo's inverse dynamics of a motion, sample by sample."""

from __future__ import annotations

import mujoco
import numpy as np


def oracle(model, at, rows=slice(None)):
    """(T, nv) by mj_inverse of a motion's samples, without contacts."""
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    model.opt.enableflags = 0
    data, out = mujoco.MjData(model), []
    for qpos, qvel, qacc in zip(at.qpos[rows], at.qvel[rows], at.qacc[rows], strict=True):
        data.qpos, data.qvel, data.qacc = qpos, qvel, qacc
        mujoco.mj_inverse(model, data)
        out.append(data.qfrc_inverse.copy())
    return np.array(out)
