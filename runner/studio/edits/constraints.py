"""Edits of contacts, grasps, the weights of soft constraints, and the settings of the search."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...clip.kinds import KINDS
from ...clip.parse import SHORTEST
from ...errors import UserError
from .tables import Blocks, add, number, numbers, put, remove, row

EDITS = ("set_contact", "set_grasp", "delete_bar", "set_weight", "set_option", "set_solve")

SWITCHED = {("collision", "self"): "self"}  # options that must be set if a part gets a weight


def set_contact(
    tree: Blocks, *, point: str, begin: float, end: float, index: int | None = None, position: Any = None
) -> str:
    """Add a contact of a point from one time to another [s], or change the one with this index."""
    entries: dict[str, object] = {"point": point, **_span(begin, end, f"the contact of {point}")}
    if position is not None:
        entries["position"] = numbers(position, f"where {point} rests")
    _put(tree, "contact", entries, index)
    return f"{'change the' if index is not None else 'a'} contact of {point}"


def set_grasp(tree: Blocks, *, hand: str, body: str, begin: float, end: float, index: int | None = None) -> str:
    """Add a grasp of a hand on a body, or change the one with this index."""
    entries = {"hand": hand, "body": body, **_span(begin, end, f"the grasp of {hand}")}
    _put(tree, "grasp", entries, index)
    return f"{'change the' if index is not None else 'a'} hold of {hand} on {body}"


def _span(begin: Any, end: Any, what: str) -> dict[str, float]:
    begin, end = number(begin, what), number(end, what)
    if end - begin < SHORTEST:
        raise UserError(f"{what} would end at {end:g} s, before it begins at {begin:g} s")
    return {"from": begin, "to": end}


def _put(tree: Blocks, name: str, entries: Mapping[str, Any], index: int | None) -> None:
    if index is None:
        add(tree, (name,), entries)
        return
    table = row(tree, name, index)
    for key, value in entries.items():
        if table.get(key) != value:
            put(table, key, value)


def delete_bar(tree: Blocks, *, kind: str, index: int) -> str:
    """Remove a contact or a grasp by index."""
    if kind not in ("contact", "grasp"):
        raise UserError(f"'{kind}': not a contact or grasp")
    remove(tree, kind, index)
    return f"delete a {kind}"


def set_weight(tree: Blocks, *, kind: str, weight: float | None, part: str = "") -> str:
    """Set the weight of a soft constraint, or of a part of it; None for its default."""
    if not part:
        return set_option(tree, kind=kind, option="weight", value=weight)
    table, record = _penalty(tree, kind), KINDS.get(kind)
    if record is None or part not in {available.name for available in record.parts}:
        raise UserError(f"'{kind}' has no part '{part}'")
    listed = {} if table is None else table.unwrap()
    before = listed.get("weight", {})
    if not isinstance(before, dict):
        before = record.weights(record.options.model_validate({k: v for k, v in listed.items() if k != "kind"}))
    weights = {name: value for name, value in before.items() if name != part}
    if weight is not None:
        weights[part] = number(weight, f"weight of {part}")
    if (kind, part) in SWITCHED:
        set_option(tree, kind=kind, option=SWITCHED[kind, part], value=None if weight is None else True)
    set_option(tree, kind=kind, option="weight", value=weights or None)
    return f"weight of {part} of {kind}"


def set_option(tree: Blocks, *, kind: str, option: str, value: Any) -> str:
    """Set an option of a soft constraint; None for its default."""
    table = _penalty(tree, kind)
    what = f"{option} of {kind}"
    if isinstance(value, int | float) and not isinstance(value, bool):
        value = number(value, what)
    if table is None:
        if value is not None:
            add(tree, ("penalty",), {"kind": kind, option: value})
        return what
    if value is not None:
        put(table, option, value)
    elif option in table:
        del table[option]
        if set(table) == {"kind"}:
            remove(tree, "penalty", [row.table["kind"] for row in tree.rows("penalty")].index(kind))
    return what


def _penalty(tree: Blocks, kind: str) -> Any:
    return next((row.table for row in tree.rows("penalty") if row.table["kind"] == kind), None)


def set_solve(tree: Blocks, *, option: str, value: Any) -> str:
    """Set a setting of the search; None for its default."""
    table = tree.table("solve", make=value is not None)
    if value is None:
        if table is not None and option in table:
            del table[option]
    else:
        put(table, option, number(value, option) if isinstance(value, float) else value)
    return f"{option} of the search"
