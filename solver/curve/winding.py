"""Winding: the direction in which a joint turns between keyframes, determined by the signs of its quaternions.

A joint takes the shortest arc *relative to its parent*. Near a half turn of the whole figure, a limb's shortest arc in
the world may be opposite to its parent's, which would tear the limb off. A free body also takes the shortest arc,
unless that is nearly a half turn. Then it turns in the direction that changes its angular velocity least, so that a
spinning body continues to spin.
"""

from __future__ import annotations

import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask
from ..tolerances import ROUNDING

NEARLY_HALF = np.radians(150.0)  # [rad] angle above which a free body's direction of rotation is ambiguous


def signs(times: Array, relative: Array, *, spins: bool) -> Array:
    """Return the signs of a joint's quaternions; that of the first is +1.

    Args:
        times: Times of the keyframes, (K,) [s].
        relative: Quaternions relative to the parent, of any length > 0, (K, 4).
        spins: Whether the joint is a free body's, which may turn by more than a half turn.

    Returns:
        ±1, (K,).
    """
    same = np.einsum("ki,ki->k", relative[1:], relative[:-1]) >= 0
    if not spins:
        return np.append(1.0, np.cumprod(np.where(same, 1.0, -1.0)))
    steps = quat.rotation_vector(quat.product(quat.inverse(relative[:-1]), relative[1:]))
    angle = np.linalg.norm(steps, axis=1)
    longer = np.zeros(angle.size, bool)
    is_ambiguous = angle > NEARLY_HALF
    if is_ambiguous.any():
        longer = _steadiest(times, steps, angle, is_ambiguous)
    return np.append(1.0, np.cumprod(np.where(same != longer, 1.0, -1.0)))


def _steadiest(times: Array, steps: Array, angle: Array, unsure: Mask) -> Mask:
    """Return which ambiguous segments take the longer arc: the least Σ |Δω|²/Δt over all choices, by recursion.

    Args:
        times: (K,) [s].
        steps: The shortest arcs, (K − 1, 3) [rad], in the joint's own axes at either end of a segment.
        angle: Their angles, (K − 1,) [rad].
        unsure: The ambiguous segments, (K − 1,).
    """
    spans = np.diff(times)
    rates = np.stack([steps, steps - 2 * np.pi * steps / np.maximum(angle, ROUNDING)[:, None]], axis=1)
    rates /= spans[:, None, None]
    cost = np.array([0.0, 0.0 if unsure[0] else np.inf])
    previous = np.zeros((spans.size, 2), int)
    for k in range(1, spans.size):
        change = rates[k][None, :] - rates[k - 1][:, None]
        by_choice = cost[:, None] + 2 * np.einsum("abi,abi->ab", change, change) / (spans[k] + spans[k - 1])
        previous[k] = by_choice.argmin(axis=0)
        cost = by_choice.min(axis=0)
        if not unsure[k]:
            cost[1] = np.inf
    choice = np.zeros(spans.size, int)
    choice[-1] = int(cost[1] < cost[0])
    for k in range(spans.size - 1, 0, -1):
        choice[k - 1] = previous[k, choice[k]]
    return choice > 0
