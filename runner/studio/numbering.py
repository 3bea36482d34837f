"""What a page's numbers mean by now: the keyframe that it calls the fourth is the fifth since another page added one.

A page says which revision of the text it has seen. From there every change is followed, one after the other: where
there are as many as before they are the same, else those that say the same are.
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
    """What a page said of a revision, in numbers of the present one; raises UserError for what is gone or unknown."""
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
    """The number of a table in the last of some texts, by that in the first of them."""
    here = number
    rows = _rows(texts[0], kind)
    if not isinstance(here, int) or isinstance(here, bool) or not 0 <= here < len(rows):
        return number  # of none: what refuses those says so
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
