"""What edits share: the rows of a file's [[...]] tables, new ones where they belong, numbers with few digits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import tomlkit
from tomlkit import TOMLDocument
from tomlkit.items import AoT, InlineTable, Table

from ...errors import UserError
from ...system.quantity import LARGEST

DIGITS = 5  # after the point: a hundredth of a millimetre, and of a thousandth of a degree
DOTTED = ("root", "roots", "joints", "sites", "bodies")  # tables of a keyframe whose entries stand one a line


def rows(tree: TOMLDocument, name: str) -> AoT:
    """The [[name]] tables, none yet if the file has none."""
    found = tree.get(name)
    if found is None:
        tree.append(name, tomlkit.aot())
        found = tree[name]
    if not isinstance(found, AoT):
        raise UserError(f"'{name}' is written as a list in this file; write it as [[{name}]] tables to edit it here")
    return found


def row(tree: TOMLDocument, name: str, index: Any) -> Table:
    """One of the [[name]] tables; raises UserError for a number that is none of theirs."""
    found = rows(tree, name)
    if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(found):
        raise UserError(f"there is no {name} {index if not isinstance(index, int) else index + 1} any more")
    return found[index]


def number(value: Any, what: str) -> float:
    """A finite number with few digits; raises UserError for anything else."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise UserError(f"{what}: give a finite number, not {_shown(value)}")
    if abs(value) > LARGEST:
        raise UserError(f"{what}: {value:g} is too large")
    return round(float(value), DIGITS) + 0.0


def _shown(value: Any) -> str:
    if value is None or value == "":
        return "nothing"
    return repr(value)[:40]


def numbers(values: Any, what: str, count: int = 3) -> list[float]:
    """So many finite numbers."""
    if not isinstance(values, list | tuple) or len(values) != count:
        raise UserError(f"{what}: give {count} numbers")
    return [number(value, what) for value in values]


def item(value: Any) -> Any:
    """A value as a file has it, tables on one line."""
    if isinstance(value, Mapping):
        table: InlineTable = tomlkit.inline_table()
        for key, entry in value.items():
            table.append(str(key), item(entry))
        return table
    if isinstance(value, list | tuple):
        out = tomlkit.array()
        for entry in value:
            out.append(item(entry))
        return out
    return number(value, "a number") if isinstance(value, float) else value


def put(table: Any, key: str, value: Any) -> None:
    """Sets an entry; its comment stays."""
    table[key] = item(value)


def put_dotted(table: Any, group: str, key: str, value: Any) -> None:
    """Sets `group.key`, such as joints.left_hip, on a line of its own if it is new."""
    if group in table:
        inner = table[group]
        if isinstance(inner, InlineTable) or key in inner:
            put(inner, key, value)
            return
    table.append(tomlkit.key([group, key]), item(value))


def drop_dotted(table: Any, group: str, key: str) -> None:
    """Takes `group.key` away, and the group with its last entry."""
    if group not in table or key not in table[group]:
        return
    del table[group][key]
    if not len(table[group]):
        del table[group]


def fresh(said: Mapping[str, Any]) -> Table:
    """A new row with what it says, and an empty line after it."""
    out = tomlkit.table()
    for key, value in said.items():
        if key in DOTTED and isinstance(value, Mapping):
            for name, entry in value.items():
                out.append(tomlkit.key([key, str(name)]), item(entry))
        else:
            out.append(key, item(value))
    out.add(tomlkit.nl())
    return out


def add(tree: TOMLDocument, name: str, said: Mapping[str, Any], index: int | None = None) -> None:
    """A new [[name]] table, at the end or before the one of a number."""
    if name not in tree and tree.body:
        _spaced(tree)
    found = rows(tree, name)
    if index is None or index >= len(found):
        if len(found):
            _end_with_space(found[-1])
        found.append(fresh(said))
    else:
        found.insert(index, fresh(said))


def _spaced(tree: TOMLDocument) -> None:
    if not tree.as_string().endswith("\n\n"):
        tree.add(tomlkit.nl())


def _end_with_space(table: Table) -> None:
    if not table.as_string().endswith("\n\n"):
        table.add(tomlkit.nl())


def remove(tree: TOMLDocument, name: str, index: int) -> None:
    """Takes a [[name]] table away, and the list with its last."""
    row(tree, name, index)
    found = rows(tree, name)
    del found[index]
    if not len(found):
        tree.remove(name)
