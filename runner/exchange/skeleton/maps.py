"""Bone maps from roles to a figure's bodies and a recording's joints: the current one, and shipped ones."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from dynsplines import models

from ...clip.table import MapTable
from ...errors import UserError

_mapping: ContextVar[tuple[MapTable, list[str]] | None] = ContextVar("mapping", default=None)


@contextmanager
def using(chosen: MapTable) -> Iterator[list[str]]:
    """Retarget recordings with a map in this block; yields the labels of the recordings to which it applies."""
    applied = list[str]()
    before = _mapping.set((chosen, applied))
    try:
        yield applied
    finally:
        _mapping.reset(before)


def current() -> tuple[MapTable, list[str]]:
    """Return the current map, and the list that collects the labels of recordings."""
    return _mapping.get() or (MapTable(), [])


def map_of(file: Path | None) -> Path | None:
    """Return the file of a map, from its path or the name of a shipped one; raises UserError if there is neither."""
    if file is None or file.exists() or file.suffix or len(file.parts) > 1:
        return file
    try:
        return models.map_file(str(file))
    except KeyError as error:
        raise UserError(f"--map: no file '{file}', and {error.args[0]}") from None
