"""The root of a figure in a recording."""

from __future__ import annotations

import mujoco

from dynsplines.solver.array import Array
from dynsplines.solver.figure.root import Root, roots_of

from . import hierarchy


def carrying(model: mujoco.MjModel, body: int) -> Root | None:
    """Return the root of the tree of a body; None without a free joint."""
    chain = hierarchy.above(model, body, itself=True)
    return next((root for root in roots_of(model) if root.body in chain), None)


def shifted(model: mujoco.MjModel, root: Root, qpos: Array, by: Array) -> Array:
    """Return qpos (T, nq) with the root translated by vectors (T, 3) [m] in world axes."""
    out = qpos.copy()
    start = int(model.jnt_qposadr[root.joint])
    out[:, start : start + 3] += by
    return out
