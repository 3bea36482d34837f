"""Edits of a clip's text. Each is a function of its blocks and of the page's arguments, and returns a description.

tables   the text as blocks, of which an edit parses one; numbers in the notation of files
entries  change, add and remove tables and their entries: poses, contacts, grasps, obstacles, settings
keys     keyframes: move, add, delete, copy, mirror
weights  weights and options of soft constraints
"""

from __future__ import annotations

from collections.abc import Callable

from . import entries, keys, weights

Edit = Callable[..., str]  # (blocks, **arguments of the page) -> description of the edit

EDITS: dict[str, Edit] = {
    **{name: getattr(entries, name) for name in entries.EDITS},
    **{name: getattr(keys, name) for name in keys.EDITS},
    **{name: getattr(weights, name) for name in weights.EDITS},
}
