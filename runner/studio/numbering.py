"""Maps indices of an older revision: the fourth keyframe becomes the fifth after another page has inserted one.

A page names the revision that it refers to. From there every change is followed in turn: if the number of tables is
unchanged they correspond in order, otherwise tables with equal content correspond.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from difflib import SequenceMatcher
from typing import Any

from ..errors import UserError
from .document import Document, parsed

BARS = {"set_contact": "contact", "set_hold": "hold"}  # edits whose `index` is of these tables


def renumbered(document: Document, revision: int | None, said: Mapping[str, Any], edit: str = "") -> dict[str, Any]:
    """A page's arguments, with indices of a revision replaced by present ones; raises UserError for unknown ones."""
    told = dict(said)
    if revision is None or revision == document.revision:
        return told
    texts = document.since(revision)
    if texts is None:
        raise UserError("the clip is another one by now; look again")

    def now(kind: str, number: Any) -> Any:
        return _followed(texts, kind, number)

    if "key" in told:
        told["key"] = now("keyframe", told["key"])
    keys = told.get("keys")
    if isinstance(keys, list | tuple):
        told["keys"] = [now("keyframe", each) for each in keys]
    elif isinstance(keys, Mapping):
        told["keys"] = {str(now("keyframe", int(each))): row for each, row in keys.items()}
    if "moves" in told:
        told["moves"] = [[now("keyframe", index), time] for index, time in told["moves"]]
    kind = BARS.get(edit, told.get("kind"))
    if isinstance(told.get("index"), int) and kind != "step":
        told["index"] = now(str(kind), told["index"])
    return told


def _followed(texts: list[str], kind: str, number: Any) -> Any:
    """The index of a table in the last of several texts, from its index in the first."""
    here = number
    rows = _rows(texts[0], kind)
    if not isinstance(here, int) or isinstance(here, bool) or not 0 <= here < len(rows):
        return number  # invalid: the edit itself rejects it
    for text in texts[1:]:
        there = _rows(text, kind)
        if len(there) != len(rows):
            blocks = SequenceMatcher(None, rows, there, autojunk=False).get_matching_blocks()
            found = next((b + here - a for a, b, size in blocks if a <= here < a + size), None)
            if found is None:
                raise UserError(f"{kind} {number + 1} is gone, or was changed from elsewhere meanwhile; look again")
            here = found
        rows = there
    return here


def _rows(text: str, kind: str) -> list[str]:
    said = parsed(text)
    found = said.get(kind, said.get("scene", {}).get(kind, []))
    return [json.dumps(row, sort_keys=True, default=str) for row in found] if isinstance(found, list) else []
