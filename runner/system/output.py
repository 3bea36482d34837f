"""The one way to write a file: whole or not at all, under its name only once the disk has it.

Output is written next to the target first, to a file with an unguessable name that only its owner can read.
A link stays a link, and what it leads to is replaced; what is no plain file, a device or a pipe, is refused. The new
file may be read by whom the old one could be, or, where there was none, by whom the umask lets.

A program that is killed leaves its temporary file behind; the next one that writes to the same target removes it. The
kernel's lock on such a file shows whether its writer is still running.
"""

from __future__ import annotations

import errno
import os
import re
import secrets
import stat
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from ..errors import UserError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

NO_ROOM = (errno.ENOSPC, errno.EFBIG, errno.EDQUOT)  # errors whose message lacks the file's name
ALL = 0o666  # what the umask takes away from, for a file that was not there
OWNER = 0o600
MODE = 0o777  # what of an older file's mode the new one has
MOST_OF_A_NAME = 40  # [characters] of the target's in a temporary name: at most 160 of the 255 bytes of a file's name
TEMPORARY = re.compile(r"\..*\.[0-9a-f]{16}\.partial(\.[^./]*)?", re.DOTALL)
REFUSED = {
    stat.S_IFDIR: "it is a folder",
    stat.S_IFIFO: "it is a pipe; name a file",
    stat.S_IFSOCK: "it is a socket; name a file",
    stat.S_IFCHR: "it is a device; name a file",
    stat.S_IFBLK: "it is a device; name a file",
}


class Replacement:
    """A temporary file beside the target that takes its place when the block ends well, and is removed otherwise."""

    def __init__(self, target: Path) -> None:
        self.target = target

    def __enter__(self) -> Path:
        self._real = real_target(self.target)
        clear(self._real)
        older = _older(self._real)
        while not self._begun(ALL if older is None else OWNER):
            pass
        self._mode = stat.S_IMODE((older or os.fstat(self._handle)).st_mode) & MODE
        if os.name == "nt":  # what is open cannot be renamed there
            os.close(self._handle)
        return self.temporary

    def __exit__(self, kind: object, value: object, trace: object) -> None:
        try:
            if kind is None:
                self._put()
            elif isinstance(value, OSError) and value.errno in NO_ROOM:
                raise UserError(f"cannot write '{self.target}': {value.strerror}") from None
        finally:
            for path in _parts(self.temporary):
                path.unlink(missing_ok=True)
            if os.name != "nt":
                os.close(self._handle)

    def _begun(self, mode: int) -> bool:
        """A new temporary file, locked; False where another writer took it, not yet locked, for a leftover."""
        name = f".{self._real.name[:MOST_OF_A_NAME]}.{secrets.token_hex(8)}.partial{self.target.suffix}"
        self.temporary = self._real.with_name(name)
        flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0)
        try:
            self._handle = os.open(self.temporary, flags, mode)
        except OSError as error:
            raise UserError(f"cannot write '{self.target}': {error.strerror}") from None
        if not _locked(self._handle) or self.temporary.exists():
            return True
        os.close(self._handle)
        return False

    def _put(self) -> None:
        """In the target's place, once its bytes are on the disk; then the folder's new entry."""
        try:
            self.temporary.chmod(self._mode)
            _synchronised(self.temporary)
            self.temporary.replace(self._real)
        except OSError as error:
            raise UserError(f"cannot write '{self.target}': {error.strerror}") from None
        with suppress(OSError):  # not every disk can, nor Windows
            _synchronised(self._real.parent)


def real_target(target: Path) -> Path:
    """The file to replace, after resolving links; raises UserError unless it is a plain file."""
    older = _older(target)
    if older is not None and not stat.S_ISREG(older.st_mode):
        raise UserError(f"cannot write '{target}': {REFUSED.get(stat.S_IFMT(older.st_mode), 'it is not a plain file')}")
    return Path(os.path.realpath(target))


def check_target(target: Path, *, overwrite: bool = True) -> None:
    """Raise UserError unless the file can be created, or may be overwritten."""
    real = real_target(target)
    if not real.parent.is_dir():
        raise UserError(f"cannot write '{target}': no folder '{real.parent if target.is_symlink() else target.parent}'")
    if not os.access(real.parent, os.W_OK):
        raise UserError(f"cannot write '{target}': the folder is not writable")
    if target.exists() and not overwrite:
        raise UserError(f"'{target}' already exists; give another -o, or --overwrite")


def clear(target: Path) -> None:
    """Removes what killed programs had begun to write to a file."""
    start = f".{target.name[:MOST_OF_A_NAME]}."
    with suppress(OSError):
        for name in os.listdir(target.parent):  # noqa: PTH208, of a hundred thousand names
            if name.startswith(start) and TEMPORARY.fullmatch(name):
                _remove_if_left(target.with_name(name))


def clear_below(folder: Path) -> None:
    """Removes what killed programs had begun to write anywhere in a folder."""
    for path in list(folder.rglob(".*")):
        if TEMPORARY.fullmatch(path.name):
            _remove_if_left(path)


def beside(temporary: Path, ending: str) -> Path:
    """The name of a further file that is needed while a temporary one is written; it goes when that one does."""
    return temporary.with_name(f"{temporary.name}.{secrets.token_hex(8)}{ending}")


def _parts(temporary: Path) -> Iterator[Path]:
    """A temporary file last, and before it those `beside` it."""
    with suppress(OSError):
        for name in os.listdir(temporary.parent):  # noqa: PTH208
            if name.startswith(f"{temporary.name}."):
                yield temporary.with_name(name)
    yield temporary


def _remove_if_left(path: Path) -> None:
    """Remove leftovers, unless their writer is still running; files next to a temporary one are checked with it."""
    if fcntl is None:
        return
    with suppress(OSError):
        if not stat.S_ISREG(path.lstat().st_mode):
            return
        handle = os.open(path, os.O_RDWR | os.O_NOFOLLOW)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            for part in _parts(path):
                part.unlink(missing_ok=True)
        finally:
            os.close(handle)


def _locked(handle: int) -> bool:
    """Wait until it is decided whether the file is a leftover; False where there are no locks, and none is removed."""
    if fcntl is None:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
    except OSError:  # not every network disk can
        return False
    return True


def _older(target: Path) -> os.stat_result | None:
    """The present file, after resolving links; None if there is none. Raises UserError if it cannot be read."""
    try:
        return target.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        raise UserError(f"cannot write '{target}': {error.strerror}") from None


def _synchronised(path: Path) -> None:
    """Waits until the disk has a file, or a folder's list of names."""
    handle = os.open(path, (os.O_RDWR if os.name == "nt" else os.O_RDONLY) | getattr(os, "O_CLOEXEC", 0))
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
