"""Limit on the memory that a file may need: a small untrusted file can request all of the memory.

The arrays of an .npz are checked by their headers, before any array is read.
"""

from __future__ import annotations

import math
import os
import zipfile
from pathlib import Path
from typing import IO, Any

from ..errors import UserError

VARIABLE = "DYNSPLINES_LARGEST"
USUAL = 1000  # [MB] default limit; ten minutes of a hundred joints at 120 Hz need 60 MB per array
MEGABYTE = 1_000_000


def bound() -> int:
    """Return the limit in bytes, by default or from the environment. Raises UserError if that is not a number of MB."""
    setting = os.environ.get(VARIABLE, "").strip()
    if not setting:
        return USUAL * MEGABYTE
    if not (setting.isascii() and setting.isdigit() and 0 < len(setting) <= 9 and int(setting)):
        raise UserError(f"{VARIABLE}={setting}: give a number of MB, such as {4 * USUAL}")
    return int(setting) * MEGABYTE


def check(where: object, size: float, what: str) -> None:
    """Raise UserError if `what` would need more bytes than the limit."""
    most = bound()
    if size > most:
        raise UserError(
            f"{where}: {what} comes to {size / MEGABYTE:,.0f} MB in memory, over {most // MEGABYTE:,} MB; "
            f"if you trust it, set {VARIABLE} to more MB"
        )


def check_file(source: Path) -> None:
    """Raise UserError for a folder, a missing file, and a file above the limit."""
    if not source.is_file():
        raise UserError(f"'{source}' is a folder, not a file" if source.is_dir() else f"no file '{source}'")
    check(source, source.stat().st_size, "it")


def check_archive(stream: IO[bytes], where: Path) -> None:
    """Raise UserError for arrays that are too large together, or larger than their data in the archive.

    A damaged archive may raise any exception. The stream is reset to its beginning.
    """
    with zipfile.ZipFile(stream) as archive:
        members = archive.infolist()
        check(where, sum(member.file_size for member in members), "what it holds")
        for member in members:
            with archive.open(member) as content:
                claimed = _size_in_header(content)
            if claimed > member.file_size:
                raise UserError(f"{where}: '{member.filename}' does not have the size in its header; it is damaged")
    stream.seek(0)


def _size_in_header(content: IO[bytes]) -> int:
    """Return the bytes that an array's header requests; 0 for other content, which its reader reports."""
    import numpy as np  # imported here because other limits do not need it

    heads = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
    try:
        head: Any = heads.get(np.lib.format.read_magic(content))
        shape, _, kind = head(content) if head else ((0,), False, np.dtype("u1"))
    except ValueError:
        return 0
    return math.prod(shape) * max(kind.itemsize, 1)
