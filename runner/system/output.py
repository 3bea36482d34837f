"""Atomic writing of files: a file gets its name only when its content is complete and on the disk.

Output is first written next to the target, to a file with an unguessable name that only its owner can read. A link is
preserved, and its target is replaced. Devices, pipes and other special files are rejected. The new file has the
permissions of the old one, or those of the umask.

A killed program leaves its temporary file; the next one that writes to the same target removes it. The kernel's lock on
such a file shows whether its writer is still running.
"""

from __future__ import annotations

import errno
import os
import re
import secrets
import stat
from collections.abc import Collection
from contextlib import suppress
from pathlib import Path

from ..errors import UserError

try:
    import fcntl
except ImportError:  # Windows has no locks
    fcntl = None

NO_ROOM = (errno.ENOSPC, errno.EFBIG, errno.EDQUOT)  # errors whose message lacks the file's name
ALL = 0o666  # mode of a new file, which the umask restricts
OWNER = stat.S_IRUSR | stat.S_IWUSR
MODE = stat.S_IRWXU | stat.S_IRWXG | stat.S_IRWXO  # bits of an older file's mode that are preserved
MOST_OF_A_NAME = 40  # characters of the target's name in a temporary name, at most 160 of its 255 bytes
TEMPORARY = re.compile(r"\..*\.[0-9a-f]{16}\.partial(\.[^./]*)?", re.DOTALL)
REFUSED = {
    stat.S_IFDIR: "it is a folder; name a file in it",
    stat.S_IFIFO: "it is a pipe; name a file",
    stat.S_IFSOCK: "it is a socket; name a file",
    stat.S_IFCHR: "it is a device; name a file",
    stat.S_IFBLK: "it is a device; name a file",
}


def hold(handle: int, *, waits: bool) -> bool:
    """Lock an open file or folder; return False if another process has locked it, or there are no locks."""
    if fcntl is None:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX if waits else fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:  # some network disks do not support locks
        return False
    return True


class Replacement:
    """A temporary file that replaces the target when the block ends without an exception, and is removed otherwise."""

    def __init__(self, target: Path) -> None:
        self.target = target

    def __enter__(self) -> Path:
        self._real = real_target(self.target)
        clear(self._real)
        older = _older(self._real)
        while not self._create(ALL if older is None else OWNER):
            pass
        self._mode = stat.S_IMODE((older or os.fstat(self._handle)).st_mode) & MODE
        if os.name == "nt":  # open files cannot be renamed on Windows
            os.close(self._handle)
        return self.temporary

    def __exit__(self, kind: object, value: object, trace: object) -> None:
        try:
            if kind is None:
                self._put()
            elif isinstance(value, OSError) and value.errno in NO_ROOM:
                raise UserError(f"cannot write '{self.target}': {value.strerror}") from None
        finally:
            self.temporary.unlink(missing_ok=True)
            if os.name != "nt":
                os.close(self._handle)

    def _create(self, mode: int) -> bool:
        """Create and lock a temporary file; return False if another writer removed it before it was locked."""
        name = f".{self._real.name[:MOST_OF_A_NAME]}.{secrets.token_hex(8)}.partial{self.target.suffix}"
        self.temporary = self._real.with_name(name)
        flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0)
        try:
            self._handle = os.open(self.temporary, flags, mode)
        except OSError as error:
            raise UserError(f"cannot write '{self.target}': {error.strerror}") from None
        if not hold(self._handle, waits=True) or self.temporary.exists():
            return True
        os.close(self._handle)
        return False

    def _put(self) -> None:
        """Replace the target after the data is on the disk; then synchronise the folder."""
        try:
            self.temporary.chmod(self._mode)
            _synchronise(self.temporary)
            self.temporary.replace(self._real)
        except OSError as error:
            raise UserError(f"cannot write '{self.target}': {error.strerror}") from None
        with suppress(OSError):  # some disks, and Windows, do not support this
            _synchronise(self._real.parent)


def real_target(target: Path) -> Path:
    """Return the file to replace, after resolving links. Raises UserError unless it is a plain file."""
    older = _older(target)
    if older is not None and not stat.S_ISREG(older.st_mode):
        raise UserError(f"cannot write '{target}': {REFUSED.get(stat.S_IFMT(older.st_mode), 'it is not a plain file')}")
    return Path(os.path.realpath(target))


def check_target(target: Path, *, overwrite: bool = True, endings: Collection[str] = ()) -> None:
    """Raise UserError unless the file can be created, or may be overwritten, and has one of the extensions, if any."""
    if endings and target.suffix.lower() not in endings:
        raise UserError(f"{target}: no way to write '{target.suffix}'; endings: {', '.join(endings)}")
    real = real_target(target)
    if not real.parent.is_dir():
        folder = real.parent if target.is_symlink() else target.parent
        raise UserError(f"cannot write '{target}': no folder '{folder}'; create it, or name another")
    if not os.access(real.parent, os.W_OK):
        raise UserError(f"cannot write '{target}': the folder is not writable; name another")
    if target.exists() and not overwrite:
        raise UserError(f"'{target}' already exists; give another -o, or --overwrite")


def clear(target: Path) -> None:
    """Remove temporary files of killed programs for a target."""
    start = f".{target.name[:MOST_OF_A_NAME]}."
    with suppress(OSError):
        for name in os.listdir(target.parent):  # noqa: PTH208, of a hundred thousand names
            if name.startswith(start) and TEMPORARY.fullmatch(name):
                _remove_leftover(target.with_name(name))


def clear_below(folder: Path) -> None:
    """Remove temporary files of killed programs anywhere in a folder."""
    for path in list(folder.rglob(".*")):
        if TEMPORARY.fullmatch(path.name):
            _remove_leftover(path)


def _remove_leftover(path: Path) -> None:
    """Remove a leftover, unless its writer is still running."""
    with suppress(OSError):
        if not stat.S_ISREG(path.lstat().st_mode) or os.name == "nt":
            return
        handle = os.open(path, os.O_RDWR | os.O_NOFOLLOW)
        try:
            if hold(handle, waits=False):
                path.unlink(missing_ok=True)
        finally:
            os.close(handle)


def _older(target: Path) -> os.stat_result | None:
    """Return the status of the present file, behind links; None if it is missing, UserError if unreadable."""
    try:
        return target.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        raise UserError(f"cannot write '{target}': {error.strerror}") from None


def _synchronise(path: Path) -> None:
    """Wait until a file, or a folder's list of names, is on the disk."""
    handle = os.open(path, (os.O_RDWR if os.name == "nt" else os.O_RDONLY) | getattr(os, "O_CLOEXEC", 0))
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
