"""The user's cache folder, of solved clips.

A file is named by a hash of everything on which its content depends. An old file is therefore never wrong, only unused.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from ..errors import UserError
from .output import Replacement

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


def hash_of(parts: Iterable[bytes]) -> str:
    """Return a hash as 40 hexadecimal digits."""
    digest = hashlib.blake2b(digest_size=20)
    for part in parts:
        digest.update(len(part).to_bytes(8, "big"))
        digest.update(part)
    return digest.hexdigest()


def version_of(package: str) -> str:
    """Return a package's version; "none" if it is not installed."""
    from importlib.metadata import PackageNotFoundError, version  # imported here because it is slow

    try:
        return version(package)
    except PackageNotFoundError:
        return "none"


def store(file: Path, content: bytes, most: int) -> None:
    """Write a file atomically if possible; all files of its kind together have at most `most` bytes."""
    with suppress(OSError, UserError):
        file.parent.mkdir(parents=True, exist_ok=True)
        with Replacement(file) as temporary:
            temporary.write_bytes(content)
        _limit_size(file.parent, file.suffix, most)


def _limit_size(folder: Path, suffix: str, most: int) -> None:
    """Delete the least recently used files, complete or not, until the rest is at most `most` bytes."""
    pattern = re.compile(rf"[0-9a-f]{{40}}{suffix}|\.[0-9a-f]{{40}}\.\w+\.partial{suffix}")
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
