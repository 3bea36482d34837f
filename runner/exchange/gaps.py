"""Samples that are not finite: errors by default, tolerated in recordings to be cleaned.

Such a sample is replaced by the sample before it, so that readers need no special case, and removed at the end.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask, runs
from dynsplines.solver.figure.figure import JointKind

from ..errors import UserError
from .recording import Recording

STILL, JUMP = 1.0, 20.0  # [rad/s] largest speed of a joint in a pose; least speed of a jump out of it
SUDDEN = 4.0  # [1] least ratio of the speed of this jump to that of the next sample, as throws and kicks last longer
POSE = "the recording starts with a pose and jumps to the motion at"  # start of a note


# masks (T,) of the samples of the file being read that are not finite, None if these are errors
_missing: ContextVar[list[Mask] | None] = ContextVar("missing", default=None)


@contextmanager
def allow() -> Iterator[None]:
    """Tolerate gaps in files within this block."""
    before = _missing.set([])
    try:
        yield
    finally:
        _missing.reset(before)


def are_allowed() -> bool:
    """Return whether samples may be missing."""
    return _missing.get() is not None


def bridge(array: Array) -> Array | None:
    """Return an array with each sample (first axis) that is not finite replaced by the one before, and note these
    samples.

    None if gaps are not allowed, if no sample is finite, or if the number of samples differs from earlier arrays.
    """
    missing = _missing.get()
    if missing is None or array.ndim == 0 or not len(array):
        return None
    bad = np.asarray(~np.isfinite(array.reshape(len(array), -1)).all(axis=1))
    if bad.all() or any(each.size != bad.size for each in missing):
        return None
    missing.append(bad)
    return hold(array, ~bad)


def hold(array: Array, is_good: Mask) -> Array:
    """Return an array with each of the other rows replaced by the last good one before, else by the first good one."""
    good = np.flatnonzero(is_good)
    return array[good[np.maximum(np.searchsorted(good, np.arange(len(array)), side="right") - 1, 0)]]


def without_missing(recording: Recording, where: object) -> Recording:
    """Return a recording without the samples noted by `bridge`."""
    missing = _missing.get()
    if not missing:
        return recording
    is_present = ~np.any(missing, axis=0)
    if is_present.size != recording.time.size:
        raise UserError(f"{where}: some of its numbers are not finite, and no single samples can be removed")
    count, times = int(np.sum(~is_present)), intervals(recording.time, ~is_present)
    many = "samples lack" if count > 1 else "sample lacks"
    notes = (*recording.notes, f"{count} {many} some or all numbers, at {times}: left out as a whole")
    return replace(recording, time=recording.time[is_present], qpos=recording.qpos[is_present], notes=notes)


def intervals(time: Array, which: Mask) -> str:
    """Return the times (T,) [s] of selected samples as text, those of successive samples as intervals."""
    ends = [(float(time[first]), float(time[end - 1])) for first, end in runs(which)]
    return ", ".join(f"{first:.3f}" + f"-{last:.3f}" * (last > first) for first, last in ends) + " s"


def initial_pose(model: mujoco.MjModel, time: Array, qpos: Array) -> int:
    """Return the number of samples of a calibration pose at the start, out of which a joint jumps; 0 without one."""
    turns, velocity = np.isin(model.jnt_type[model.dof_jntid], (JointKind.BALL, JointKind.HINGE)), np.zeros(model.nv)
    before = 0.0
    for i, duration in enumerate(np.diff(time)):
        mujoco.mj_differentiatePos(model, velocity, duration or np.inf, qpos[i], qpos[i + 1])
        speed = float(np.abs(velocity[turns]).max(initial=0.0))
        if before > STILL:
            return i if before > JUMP and before >= SUDDEN * speed else 0
        before = speed
    return 0
