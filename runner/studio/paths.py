"""A motion as the page plays it: poses of every body at equal times, as a JSON header and float32 arrays.

The format is: 4 bytes, the header's length n; n bytes, the header, padded with spaces to a multiple of 4; positions
(T, B, 3) [m], rotations (T, B, 4) xyzw and the centre of mass (T, 3) [m].
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping, Sequence

import mujoco
import numpy as np
from numpy.typing import NDArray

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.root import subtree

RATE = 60.0  # [1/s] of samples, that of most displays
MOST_SAMPLES = 1200  # number of samples of a long motion, few enough to be sent quickly


def rate_of(duration: float) -> float:
    """Return the sampling rate [1/s] for a motion of this duration [s]."""
    return min(RATE, MOST_SAMPLES / duration)


def pack(figure: Figure, timeline: Timeline, header: Mapping[str, object], key_times: Sequence[float] = ()) -> bytes:
    """Return a timeline's motion with a header, to which start, rate and count of the samples are added, and the poses
    qpos at keyframes."""
    first, last = float(timeline.times[0]), float(timeline.times[-1])
    rate = rate_of(last - first)
    time = np.append(np.arange(first, last - 0.25 / rate, 1 / rate), last)
    qpos = figure.to_qpos(path_of(timeline).at(np.append(time, np.clip(key_times, first, last))))
    full_header = {
        **header,
        "first": first,
        "last": last,
        "rate": rate,
        "count": len(time),
        "bodies": figure.model.nbody,
        "keys": qpos[len(time) :].round(6).tolist(),
    }
    return join_bytes(full_header, *poses(figure, qpos[: len(time)]))


def join_bytes(header: Mapping[str, object], *arrays: Array | NDArray[np.float32]) -> bytes:
    """Return a header and arrays as bytes."""
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return b"".join([struct.pack("<I", len(text)), text, *(np.ascontiguousarray(a, "<f4").tobytes() for a in arrays)])


def poses(figure: Figure, qpos: Array) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Return positions (T, B, 3), rotations (T, B, 4) xyzw and the figure's centres of mass (T, 3) of poses qpos
    (T, nq)."""
    model = figure.model
    data, count = mujoco.MjData(model), len(qpos)
    position = np.empty((count, model.nbody, 3), np.float32)
    turned = np.empty((count, model.nbody, 4), np.float32)  # as MuJoCo has them, wxyz
    middle = np.empty((count, model.nbody, 3))
    here, places, turns, middles = data.qpos, data.xpos, data.xquat, data.xipos
    for i, pose in enumerate(qpos):
        here[:] = pose
        mujoco.mj_kinematics(model, data)
        position[i], turned[i], middle[i] = places, turns, middles
    masses = model.body_mass * _is_of_figure(figure)
    masses = masses / max(float(masses.sum()), 1e-12)
    return position, turned[..., [1, 2, 3, 0]], np.einsum("b,tbi->ti", masses, middle).astype(np.float32)


def _is_of_figure(figure: Figure) -> Mask:
    """Return which bodies (B,) are parts of the articulated tree with the root; without one, those that move."""
    model, root = figure.model, figure.root
    if root is not None and root.limbs:
        return subtree(model, root.body)
    return (model.body_weldid != 0) | (model.njnt == 0)
