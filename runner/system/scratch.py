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

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

PREFIX = "dynsplines-scratch-"


@contextmanager
def scratch() -> Iterator[Path]:
    """Yield a new private folder, which is removed with its content when the block ends."""
    _clear(Path(tempfile.gettempdir()))
    folder, handle = _create()
    while handle is not None and not folder.exists():  # another program removed it before it was locked
        os.close(handle)
        folder, handle = _create()
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        if handle is not None:
            os.close(handle)


def _create() -> tuple[Path, int | None]:
    """Return a new folder and the handle that locks it; None without locks, in which case leftovers are not removed."""
    folder = Path(tempfile.mkdtemp(prefix=PREFIX))
    if fcntl is None:
        return folder, None
    with suppress(FileNotFoundError):
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        with suppress(OSError):  # some network disks do not support locks
            fcntl.flock(handle, fcntl.LOCK_EX)
        return folder, handle
    return _create()


def _clear(place: Path) -> None:
    if fcntl is None:
        return
    with suppress(OSError):
        for name in os.listdir(place):  # noqa: PTH208, of a hundred thousand names
            if name.startswith(PREFIX):
                _remove_leftover(place / name)


def _remove_leftover(folder: Path) -> None:
    """Remove a folder, unless its creator is still running or is another user."""
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
