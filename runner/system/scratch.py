"""Temporary folders, among the system's temporary files.

A killed program leaves its folder; the next program that creates one removes it. The kernel's lock on a folder shows
whether its creator is still running.
"""

from __future__ import annotations

import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from .output import hold

PREFIX = "dynsplines-scratch-"


@contextmanager
def scratch() -> Iterator[Path]:
    """Yield a new private folder, which is removed with its content when the block ends."""
    _clear(Path(tempfile.gettempdir()))
    folder, handle = _create()
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        if handle is not None:
            os.close(handle)


def _create() -> tuple[Path, int | None]:
    """Return a new folder and the handle that locks it; None on Windows, where leftovers are not removed."""
    while True:
        folder = Path(tempfile.mkdtemp(prefix=PREFIX))
        if os.name == "nt":
            return folder, None
        with suppress(FileNotFoundError):  # another program removed it before it was locked
            handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
            hold(handle, waits=True)
            if folder.exists():
                return folder, handle
            os.close(handle)


def _clear(place: Path) -> None:
    with suppress(OSError):
        for name in os.listdir(place) if os.name != "nt" else ():  # noqa: PTH208, of a hundred thousand names
            if name.startswith(PREFIX):
                _remove_leftover(place / name)


def _remove_leftover(folder: Path) -> None:
    """Remove a folder, unless its creator is still running or is another user."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
        try:
            status = os.fstat(handle)
            is_own = status.st_uid == os.geteuid() and stat.S_IMODE(status.st_mode) == stat.S_IRWXU
            if is_own and hold(handle, waits=False):
                shutil.rmtree(folder)
        finally:
            os.close(handle)
