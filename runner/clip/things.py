"""Things of a clip's scene that move, a crate or a ball: they lie where they were put until somebody holds them.

A keyframe that says nothing of such a thing has it where the keyframe before has it, or the first ones where the first
that says it does, unless a [[hold]] has carried it in between: then it is free whatever `others` says, and goes with
the hands.
"""

from __future__ import annotations

from .contacts import ROUNDING
from .table import ClipTable, KeyframeTable, RootTable, SceneTable

FREE = RootTable(position="free", rotation="free")


def things(scene: SceneTable) -> tuple[str, ...]:
    """The names of the bodies that a scene's tables make."""
    parts = (*scene.box, *scene.sphere, *scene.capsule, *scene.cylinder)
    return tuple(dict.fromkeys(part.body for part in parts if part.body is not None))


def lying(table: ClipTable) -> list[KeyframeTable]:
    """A clip's keyframes, with the places of things that nothing has moved since the keyframe before; in a clip that
    follows a recording things go with that, as all else does."""
    rows = list(table.keyframe)
    if table.recording is not None:  # where they are says the recording
        return rows
    for name in things(table.scene):
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
    """Where a thing is from the first keyframe on: where the first that says it has it, if nothing holds it before."""
    said = next((row for row in table.keyframe if name in row.roots), None)
    if said is None or _is_carried(table, name, table.keyframe[0].time, said.time):
        return FREE
    return said.roots[name]


def _is_carried(table: ClipTable, name: str, first: float, last: float) -> bool:
    """Whether something holds a thing at a time between two."""
    held = (hold for hold in table.hold if hold.body == name)
    return any(max(hold.start, first) < min(hold.end, last) - ROUNDING for hold in held)
