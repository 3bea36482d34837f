"""A clip as it is sent to a worker, the options and limits of the batch, and the outcome."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import metadata
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator, AliasChoices, Field

from ..errors import UserError
from ..exchange import formats

if TYPE_CHECKING:
    from ..clean.command import Source as Recording

FORMER_QUANTITIES = {  # names in older manifests, and the present ones
    "deepest in anything [mm]": "deepest penetration [mm]",
    "slip of a stance, most [mm]": "largest stance slip [mm]",
    "sole at rest, off the ground [mm]": "largest sole height in a stance [mm]",
    "joint beyond its range [°]": "largest joint range excess [°]",
    "joint speed, most [rad/s]": "largest joint speed [rad/s]",
    "joint acceleration, most [rad/s²]": "largest joint acceleration [rad/s²]",
    "jerk of bodies, mean [m/s³]": "mean body jerk [m/s³]",
    "force nothing supplies, mean [weight]": "mean unsupported force [weight]",
}
NPZ = "npz"


@dataclass(frozen=True)
class Files:
    """A clip and the files that it needs, by their paths in a common folder.

    Attributes:
        clip: The path of the clip; a name without extension is that of a shipped clip.
        files: Contents by path.
        others: Paths of files that replace those of the clip or of the command: "figure", "scene", "map".
    """

    clip: str
    files: Mapping[str, bytes]
    others: Mapping[str, str] = field(default_factory=dict)

    def digest(self, *options: object) -> str:
        """Return a hash of the files and the options on which the motion depends."""
        digest = hashlib.sha256(repr((self.clip, *sorted(self.others.items()), *options)).encode())
        for name, data in sorted(self.files.items()):
            digest.update(f"\n{name}\n{len(data)}\n".encode())
            digest.update(data)
        return digest.hexdigest()[:32]


@dataclass(frozen=True)
class Limits:
    """Limits of one clip.

    Attributes:
        seconds: Wall-clock time [s].
        megabytes: Resident memory [MB], of which an idle process has about 220. None: an equal share of the memory of
            the machine or the Dask worker.
    """

    seconds: float = 3600.0
    megabytes: float | None = None


@dataclass(frozen=True)
class Options:
    """The options of a batch. Raises UserError for invalid ones.

    Attributes:
        listed: A file with more clips, one per line.
        workers: The number of processes of this machine; None: one per core.
        scheduler: The address of a Dask cluster to use instead.
        to: The format of the output.
        fps: Samples per second [1/s]; None: those of the clip.
        report: Whether to measure every motion in full.
        retry_failed: Whether to solve unchanged clips again that have failed.
        cleaning: A recording to clean, but for its file; None for clips.
        max_displacement: The largest displacement of hands, feet and pelvis [m].
    """

    listed: str | None = None
    workers: int | None = None
    scheduler: str | None = None
    to: str = NPZ
    fps: float | None = None
    limits: Limits = Limits()
    report: bool = False
    retry_failed: bool = False
    cleaning: Recording | None = None
    max_displacement: float | None = None

    def __post_init__(self) -> None:
        if self.workers is not None and self.scheduler is not None:
            raise UserError("--workers are of this machine and --scheduler is elsewhere; give one of them")
        if self.report and self.cleaning is not None:
            raise UserError("--report is for clips; a recording is measured before and after as it is")
        assert self.suffix

    @property
    def suffix(self) -> str:
        """The extension of the output. Raises UserError for an unknown format."""
        return ".npz" if self.to == NPZ else formats.writer(self.to).ending

    def digest(self, files: Files) -> str:
        """Return a hash of everything that the output of a clip depends on."""
        return files.digest(program(), self.to, self.fps, self.report, self.cleaning, self.max_displacement)


@dataclass(frozen=True)
class Task:
    """A clip to solve, or a recording to clean.

    Attributes:
        output: The name of the file to write.
        allow_outside: Whether models may refer to files outside their folder, which are in `files`.
        program: The version of this program at the sender.
    """

    files: Files
    output: str
    options: Options = Options()
    allow_outside: bool = False
    program: str = field(default_factory=lambda: program())


def _violation(table: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return a violation as a table. Raises ValueError for values that a batch cannot print and compare."""
    numbers = [table.get(name) for name in ("amount", "bound")]
    if not isinstance(table.get("text"), str) or not all(isinstance(x, int | float) and x > 0 for x in numbers):
        raise ValueError(f"'violations' has {table!r}")
    return table


def _present_quantities(figures: Mapping[str, tuple[float, float]]) -> Mapping[str, tuple[float, float]]:
    """Return measurements by their present names."""
    return {FORMER_QUANTITIES.get(name, name): values for name, values in figures.items()}


@dataclass(frozen=True)
class Result:
    """The measurements of a clip's motion, or its error.

    Attributes:
        cause: Of a failure: "error", "time", "memory" or "lost" (its process or worker ended).
        bound: The limit of a failure by time [s] or memory [MB].
        seconds: The duration of the last attempt [s].
        violations: The violations, worst first, as tables.
        figures: Values of a recording before and after cleaning, by quantity and unit.
        notes: Content that the output's format cannot store, and warnings.
    """

    cause: str = ""
    error: str = ""
    bound: float | None = None
    seconds: float = 0.0
    worker: str = ""
    violations: Annotated[
        tuple[Annotated[Mapping[str, Any], AfterValidator(_violation)], ...],
        Field(validation_alias=AliasChoices("violations", "problems")),  # its former name, in older manifests
    ] = ()
    figures: Annotated[Mapping[str, tuple[float, float]], AfterValidator(_present_quantities)] = field(
        default_factory=dict
    )
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Outcome(Result):
    """A result, and the files of the motion by name: the output first, then files that belong to it, such as meshes."""

    files: Mapping[str, bytes] = field(default_factory=dict)


@cache
def program() -> str:
    """Return the version of this program."""
    try:
        return metadata.version("dynamic-splines")
    except metadata.PackageNotFoundError:
        return "unknown"
