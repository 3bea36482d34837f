"""What the arrays of an .npz come to in memory, told from their heads before any is read."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path
from typing import IO, Any

import numpy as np

from ..errors import UserError
from . import largest

HEADS = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}


def check(stream: IO[bytes], where: Path) -> None:
    """Raises UserError for arrays that are too large together, or larger than what the archive has of them.

    Raises nearly anything for a damaged archive. The stream is left at its begin.
    """
    with zipfile.ZipFile(stream) as archive:
        members = archive.infolist()
        largest.check(where, sum(member.file_size for member in members), "what it holds")
        for member in members:
            with archive.open(member) as content:
                claimed = _claimed(content)
            if claimed > member.file_size:
                raise UserError(f"{where}: '{member.filename}' is not as large as it says")
    stream.seek(0)


def _claimed(content: IO[bytes]) -> int:
    """[bytes] that an array's head asks for; 0 for what is no array of ours, which is told by whoever reads it."""
    try:
        head: Any = HEADS.get(np.lib.format.read_magic(content))
        shape, _, kind = head(content) if head else ((0,), False, np.dtype("u1"))
    except ValueError:
        return 0
    return math.prod(shape) * max(kind.itemsize, 1)
