"""The last view of a clip, cached in the user's folder and shown at once while the clip is loaded.

The solver's messages then replace it, so an outdated view disappears within seconds. A damaged file counts as missing.
"""

from __future__ import annotations

import json
import os
import struct
from contextlib import suppress
from importlib.resources import files
from pathlib import Path

from ..system.cache_folder import hash_of, place, store
from .document import Document

FOLDER = "studio"

LARGEST = 20_000_000  # [bytes] maximum size of a view
MOST_BYTES = 100_000_000  # [bytes] maximum size of all views together
HEAD = struct.Struct("<8sII")
MAGIC = b"glimpse1"


def file_of(document: Document) -> Path | None:
    """Return the cache file of a document's view, named by its text, folder and page; None if caching is off."""
    folder = place()
    if folder is None:
        return None
    page = (files("dynsplines.studio") / "built" / "sources.txt").read_bytes()
    parts = (page, str(document.folder).encode(errors="surrogateescape"), document.text.encode())
    return folder / FOLDER / f"{hash_of(parts)}.view"


def read(file: Path | None) -> tuple[bytes, bytes] | None:
    """Return the stage and a path, in the page's format; None if they are missing or invalid."""
    with suppress(OSError, ValueError, KeyError, TypeError, struct.error):
        if file is None or file.stat().st_size > LARGEST + HEAD.size:
            return None
        data = file.read_bytes()
        magic, first, second = HEAD.unpack_from(data)
        stage, path = data[HEAD.size : HEAD.size + first], data[HEAD.size + first :]
        if magic == MAGIC and len(path) == second and _fits(json.loads(stage), path):
            os.utime(file)  # marks it as recently used
            return stage, path
    return None


def _fits(stage: dict[str, list[str]], path: bytes) -> bool:
    """Return whether a path is complete, and of the figure on a stage."""
    (size,) = struct.unpack_from("<I", path)
    head = json.loads(path[4 : 4 + size])
    count, bodies = int(head["count"]), int(head["bodies"])
    return bodies == len(stage["bodies"]) and len(path) == 4 + size + 4 * count * (7 * bodies + 3)


def write(file: Path | None, stage: bytes, path: bytes) -> None:
    """Write a view, if possible."""
    if file is not None and len(stage) + len(path) <= LARGEST:
        store(file, HEAD.pack(MAGIC, len(stage), len(path)) + stage + path, MOST_BYTES)
