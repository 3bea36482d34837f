"""General edits: change the entries of a table, add a table, remove one. Whether a text is a clip, the solver decides.

The address of a table consists of keys, and the index of one of several tables: ["keyframe", 2], ["scene", "step"].
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ...errors import UserError
from . import tables
from .tables import DOTTED, Blocks, drop_dotted, put, put_dotted

EDITS = ("change", "add", "remove")

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
    tables.add(tree, tuple(at), real(entries))
    return f"add a {_name(at)}"


def remove(tree: Blocks, *, at: Sequence[Any]) -> str:
    """Remove a table."""
    _table(tree, at)
    if isinstance(at[-1], int):
        tables.remove(tree, *at)
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
        return tables.row(tree, *at)
    table = tree.table(*at, make=len(at) == 1)
    if table is None:
        raise UserError(f"there is no {_name(at)} any more")
    return table


def _check(at: Sequence[Any]) -> None:
    if not at or at[0] not in ROOTS or not all(isinstance(key, str) for key in at[:-1]):
        raise UserError(f"{at!r}: not a table that can be edited here")


def _name(at: Sequence[Any]) -> str:
    return " ".join(str(key + 1) if isinstance(key, int) else key for key in at if key != "scene") or "the scene"
