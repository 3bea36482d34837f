"""Edits of whole keyframes: their times, additions and deletions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from dynsplines.solver.contacts import ROUNDING

from ...clip.parse import is_too_near
from ...errors import UserError
from .entries import assign
from .tables import DOTTED, Blocks, add, drop_dotted, number, put, remove, row

EDITS = ("move_keys", "add_key", "delete_keys", "paste_keys", "replace_keys")


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
    add(tree, ("keyframe",), {**entries, "time": time}, sum(other < time for other in was))
    return f"add a keyframe at {time:g} s"


def delete_keys(tree: Blocks, *, keys: Sequence[int]) -> str:
    """Delete keyframes."""
    for index in sorted(set(keys), reverse=True):
        remove(tree, "keyframe", index)
    return "delete a keyframe" if len(keys) == 1 else f"delete {len(keys)} keyframes"


def paste_keys(tree: Blocks, *, copied: Sequence[Mapping[str, Any]], time: float) -> str:
    """Paste copied keyframes, the first of them at a time [s]."""
    if not copied:
        raise UserError("nothing has been copied: select keyframes and press Ctrl-C first")
    begin = float(copied[0]["time"])
    for key in copied:
        add_key(tree, entries={**key, "time": number(time, "the time") + float(key["time"]) - begin})
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
