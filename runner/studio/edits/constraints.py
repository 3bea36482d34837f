"""Edits of contacts, holds, the weights of soft constraints, and how the search goes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import tomlkit
from tomlkit import TOMLDocument

from ...errors import UserError
from .tables import add, item, number, numbers, put, remove, row, rows

EDITS = ("set_contact", "set_hold", "delete_bar", "set_weight", "set_option", "set_solve")
SHORTEST = 0.001  # [s] of a contact or hold


def set_contact(
    tree: TOMLDocument, *, point: str, begin: float, end: float, index: int | None = None, position: Any = None
) -> str:
    """A new contact of a point from one time to another [s], or an old one, by number, at other times."""
    said: dict[str, Any] = {"point": point, **_span(begin, end, f"the contact of {point}")}
    if position is not None:
        said["position"] = numbers(position, f"where {point} rests")
    _put(tree, "contact", said, index)
    return f"{'change the' if index is not None else 'a'} contact of {point}"


def set_hold(tree: TOMLDocument, *, hand: str, body: str, begin: float, end: float, index: int | None = None) -> str:
    """A new hold of a hand on a body, or an old one, by number, at other times."""
    said = {"hand": hand, "body": body, **_span(begin, end, f"the hold of {hand}")}
    _put(tree, "hold", said, index)
    return f"{'change the' if index is not None else 'a'} hold of {hand} on {body}"


def _span(begin: Any, end: Any, what: str) -> dict[str, float]:
    begin, end = number(begin, what), number(end, what)
    if end - begin < SHORTEST:
        raise UserError(f"{what} would end at {end:g} s, before it begins at {begin:g} s")
    return {"from": begin, "to": end}


def _put(tree: TOMLDocument, name: str, said: Mapping[str, Any], index: int | None) -> None:
    if index is None:
        add(tree, name, said)
        return
    table = row(tree, name, index)
    for key, value in said.items():
        if key not in table:
            table.append(key, item(value))
        elif table[key] != value:
            put(table, key, value)


def delete_bar(tree: TOMLDocument, *, kind: str, index: int) -> str:
    """A contact or a hold less, by number."""
    if kind not in ("contact", "hold"):
        raise UserError(f"'{kind}': not a contact or hold")
    remove(tree, kind, index)
    return f"delete a {kind}"


def set_weight(tree: TOMLDocument, *, kind: str, weight: float | None) -> str:
    """The weight of a soft constraint; None for its default."""
    return set_option(tree, kind=kind, option="weight", value=weight)


def set_option(tree: TOMLDocument, *, kind: str, option: str, value: Any) -> str:
    """An option of a soft constraint; None for its default."""
    known = rows(tree, "penalty") if "penalty" in tree else []
    index = next((i for i, each in enumerate(known) if each["kind"] == kind), None)
    what = f"{option} of {kind}"
    if isinstance(value, int | float) and not isinstance(value, bool):
        value = number(value, what)
    if index is None:
        if value is not None:
            add(tree, "penalty", {"kind": kind, option: value})
        return what
    table = known[index]
    if value is not None and option in table:
        put(table, option, value)
    elif value is not None:
        table.append(option, item(value))
    elif option in table:
        del table[option]
        if set(table) == {"kind"}:
            remove(tree, "penalty", index)
    return what


def set_solve(tree: TOMLDocument, *, option: str, value: Any) -> str:
    """A setting of the search; None for its default."""
    if "solve" not in tree:
        if value is None:
            return f"default {option}"
        tree.append("solve", tomlkit.table())
    table: Any = tree["solve"]
    if value is None:
        if option in table:
            del table[option]
    else:
        value = number(value, option) if isinstance(value, float) else value
        put(table, option, value)
    return f"{option} of the search"
