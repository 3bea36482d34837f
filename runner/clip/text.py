"""Clips as files, the reverse of loading: tables as TOML text, keyframes as tables, and motions as clips."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from dynsplines import models
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns

from ..errors import UserError
from ..motion import Saved
from ..scene.assets import Scene
from ..scene.compose import compose, figure_spec
from ..system.output import Replacement, check_target
from .build import around
from .load import scene_and_figure
from .parse import Parsed, table_of
from .table import ClipTable, KeyframeTable, RootTable, RotationTable, SolveTable, Table, degrees

TomlTable = dict[str, Any]  # a table as a file has it, of keys that its reader checks
BARE = re.compile(r"[A-Za-z0-9_-]+")


def tables(table: Table) -> TomlTable:
    """Return the set keys of a table, in the file's notation, including nested tables."""
    return table.model_dump(exclude_unset=True, by_alias=True)


def text_of(clip: ClipTable | Mapping[str, object]) -> str:
    """Return the TOML text of a clip, keyframes last. A table inside a table is on one line."""
    plain = tables(clip) if isinstance(clip, ClipTable) else clip
    head = [(key, value) for key, value in plain.items() if not _is_table(value)]
    blocks = ["\n".join(assignment(key, value) for key, value in head)]
    for key, value in sorted(plain.items(), key=lambda item: item[0] == "keyframe"):
        if isinstance(value, dict) and value:
            blocks.append("\n".join([f"[{_key(key)}]", *(assignment(*entry) for entry in value.items())]))
        elif isinstance(value, list | tuple) and _is_table(value):
            blocks += ["\n".join([f"[[{_key(key)}]]", *_rows(row)]) for row in value]
    return "\n\n".join(blocks) + "\n"


def _is_table(value: object) -> bool:
    return isinstance(value, dict) or (isinstance(value, list | tuple) and bool(value) and isinstance(value[0], dict))


def _rows(row: Mapping[str, object]) -> list[str]:
    """Return the lines of a table. Each joint, site and body, and each part of the root, has a separate line."""
    lines = []
    for key, value in row.items():
        if key in ("root", "roots", "joints", "sites", "bodies") and isinstance(value, dict):
            lines += [f"{_key(key)}.{assignment(*entry)}" for entry in value.items()]
        else:
            lines.append(assignment(key, value))
    return lines


def assignment(key: str, value: object) -> str:
    """Return KEY = VALUE in TOML."""
    return f"{_key(key)} = {_value(value)}"


def _key(key: str) -> str:
    return key if BARE.fullmatch(key) else _text(key)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, dict):
        return "{" + ", ".join(assignment(*entry) for entry in value.items() if entry[1] is not None) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value)


def keyframe_tables(figure: Figure, keys: Sequence[Frame]) -> list[KeyframeTable]:
    """Return the tables of keyframes, qpos and mask: rotations as rotation vectors, without free entries."""
    return [_keyframe(figure, key) for key in keys]


def _keyframe(figure: Figure, key: Frame) -> KeyframeTable:
    """Return the table of a keyframe, unchecked: a state may exceed a file's limits, which loading reports."""
    root: RootTable | None = None
    roots: dict[str, RootTable] = {}
    joints: dict[str, RotationTable | float] = {}
    main_root = figure.root  # if there are several figures, each is placed by name
    first = None if main_root is None or main_root.is_ambiguous else figure.links[main_root.link]
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        fixed = bool(key.fixed[link.qpos if columns is None else columns].all())
        value = key.state[link.qpos if columns is None else columns].tolist()
        if link.kind is JointKind.FREE:
            axes = slice(link.qpos, link.qpos + 3)
            pairs = zip(key.state[axes].tolist(), key.fixed[axes], strict=True)
            place = {"position": tuple(x if is_fixed else "free" for x, is_fixed in pairs)}
            turn = {"rotation": RotationTable.of(value)} if fixed else {}
            table = RootTable.without_checks(**(place if key.fixed[axes].any() else {}), **turn)
            if link is first:
                root = table
            elif table.model_fields_set:
                roots[link.name] = table
        elif fixed and columns is not None:
            joints[link.name] = RotationTable.of(value)
        elif fixed:
            joints[link.name] = degrees(value) if link.kind is JointKind.HINGE else value
    named = {"root": root if root is not None and root.specified else None, "roots": roots, "joints": joints}
    return KeyframeTable.without_checks(time=float(key.time), **{name: value for name, value in named.items() if value})


def write(saved: Saved, target: Path, *, note: str = "", overwrite: bool) -> list[Path]:
    """Write a clip (.toml) and return the files written, including the scene of a figure that is not shipped.

    Args:
        note: A comment for the first lines.
        overwrite: Whether to overwrite a different scene next to the clip.

    Raises:
        UserError: For a motion whose clip follows a recording in a file.
    """
    check_target(target)
    if saved.text:
        table = table_of(saved.text, saved.name)
        if table.recording is not None and table.recording.file not in models.clips():
            raise UserError(
                f"{target}: '{saved.name}' follows the recording '{table.recording.file}'; save it as a motion, .npz, "
                "which a clip can follow"
            )
    else:
        keys = keyframe_tables(saved.figure, saved.keys)
        shipped = (name for name in models.figures() if compose(figure_spec(name)).mjcf == saved.mjcf)
        named = {"figure": next(shipped, ""), "fps": saved.fps, "solve": _solve_table(saved), "keyframe": keys}
        table = ClipTable.without_checks(**named)
    files: dict[Path, bytes] = {}
    if table.figure not in models.figures() or (saved.text and not _defines_scene(saved)):
        scene = target.with_suffix(".xml")
        for file in (target, scene):
            if file.name in saved.scene.assets:
                raise UserError(f"'{file}' would be both the clip's and a file of its figure; choose another name")
        files = _scene_files(saved.scene, scene, overwrite=overwrite)
        table = table.without("scene").change(figure=scene.name)
    files[target] = ((f"# {note}\n" if note else "") + text_of(table)).encode()
    for path, data in files.items():
        with Replacement(path) as temporary:
            temporary.write_bytes(data)
    return list(files)


def _scene_files(scene: Scene, target: Path, *, overwrite: bool) -> dict[Path, bytes]:
    """Return the files of a scene by path, its MJCF at `target`. Raises UserError if different ones exist."""
    files = {target: scene.mjcf.encode(), **{target.parent / name: data for name, data in scene.assets.items()}}
    for file, data in files.items():
        if file.exists() and file.read_bytes() != data and not overwrite:
            raise UserError(
                f"'{file}' already exists, where a file of the clip's figure would be written; give another name, or "
                "overwrite"
            )
    return files


def _defines_scene(saved: Saved) -> bool:
    """Return whether the tables alone define the motion's scene. Files to which they refer may be missing."""
    try:
        return scene_and_figure(Parsed.of(saved.text, saved.name, saved.name))[0].mjcf == saved.mjcf
    except UserError:
        return False


def _solve_table(saved: Saved) -> SolveTable:
    """Return the [solve] table of a motion's ends."""
    return SolveTable.without_checks(ends=saved.timeline.ends, **around(saved).specified)
