"""Quaternions as three angles about the axes, one after the other, without jumps from instant to instant.

Angles (a, b, c) of an order "ZYX" are R = Rz(a) Ry(b) Rx(c). Of the two triples of a rotation and their full turns the
nearest to the one before is taken; where the middle angle is a right angle, c is what it was.
"""

from __future__ import annotations

import numpy as np

from dynsplines.solver.array import Array

LOCKED = 1e-7  # sine of the distance from where two axes fall together


def matrices(q: Array) -> Array:
    """(..., 3, 3) of unit quaternions (..., 4), wxyz."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    return np.stack(
        [
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], axis=-1),
            np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], axis=-1),
            np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=-1),
        ],
        axis=-2,
    )


def angles(q: Array, order: str) -> Array:
    """(T, 3) [rad] of a track (T, 4) in an order of three different axes."""
    i, j, k = ("XYZ".index(axis) for axis in order)
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    turn = matrices(q)
    middle = np.arctan2(sign * turn[:, i, k], np.hypot(turn[:, i, i], turn[:, i, j]))
    first = np.arctan2(-sign * turn[:, j, k], turn[:, k, k])
    last = np.arctan2(-sign * turn[:, i, j], turn[:, i, i])
    locked = np.hypot(turn[:, i, i], turn[:, i, j]) < LOCKED
    both = np.arctan2(sign * turn[:, k, j], turn[:, j, j])  # a + side c
    side = np.sign(turn[:, i, k])
    out = np.stack([first, middle, last], axis=-1)
    before = np.zeros(3)
    for row in range(len(out)):
        if locked[row]:
            out[row] = [both[row] - side[row] * before[2], middle[row], before[2]]
        other = np.array([out[row, 0] + np.pi, np.pi - out[row, 1], out[row, 2] + np.pi])
        near = [each - 2 * np.pi * np.round((each - before) / (2 * np.pi)) for each in (out[row], other)]
        out[row] = before = min(near, key=lambda each: float(np.abs(each - before).sum()))
    return out
