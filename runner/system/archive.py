"""Memory of the arrays of an .npz, from their headers before any is read."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path
from typing import IO, Any

import numpy as np

from ..errors import UserError
from . import size_limit

HEADS = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}


def check(stream: IO[bytes], where: Path) -> None:
    """Raise UserError for arrays that are too large together, or larger than their data in the archive.

    A damaged archive may raise any exception. The stream is reset to its beginning.
    """
    with zipfile.ZipFile(stream) as archive:
        members = archive.infolist()
        size_limit.check(where, sum(member.file_size for member in members), "what it holds")
        for member in members:
            with archive.open(member) as content:
                claimed = _claimed(content)
            if claimed > member.file_size:
                raise UserError(f"{where}: '{member.filename}' does not have the size in its header; it is damaged")
    stream.seek(0)


def _claimed(content: IO[bytes]) -> int:
    """Return the bytes that an array's header requests; 0 for other content, which its reader reports."""
    try:
        head: Any = HEADS.get(np.lib.format.read_magic(content))
        shape, _, kind = head(content) if head else ((0,), False, np.dtype("u1"))
    except ValueError:
        return 0
    return math.prod(shape) * max(kind.itemsize, 1)
