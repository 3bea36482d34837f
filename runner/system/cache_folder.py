"""The user's folder for what this program could find again: solved clips, and which renderer worked."""

from __future__ import annotations

import os
from pathlib import Path

PLACE = "DYNSPLINES_CACHE"
OFF = ("off", "0", "no", "false")


def place() -> Path | None:
    """The folder, whether or not it is there; None where nothing is to be kept."""
    asked = os.environ.get(PLACE, "").strip()
    if asked.lower() in OFF:
        return None
    if asked:
        return Path(asked)
    from platformdirs import user_cache_path

    return user_cache_path("dynsplines", appauthor=False)
