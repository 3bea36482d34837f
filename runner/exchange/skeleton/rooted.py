"""The root of a figure in a recording: moved by what a recording moves, on a free joint or on slides."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.root import SLIDE, Root, roots_of

from . import hierarchy


def carrying(model: mujoco.MjModel, body: int) -> Root | None:
    """The root of the tree that a body is part of; None where it hangs on the world by hinges, or does not move."""
    chain = hierarchy.above(model, body, itself=True)
    return next((root for root in roots_of(model) if root.body in chain), None)


def shifted(model: mujoco.MjModel, root: Root, qpos: Array, by: Array) -> Array:
    """qpos (T, nq) with the root moved by vectors (T, 3) [m] of the world, as far as its slides reach."""
    out = qpos.copy()
    if root.is_free:
        start = int(model.jnt_qposadr[root.joints[0]])
        out[:, start : start + 3] += by
        return out
    slides = [joint for joint in root.joints if model.jnt_type[joint] == SLIDE]
    columns, data = model.jnt_qposadr[slides], mujoco.MjData(model)
    for i, row in enumerate(out):
        data.qpos[:] = row
        mujoco.mj_kinematics(model, data)
        out[i, columns] += np.linalg.lstsq(data.xaxis[slides].T, by[i], rcond=None)[0]
    return out
