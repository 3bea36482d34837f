"""Present indices for those of an older revision: the fourth keyframe becomes the fifth after another page inserts one.

A page sends the revision to which it refers. All later changes are followed in turn. If the number of tables is
unchanged, they correspond in order; otherwise tables with equal content correspond.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from difflib import SequenceMatcher
from typing import Any

from ..errors import UserError
from .document import Document, parsed
from .solver import Message

BARS = {"set_contact": "contact", "set_grasp": "grasp"}  # edits whose `index` refers to these tables


def renumbered(document: Document, revision: int | None, request: Mapping[str, Any], edit: str = "") -> Message:
    """Return a page's arguments with present indices for those of a revision. Raises UserError for unknown ones."""
    arguments = dict(request)
    if revision is None or revision == document.revision:
        return arguments
    texts = document.since(revision)
    if texts is None:
        raise UserError("another clip is open now; reload the page")

    def now(kind: str, number: Any) -> Any:
        return _followed(texts, kind, number)

    if "key" in arguments:
        arguments["key"] = now("keyframe", arguments["key"])
    keys = arguments.get("keys")
    if isinstance(keys, list | tuple):
        arguments["keys"] = [now("keyframe", index_) for index_ in keys]
    elif isinstance(keys, Mapping):
        arguments["keys"] = {str(now("keyframe", int(index_))): row for index_, row in keys.items()}
    if "moves" in arguments:
        arguments["moves"] = [[now("keyframe", index), time] for index, time in arguments["moves"]]
    kind = BARS.get(edit, arguments.get("kind"))
    if isinstance(arguments.get("index"), int) and kind != "step":
        arguments["index"] = now(str(kind), arguments["index"])
    return arguments


def _followed(texts: list[str], kind: str, number: Any) -> Any:
    """Return the index of a table in the last of several texts, for its index in the first."""
    here = number
    rows = _rows(texts[0], kind)
    if not isinstance(here, int) or isinstance(here, bool) or not 0 <= here < len(rows):
        return number  # invalid: the edit itself rejects it
    for text in texts[1:]:
        there = _rows(text, kind)
        if len(there) != len(rows):
            blocks = SequenceMatcher(None, rows, there, autojunk=False).get_matching_blocks()
            position = next((b + here - a for a, b, size in blocks if a <= here < a + size), None)
            if position is None:
                raise UserError(f"{kind} {number + 1} was deleted or changed on another page; check and try again")
            here = position
        rows = there
    return here


def _rows(text: str, kind: str) -> list[str]:
    content = parsed(text)
    tables = content.get(kind, content.get("scene", {}).get(kind, []))
    return [json.dumps(row, sort_keys=True, default=str) for row in tables] if isinstance(tables, list) else []
