"""The user's cache folder: solved clips, views of the studio, and the renderer that worked."""

from __future__ import annotations

import os
import re
from contextlib import suppress
from pathlib import Path

PLACE = "DYNSPLINES_CACHE"
OFF = ("off", "0", "no", "false")


def place() -> Path | None:
    """Return the folder, which may not exist; None if caching is off."""
    setting = os.environ.get(PLACE, "").strip()
    if setting.lower() in OFF:
        return None
    if setting:
        return Path(setting)
    from platformdirs import user_cache_path

    return user_cache_path("dynsplines", appauthor=False)


def limit_size(folder: Path, pattern: re.Pattern[str], most: int) -> None:
    """Delete the least recently used files with names of a pattern, until the rest is at most `most` bytes."""
    files: list[tuple[float, int, Path]] = []
    for path in folder.iterdir():
        if pattern.fullmatch(path.name):
            with suppress(OSError):  # another command may have deleted it
                about = path.stat()
                files.append((about.st_mtime, about.st_size, path))
    total = sum(size for _, size, _ in files)
    for _, size, path in sorted(files):
        if total <= most:
            return
        path.unlink(missing_ok=True)
        total -= size
