"""The vertical axis of rest poses and recordings.

The rest pose of a model built with y up lies down in MuJoCo's world. A recording has the conventional vertical axis if
the person is upright along it in enough samples. Otherwise it is an axis along which the person is upright in most
samples, and the feet are not as level along the conventional axis as on a floor.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array

CLEARLY = 0.3  # least gain in the sum of the cosines of up and left for which a rest pose is rotated
AXES, USUAL = "xyz", "y"  # and the vertical axis of BVH files
NONE = np.array([1.0, 0, 0, 0])
TO_Z = {  # rotation of an axis to z; that of y is for figures facing z, as in animation
    "z": NONE, "y": np.array([0.5, 0.5, 0.5, 0.5]), "x": np.array([0.5, -0.5, -0.5, -0.5]),
    "-z": np.array([0.0, 1, 0, 0]), "-y": np.array([0.5, -0.5, 0.5, -0.5]), "-x": np.array([0.5, -0.5, 0.5, 0.5]),
}  # fmt: skip
UPRIGHT = 0.7  # least cosine between the vertical and the line from feet to head of an upright person
SOME, MOST = 0.2, 0.5  # fractions of the samples that count as enough and as most
LEVEL = 0.25  # ratio of standard deviations of the lowest joint's height below which an axis indicates a floor


def vertical(position: Array, roles: Mapping[str, int]) -> tuple[str, tuple[str, ...]]:
    """Return the vertical axis of a recording, of "x", "-x", ..., and a note if it is not the usual one.

    position (T, J, 3) of joints; roles: joints by part of the body
    """
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles][:1]
    tops = tops or [roles[role] for role in ("pelvis",) if role in roles]
    feet = [roles[role] for role in ("left_foot", "right_foot") if role in roles]
    feet = feet or [roles[role] for role in ("left_shin", "right_shin") if role in roles]
    if not tops or not feet:
        return USUAL, ()
    along = position[:, tops].mean(axis=1) - position[:, feet].mean(axis=1)
    cosine = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    share, drift = {}, {}
    for i, name in enumerate(AXES):
        for sign, axis in ((1.0, name), (-1.0, f"-{name}")):
            share[axis] = float(np.mean(sign * cosine[:, i] > UPRIGHT))
            drift[axis] = float(np.std(np.min(sign * position[:, :, i], axis=1)))
    upright = max(share, key=lambda axis: share[axis])
    if share[USUAL] >= SOME or upright == USUAL:
        return USUAL, ()
    if share[upright] > MOST and drift[USUAL] > LEVEL * drift[upright]:
        return upright, (
            f"{upright} is up in the file: along it the person is upright at {share[upright]:.0%} of the samples",
        )
    return USUAL, (f"the person is upright along no axis of the file; {USUAL} is taken as up, the usual axis",)


def standing_turn(place: Array, roles: Mapping[str, int]) -> tuple[Array, tuple[str, ...]]:
    """Return the rotation (4,) by multiples of 90° with which a rest pose stands upright and faces x, and a note.

    place (nbody, 3) [m] of bodies at rest; roles: bodies by part. Upright, the head is above the hips, these are above
    the feet, and the left hip is to the left. A figure without identified legs is taken to stand.
    """
    thighs, ends = ([roles.get(f"{side}_{part}") for side in ("left", "right")] for part in ("thigh", "foot"))
    ends = [
        end if end is not None else roles.get(f"{side}_shin") for end, side in zip(ends, ("left", "right"), strict=True)
    ]
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles]
    if None in thighs or None in ends:
        return NONE, ()
    hips, feet = (place[np.array(bodies, int)].mean(axis=0) for bodies in (thighs, ends))
    up = unit(hips - feet) + (unit(place[tops].mean(axis=0) - hips) if tops else 0.0)
    leftward = unit(place[thighs[0]] - place[thighs[1]])
    turns = Rotation.create_group("O")
    score = turns.apply(unit(up))[:, 2] + turns.apply(leftward)[:, 1]
    best = int(np.argmax(score))
    if score[best] - (unit(up)[2] + leftward[1]) < CLEARLY:
        return NONE, ()
    turn = turns[best]
    was_up = turn.inv().apply([0, 0, 1])
    axis = int(np.argmax(np.abs(was_up)))
    name = ("-" if was_up[axis] < 0 else "") + AXES[axis]
    notes = (
        () if name == "z" else (f"the figure's rest pose has {name} up, and lies down in the model's world: stood up",)
    )
    return turn.as_quat(scalar_first=True), notes


def unit(vector: Array) -> Array:
    """Return a vector (3,) scaled to length 1; zero stays zero."""
    return vector / max(float(np.linalg.norm(vector)), 1e-12)
