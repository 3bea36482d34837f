"""Rotations in the notation of clips: rotation vectors, Euler angles in degrees, quaternions, and a heading."""

from __future__ import annotations

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ..table import RotationTable

UP = np.array([0.0, 0.0, 1.0])


def quaternion_of(table: RotationTable) -> Array:
    """Return the quaternion (4,) wxyz of a rotation in the world; a heading rotates the rest about the vertical."""
    if table.heading is None:
        return _without_heading(table)
    heading = quat.from_rotation_vector(np.radians(table.heading) * UP)
    return heading if table.is_heading else quat.product(heading, _without_heading(table))


def _without_heading(table: RotationTable) -> Array:
    if table.rotvec is not None:
        return quat.from_rotation_vector(np.radians(table.rotvec))
    if table.quat is not None:
        return quat.normalised(table.quat)
    return quat.from_euler(np.radians(table.euler or []), table.order or "xyz")
