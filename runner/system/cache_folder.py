"""The user's folder for what this program could find again: solved clips, how they looked, which renderer worked."""

from __future__ import annotations

import os
import re
from contextlib import suppress
from pathlib import Path

PLACE = "DYNSPLINES_CACHE"
OFF = ("off", "0", "no", "false")


def place() -> Path | None:
    """The folder, whether or not it is there; None where nothing is to be kept."""
    setting = os.environ.get(PLACE, "").strip()
    if setting.lower() in OFF:
        return None
    if setting:
        return Path(setting)
    from platformdirs import user_cache_path

    return user_cache_path("dynsplines", appauthor=False)


def make_room(folder: Path, own: re.Pattern[str], most: int) -> None:
    """Takes away files of such names that were not used for longest, until the rest is small enough [bytes]."""
    files: list[tuple[float, int, Path]] = []
    for path in folder.iterdir():
        if own.fullmatch(path.name):
            with suppress(OSError):  # another command may have taken it away
                about = path.stat()
                files.append((about.st_mtime, about.st_size, path))
    total = sum(size for _, size, _ in files)
    for _, size, path in sorted(files):
        if total <= most:
            return
        path.unlink(missing_ok=True)
        total -= size
