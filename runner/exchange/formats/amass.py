"""NPZ of AMASS, only read: motion capture of thousands of people on the SMPL body.

trans (T, 3) [m]        z up, the floor at z = 0
poses (T, n)            rotation vectors [rad] of SMPL's joints, relative to the parent, the root's in the world:
                        pelvis, left_hip, right_hip, spine1, left_knee, right_knee, spine2, left_ankle, right_ankle,
                        spine3, ...; n is 66, 72 (SMPL), 156 (SMPL-H) or 165 (SMPL-X); 22 joints are read
root_orient, pose_body  the first three columns of poses and the others, in its place
mocap_framerate         [1/s]; mocap_frame_rate in later files

At rest SMPL's body has its arms to the sides, x to its left, y up and z forward. Source: N. Mahmood et al., AMASS, ICCV
2019. The files contain no skeleton, only coefficients of a body model that may not be redistributed. A figure gets the
motion of SMPL's mean shape by retargeting. Without a figure, the mean shape is the figure.

Joints are named as in SMPL, except for its left_foot and right_foot, which are the toes. Offsets are those of the mean
shape (betas of zero), rounded to a millimetre and made symmetric.

Sources: M. Loper et al., SMPL: A Skinned Multi-Person Linear Model, SIGGRAPH Asia 2015, for joints and their order;
Z. Luo et al., PHC (ICCV 2023), phc/data/assets/mjcf/smpl_humanoid.xml, which publishes the offsets of the mean shape.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import GIVE_RATE, UserError
from ..array_reader import SAMPLES, ArrayReader, names_in, read_npz
from ..recording import Recording
from ..skeleton import hierarchy
from ..skeleton.bvh_file import to_world
from ..skeleton.captured_skeleton import CapturedSkeleton
from . import bvh

NAMES = (
    "pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2", "left_ankle", "right_ankle",
    "spine3", "left_toe", "right_toe", "neck", "left_collar", "right_collar", "head", "left_shoulder",
    "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
)  # fmt: skip
PARENT = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
OFFSET_OF = {  # [m] offset from the parent, for the left side and the middle
    "pelvis": (0, 0, 0), "left_hip": (0.069, -0.091, -0.006), "left_knee": (0.036, -0.379, -0.007),
    "left_ankle": (-0.015, -0.398, -0.043), "left_toe": (0.026, -0.052, 0.121), "spine1": (0, 0.109, -0.027),
    "spine2": (0, 0.135, 0.001), "spine3": (0, 0.053, 0.025), "neck": (0, 0.214, -0.043), "head": (0, 0.065, 0.051),
    "left_collar": (0.080, 0.120, -0.036), "left_shoulder": (0.094, 0.032, -0.009),
    "left_elbow": (0.257, -0.013, -0.024), "left_wrist": (0.252, 0.008, -0.003),
}  # fmt: skip
END_OF = {"left_toe": (0, -0.018, 0.072), "head": (0, 0.18, 0), "left_wrist": (0.17, -0.014, -0.026)}  # [m], about
RATES = ("mocap_framerate", "mocap_frame_rate")
COUNTS = (22, 24, 52, 55)  # joints of SMPL's body, SMPL, SMPL-H and SMPL-X
HIGHEST, FASTEST = 10.0, 15.0  # [m], [m/s] median height and mean speed above which positions are not in metres


def _mirror(table: dict[str, tuple[float, float, float]]) -> dict[str, Array]:
    """Return a table with the right side added, whose x is opposite."""
    return {
        name: np.array(table[name] if name in table else table[f"left{name[5:]}"]) * [1 - 2 * (name not in table), 1, 1]
        for name in NAMES
        if name in table or f"left{name[5:]}" in table
    }


OFFSET = np.array([_mirror(OFFSET_OF)[name] for name in NAMES])
ENDS = {NAMES.index(name): end for name, end in _mirror(END_OF).items()}


def recognises(path: Path) -> bool:
    """Return whether an .npz is of this format."""
    names = names_in(path)
    return "trans" in names and ("poses" in names or {"root_orient", "pose_body"} <= names)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the motion of SMPL's mean shape on a figure, or as a new figure."""
    arrays = read_npz(path)
    name = next((name for name in RATES if name in arrays), RATES[0])
    if name not in arrays and fps is None:
        raise UserError(f"{path}: it has no '{name}'; {GIVE_RATE}")
    rate = arrays.rate(name, fps)
    position = arrays.numbers("trans", SAMPLES, 3)
    if not len(position):
        raise UserError(f"{path}: it has no samples")
    local = _rotations(arrays)
    _check_unit(position, rate, path)
    out = bvh.of_captured(mean_shape(position, local), rate, path, model, _on_shape(arrays))
    return replace(out, assumed_layout="z up")


def _rotations(reader: ArrayReader) -> Array:
    """Return quaternions (T, 22, 4) relative to the parent; raises UserError for other arrays."""
    parts = ["poses"] if "poses" in reader or "root_orient" not in reader else ["root_orient", "pose_body"]
    poses = np.concatenate([reader.numbers(part, SAMPLES, f"numbers of {part}") for part in parts], axis=1)
    widths = [3 * count for count in COUNTS]
    if poses.shape[1] not in widths:
        raise UserError(
            f"{reader.where}: {' and '.join(map(repr, parts))} have {poses.shape[1]} numbers a sample; rotation "
            f"vectors of SMPL's joints are {', '.join(map(str, widths))} numbers"
        )
    return quat.from_rotation_vector(poses[:, : widths[0]].reshape(len(poses), -1, 3))


def _check_unit(position: Array, rate: float, path: Path) -> None:
    """Raise UserError if the pelvis is too high or too fast for positions (T, 3) in metres."""
    height = float(np.median(np.abs(position[:, 2])))
    speed = rate * float(np.linalg.norm(np.diff(position, axis=0), axis=1).mean()) if len(position) > 1 else 0.0
    if height > HIGHEST or speed > FASTEST:
        raise UserError(
            f"{path}: 'trans' is not in metres, as the pelvis is {height:.0f} m high and moves at {speed:.0f} m/s; "
            "divide it by 100 if it is in centimetres, by 1000 if it is in millimetres"
        )


def _on_shape(reader: ArrayReader) -> tuple[str, ...]:
    """Return a note if a file has the shape of the person."""
    betas = reader.of("betas") if "betas" in reader else None
    has_shape = isinstance(betas, np.ndarray) and betas.dtype.kind in "fiu" and bool(np.any(betas))
    return ("bones are those of SMPL's mean shape: the file's 'betas' are not used",) if has_shape else ()


def mean_shape(position: Array, local: Array) -> CapturedSkeleton:
    """Return the mean shape in motion: positions (T, 3) [m] of the pelvis, in a z-up world, and rotations (T, 22, 4)
    relative to the parent."""
    ours, (away, turn) = quat.inverse(hierarchy.Y_UP), to_world(PARENT, np.tile(OFFSET, (len(local), 1, 1)), local)
    place = position[:, None] + away
    ends = {joint: quat.rotate(ours, end) for joint, end in ENDS.items()}
    rotation = quat.align_signs(quat.product(turn, hierarchy.Y_UP))
    return CapturedSkeleton(list(NAMES), list(PARENT), quat.rotate(ours, OFFSET), ends, place, rotation)
