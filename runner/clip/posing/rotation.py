"""Rotations in the notation of clips: rotation vectors, Euler angles in degrees, quaternions, and a heading."""

from __future__ import annotations

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ..table import RotationTable

UP = np.array([0.0, 0.0, 1.0])
IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])


def quaternion_of(table: RotationTable, rest: Array = IDENTITY) -> Array:
    """Return the quaternion (4,) wxyz of a rotation. A heading rotates the other notation of the table about the
    vertical; without one, it rotates the orientation in the rest pose, `rest` (4,) wxyz."""
    other = rest if table.is_heading else _without_heading(table)
    if table.heading is None:
        return other
    return quat.product(quat.from_rotation_vector(np.radians(table.heading) * UP), other)


def _without_heading(table: RotationTable) -> Array:
    if table.rotvec is not None:
        return quat.from_rotation_vector(np.radians(table.rotvec))
    if table.quat is not None:
        return quat.normalised(table.quat)
    return quat.from_euler(np.radians(table.euler or []), table.order or "xyz")
