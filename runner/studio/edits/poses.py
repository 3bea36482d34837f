"""Edits of a keyframe's joints and root, and of the target positions of hands and feet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ...clip.table import KEY
from ...errors import UserError
from .tables import Blocks, drop_dotted, number, numbers, put, put_dotted, row

EDITS = ("set_joint", "set_root", "set_pose", "set_place", "set_others")
ROTATIONS = {"rotvec": 3, "quat": 4, "euler": 3}  # notations of rotations, and their numbers of entries


def set_joint(tree: Blocks, *, key: int, joint: str, value: Any) -> str:
    """Set a joint's angle [degrees], displacement [m] or rotation; "free" to free it; None for the `others` rule."""
    table = row(tree, "keyframe", key)
    if value is None:
        drop_dotted(table, "joints", joint)
        return f"leave {joint} to the optimiser"
    put_dotted(table, "joints", joint, _turned(value, joint))
    return f"free {joint}" if value == "free" else f"set {joint}"


def _turned(value: Any, what: str) -> Any:
    """Return a rotation, a number or "free", checked."""
    if value == "free":
        return value
    if isinstance(value, Mapping):
        rotation = {name: numbers(value[name], what, count) for name, count in ROTATIONS.items() if name in value}
        if not rotation:
            raise UserError(f"{what}: give a rotation, {', '.join(ROTATIONS)}")
        return rotation
    return number(value, what)


def set_root(tree: Blocks, *, key: int, position: Any = None, rotation: Any = None, joint: str = "") -> str:
    """Set the root's position, each axis a number [m] or "free", and its rotation; or of another free body by joint."""
    table = row(tree, "keyframe", key)
    parts = {"position": position, "rotation": rotation}
    entries = {part: value for part, value in parts.items() if value is not None}
    _put_body(table, joint, entries)
    what = joint or "the root"
    return f"free {what}" if all(value == "free" for value in entries.values()) else f"place {what}"


def _put_body(table: Any, joint: str, entries: Mapping[str, Any]) -> None:
    what = joint or "the root"
    for part, value in entries.items():
        value = _axes(value, f"{what}'s position") if part == "position" else _turned(value, f"{what}'s rotation")
        if not joint:
            put_dotted(table, "root", part, value)
        elif joint in table.get("roots", {}):
            put(table["roots"][joint], part, value)
        else:
            put_dotted(table, "roots", joint, {part: value})


def _axes(position: Any, what: str) -> Any:
    if position == "free":
        return position
    if not isinstance(position, Sequence) or len(position) != 3:
        raise UserError(f"{what}: give three numbers, each of which may be free")
    return [axis if axis == "free" else number(axis, what) for axis in position]


def set_pose(
    tree: Blocks,
    *,
    key: int,
    joints: Mapping[str, Any],
    root: Mapping[str, Any] | None = None,
    roots: Mapping[str, Mapping[str, Any]] | None = None,
    places: Sequence[str] = (),
    words: str = "pose the figure",
) -> str:
    """Set several joints, the root, and further free bodies by their joints; remove the targets `places`."""
    table = row(tree, "keyframe", key)
    for name, value in joints.items():
        put_dotted(table, "joints", name, _turned(value, name))
    for joint, pose in {"": root or {}, **(roots or {})}.items():
        _put_body(table, joint, pose)
    for name in places:
        drop_dotted(table, "sites", name)
        drop_dotted(table, "bodies", name)
    return words


def set_place(tree: Blocks, *, key: int, site: str, position: Any) -> str:
    """Set the target position [m] of a hand, a foot or another point; None to remove it."""
    table = row(tree, "keyframe", key)
    if position is None:
        drop_dotted(table, "sites", site)
        return f"let {site} go"
    put_dotted(table, "sites", site, _axes(position, site))
    return f"put {site} in its place"


def set_others(tree: Blocks, *, key: int, value: str) -> str:
    """Set the rule for unspecified joints: "free", "rest", "previous" (as in the keyframe before), or "key:NAME"."""
    if value not in ("free", "rest", "previous") and not value.startswith(KEY):
        raise UserError(f"others: 'free', 'rest', 'previous' or 'key:NAME', not '{value}'")
    table = row(tree, "keyframe", key)
    if value == "free":
        if "others" in table:
            del table["others"]
    else:
        put(table, "others", value)
    return f"others: {value}"
