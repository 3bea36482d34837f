"""One program at a time in a folder: a lock that goes with the process that holds it, however that ends."""

from __future__ import annotations

import json
import os
import socket
import time
from pathlib import Path
from typing import Self

from ..errors import UserError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

NAME = "manifest.lock"


class Lock:
    """Held within a `with` block. The file says who: process, host, since when.

    The kernel's lock tells whether that process still runs; what a killed one leaves behind is taken over. A file from
    another host is believed, for not every network disk carries locks over.
    """

    def __init__(self, folder: Path) -> None:
        self.path = folder / NAME
        self._handle = -1

    def __enter__(self) -> Self:
        if fcntl is None:
            raise UserError("batches need a system with POSIX locks and limits, such as Linux or macOS")
        while True:
            try:
                handle = os.open(self.path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o644)
            except OSError as error:
                raise UserError(f"cannot write '{self.path}': {error.strerror}") from None
            try:
                self._take(handle)
                if self._is(handle):
                    break
            except BaseException:
                os.close(handle)
                raise
            os.close(handle)  # it was removed by who held it, between our opening and locking it
        owner = {"pid": os.getpid(), "host": socket.gethostname(), "since": time.strftime("%Y-%m-%d %H:%M:%S")}
        os.ftruncate(handle, 0)
        os.pwrite(handle, json.dumps(owner).encode(), 0)
        self._handle = handle
        return self

    def __exit__(self, *_: object) -> None:
        self.path.unlink(missing_ok=True)
        os.close(self._handle)

    def _take(self, handle: int) -> None:
        assert fcntl is not None
        owner = _owner(handle)
        who = f"process {owner.get('pid', '?')} on {owner.get('host', '?')} since {owner.get('since', '?')}"
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise UserError(f"'{self.path.parent}' is being worked on by {who}; wait for it, or end it") from None
        if owner.get("host", socket.gethostname()) != socket.gethostname():
            raise UserError(
                f"'{self.path.parent}' was being worked on by {who}; if that has ended, remove '{self.path}'"
            )

    def _is(self, handle: int) -> bool:
        """Whether the file that was opened is the one that has the name now."""
        try:
            named, opened = self.path.stat(), os.fstat(handle)
        except FileNotFoundError:
            return False
        return (named.st_dev, named.st_ino) == (opened.st_dev, opened.st_ino)


def _owner(handle: int) -> dict[str, object]:
    """Who wrote the file; empty if nobody has yet."""
    try:
        owner = json.loads(os.pread(handle, 10_000, 0))
    except ValueError:
        return {}
    return owner if isinstance(owner, dict) else {}
