"""Edits of the weights and options of soft constraints."""

from __future__ import annotations

from typing import Any

from ...clip.kinds import KINDS, Options
from ...errors import UserError
from .tables import Blocks, add, number, put, remove

EDITS = ("set_weight",)

SWITCHED = {("collision", "self"): "self"}  # options that must be set if a part gets a weight


def set_weight(tree: Blocks, *, kind: str, weight: float | None, part: str = "") -> str:
    """Set the weight of a soft constraint, or of a part of it; None for its default."""
    if not part:
        return _set_option(tree, kind=kind, option="weight", value=weight)
    table, record = _penalty(tree, kind), KINDS.get(kind)
    if record is None or part not in {available.name for available in record.parts}:
        raise UserError(f"'{kind}' has no part '{part}'")
    listed = {} if table is None else table.unwrap()
    before = listed.get("weight", {})
    if not isinstance(before, dict):
        before = record.weights(Options.model_validate({k: v for k, v in listed.items() if k != "kind"}))
    weights = {name: value for name, value in before.items() if name != part}
    if weight is not None:
        weights[part] = number(weight, f"weight of {part}")
    if (kind, part) in SWITCHED:
        _set_option(tree, kind=kind, option=SWITCHED[kind, part], value=None if weight is None else True)
    _set_option(tree, kind=kind, option="weight", value=weights or None)
    return f"weight of {part} of {kind}"


def _set_option(tree: Blocks, *, kind: str, option: str, value: Any) -> str:
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
