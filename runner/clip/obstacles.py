"""The obstacles and objects of a clip's [scene] table."""

from __future__ import annotations

import numpy as np

from ..scene.compose import KINDS, Obstacle
from .table import BarTable, BoxTable, SceneTable, SphereTable, StepTable


def obstacles(scene: SceneTable) -> tuple[Obstacle, ...]:
    """Return the obstacles of a scene's tables: the step, and the others in the order of their kinds."""
    numbered = ((kind, pair) for kind in KINDS for pair in enumerate(getattr(scene, kind), start=1))
    others = (_obstacle(kind, table.name or f"{kind} {number}", table) for kind, (number, table) in numbered)
    return (*(() if scene.step is None else (_step(scene.step),)), *others)


def _step(table: StepTable) -> Obstacle:
    """Return a step: its front face is at x, its top at its height, its bottom on the ground."""
    half = (table.length / 2, table.width / 2, table.height / 2)
    return Obstacle("step", "box", half, np.array([table.x + half[0], table.y, half[2]]), np.array([1.0, 0, 0, 0]))


def _obstacle(kind: str, name: str, table: BoxTable | SphereTable | BarTable) -> Obstacle:
    ends = None
    if isinstance(table, BoxTable):
        size = tuple(0.5 * length for length in table.size)
    elif isinstance(table, SphereTable):
        size = (table.radius,)
    else:
        ends = None if table.start is None or table.end is None else np.array([*table.start, *table.end])
        size = (table.radius,) if table.length is None else (table.radius, 0.5 * table.length)
    place = np.array(table.position or (0.0, 0, 0))
    turn = np.array([1.0, 0, 0, 0]) if table.rotation is None else table.rotation.quaternion()
    return Obstacle(name, kind, size, place, turn, ends, table.color, table.body, table.mass)
