"""Obstacles and objects of a clip's [scene]. An object keeps its position until a hand grasps it.

A keyframe that does not specify an object's pose has that of the previous keyframe. The keyframes before the first
specified pose have this pose. If a [[grasp]] moves an object in between, it is free, independent of `others`.
"""

from __future__ import annotations

import numpy as np

from dynsplines.solver.contacts import ROUNDING

from ..scene.obstacle import KINDS, Obstacle
from .posing.rotation import quaternion_of
from .table import BarTable, BoxTable, ClipTable, KeyframeTable, RootTable, SceneTable, SphereTable, StepTable

FREE = RootTable(position="free", rotation="free")


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
    turn = np.array([1.0, 0, 0, 0]) if table.rotation is None else quaternion_of(table.rotation)
    return Obstacle(name, kind, size, place, turn, ends, table.color, table.body, table.mass)


def objects(scene: SceneTable) -> tuple[str, ...]:
    """Return the names of the bodies that a scene's tables define."""
    parts = (*scene.box, *scene.sphere, *scene.capsule, *scene.cylinder)
    return tuple(dict.fromkeys(part.body for part in parts if part.body is not None))


def lying(table: ClipTable) -> list[KeyframeTable]:
    """Return a clip's keyframes with the positions of objects that nothing has moved since the previous keyframe.

    In a clip that follows a recording, the recording places them.
    """
    rows = list(table.keyframe)
    for name in objects(table.scene) if table.recording is None else ():
        time, place = rows[0].time, _first(table, name)
        for k, row in enumerate(rows):
            if name in row.roots:
                place = row.roots[name]
            else:
                place = FREE if _is_carried(table, name, time, row.time) else place
                rows[k] = row.model_copy(update={"roots": row.roots | {name: place}})
            time = row.time
    return rows


def _first(table: ClipTable, name: str) -> RootTable:
    """Return the initial position of an object: that of the first keyframe that places it, unless it is held before."""
    row = next((row for row in table.keyframe if name in row.roots), None)
    if row is None or _is_carried(table, name, table.keyframe[0].time, row.time):
        return FREE
    return row.roots[name]


def _is_carried(table: ClipTable, name: str, first: float, last: float) -> bool:
    """Return whether an object is held at any time of an interval."""
    grasps = (grasp for grasp in table.grasp if grasp.body == name)
    return any(max(grasp.start, first) < min(grasp.end, last) - ROUNDING for grasp in grasps)
