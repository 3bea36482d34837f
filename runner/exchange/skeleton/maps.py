"""Maps, who is who between a figure and recordings: by their file, or by the name of one that ships."""

from __future__ import annotations

from pathlib import Path

from dynsplines import models

from ...errors import UserError


def map_of(said: Path | None) -> Path | None:
    """The file of a map that is said by its path, or by its name if it ships. Raises UserError if there is neither."""
    if said is None or said.exists() or said.suffix or len(said.parts) > 1:
        return said
    try:
        return models.map_file(str(said))
    except models.UnknownName as error:
        raise UserError(f"--map: no file '{said}', and {error}") from None
