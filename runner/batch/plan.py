"""What a command asks for, and what of it is left to do."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ..errors import UserError
from ..exchange import formats
from ..system.progress import Progress
from .bounded import Bounds
from .inputs import Source, files_of, named_apart
from .manifest import Entry, Manifest
from .task import NPZ, Cleaning, Files, program

UNDONE: dict[str, Any] = {"state": "queued", "error": "", "cause": "", "bound": None, "problems": (), "figures": {}}
UNDONE |= {"output": "", "size": 0, "sha256": "", "beside": {}, "notes": ()}  # of an entry that is to be done again
TOLD_EVERY = 500  # clips, between lines on how far the plan is


@dataclass(frozen=True)
class Options:
    """What a batch is to do.

    listed        a file with more clips, one a line
    workers       processes on this machine; scheduler: the address of a Dask cluster to use instead
    to, fps       the kind of file to make, and samples a second if not the clip's
    report        measure every motion at length, too
    retry_failed  solve again what failed for a reason of its own and has not changed since
    cleaning      what to do to recordings, which the sources are then; None for clips
    """

    listed: str | None = None
    workers: int = 1
    scheduler: str | None = None
    to: str = NPZ
    fps: float | None = None
    report: bool = False
    retry_failed: bool = False
    cleaning: Cleaning | None = None

    @property
    def ending(self) -> str:
        return ".npz" if self.to == NPZ else formats.writer(self.to).ending

    def digest(self, files: Files) -> str:
        """Of everything that a clip's output depends on."""
        done = () if self.cleaning is None else (self.cleaning,)
        return files.digest(program(), self.to, self.fps, self.report, *done)


@dataclass(frozen=True)
class Clip:
    """A clip of the command under the name that no other has."""

    name: str
    source: Source


@dataclass(frozen=True)
class Plan:
    """All clips of the command, those of them that are left to do, and the figures that were read for them."""

    all: list[Clip]
    left: list[Clip]
    figures: dict[Path, dict[Path, bytes]]


def planned(found: list[Source], manifest: Manifest, options: Options, bounds: Bounds, progress: Progress) -> Plan:
    """Whatever has changed, has not been done, or is not there any more is queued."""
    folder = manifest.path.parent
    known = {entry.source: entry.clip for entry in manifest.entries.values()}
    fresh = [source for source in found if source.place(folder) not in known]
    named = {source.place(folder): str(source.name) for source in named_apart(fresh, manifest.entries.keys())} | known
    clips = [Clip(named[source.place(folder)], source) for source in found]
    figures: dict[Path, dict[Path, bytes]] = {}
    left, changed = [], []
    for number, clip in enumerate(clips, 1):
        if number % TOLD_EVERY == 0:
            progress.step("reading", number / len(clips), f"{number} of {len(clips)} clips")
        before = manifest.entries.get(clip.name)
        digest = _digest(clip.source, figures, options)
        if before is None or before.input != digest:
            now = Entry(clip.name, clip.source.place(folder), input=digest)
        elif before.state != "failed" and before.holds(folder):
            if before.state == "done":
                continue
            changed.append(replace(before, state="done"))  # its files were written, and nothing after that
            continue
        elif _final(before, options, bounds):
            continue
        else:
            now = replace(before, **UNDONE)
        changed.append(now)
        left.append(clip)
    if changed:
        manifest.record(changed)
    return Plan(clips, left, figures)


def _digest(source: Source, figures: dict[Path, dict[Path, bytes]], options: Options) -> str:
    """Empty for what cannot be read, which is told when it is its turn."""
    try:
        files = files_of(source, figures, options.cleaning)
    except (OSError, UserError):
        return ""
    return options.digest(files)


def _final(before: Entry, options: Options, bounds: Bounds) -> bool:
    """Whether a failure would be one again: not if its worker had gone, or the bound that it hit is another now."""
    if before.state != "failed" or before.cause == "lost" or options.retry_failed:
        return False
    if before.cause == "time":
        return before.bound == bounds.seconds
    return before.cause == "error" or bounds.megabytes in (None, before.bound)
