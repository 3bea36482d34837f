"""Present indices for those of an older revision: the fourth keyframe becomes the fifth after another page inserts one.

A page sends the revision to which it refers. All later changes are followed in turn. If the number of tables is
unchanged, they correspond in order; otherwise tables with equal content correspond.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from difflib import SequenceMatcher
from typing import Any

from ..errors import UserError
from .document import Document, parsed
from .solver import Message


def renumbered(document: Document, revision: int | None, request: Mapping[str, Any]) -> Message:
    """Return a page's arguments with present indices for those of a revision. Raises UserError for unknown ones."""
    arguments = dict(request)
    if revision is None or revision == document.revision:
        return arguments
    texts = document.since(revision)
    if texts is None:
        raise UserError("another clip is open now; reload the page")

    def now(path: Sequence[str], number: Any) -> Any:
        return _followed(texts, path, number)

    if "key" in arguments:
        arguments["key"] = now(["keyframe"], arguments["key"])
    keys = arguments.get("keys")
    if isinstance(keys, list | tuple):
        arguments["keys"] = [now(["keyframe"], index_) for index_ in keys]
    elif isinstance(keys, Mapping):
        arguments["keys"] = {str(now(["keyframe"], int(index_))): row for index_, row in keys.items()}
    if "moves" in arguments:
        arguments["moves"] = [[now(["keyframe"], index), time] for index, time in arguments["moves"]]
    match arguments.get("at"):
        case [*path, int(index)]:
            arguments["at"] = [*path, now(path, index)]
    return arguments


def _followed(texts: list[str], path: Sequence[str], number: Any) -> Any:
    """Return the index of a table in the last of several texts, for its index in the first."""
    here = number
    rows = _rows(texts[0], path)
    if not isinstance(here, int) or isinstance(here, bool) or not 0 <= here < len(rows):
        return number  # invalid: the edit itself rejects it
    for text in texts[1:]:
        there = _rows(text, path)
        if len(there) != len(rows):
            blocks = SequenceMatcher(None, rows, there, autojunk=False).get_matching_blocks()
            position = next((b + here - a for a, b, size in blocks if a <= here < a + size), None)
            if position is None:
                raise UserError(f"{path[-1]} {number + 1} was deleted or changed on another page; check and try again")
            here = position
        rows = there
    return here


def _rows(text: str, path: Sequence[str]) -> list[str]:
    tables: Any = parsed(text)
    for key in path:
        tables = tables.get(key, {}) if isinstance(tables, Mapping) else {}
    return [json.dumps(row, sort_keys=True, default=str) for row in tables] if isinstance(tables, list) else []
