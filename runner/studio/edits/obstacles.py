"""Edits of what stands about: step, boxes, balls and bars."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import tomlkit
from tomlkit import TOMLDocument

from ...errors import UserError
from .tables import DIGITS, fresh, item, put

EDITS = ("add_obstacle", "set_obstacle", "delete_obstacle")
NEW: dict[str, dict[str, Any]] = {
    "step": {"x": 0.5, "height": 0.2},
    "box": {"position": [0.6, 0.0, 0.2], "size": [0.4, 0.4, 0.4]},
    "sphere": {"position": [0.6, 0.0, 0.2], "radius": 0.2},
    "capsule": {"position": [0.6, 0.0, 0.9], "length": 1.0, "radius": 0.03},
    "cylinder": {"position": [0.6, 0.0, 0.25], "length": 0.5, "radius": 0.15},
}


def _scene(tree: TOMLDocument) -> Any:
    if "scene" not in tree:
        tree.append("scene", tomlkit.table(is_super_table=True))
    return tree["scene"]


def add_obstacle(tree: TOMLDocument, *, kind: str, at: list[float] | None = None) -> str:
    """A new thing in the way, near a place [m]; there is one step at most."""
    if kind not in NEW:
        raise UserError(f"no obstacle '{kind}'; there are: {', '.join(NEW)}")
    said, scene = dict(NEW[kind]), _scene(tree)
    if at is not None and "position" in said:
        said["position"] = [round(float(at[0]), DIGITS), round(float(at[1]), DIGITS), said["position"][2]]
    if kind == "step":
        if "step" in scene:
            raise UserError("there is a step already; a clip has one at most, and boxes beside it")
        scene.append("step", item({**said, "x": round(float(at[0]), 2) if at else said["x"]}))
    elif kind in scene:
        scene[kind].append(fresh(said))
    else:
        rows = tomlkit.aot()
        rows.append(fresh(said))
        scene.append(kind, rows)
    return f"add a {kind}"


def set_obstacle(tree: TOMLDocument, *, kind: str, index: int, said: Mapping[str, Any]) -> str:
    """What an obstacle says of its place and size; None takes an entry away."""
    table = _found(tree, kind, index)
    for key, value in said.items():
        if value is None:
            if key in table:
                del table[key]
        elif key in table:
            put(table, key, value)
        else:
            table.append(key, item(value))
    return f"change the {kind}"


def delete_obstacle(tree: TOMLDocument, *, kind: str, index: int) -> str:
    """One thing less in the way."""
    _found(tree, kind, index)
    scene = _scene(tree)
    if kind == "step":
        del scene["step"]
    else:
        del scene[kind][index]
        if not len(scene[kind]):
            del scene[kind]
    return f"delete a {kind}"


def _found(tree: TOMLDocument, kind: str, index: int) -> Any:
    scene = _scene(tree)
    if kind not in scene or (kind != "step" and not 0 <= index < len(scene[kind])):
        raise UserError(f"there is no {kind} {index + 1} any more")
    return scene[kind] if kind == "step" else scene[kind][index]
