"""A clip as it goes to a worker: its files and what is to be made of them. Imports nothing that takes long."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import metadata
from typing import Any

NPZ = "npz"


@dataclass(frozen=True)
class Files:
    """A clip's files by their path below a folder that holds them all.

    clip    which of them is the clip; a name without an ending is one that ships
    figure  which of them is the figure, where the clip says it by a path that is good only here
    """

    clip: str
    files: Mapping[str, bytes]
    figure: str | None = None

    def digest(self, *also: object) -> str:
        """Changes whenever the motion could."""
        seen = hashlib.sha256(repr((self.clip, self.figure, *also)).encode())
        for name, data in sorted(self.files.items()):
            seen.update(f"\n{name}\n{len(data)}\n".encode())
            seen.update(data)
        return seen.hexdigest()[:32]


@dataclass(frozen=True)
class Task:
    """A clip to be solved.

    to       the kind of file to make, "npz" or one of the formats
    fps      samples a second; None: the clip's
    report   measure the motion at length, too
    program  the version of this program that asks
    allow_outside  let a model read files outside its folder: those that came along with it
    """

    files: Files
    to: str = NPZ
    fps: float | None = None
    report: bool = False
    program: str = ""
    allow_outside: bool = False


@dataclass(frozen=True)
class Product:
    """What comes back: the bytes of the output, and what is wrong with the motion, worst first, as plain tables."""

    data: bytes
    problems: tuple[dict[str, Any], ...] = ()


@cache
def program() -> str:
    """The version of this program."""
    try:
        return metadata.version("dynamic-splines")
    except metadata.PackageNotFoundError:
        return "unknown"
