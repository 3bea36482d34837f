"""The root of a figure in a recording, moved on a free joint or on slides."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.root import SLIDE, Root, roots_of

from ...errors import UserError
from ...scene.configuration import posed
from ...scene.framing import root_places
from . import hierarchy

BALL = int(mujoco.mjtJoint.mjJNT_BALL)
STEPS, LONGEST = 60, 0.5  # most Gauss-Newton steps on a root's hinges; [rad] most rotation in one
TURNED, MOVED = float(np.radians(0.5)), 0.005  # [rad, m] allowed deviation of a root from the recorded one


def carrying(model: mujoco.MjModel, body: int) -> Root | None:
    """Return the root of the tree of a body; None if the tree is fixed to the world or moves on hinges alone."""
    chain = hierarchy.above(model, body, itself=True)
    return next((root for root in roots_of(model) if root.body in chain), None)


def shifted(model: mujoco.MjModel, root: Root, qpos: Array, by: Array) -> Array:
    """Return qpos (T, nq) with the root translated by vectors (T, 3) [m] in world axes, as far as its slides permit."""
    out = qpos.copy()
    if root.is_free:
        start = int(model.jnt_qposadr[root.joints[0]])
        out[:, start : start + 3] += by
        return out
    slides = [joint for joint in root.joints if model.jnt_type[joint] == SLIDE]
    columns = model.jnt_qposadr[slides]
    for row, move, data in zip(out, by, posed(model, qpos), strict=True):
        row[columns] += np.linalg.lstsq(data.xaxis[slides].T, move, rcond=None)[0]
    return out


def placed(model: mujoco.MjModel, root: Root, qpos: Array, position: Array, rotation: Array, where: object) -> Array:
    """Return qpos (T, nq) with a root of slides and hinges at positions (T, 3) [m] and orientations (T, 4) wxyz.

    Each sample is solved from the previous one, so that hinges are continuous. Raises UserError if the joints do not
    reach the recorded root; where: label of the file in errors.
    """
    out, data = qpos.copy(), mujoco.MjData(model)
    turning = [joint for joint in root.joints if model.jnt_type[joint] != SLIDE]
    is_ball = [model.jnt_type[joint] == BALL for joint in turning]
    dofs = _runs(model.jnt_dofadr[turning], [3 if ball else 1 for ball in is_ball])
    columns = _runs(model.jnt_qposadr[turning], [4 if ball else 1 for ball in is_ball])
    turned = np.zeros(len(out))
    for i, row in enumerate(out):
        if i:
            row[columns] = out[i - 1, columns]
        turned[i] = _turn(model, data, root, row, dofs, rotation[i])
    away = position - root_places(model, root, out)
    out = shifted(model, root, out, away)
    missed = np.linalg.norm(position - root_places(model, root, out), axis=1)
    if turned.max() > TURNED or missed.max() > MOVED:
        names = ", ".join(f"'{model.joint(joint).name}'" for joint in root.joints)
        raise UserError(
            f"{where}: the figure's root moves on {names} alone; the file's root goes {missed.max():.2f} m and "
            f"{np.degrees(turned.max()):.0f} degrees beyond them; give a figure with a free joint"
        )
    return out


def _runs(starts: Index, lengths: list[int]) -> Index:
    return np.array([start + k for start, length in zip(starts, lengths, strict=True) for k in range(length)], int)


def _turn(model: mujoco.MjModel, data: mujoco.MjData, root: Root, row: Array, dofs: Index, target: Array) -> float:
    """Rotate a root's body in a pose (nq,) to an orientation (4,), in place; return the remaining angle [rad]."""
    spin, error = np.zeros((3, model.nv)), np.zeros(3)
    for _ in range(STEPS):
        data.qpos[:] = row
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_jacBody(model, data, None, spin, root.body)
        error = quat.rotation_vector(quat.product(target, quat.inverse(data.xquat[root.body])))
        jacobian, step = spin[:, dofs], np.zeros(model.nv)
        step[dofs] = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-12 * np.eye(3), error)
        size = float(np.abs(step).max(initial=0.0))
        if size < 1e-10:
            break
        mujoco.mj_integratePos(model, row, step * min(1.0, LONGEST / size), 1.0)
    return float(np.linalg.norm(error))
