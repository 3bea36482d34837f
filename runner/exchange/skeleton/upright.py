"""Which way is up in a model's rest pose: some models are built y up, as SMPL's are, and lie down in MuJoCo's world."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array

CLEARLY = 0.3  # by which the cosines of up and left, summed, must be better in another orientation
AXES = "xyz"


def standing_turn(place: Array, roles: Mapping[str, int]) -> tuple[Array, tuple[str, ...]]:
    """(4,) the turn by multiples of 90° that stands a rest pose upright, facing x with y to its left, and a note.

    place (nbody, 3) [m] of bodies at rest, roles which body is which part. The head is above the hips and these above
    the feet; the left hip is to the left. A figure without known legs is taken to stand.
    """
    none = np.array([1.0, 0, 0, 0])
    thighs, ends = ([roles.get(f"{side}_{part}") for side in ("left", "right")] for part in ("thigh", "foot"))
    ends = [
        end if end is not None else roles.get(f"{side}_shin") for end, side in zip(ends, ("left", "right"), strict=True)
    ]
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles]
    if None in thighs or None in ends:
        return none, ()
    hips, feet = (place[np.array(bodies, int)].mean(axis=0) for bodies in (thighs, ends))
    up = _unit(hips - feet) + (_unit(place[tops].mean(axis=0) - hips) if tops else 0.0)
    left = _unit(place[thighs[0]] - place[thighs[1]])
    turns = Rotation.create_group("O")
    score = turns.apply(_unit(up))[:, 2] + turns.apply(left)[:, 1]
    best = int(np.argmax(score))
    if score[best] - (_unit(up)[2] + left[1]) < CLEARLY:
        return none, ()
    turn = turns[best]
    was_up = turn.inv().apply([0, 0, 1])
    axis = int(np.argmax(np.abs(was_up)))
    name = ("-" if was_up[axis] < 0 else "") + AXES[axis]
    notes = (
        () if name == "z" else (f"the figure's rest pose has {name} up, and lies down in the model's world: stood up",)
    )
    return turn.as_quat(scalar_first=True), notes


def _unit(vector: Array) -> Array:
    return vector / max(float(np.linalg.norm(vector)), 1e-12)
