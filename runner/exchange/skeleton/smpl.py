"""The SMPL body: its 22 joints, their places in the mean shape, and the axes and unit of its recordings.

Joints are named as in SMPL, except for its left_foot and right_foot, which are the toes. They are turned relative to
their parent. Without turns the body has its arms to the sides, x to its left, y up and z forward. Offsets are those of
the mean shape (betas of zero), rounded to a millimetre and made symmetric.

Sources: M. Loper et al., SMPL: A Skinned Multi-Person Linear Model, SIGGRAPH Asia 2015, for joints and their order;
Z. Luo et al., PHC (ICCV 2023), phc/data/assets/mjcf/smpl_humanoid.xml, which publishes the offsets of the mean shape.
"""

from __future__ import annotations

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from .captured_skeleton import CapturedSkeleton

NAMES = (
    "pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2", "left_ankle", "right_ankle",
    "spine3", "left_toe", "right_toe", "neck", "left_collar", "right_collar", "head", "left_shoulder",
    "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
)  # fmt: skip
PARENT = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
OFFSET_OF = {  # [m] from the parent, of the left side and the middle
    "pelvis": (0, 0, 0), "left_hip": (0.069, -0.091, -0.006), "left_knee": (0.036, -0.379, -0.007),
    "left_ankle": (-0.015, -0.398, -0.043), "left_toe": (0.026, -0.052, 0.121), "spine1": (0, 0.109, -0.027),
    "spine2": (0, 0.135, 0.001), "spine3": (0, 0.053, 0.025), "neck": (0, 0.214, -0.043), "head": (0, 0.065, 0.051),
    "left_collar": (0.080, 0.120, -0.036), "left_shoulder": (0.094, 0.032, -0.009),
    "left_elbow": (0.257, -0.013, -0.024), "left_wrist": (0.252, 0.008, -0.003),
}  # fmt: skip
END_OF = {"left_toe": (0, -0.018, 0.072), "head": (0, 0.18, 0), "left_wrist": (0.17, -0.014, -0.026)}  # [m], about
UPRIGHT = 0.5  # cosine to the vertical of a body that counts as upright, from ankles to head
MOST = 0.5  # of the samples
FLOOR = 0.125  # [m] height of the lowest joint of a body that lies on the floor, and as much more or less
AXES = {"z": (1, 2), "y": (1, 1), "-y": (-1, 1)}  # sign and column of what may be up
OFF_FLOOR = 0.3  # [m] height of the soles of a body that does not stand on the floor
STANDS, WALKS = 0.3, 0.3  # of the pelvis' height above the soles; [m] of a path by the feet: enough to measure a unit
LOW = 0.05  # [m] least height of the pelvis above the soles
UNITS = {2: ("centimetres", 0.01), 3: ("millimetres", 0.001)}  # by the power of ten


def _mirrored(table: dict[str, tuple[float, float, float]]) -> dict[str, Array]:
    """With the right side, whose x is opposite."""
    return {
        name: np.array(table[name] if name in table else table[f"left{name[5:]}"]) * [1 - 2 * (name not in table), 1, 1]
        for name in NAMES
        if name in table or f"left{name[5:]}" in table
    }


OFFSET = np.array([_mirrored(OFFSET_OF)[name] for name in NAMES])
ENDS = {NAMES.index(name): end for name, end in _mirrored(END_OF).items()}
PELVIS, HEAD = NAMES.index("pelvis"), NAMES.index("head")  # indices
ANKLES, TOES = ([NAMES.index(f"{side}_{part}") for side in ("left", "right")] for part in ("ankle", "toe"))  # indices
TO_SMPL = np.array([0.5, -0.5, -0.5, -0.5])  # from axes x forward, y left, z up


def in_world(local: Array) -> Array:
    """Rotations (T, 22, 4) in the world, of those relative to the parent."""
    out = local.copy()
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            out[:, joint] = quat.product(out[:, parent], local[:, joint])
    return out


def about_pelvis(turn: Array) -> Array:
    """(T, 22, 3) [m] the joints' places about the pelvis, by their rotations (T, 22, 4) in the world."""
    place = np.zeros((*turn.shape[:2], 3))
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            place[:, joint] = place[:, parent] + quat.rotated(turn[:, parent], OFFSET[joint])
    return place


def z_up(position: Array, local: Array) -> tuple[Array, Array, tuple[str, ...]]:
    """The pelvis' positions (T, 3) and the joints' rotations (T, 22, 4) in a world whose z is up, and notes."""
    up, notes = _up(position, about_pelvis(in_world(local)))
    if up == "z":
        return position, local, notes
    turn = quat.from_rotation_vector(np.array([np.pi / 2 if up == "y" else -np.pi / 2, 0, 0]))
    local = local.copy()
    local[:, PELVIS] = quat.product(turn, local[:, PELVIS])
    return quat.rotated(turn, position), local, notes


def _up(position: Array, away: Array) -> tuple[str, tuple[str, ...]]:
    """The vertical axis, "z", "y" or "-y", and notes; of places (T, 22, 3) about the pelvis.

    It is the axis along which the body is upright at most samples, from its ankles to its head, and otherwise z, as
    AMASS specifies. A body on the floor by z whose feet are not on the floor by the other axis lies there; one that is
    on the floor by y alone lies in a file with y up.
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
    """Positions (T, 3) of the pelvis [m], z up, and notes: by its height above the soles, and its path by the feet.

    Lengths are those of the mean shape. They are metres unless all measured lengths are a hundred or a thousand
    times too long.
    """
    place = about_pelvis(in_world(local))
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
    """The mean shape in motion: positions (T, 3) [m] of the pelvis, rotations (T, 22, 4), in a world whose z is up."""
    ours, turn = quat.inverse(TO_SMPL), in_world(local)
    place = position[:, None] + about_pelvis(turn)
    relative = quat.product(quat.product(ours, local), TO_SMPL)
    relative[:, PELVIS] = quat.product(local[:, PELVIS], TO_SMPL)
    ends = {joint: quat.rotated(ours, end) for joint, end in ENDS.items()}
    rotation = quat.aligned(quat.product(turn, TO_SMPL))
    return CapturedSkeleton(
        list(NAMES), list(PARENT), quat.rotated(ours, OFFSET), ends, place, rotation, quat.aligned(relative)
    )
