"""Equality constraints of a model, enforced in the unspecified entries of keyframes."""

from __future__ import annotations

from collections.abc import Callable

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import couplings
from dynsplines.solver.penalty.joints.coupling import Coupling, in_order


def follow(figure: Figure, qpos: Array, fixed: Mask, is_named: Callable[[str], bool]) -> None:
    """Set the followers of coupled joints in a keyframe, qpos and mask, in place.

    A joint that the keyframe names is unchanged. If it names the follower and not the driver, the driver is set.
    """
    names = {link.qpos: link.name for link in figure.links[1:]}
    for coupling in in_order(couplings(figure)):
        driver = coupling.driver
        if not is_named(names[coupling.follower]):
            if driver < 0 or fixed[driver]:
                qpos[coupling.follower] = coupling.follow(qpos[driver] if driver >= 0 else np.zeros(()))
                fixed[coupling.follower] = True
        elif driver >= 0 and not is_named(names[driver]) and fixed[coupling.follower]:
            back = _driven(coupling, float(qpos[coupling.follower]))
            if back is not None:
                qpos[driver], fixed[driver] = back, True


def _driven(coupling: Coupling, follower: float) -> float | None:
    """Return the driver's value for a follower's value; None unless the relation is linear."""
    a = coupling.coefficients
    if a[1] == 0 or np.any(a[2:]):
        return None
    return coupling.rest[1] + (follower - coupling.rest[0] - float(a[0])) / float(a[1])


def unsupported(model: mujoco.MjModel) -> list[str]:
    """Return a note on equality constraints of kinds that are not looked at."""
    handled = [int(kind) for kind in (mujoco.mjtEq.mjEQ_JOINT, mujoco.mjtEq.mjEQ_CONNECT, mujoco.mjtEq.mjEQ_WELD)]
    others = [i for i in range(model.neq) if model.eq_active0[i] and int(model.eq_type[i]) not in handled]
    names = ", ".join(f"'{model.equality(i).name or i}'" for i in others)
    return [f"equality constraints of tendons are not looked at: {names}"] if others else []
