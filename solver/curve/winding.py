"""Winding: which way round a joint turns from one keyframe to the next, that is, the signs of its quaternions.

A joint takes the shortest arc, *relative to its parent*: near a half turn of the whole figure a limb's own arc in the
world can be short the other way, which would tear it off. So does a free body, but where its shortest arc is nearly a
half turn and the other way round is hardly longer: there it turns the way that changes its angular velocity least, as
a body in a spin goes on spinning.
"""

from __future__ import annotations

import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask

NEARLY_HALF = np.radians(150.0)
TINY = 1e-9  # [rad] a turn that has no axis


def signs(times: Array, relative: Array, *, spins: bool) -> Array:
    """(K,) ±1 for the quaternions (K, 4) of a joint at key times (K,) [s], any length > 0; the first keeps its own.

    spins  whether the joint is a free body's, which may go on past a half turn
    """
    same = np.einsum("ki,ki->k", relative[1:], relative[:-1]) >= 0
    if not spins:
        return np.append(1.0, np.cumprod(np.where(same, 1.0, -1.0)))
    steps = quat.rotation_vector(quat.product(quat.inverse(relative[:-1]), relative[1:]))
    angle = np.linalg.norm(steps, axis=1)
    longer = np.zeros(angle.size, bool)
    unsure = angle > NEARLY_HALF
    if unsure.any():
        longer = _steadiest(times, steps, angle, unsure)
    return np.append(1.0, np.cumprod(np.where(same != longer, 1.0, -1.0)))


def _steadiest(times: Array, steps: Array, angle: Array, unsure: Mask) -> Mask:
    """(K − 1,) which unsure segments go the longer way round: the least Σ |Δω|²/Δt over all choices, by recursion.

    steps  (K − 1, 3) the shortest arcs [rad], in the joint's own axes at either end of a segment
    """
    spans = np.diff(times)
    rates = np.stack([steps, steps - 2 * np.pi * steps / np.maximum(angle, TINY)[:, None]], axis=1)
    rates /= spans[:, None, None]
    cost = np.array([0.0, 0.0 if unsure[0] else np.inf])
    came = np.zeros((spans.size, 2), int)
    for k in range(1, spans.size):
        change = rates[k][None, :] - rates[k - 1][:, None]
        by_way = cost[:, None] + 2 * np.einsum("abi,abi->ab", change, change) / (spans[k] + spans[k - 1])
        came[k] = by_way.argmin(axis=0)
        cost = by_way.min(axis=0)
        if not unsure[k]:
            cost[1] = np.inf
    way = np.zeros(spans.size, int)
    way[-1] = int(cost[1] < cost[0])
    for k in range(spans.size - 1, 0, -1):
        way[k - 1] = came[k, way[k]]
    return way > 0
