"""Edits of obstacles: step, boxes, balls and bars."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...errors import UserError
from .tables import Blocks, add, item, numbers, put

EDITS = ("add_obstacle", "set_obstacle", "delete_obstacle")


NEW: dict[str, dict[str, Any]] = {  # the entries of a new obstacle [m]
    "step": {"x": 0.5, "height": 0.2},
    "box": {"position": [0.6, 0.0, 0.2], "size": [0.4, 0.4, 0.4]},
    "sphere": {"position": [0.6, 0.0, 0.2], "radius": 0.2},
    "capsule": {"position": [0.6, 0.0, 0.9], "length": 1.0, "radius": 0.03},
    "cylinder": {"position": [0.6, 0.0, 0.25], "length": 0.5, "radius": 0.15},
}


def add_obstacle(tree: Blocks, *, kind: str, at: list[float] | None = None) -> str:
    """Add an obstacle near a position [m]; there is at most one step."""
    if kind not in NEW:
        raise UserError(f"no obstacle '{kind}'; there are: {', '.join(NEW)}")
    entries = NEW[kind].copy()
    if at is not None and "position" in entries:
        entries["position"] = [*numbers(at, "the position", 2), entries["position"][2]]
    if kind != "step":
        if kind in (tree.table("scene") or {}) and not tree.rows("scene", kind):
            raise UserError(f"'scene.{kind}' is written as a list; write [[scene.{kind}]] tables to add one here")
        add(tree, ("scene", kind), entries)
        return f"add a {kind}"
    if tree.table("scene", "step") is not None:
        raise UserError("the clip already has a step, and at most one is allowed; add a box instead")
    scene = tree.table("scene", make=True)
    scene.append("step", item({**entries, "x": round(float(at[0]), 2) if at else entries["x"]}))
    return "add a step"


def set_obstacle(tree: Blocks, *, kind: str, index: int, entries: Mapping[str, Any]) -> str:
    """Set entries of an obstacle; None removes an entry."""
    table = _obstacle_row(tree, kind, index)
    for key, value in entries.items():
        if value is not None:
            put(table, key, value)
        elif key in table:
            del table[key]
    return f"change the {kind}"


def delete_obstacle(tree: Blocks, *, kind: str, index: int) -> str:
    """Remove an obstacle."""
    _obstacle_row(tree, kind, index)
    block = next(
        (candidate for candidate in tree.blocks if not candidate.is_row and candidate.path == ("scene", "step")), None
    )
    if kind == "step" and block is None:
        del tree.table("scene")["step"]
    else:
        tree.remove(block if kind == "step" and block is not None else tree.rows("scene", kind)[index])
    return f"delete a {kind}"


def _obstacle_row(tree: Blocks, kind: str, index: int) -> Any:
    """Return the table of an obstacle. Raises UserError if there is none."""
    if kind == "step":
        table = tree.table("scene", "step")
    else:
        rows = tree.rows("scene", kind)
        table = rows[index].table if 0 <= index < len(rows) else None
    if table is None:
        raise UserError(f"there is no {kind} {index + 1} any more")
    return table
