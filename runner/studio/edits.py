"""Edits of a clip's text. Each is a function of its blocks and of the page's arguments, and returns a description.

Whether a text is a clip, the solver decides. The address of a table consists of keys, and the index of one of several
tables: ["keyframe", 2], ["scene", "step"].
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from dynsplines.solver.tolerances import ROUNDING

from ..clip.kinds import KINDS, Options
from ..clip.parse import is_too_near
from ..errors import UserError
from . import blocks
from .blocks import DIGITS, DOTTED, Blocks, drop_dotted, number, put, put_dotted, row

ROOTS = ("keyframe", "contact", "grasp", "scene", "solve")  # tables that the page may edit, without names of files
WHOLE = ("scene", "solve")  # tables in which whole numbers stay whole when they are changed


def change(tree: Blocks, *, at: Sequence[Any], entries: Mapping[str, Any], words: str = "") -> str:
    """Set entries of a table; None removes one. Of joints, positions and roots, only the listed names change."""
    table = _table(tree, at)
    for key, value in entries.items():
        assign(table, key, value if at[0] in WHOLE else real(value))
    names = [name for key, value in entries.items() for name in (value if isinstance(value, Mapping) else [key])]
    return words or f"change {', '.join(names[:2])}{' ...' if len(names) > 2 else ''} of {_name(at)}"


def add(tree: Blocks, *, at: Sequence[str], entries: Mapping[str, Any]) -> str:
    """Add a contact, a grasp or an obstacle, after others of its kind."""
    _check(at)
    if at[-1] in (tree.table(*at[:-1]) or {}) and not tree.rows(*at):
        name = ".".join(at)
        raise UserError(f"'{name}' is written as a list; write [[{name}]] tables to add one here")
    blocks.add(tree, tuple(at), real(entries))
    return f"add a {_name(at)}"


def remove(tree: Blocks, *, at: Sequence[Any]) -> str:
    """Remove a table."""
    _table(tree, at)
    if isinstance(at[-1], int):
        blocks.remove(tree, *at)
    else:
        tree.remove_table(*at)
    return f"delete {_name(at)}"


def assign(table: Any, key: str, value: Any) -> None:
    """Set an entry if it differs, or remove it if the value is None."""
    if key in DOTTED and isinstance(value, Mapping):
        for name, entry in value.items():
            _assign_dotted(table, key, str(name), entry)
    elif value is None:
        if key in table:
            del table[key]
    elif table.get(key) != value:
        put(table, key, value)


def _assign_dotted(table: Any, group: str, name: str, entry: Any) -> None:
    before = table.get(group, {}).get(name)
    if entry is None:
        drop_dotted(table, group, name)
    elif group == "roots" and before is not None:
        for part, value in entry.items():
            assign(before, part, value)
    elif before != entry:
        put_dotted(table, group, name, entry)


def real(value: Any) -> Any:
    """Return a value with real instead of whole numbers: a page has only one kind."""
    if isinstance(value, Mapping):
        return {key: real(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [real(entry) for entry in value]
    return float(value) if isinstance(value, int) and not isinstance(value, bool) else value


def _table(tree: Blocks, at: Sequence[Any]) -> Any:
    """Return the table at an address; [scene] and [solve] are made if necessary. Raises UserError if there is none."""
    _check(at)
    if isinstance(at[-1], int):
        return blocks.row(tree, *at)
    table = tree.table(*at, make=len(at) == 1)
    if table is None:
        raise UserError(f"there is no {_name(at)} any more")
    return table


def _check(at: Sequence[Any]) -> None:
    if not at or at[0] not in ROOTS or not all(isinstance(key, str) for key in at[:-1]):
        raise UserError(f"{at!r}: not a table that can be edited here")


def _name(at: Sequence[Any]) -> str:
    return " ".join(str(key + 1) if isinstance(key, int) else key for key in at if key != "scene") or "the scene"


def times(tree: Blocks) -> list[float]:
    """Return the times of all keyframes [s]."""
    return [float(block.table["time"]) for block in tree.rows("keyframe")]


def move_keys(tree: Blocks, *, moves: Sequence[Sequence[float]]) -> str:
    """Move keyframes to other times, given as pairs of index and time [s].

    Contacts and grasps that begin or end at them move along.
    """
    was = times(tree)
    now = dict(enumerate(was))
    for pair in moves:
        index, time = int(pair[0]), number(pair[1], "the time of a keyframe")
        row(tree, "keyframe", index)
        now[index] = time
    for index, time in now.items():
        if abs(time - was[index]) > ROUNDING:
            put(row(tree, "keyframe", index), "time", time)
    for name in ("contact", "grasp"):
        for block in tree.rows(name):
            for end in ("from", "to"):
                _follow(block.table, end, was, now)
    count = len(moves)
    return "move a keyframe" if count == 1 else f"move {count} keyframes"


def _follow(table: Any, end: str, was: Sequence[float], now: Mapping[int, float]) -> None:
    for index, time in enumerate(was):
        if abs(float(table[end]) - time) < ROUNDING and abs(now[index] - time) > ROUNDING:
            put(table, end, now[index])
            return


def add_key(tree: Blocks, *, entries: Mapping[str, Any]) -> str:
    """Insert a keyframe with these entries, sorted by time."""
    time, was = number(entries["time"], "the time of a keyframe"), times(tree)
    for index, other in enumerate(was):
        if is_too_near(other, time):
            raise UserError(f"there is a keyframe at {other:g} s already: keyframe {index + 1}")
    blocks.add(tree, ("keyframe",), {**entries, "time": time}, sum(other < time for other in was))
    return f"add a keyframe at {time:g} s"


def delete_keys(tree: Blocks, *, keys: Sequence[int]) -> str:
    """Delete keyframes."""
    for index in sorted(set(keys), reverse=True):
        blocks.remove(tree, "keyframe", index)
    return "delete a keyframe" if len(keys) == 1 else f"delete {len(keys)} keyframes"


def paste_keys(tree: Blocks, *, copied: Sequence[Mapping[str, Any]], time: float) -> str:
    """Paste copied keyframes, the first of them at a time [s], in place of those at their times."""
    if not copied:
        raise UserError("nothing has been copied: select keyframes and press Ctrl-C first")
    begin = number(time, "the time") - float(copied[0]["time"])
    for key in copied:
        at = round(float(key["time"]) + begin, DIGITS)
        delete_keys(tree, keys=[index for index, other in enumerate(times(tree)) if is_too_near(other, at)])
        add_key(tree, entries={**real(key), "time": at})
    return "paste a keyframe" if len(copied) == 1 else f"paste {len(copied)} keyframes"


def replace_keys(tree: Blocks, *, keys: Mapping[str, Mapping[str, Any]], words: str) -> str:
    """Replace the entries of keyframes by index, except their times. Lines of unchanged entries are unchanged."""
    for index, entries in keys.items():
        table = row(tree, "keyframe", int(index))
        for group in DOTTED:
            for name in [old_name for old_name in table.get(group, {}) if old_name not in entries.get(group, {})]:
                drop_dotted(table, group, name)
        for name, pose in table.get("roots", {}).items():
            for part in set(pose) - set(entries["roots"][name]):
                del pose[part]
        for key, value in {**entries, "others": entries.get("others")}.items():
            if key != "time":
                assign(table, key, value)
    return words


def set_weight(tree: Blocks, *, kind: str, weight: float | None, part: str = "") -> str:
    """Set the weight of a soft constraint, or of a part of it; None for its default."""
    table = next((block.table for block in tree.rows("penalty") if block.table["kind"] == kind), None)
    record = KINDS.get(kind)
    options = {} if record is None else {each.name: each.option for each in record.parts}
    if record is None or (part and part not in options):
        raise UserError(f"'{kind}' has no part '{part}'")
    words = f"weight of {part} of {kind}" if part else f"weight of {kind}"
    value = None if weight is None else number(weight, words)
    entries: dict[str, Any] = {"weight": value}
    if part:
        listed = {} if table is None else table.unwrap()
        before = listed.get("weight", {})
        if not isinstance(before, dict):
            before = record.weights(Options.model_validate({k: v for k, v in listed.items() if k != "kind"}))
        weights = {name: each for name, each in {**before, part: value}.items() if each is not None}
        entries["weight"] = weights or None
        if (option := options[part]) is not None:  # without this option, the part has no weight
            entries[option] = None if weight is None else True
    if table is None and value is not None:
        blocks.add(tree, ("penalty",), {"kind": kind, **entries})
    if table is None:
        return words
    for key, entry in entries.items():
        assign(table, key, entry)
    if set(table) == {"kind"}:
        blocks.remove(tree, "penalty", [block.table["kind"] for block in tree.rows("penalty")].index(kind))
    return words


EDITS: dict[str, Callable[..., str]] = {
    edit.__name__: edit
    for edit in (change, add, remove, move_keys, add_key, delete_keys, paste_keys, replace_keys, set_weight)
}
