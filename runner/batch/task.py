"""A clip as it is sent to a worker, the options of a batch, and the outcome."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import metadata
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator

from ..errors import UserError

if TYPE_CHECKING:
    from ..clean.command import Source as Recording

NPZ = "npz"


@cache
def program() -> str:
    """Return the version of this program."""
    return metadata.version("dynamic-splines")


@dataclass(frozen=True)
class BatchOptions:
    """The options of the command, in its units, with their defaults as None. Raises UserError for invalid ones.

    Attributes:
        cluster: The address of a Dask scheduler; None: workers of this machine.
        cleaning: A recording to clean, but for its file; None for clips.
    """

    listed: str | None = None
    workers: int | None = None
    cluster: str | None = None
    to: str = NPZ
    fps: float | None = None
    limit_time: float = 3600.0
    report: bool = False
    retry_failed: bool = False
    cleaning: Recording | None = None

    def __post_init__(self) -> None:
        if self.workers is not None and self.cluster is not None:
            raise UserError("--workers are of this machine and --cluster is elsewhere; give one of them")
        if self.report and self.cleaning is not None:
            raise UserError("--report is for clips, not for recordings")
        assert self.suffix

    @property
    def suffix(self) -> str:
        """The extension of the output. Raises UserError for an unknown format."""
        if self.to == NPZ:
            return ".npz"
        from ..exchange import formats  # imported here because the command line imports this file

        return formats.writer(self.to).ending


@dataclass(frozen=True)
class Task:
    """A clip to solve, or a recording to clean, with all files that it needs.

    Attributes:
        clip: The path of the clip in a common folder; a name without extension is that of a shipped clip.
        files: Contents by path in this folder.
        others: Paths of files that replace those of the clip or of the options: "figure", "scene", "map".
        output: The name of the file to write.
        allow_outside: Whether models may refer to files outside their folder, which are in `files`.
        program: The version of this program at the sender.
    """

    clip: str
    files: Mapping[str, bytes]
    others: Mapping[str, str] = field(default_factory=dict)
    options: BatchOptions = BatchOptions()
    output: str = ""
    allow_outside: bool = False
    program: str = field(default_factory=program)

    @property
    def digest(self) -> str:
        """A hash of everything on which the output depends."""
        options = self.options
        kinds = (options.to, options.fps, options.report, options.cleaning)
        digest = hashlib.sha256(repr((self.clip, *sorted(self.others.items()), self.program, *kinds)).encode())
        for name, data in sorted(self.files.items()):
            digest.update(f"\n{name}\n{len(data)}\n".encode() + data)
        return digest.hexdigest()[:32]


def _violation(table: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return a violation as a table. Raises ValueError for values that a batch cannot print and compare."""
    numbers = [table.get(name) for name in ("amount", "bound")]
    if not isinstance(table.get("text"), str) or not all(isinstance(x, int | float) and x > 0 for x in numbers):
        raise ValueError(f"'violations' has {table!r}")
    return table


@dataclass(frozen=True)
class Result:
    """The measurements of a clip's motion, or its error.

    Attributes:
        error: The reason of a failure; "" for a solved clip.
        seconds: The duration of the work [s].
        violations: The violations, worst first, as tables.
        notes: Content that the output's format cannot store, and warnings.
        files: The files of the motion by name: the output first, then files that belong to it, such as meshes.
    """

    error: str = ""
    seconds: float = 0.0
    violations: tuple[Annotated[Mapping[str, Any], AfterValidator(_violation)], ...] = ()
    notes: tuple[str, ...] = ()
    files: Mapping[str, Any] = field(default_factory=dict)
