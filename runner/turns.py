"""Rotations as a clip file gives them, in degrees, as unit quaternions."""

from __future__ import annotations

import numpy as np

from solver import quaternion as quat
from solver.quaternion import Array

from .clip_table import RotationTable
from .errors import UserError


def rotation(table: RotationTable, place: str) -> Array:
    """The unit quaternion wxyz of a rotation given in degrees."""
    given = [name for name in ("rotvec", "euler", "quat") if getattr(table, name) is not None]
    if len(given) != 1:
        raise UserError(f"{place}: give exactly one of rotvec, euler, quat, not {' and '.join(given) or 'none'}")
    if table.order is not None and table.euler is None:
        raise UserError(f"{place}: order goes with euler, not with {given[0]}")
    if table.rotvec is not None:
        return quat.from_rotation_vector(np.radians(table.rotvec))
    if table.quat is not None:
        if np.linalg.norm(table.quat) < 1e-6:
            raise UserError(f"{place}: the quaternion is zero")
        return quat.normalised(table.quat)
    order, angles = "xyz" if table.order is None else table.order, table.euler or []
    if not order or set(order) - set("xyz") or len(order) != len(angles):
        raise UserError(
            f"{place}: euler has {len(angles)} angles and order = '{order}'; order names an axis x, y or z for each"
        )
    out = np.array([1.0, 0, 0, 0])
    for letter, angle in zip(order, np.radians(angles), strict=True):
        out = quat.product(out, quat.from_rotation_vector(angle * np.eye(3)["xyz".index(letter)]))
    return out
