"""A skinned avatar as exporters write them, for readers of glTF and USD: bones with axes of their own, an armature.

Its motion is random. Where every bone is in the world comes from products of 4 x 4 matrices by the formulas of the
formats, without the project's code.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

BONES = {  # parent, and offset [m] from it in the world in the bind pose, y up, facing z
    "J_Bip_C_Hips": ("", (0.0, 0.9, 0.0)),
    "J_Bip_C_Spine": ("J_Bip_C_Hips", (0.0, 0.15, 0.0)),
    "J_Bip_C_Chest": ("J_Bip_C_Spine", (0.0, 0.15, 0.0)),
    "J_Bip_C_Head": ("J_Bip_C_Chest", (0.0, 0.3, 0.0)),
    "J_Bip_L_UpperArm": ("J_Bip_C_Chest", (0.18, 0.18, 0.0)),
    "J_Bip_L_LowerArm": ("J_Bip_L_UpperArm", (0.27, 0.0, 0.0)),
    "J_Bip_L_Hand": ("J_Bip_L_LowerArm", (0.25, 0.0, 0.0)),
    "J_Bip_R_UpperArm": ("J_Bip_C_Chest", (-0.18, 0.18, 0.0)),
    "J_Bip_R_LowerArm": ("J_Bip_R_UpperArm", (-0.27, 0.0, 0.0)),
    "J_Bip_R_Hand": ("J_Bip_R_LowerArm", (-0.25, 0.0, 0.0)),
    "J_Bip_L_UpperLeg": ("J_Bip_C_Hips", (0.09, -0.05, 0.0)),
    "J_Bip_L_LowerLeg": ("J_Bip_L_UpperLeg", (0.0, -0.4, 0.0)),
    "J_Bip_L_Foot": ("J_Bip_L_LowerLeg", (0.0, -0.4, 0.0)),
    "J_Bip_L_ToeBase": ("J_Bip_L_Foot", (0.0, -0.04, 0.12)),
    "J_Bip_R_UpperLeg": ("J_Bip_C_Hips", (-0.09, -0.05, 0.0)),
    "J_Bip_R_LowerLeg": ("J_Bip_R_UpperLeg", (0.0, -0.4, 0.0)),
    "J_Bip_R_Foot": ("J_Bip_R_LowerLeg", (0.0, -0.4, 0.0)),
    "J_Bip_R_ToeBase": ("J_Bip_R_Foot", (0.0, -0.04, 0.12)),
}
NAMES = list(BONES)
PARENTS = [NAMES.index(parent) if parent else -1 for parent, _ in BONES.values()]
SAMPLES, FPS = 16, 25.0
SCALE = 0.01  # of the armature: its bones are in centimetres


def armature() -> np.ndarray:
    """(4, 4) of the node above the hips: turned by −90° about x and scaled, as exports from z-up programs have it."""
    out = np.eye(4)
    out[:3, :3] = SCALE * Rotation.from_euler("x", -90, degrees=True).as_matrix()
    return out


def bind() -> np.ndarray:
    """(J, 4, 4) of the bones in the world in the bind pose; their own axes are random, their scales the armature's."""
    rng = np.random.default_rng(5)
    out = np.tile(np.eye(4), (len(NAMES), 1, 1))
    out[:, :3, :3] = SCALE * Rotation.random(len(NAMES), rng).as_matrix()
    for i, (_, offset) in enumerate(BONES.values()):
        out[i, :3, 3] = offset if PARENTS[i] < 0 else out[PARENTS[i], :3, 3] + offset
    return out


def local(world: np.ndarray) -> np.ndarray:
    """(..., J, 4, 4) in the parents' axes, the hips in the armature's."""
    above = np.stack([armature() if p < 0 else np.broadcast_to(np.eye(4), (4, 4)) for p in PARENTS])
    above = np.broadcast_to(above, world.shape).copy()
    for i, parent in enumerate(PARENTS):
        if parent >= 0:
            above[..., i, :, :] = world[..., parent, :, :]
    return np.linalg.inv(above) @ world


def moving() -> np.ndarray:
    """(T, J, 4, 4) in the world: the hips walk along z and every bone turns a little about a random axis."""
    rng = np.random.default_rng(6)
    rest = local(bind())
    axes = rng.normal(size=(len(NAMES), 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    phase = np.linspace(0, 2 * np.pi, SAMPLES)
    out = np.empty((SAMPLES, len(NAMES), 4, 4))
    for i, parent in enumerate(PARENTS):
        turn = np.tile(np.eye(4), (SAMPLES, 1, 1))
        turn[:, :3, :3] = Rotation.from_rotvec(0.3 * np.sin(phase + i)[:, None] * axes[i]).as_matrix()
        above = armature() if parent < 0 else out[:, parent]
        out[:, i] = above @ rest[i] @ turn
        if parent < 0:
            out[:, i, 2, 3] += np.linspace(0, 1.2, SAMPLES)
    return out


def in_our_axes(world: np.ndarray) -> np.ndarray:
    """(T, J, 3) [m] the bones' places with z up, facing x."""
    return np.roll(world[..., :3, 3], 1, axis=-1)
