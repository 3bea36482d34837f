"""Which way is up: in a model's rest pose, which lies down in MuJoCo's world where it is built y up, and in recordings.

A recording's vertical is the axis along which the person is upright at most samples. Without one it is the axis by
convention, unless along another the lowest joint is much more often at the same height, as if on a floor.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array

CLEARLY = 0.3  # by which the cosines of up and left, summed, must be better in another orientation
AXES = "xyz"
NONE = np.array([1.0, 0, 0, 0])
TO_Z = {  # the turn that takes an axis to z; y as animators have it, where a figure looks along z
    "z": NONE, "y": np.array([0.5, 0.5, 0.5, 0.5]), "x": np.array([0.5, -0.5, -0.5, -0.5]),
    "-z": np.array([0.0, 1, 0, 0]), "-y": np.array([0.5, -0.5, 0.5, -0.5]), "-x": np.array([0.5, -0.5, 0.5, 0.5]),
}  # fmt: skip
UPRIGHT = 0.7  # cosine to the vertical of a person that counts as upright, from feet to head
SOME, MOST = 0.2, 0.5  # of the samples
LEVEL = 0.25  # of how much the lowest joint goes up and down by the convention, less of which indicates a floor


def vertical(position: Array, roles: Mapping[str, int], usual: str) -> tuple[str, tuple[str, ...]]:
    """The axis that is up in a recording, of "x", "-x", ..., and a note if it is not the usual one.

    position (T, J, 3) of joints, roles which joint is which part; usual, the axis by convention
    """
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles][:1]
    tops = tops or [roles[role] for role in ("pelvis",) if role in roles]
    feet = [roles[role] for role in ("left_foot", "right_foot") if role in roles]
    feet = feet or [roles[role] for role in ("left_shin", "right_shin") if role in roles]
    if not tops or not feet:
        return usual, ()
    along = position[:, tops].mean(axis=1) - position[:, feet].mean(axis=1)
    cosine = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    share, drift = {}, {}
    for i, name in enumerate(AXES):
        for sign, axis in ((1.0, name), (-1.0, f"-{name}")):
            share[axis] = float(np.mean(sign * cosine[:, i] > UPRIGHT))
            drift[axis] = float(np.std(np.min(sign * position[:, :, i], axis=1)))
    upright = max(share, key=lambda axis: share[axis])
    if share[usual] >= SOME or upright == usual:
        return usual, ()
    if share[upright] > MOST and drift[usual] > LEVEL * drift[upright]:
        return upright, (
            f"{upright} is up in the file: along it the person is upright at {share[upright]:.0%} of the samples",
        )
    level = min((axis for axis in share if share[axis] > share[usual]), key=lambda axis: drift[axis], default=usual)
    if drift[level] < LEVEL * drift[usual]:
        return level, (f"{level} is taken as up in the file: along it the lowest joint stays at one height",)
    return usual, (f"the person is upright along no axis of the file; {usual} is taken as up, the usual axis",)


def standing_turn(place: Array, roles: Mapping[str, int]) -> tuple[Array, tuple[str, ...]]:
    """(4,) the turn by multiples of 90° that stands a rest pose upright, facing x with y to its left, and a note.

    place (nbody, 3) [m] of bodies at rest, roles which body is which part. The head is above the hips and these above
    the feet; the left hip is to the left. A figure without known legs is taken to stand.
    """
    none = NONE
    thighs, ends = ([roles.get(f"{side}_{part}") for side in ("left", "right")] for part in ("thigh", "foot"))
    ends = [
        end if end is not None else roles.get(f"{side}_shin") for end, side in zip(ends, ("left", "right"), strict=True)
    ]
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles]
    if None in thighs or None in ends:
        return none, ()
    hips, feet = (place[np.array(bodies, int)].mean(axis=0) for bodies in (thighs, ends))
    up = unit(hips - feet) + (unit(place[tops].mean(axis=0) - hips) if tops else 0.0)
    leftward = unit(place[thighs[0]] - place[thighs[1]])
    turns = Rotation.create_group("O")
    score = turns.apply(unit(up))[:, 2] + turns.apply(leftward)[:, 1]
    best = int(np.argmax(score))
    if score[best] - (unit(up)[2] + leftward[1]) < CLEARLY:
        return none, ()
    turn = turns[best]
    was_up = turn.inv().apply([0, 0, 1])
    axis = int(np.argmax(np.abs(was_up)))
    name = ("-" if was_up[axis] < 0 else "") + AXES[axis]
    notes = (
        () if name == "z" else (f"the figure's rest pose has {name} up, and lies down in the model's world: stood up",)
    )
    return turn.as_quat(scalar_first=True), notes


def unit(vector: Array) -> Array:
    """Return a vector (3,) of length 1, or zero."""
    return vector / max(float(np.linalg.norm(vector)), 1e-12)
