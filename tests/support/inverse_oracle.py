"""MuJoCo's inverse dynamics of a motion, sample by sample, and motions of any model to try it on."""

from __future__ import annotations

import mujoco
import numpy as np
import wild


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


def motion_of(path, seed):
    """The spline through three random poses of any model, 0.2 s apart; all joints are within 0.6 of their reference."""
    model, rng = mujoco.MjModel.from_xml_path(str(path)), np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (3, 1))
    for row in qpos:
        mujoco.mj_integratePos(model, row, rng.uniform(-0.6, 0.6, model.nv), 1.0)
    return wild.through(str(path), 0.2 * np.arange(3), qpos)
