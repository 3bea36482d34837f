"""The SMPL body: its 22 joints, their offsets in the mean shape, and the axes and unit of recordings.

Joints are named as in SMPL, except for its left_foot and right_foot, which are the toes. Rotations are relative to the
parent. Without rotations the body has its arms to the sides, x to its left, y up and z forward. Offsets are those of
the mean shape (betas of zero), rounded to a millimetre and made symmetric.

Sources: M. Loper et al., SMPL: A Skinned Multi-Person Linear Model, SIGGRAPH Asia 2015, for joints and their order;
Z. Luo et al., PHC (ICCV 2023), phc/data/assets/mjcf/smpl_humanoid.xml, which publishes the offsets of the mean shape.
"""

from __future__ import annotations

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from .bvh_file import placed
from .captured_skeleton import CapturedSkeleton
from .hierarchy import Y_UP

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
UPRIGHT = 0.5  # least cosine between the vertical and the line from ankles to head of an upright body
MOST = 0.5  # fraction of the samples that counts as most
FLOOR = 0.125  # [m] height of the lowest joint of a body lying on the floor, and tolerance of this height
AXES = {"z": (1, 2), "y": (1, 1), "-y": (-1, 1)}  # sign and column of possible vertical axes
OFF_FLOOR = 0.3  # [m] height of the soles from which a body does not stand on the floor
STANDS, WALKS = 0.3, 0.3  # least relative height of the pelvis and path [m] by the feet that determine a unit
LOW = 0.05  # [m] least height of the pelvis above the soles
UNITS = {2: ("centimetres", 0.01), 3: ("millimetres", 0.001)}  # by the power of ten


def _mirrored(table: dict[str, tuple[float, float, float]]) -> dict[str, Array]:
    """Return a table with the right side added, whose x is opposite."""
    return {
        name: np.array(table[name] if name in table else table[f"left{name[5:]}"]) * [1 - 2 * (name not in table), 1, 1]
        for name in NAMES
        if name in table or f"left{name[5:]}" in table
    }


OFFSET = np.array([_mirrored(OFFSET_OF)[name] for name in NAMES])
ENDS = {NAMES.index(name): end for name, end in _mirrored(END_OF).items()}
PELVIS, HEAD = NAMES.index("pelvis"), NAMES.index("head")  # indices
ANKLES, TOES = ([NAMES.index(f"{side}_{part}") for side in ("left", "right")] for part in ("ankle", "toe"))  # indices


def in_world(local: Array) -> tuple[Array, Array]:
    """Return positions (T, 22, 3) [m] of the joints relative to the pelvis, and rotations (T, 22, 4) in the world, from
    rotations relative to the parent."""
    return placed(PARENT, np.tile(OFFSET, (len(local), 1, 1)), local)


def z_up(position: Array, local: Array) -> tuple[Array, Array, tuple[str, ...]]:
    """Return the pelvis' positions (T, 3) and the joints' rotations (T, 22, 4) in a world with z up, and notes."""
    up, notes = _up(position, in_world(local)[0])
    if up == "z":
        return position, local, notes
    turn = quat.from_rotation_vector(np.array([np.pi / 2 if up == "y" else -np.pi / 2, 0, 0]))
    local = local.copy()
    local[:, PELVIS] = quat.product(turn, local[:, PELVIS])
    return quat.rotated(turn, position), local, notes


def _up(position: Array, away: Array) -> tuple[str, tuple[str, ...]]:
    """Return the vertical axis, "z", "y" or "-y", and notes; away: positions (T, 22, 3) relative to the pelvis.

    It is the axis along which the body is upright in most samples, and otherwise z, as AMASS specifies. Lying bodies
    are distinguished by the floor. A body that is on the floor by z lies there, if its feet are not on the floor by the
    other axis. A body on the floor by y alone lies in a file with y up.
    """
    along = away[:, HEAD] - away[:, ANKLES].mean(axis=1)
    cosine = along / np.linalg.norm(along, axis=1, keepdims=True)
    upright = {axis: float(np.mean(sign * cosine[:, column] > UPRIGHT)) for axis, (sign, column) in AXES.items()}
    if upright["z"] >= MOST:
        return "z", ()
    lowest = {
        axis: (sign * (position[:, None] + away)[..., column]).min(axis=1) for axis, (sign, column) in AXES.items()
    }
    lies = {
        axis: bool(np.all(np.abs(np.quantile(heights, [0.05, 0.95]) - FLOOR) < FLOOR))
        for axis, heights in lowest.items()
    }
    up = max(upright, key=lambda axis: upright[axis])
    if upright[up] >= MOST:
        if lies["z"] and np.median(np.abs(lowest[up])) > OFF_FLOOR:
            return "z", (f"lies on the floor, along {up}, at {upright[up]:.0%} of the samples: z is up",)
        return up, (
            f"{up} is up in the file, along which the person is upright at {upright[up]:.0%} of the samples: turned",
        )
    if lies["y"] and not lies["z"]:
        return "y", ("y is up in the file, along which the person is on the floor: turned",)
    return "z", (f"upright at {upright['z']:.0%} of the samples only: z is taken as up, as in AMASS",)


def in_metres(position: Array, local: Array) -> tuple[Array, tuple[str, ...]]:
    """Return positions (T, 3) [m] of the pelvis, z up, and notes.

    The unit is inferred by comparison with the mean shape, from the pelvis' height above the soles and the path by the
    feet. It is the metre unless all measured lengths are a hundred or a thousand times too long.
    """
    place, _ = in_world(local)
    ratios = []
    height = float(np.median(position[:, 2] / np.maximum(-place[..., 2].min(axis=1), LOW)))
    if abs(height) > STANDS:
        ratios.append(abs(height))
    standing = np.argmin(place[:, TOES, 2], axis=1)[:-1]
    step = np.diff(place[:, TOES], axis=0)[np.arange(len(standing)), standing]
    path = float(np.linalg.norm(step, axis=1).sum())
    if path > WALKS:
        ratios.append(float(np.linalg.norm(np.diff(position, axis=0), axis=1).sum()) / path)
    powers = {round(np.log10(max(ratio, 1e-9))) for ratio in ratios}
    if len(powers) == 1 and (power := powers.pop()) in UNITS:
        name, unit = UNITS[power]
        return unit * position, (f"positions are taken for {name}, which fit the length of the legs",)
    return position, ()


def captured(position: Array, local: Array) -> CapturedSkeleton:
    """Return the mean shape in motion: positions (T, 3) [m] of the pelvis, rotations (T, 22, 4), in a z-up world."""
    ours, (away, turn) = quat.inverse(Y_UP), in_world(local)
    place = position[:, None] + away
    ends = {joint: quat.rotated(ours, end) for joint, end in ENDS.items()}
    rotation = quat.aligned(quat.product(turn, Y_UP))
    return CapturedSkeleton(list(NAMES), list(PARENT), quat.rotated(ours, OFFSET), ends, place, rotation)
