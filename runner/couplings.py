"""Equality constraints of a model: which joints follow others, and what else there is."""

from __future__ import annotations

import mujoco
import numpy as np

JOINT = int(mujoco.mjtEq.mjEQ_JOINT)


def active(model: mujoco.MjModel, kind: int) -> list[int]:
    """The equality constraints of one kind that are on."""
    return [int(i) for i in np.flatnonzero((model.eq_type == kind) & (model.eq_active0 != 0))]


def dependents(model: mujoco.MjModel) -> list[int]:
    """The joints that follow another, or stay, by equality constraints."""
    return [int(model.eq_obj1id[i]) for i in active(model, JOINT)]
