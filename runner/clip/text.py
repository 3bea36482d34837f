"""A clip's tables as TOML text again, and keyframes as its tables: the way back of clip.py."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns

from .table import ClipTable

DIGITS = 9  # after the point, of angles in degrees: 1e-11 rad, more than conversions there and back keep
BARE = re.compile(r"[A-Za-z0-9_-]+")


def tables(table: ClipTable) -> dict[str, Any]:
    """What a clip's file says, as plain tables."""
    return table.model_dump(exclude_unset=True, by_alias=True)


def written(clip: dict[str, Any]) -> str:
    """TOML text of a clip's tables, keyframes last; entries of a table inside a table stand on one line."""
    head = [(key, value) for key, value in clip.items() if not _is_table(value)]
    blocks = ["\n".join(assignment(key, value) for key, value in head)]
    for key, value in sorted(clip.items(), key=lambda item: item[0] == "keyframe"):
        if isinstance(value, dict) and value:
            blocks.append("\n".join([f"[{_key(key)}]", *(assignment(*entry) for entry in value.items())]))
        elif _is_table(value) and not isinstance(value, dict):
            blocks += ["\n".join([f"[[{_key(key)}]]", *_rows(row)]) for row in value]
    return "\n\n".join(blocks) + "\n"


def _is_table(value: Any) -> bool:
    return isinstance(value, dict) or (isinstance(value, list | tuple) and bool(value) and isinstance(value[0], dict))


def _rows(row: dict[str, Any]) -> list[str]:
    """The lines of a table; each joint, site and body, and each part of the root, has one of its own."""
    lines = []
    for key, value in row.items():
        if key in ("root", "roots", "joints", "sites", "bodies") and isinstance(value, dict):
            lines += [f"{_key(key)}.{assignment(*entry)}" for entry in value.items()]
        else:
            lines.append(assignment(key, value))
    return lines


def assignment(key: str, value: Any) -> str:
    """KEY = VALUE in TOML."""
    return f"{_key(key)} = {_value(value)}"


def _key(key: str) -> str:
    return key if BARE.fullmatch(key) else _text(key)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, dict):
        return "{" + ", ".join(assignment(*entry) for entry in value.items() if entry[1] is not None) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value)


def keyframe_tables(figure: Figure, keys: Sequence[Frame]) -> list[dict[str, Any]]:
    """Keyframes, qpos and mask, as a clip's tables: rotations as rotation vectors, what is not fixed left out."""
    return [_keyframe(figure, key) for key in keys]


def rotation(quaternion: ArrayLike) -> dict[str, list[float]]:
    """A rotation's table: its rotation vector in degrees."""
    return {"rotvec": [_angle(x) for x in quat.rotation_vector(quat.normalised(quaternion))]}


def _angle(radians: float) -> float:
    """Degrees without the noise of the conversion."""
    return round(float(np.degrees(radians)), DIGITS) + 0.0


def _keyframe(figure: Figure, key: Frame) -> dict[str, Any]:
    root: dict[str, Any] = {}
    roots: dict[str, Any] = {}
    joints: dict[str, Any] = {}
    main_root = figure.root  # of several figures each is placed by its name
    first = None if main_root is None or main_root.is_ambiguous else figure.links[main_root.link]
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        fixed = bool(key.fixed[link.qpos if columns is None else columns].all())
        value = key.state[link.qpos if columns is None else columns].tolist()
        if link.kind is JointKind.FREE:
            axes = slice(link.qpos, link.qpos + 3)
            table = root if link is first else roots.setdefault(link.name, {})
            if key.fixed[axes].any():
                pairs = zip(key.state[axes].tolist(), key.fixed[axes], strict=True)
                table["position"] = [x if said else "free" for x, said in pairs]
            if fixed:
                table["rotation"] = rotation(value)
        elif fixed and columns is not None:
            joints[link.name] = rotation(value)
        elif fixed:
            joints[link.name] = _angle(value) if link.kind is JointKind.HINGE else value
    said = {"root": root, "roots": {name: table for name, table in roots.items() if table}, "joints": joints}
    return {"time": float(key.time), **{name: table for name, table in said.items() if table}}
