"""Equality constraints of a model: enforced in the unspecified entries of keyframes, otherwise reported."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import CouplingPenalty, LoopClosure, closures, couplings
from dynsplines.solver.penalty.joints.coupling import Coupling, in_order
from dynsplines.solver.surface.points import placed

BROKEN = {"degrees": np.radians(0.1), "m": 1e-4}  # [rad, m] least deviation from a coupling that is reported
TORN = 1e-3  # [m] least gap of a closed loop that is reported


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


def complaints(figure: Figure, keys: Timeline, frames: Sequence[Frame]) -> list[str]:
    """Return a note for every constraint that keyframes violate, and for ignored constraints."""
    samples = Samples.still(figure, keys.states)
    notes = []
    joined = couplings(figure)
    if joined:
        away, _ = CouplingPenalty(joined).away(samples)
        for coupling, off in zip(joined, away, strict=True):
            is_fixed = keys.fixed[:, coupling.follower] & ((coupling.driver < 0) | keys.fixed[:, coupling.driver])
            k = int(np.argmax(np.abs(off) * is_fixed))
            if is_fixed[k] and abs(off[k]) > BROKEN[coupling.unit]:
                far = np.degrees(off[k]) if coupling.unit == "degrees" else off[k]
                notes.append(
                    f"keyframe {k + 1} (t = {frames[k].time:g} s) has '{coupling.name}' {abs(far):.3g} {coupling.unit} "
                    "off where the model's equality constraint requires it"
                )
    loops = closures(figure)
    if loops:
        apart = np.linalg.norm(LoopClosure(loops).gaps(samples), axis=0)
        both = placed(figure, keys.fixed, [c.one for c in loops]) & placed(figure, keys.fixed, [c.two for c in loops])
        n, k = (int(i) for i in np.unravel_index(np.argmax(apart * both), apart.shape))
        if both[n, k] and apart[n, k] > TORN:
            notes.append(
                f"keyframe {k + 1} (t = {frames[k].time:g} s) tears the loop of {loops[n].name} "
                f"apart by {1000 * apart[n, k]:.3g} mm"
            )
    return notes + _unseen(figure.model)


def _unseen(model: mujoco.MjModel) -> list[str]:
    """Return a note on equality constraints of other kinds."""
    handled = [int(kind) for kind in (mujoco.mjtEq.mjEQ_JOINT, mujoco.mjtEq.mjEQ_CONNECT, mujoco.mjtEq.mjEQ_WELD)]
    others = [i for i in range(model.neq) if model.eq_active0[i] and int(model.eq_type[i]) not in handled]
    names = ", ".join(f"'{model.equality(i).name or i}'" for i in others)
    return [f"equality constraints of tendons are not looked at: {names}"] if others else []
