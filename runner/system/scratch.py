"""Folders for what is needed only while something runs, among the system's temporary files.

A program that is killed leaves its folder behind; the next one that makes a folder removes it. The kernel's lock on a
folder shows whether its creator is still running.
"""

from __future__ import annotations

import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

PREFIX = "dynsplines-scratch-"


@contextmanager
def scratch() -> Iterator[Path]:
    """A new private folder, removed with its content when the block ends."""
    _clear(Path(tempfile.gettempdir()))
    folder, handle = _begun()
    while handle is not None and not folder.exists():  # another program took it, not yet locked, for a leftover
        os.close(handle)
        folder, handle = _begun()
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        if handle is not None:
            os.close(handle)


def _begun() -> tuple[Path, int | None]:
    """A new folder and the handle that locks it; None without locks, and then nothing is removed."""
    folder = Path(tempfile.mkdtemp(prefix=PREFIX))
    if fcntl is None:
        return folder, None
    with suppress(FileNotFoundError):
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        with suppress(OSError):  # not every network disk can
            fcntl.flock(handle, fcntl.LOCK_EX)
        return folder, handle
    return _begun()


def _clear(place: Path) -> None:
    """Remove folders of killed programs of this user."""
    if fcntl is None:
        return
    with suppress(OSError):
        for name in os.listdir(place):  # noqa: PTH208, of a hundred thousand names
            if name.startswith(PREFIX):
                _remove_if_left(place / name)


def _remove_if_left(folder: Path) -> None:
    """Unless its creator is still running, or is another user."""
    assert fcntl is not None
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
        try:
            status = os.fstat(handle)
            if status.st_uid != os.geteuid() or stat.S_IMODE(status.st_mode) != stat.S_IRWXU:
                return
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            shutil.rmtree(folder)
        finally:
            os.close(handle)
