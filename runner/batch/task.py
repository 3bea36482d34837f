"""A clip as it goes to a worker: its files and what is to be made of them. Imports nothing that takes long."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import metadata
from typing import Any

NPZ = "npz"


@dataclass(frozen=True)
class Files:
    """A clip's files by their path below a folder that holds them all.

    clip    which of them is the clip; a name without an ending is one that ships
    figure  which of them is the figure, where the clip says it by a path that is good only here
    others  which of them is what else was asked for with a recording: "figure", "scene", "map"
    """

    clip: str
    files: Mapping[str, bytes]
    figure: str | None = None
    others: Mapping[str, str] = field(default_factory=dict)

    def digest(self, *also: object) -> str:
        """Changes whenever the motion could."""
        seen = hashlib.sha256(repr((self.clip, self.figure, *sorted(self.others.items()), *also)).encode())
        for name, data in sorted(self.files.items()):
            seen.update(f"\n{name}\n{len(data)}\n".encode())
            seen.update(data)
        return seen.hexdigest()[:32]


@dataclass(frozen=True)
class Cleaning:
    """What is to be done to recordings, which are then no clips.

    figure  the one that they are for, a shipped one's name or MJCF; scene, map: TOML files, as `clean` takes them
    kind    their format, where the ending does not tell it
    within  [m] how far hands, feet and pelvis may move
    apart   limbs are kept out of each other: they are brought on to another figure
    """

    figure: str | None = None
    scene: str | None = None
    map: str | None = None
    kind: str | None = None
    within: float | None = None
    apart: bool = False


@dataclass(frozen=True)
class Task:
    """A clip to be solved, or a recording to be cleaned.

    to       the kind of file to make, "npz" or one of the formats
    fps      samples a second; None: the clip's
    report   measure the motion at length, too
    program  the version of this program that asks
    allow_outside  let a model read files outside its folder: those that came along with it
    cleaning  what is to be done to a recording; None for a clip
    """

    files: Files
    to: str = NPZ
    fps: float | None = None
    report: bool = False
    program: str = ""
    allow_outside: bool = False
    cleaning: Cleaning | None = None


@dataclass(frozen=True)
class Product:
    """What comes back: the bytes of the output, and what is wrong with the motion, worst first, as plain tables.

    beside   what is to lie beside the output: by an ending that goes on its name, or by a name in its folder
    notes    what the format could not hold, a line each
    figures  of a recording: what was measured, before and after, by what it says and its unit
    """

    data: bytes
    problems: tuple[dict[str, Any], ...] = ()
    figures: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    beside: Mapping[str, bytes] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


@cache
def program() -> str:
    """The version of this program."""
    try:
        return metadata.version("dynamic-splines")
    except metadata.PackageNotFoundError:
        return "unknown"
