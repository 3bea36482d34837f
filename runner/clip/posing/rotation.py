"""Rotations as a clip file writes them: rotation vectors, Euler angles in degrees, quaternions, and a heading."""

from __future__ import annotations

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError
from ..table import RotationTable

UP = np.array([0.0, 0.0, 1.0])


def quaternion_of(table: RotationTable, where: str) -> Array:
    """The unit quaternion wxyz of a rotation in the world, given in degrees: the heading turns all else, if there is
    anything else, about the vertical."""
    if table.heading is None:
        return plain_quaternion(table, where)
    heading = quat.from_rotation_vector(np.radians(table.heading) * UP)
    others = table.model_fields_set & {"rotvec", "euler", "quat", "order"}
    return quat.product(heading, plain_quaternion(table, where)) if others else heading


def plain_quaternion(table: RotationTable, where: str) -> Array:
    """The unit quaternion wxyz of a rotation given in degrees, whatever its heading."""
    given = [name for name in ("rotvec", "euler", "quat") if getattr(table, name) is not None]
    if len(given) != 1:
        raise UserError(f"{where}: give exactly one of rotvec, euler, quat, not {' and '.join(given) or 'none'}")
    if table.order is not None and table.euler is None:
        raise UserError(f"{where}: order goes with euler, not with {given[0]}")
    if table.rotvec is not None:
        return quat.from_rotation_vector(np.radians(table.rotvec))
    if table.quat is not None:
        if np.linalg.norm(table.quat) < 1e-6:
            raise UserError(f"{where}: the quaternion is zero")
        return quat.normalised(table.quat)
    order, angles = "xyz" if table.order is None else table.order, table.euler or []
    if not order or set(order) - set("xyz") or len(order) != len(angles):
        raise UserError(
            f"{where}: euler has {len(angles)} angles and order = '{order}'; order names an axis x, y or z for each"
        )
    out = np.array([1.0, 0, 0, 0])
    for letter, angle in zip(order, np.radians(angles), strict=True):
        out = quat.product(out, quat.from_rotation_vector(angle * np.eye(3)["xyz".index(letter)]))
    return out
