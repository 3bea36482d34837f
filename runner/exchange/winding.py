"""Removal of jumps by a whole turn from recorded hinges without limits, whose angles wrap at ±180°."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask

HINGE = int(mujoco.mjtJoint.mjJNT_HINGE)
TURN = 2 * np.pi  # [rad]
NEAR = 1.0  # [rad] largest deviation of a jump from a whole turn that counts as a wrap in every recording
EDGE = 1e-3  # [rad] tolerance at the bounds of a turn, as files contain rounded angles
NAMED = 3  # most joints that a note lists


def unwrapped(model: mujoco.MjModel, time: Array, qpos: Array) -> tuple[Array, tuple[str, ...]]:
    """Return a recording in which hinges stored within one turn are continuous, and a note on them.

    Args:
        time: (T,) [s].
        qpos: (T, nq), hinges in radians.

    Returns:
        qpos (T, nq), and one note if a hinge jumped. Hinges with a range of less than a turn are unchanged.
    """
    out, names, first = qpos, [], np.inf
    if qpos.shape[1] != model.nq:  # reported where the keyframes are made
        return qpos, ()
    for joint in range(model.njnt):
        is_bounded = model.jnt_limited[joint] and np.ptp(model.jnt_range[joint]) < TURN - EDGE
        if model.jnt_type[joint] != HINGE or is_bounded:
            continue
        column = int(model.jnt_qposadr[joint])
        jumps = _whole_turns(qpos[:, column])
        if not jumps.any():
            continue
        out = qpos.copy() if out is qpos else out
        out[1:, column] -= TURN * np.cumsum(jumps)
        names.append(model.joint(joint).name or f"joint{joint}")
        first = min(first, float(time[1 + np.flatnonzero(jumps)[0]]))
    if not names:
        return qpos, ()
    whose = ", ".join(f"'{name}'" for name in names[:NAMED])
    whose += f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return out, (f"{whose}: angles wrap at a whole turn, first at {first:.3f} s: unwrapped",)


def _whole_turns(angle: Array) -> Array:
    """Return the number of whole turns (T - 1,) between samples that are artefacts of wrapping. If all angles lie
    within one turn, from -180° or from 0°, they are taken as wrapped, and every jump counts. Otherwise only jumps of
    nearly a whole turn count: a rotor recorded over many turns may pass half a turn between samples."""
    step = np.diff(angle)
    turns = np.round(step / TURN)
    is_within = any(angle.min() >= low - EDGE and angle.max() <= low + TURN + EDGE for low in (-np.pi, 0.0))
    counts: Mask = np.abs(step - TURN * turns) <= NEAR
    return turns if is_within else np.where(counts, turns, 0.0)
