"""Locks of files and folders that end with the process that holds them. Windows has none of them."""

from __future__ import annotations

import json
import os
import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import UserError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

NAME = "manifest.lock"


def hold(handle: int, *, waits: bool) -> bool:
    """Lock an open file or folder; return False if another process has locked it, or there are no locks."""
    if fcntl is None:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX if waits else fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:  # some network disks do not support locks
        return False
    return True


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold the lock of a folder. Its file contains the process, the host and the time.

    The lock of a killed process is taken over. The lock file of another host is trusted, because not every network disk
    shares locks. Raises UserError if the folder is locked.
    """
    if fcntl is None:
        raise UserError("batches need a system with POSIX locks, such as Linux or macOS")
    path = folder / NAME
    while (handle := _taken(path)) is None:
        pass
    owner = {"pid": os.getpid(), "host": socket.gethostname(), "since": time.strftime("%Y-%m-%d %H:%M:%S")}
    os.ftruncate(handle, 0)
    os.pwrite(handle, json.dumps(owner).encode(), 0)
    try:
        yield
    finally:
        path.unlink(missing_ok=True)
        os.close(handle)


def _taken(path: Path) -> int | None:
    """Return the handle of the locked file; None if its last owner removed it meanwhile."""
    assert fcntl is not None
    try:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o644)
    except OSError as error:
        raise UserError(f"cannot write '{path}': {error.strerror}") from None
    try:
        owner = _owner(handle)
        who = f"process {owner.get('pid', '?')} on {owner.get('host', '?')} since {owner.get('since', '?')}"
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise UserError(f"'{path.parent}' is in use by {who}; wait for it, or end it") from None
        if owner.get("host", socket.gethostname()) != socket.gethostname():
            raise UserError(f"'{path.parent}' was in use by {who}; if that has ended, remove '{path}'")
        if path.exists() and os.path.samestat(path.stat(), os.fstat(handle)):
            return handle
    except BaseException:
        os.close(handle)
        raise
    os.close(handle)
    return None


def _owner(handle: int) -> dict[str, object]:
    """Return the content of a lock file; {} before its owner has written it."""
    try:
        owner = json.loads(os.pread(handle, 10_000, 0))
    except ValueError:
        return {}
    return owner if isinstance(owner, dict) else {}
