"""Edits of whole keyframes: their times, additions and deletions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from dynsplines.solver.contacts import ROUNDING

from ...clip.parse import is_too_near
from ...errors import UserError
from .tables import DOTTED, Blocks, add, drop_dotted, number, put, put_dotted, remove, row

EDITS = ("move_keys", "add_key", "delete_keys", "paste_keys", "replace_keys")


def times(tree: Blocks) -> list[float]:
    """Return the times of all keyframes [s]."""
    return [float(block.table["time"]) for block in tree.rows("keyframe")]


def move_keys(tree: Blocks, *, moves: Sequence[Sequence[float]]) -> str:
    """Move keyframes to other times, given as pairs of index and time [s].

    Contacts and grasps that begin or end at them move along. Raises UserError if the order of keyframes would change.
    """
    was = times(tree)
    now = dict(enumerate(was))
    for pair in moves:
        index, time = int(pair[0]), number(pair[1], "the time of a keyframe")
        row(tree, "keyframe", index)
        now[index] = time
    _check_order(was, list(now.values()))
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


def _check_order(was: Sequence[float], now: Sequence[float]) -> None:
    for index, (a, b) in enumerate(pairwise(now)):
        if b < a or is_too_near(a, b):
            moved = index if abs(now[index] - was[index]) > ROUNDING else index + 1
            other = index + 1 if moved == index else index
            side = "past" if (b <= a) else "on"
            raise UserError(
                f"keyframe {moved + 1} would come at {now[moved]:g} s, {side} keyframe {other + 1} at "
                f"{now[other]:g} s; keyframes keep their order, at least 1 ms apart"
            )


def add_key(tree: Blocks, *, entries: Mapping[str, Any]) -> str:
    """Insert a keyframe with these entries, sorted by time."""
    time, was = number(entries["time"], "the time of a keyframe"), times(tree)
    for index, other in enumerate(was):
        if is_too_near(other, time):
            raise UserError(f"there is a keyframe at {other:g} s already: keyframe {index + 1}")
    add(tree, ("keyframe",), {**entries, "time": time}, sum(other < time for other in was))
    return f"add a keyframe at {time:g} s"


def delete_keys(tree: Blocks, *, keys: Sequence[int]) -> str:
    """Delete keyframes. Raises UserError if fewer than two would remain, except in a clip that follows a recording."""
    remaining = len(times(tree)) - len(set(keys))
    if remaining < 2 and tree.table("recording") is None:
        raise UserError(f"a clip needs two keyframes; {remaining if remaining > 0 else 'none'} would be left")
    for index in sorted(set(keys), reverse=True):
        remove(tree, "keyframe", index)
    return "delete a keyframe" if len(keys) == 1 else f"delete {len(keys)} keyframes"


def paste_keys(tree: Blocks, *, copied: Sequence[Mapping[str, Any]], at: float) -> str:
    """Paste copied keyframes, the first of them at a time [s]."""
    if not copied:
        raise UserError("nothing has been copied: select keyframes and press Ctrl-C first")
    begin = float(copied[0]["time"])
    for key in copied:
        add_key(tree, entries={**key, "time": number(at, "the time") + float(key["time"]) - begin})
    return "paste a keyframe" if len(copied) == 1 else f"paste {len(copied)} keyframes"


def replace_keys(tree: Blocks, *, keys: Mapping[str, Mapping[str, Any]], words: str) -> str:
    """Replace the entries of keyframes by index, except their times. Lines of unchanged entries are unchanged."""
    for index, entries in keys.items():
        table = row(tree, "keyframe", int(index))
        for group in DOTTED:
            for name in [old_name for old_name in table.get(group, {}) if old_name not in entries.get(group, {})]:
                drop_dotted(table, group, name)
        if "others" in table and "others" not in entries:
            del table["others"]
        for key, value in entries.items():
            _assign(table, key, value)
    return words


def _assign(table: Any, key: str, value: Any) -> None:
    """Replace a keyframe's entry if it has changed, except its time."""
    if key in DOTTED and isinstance(value, Mapping):
        for name, entry in value.items():
            if table.get(key, {}).get(name) != entry:
                put_dotted(table, key, str(name), entry)
    elif key != "time" and table.get(key) != value:
        put(table, key, value)
