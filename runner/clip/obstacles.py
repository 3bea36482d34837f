"""The obstacles that a clip's [scene] tables describe."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dynsplines.solver.array import Array

from ..errors import UserError
from ..scene.obstacle import KINDS, Obstacle
from .posing.rotation import quaternion_of
from .table import BarTable, BoxTable, SceneTable, SphereTable

SHORTEST = 1e-4  # [m] from end to end


def obstacles(scene: SceneTable) -> tuple[Obstacle, ...]:
    """The obstacles of a scene's tables, in the order of their kinds."""
    return tuple(_obstacles(scene))


def _obstacles(scene: SceneTable) -> Iterator[Obstacle]:
    for kind in KINDS:
        for number, table in enumerate(getattr(scene, kind), start=1):
            name = table.name or f"{kind} {number}"
            where = f"scene.{kind} {number}" + (f" ('{table.name}')" if table.name else "")
            yield _one(kind, name, table, where)


def _one(kind: str, name: str, table: BoxTable | SphereTable | BarTable, where: str) -> Obstacle:
    ends = None
    if isinstance(table, BoxTable):
        size = tuple(0.5 * length for length in table.size)
    elif isinstance(table, SphereTable):
        size = (table.radius,)
    else:
        ends = _ends(table, where)
        size = (table.radius,) if table.length is None else (table.radius, 0.5 * table.length)
    if table.mass is not None and table.body is None:
        raise UserError(f"{where}: 'mass' is for parts of a body that moves; name it by body = '...'")
    if table.position is None and ends is None and table.body is None:
        raise UserError(f"{where}: 'position' is missing")
    place = np.array(table.position or (0.0, 0, 0))
    turn = np.array([1.0, 0, 0, 0]) if table.rotation is None else quaternion_of(table.rotation, f"{where}: rotation")
    return Obstacle(name, kind, size, place, turn, ends, table.color, table.body, table.mass)


def _ends(table: BarTable, where: str) -> Array | None:
    """Where a capsule or cylinder goes from and to, or None if it lies about its position."""
    about = [name for name in ("position", "length", "rotation") if getattr(table, name) is not None]
    if table.start is None and table.end is None:
        if table.length is None:
            raise UserError(f"{where}: give position and length, or from and to")
        return None
    if table.start is None or table.end is None:
        raise UserError(f"{where}: 'from' and 'to' go together")
    if about:
        raise UserError(f"{where}: give from and to, or position and length, not both ('{about[0]}' and 'from')")
    ends = np.array([*table.start, *table.end])
    if np.linalg.norm(ends[3:] - ends[:3]) < SHORTEST:
        raise UserError(f"{where}: from and to are the same point")
    return ends
