"""What became of every clip: a file of JSON lines in the folder of the results.

A line is added whenever something happens to a clip, and the last line about it counts, so that whatever ends the
program at any instant costs one line at most. When a batch begins and when it ends the file is written anew, whole or
not at all, with one line a clip.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any, Literal

from ..errors import UserError
from ..scene.outside import lies_in
from ..system.output import Replacement

NAME = "manifest.jsonl"
VERSION = 1  # of the file's form
STATES = ("queued", "running", "done", "failed")

State = Literal["queued", "running", "done", "failed"]


@dataclass(frozen=True)
class Entry:
    """A clip and what became of it.

    clip      its name, and that of its output but for the ending; nobody else's
    source    where it was found, from the manifest's folder on; "shipped:NAME" for one that ships
    input     a digest of everything that the output depends on; empty before it has been read
    attempts  how often it was begun
    seconds   of the last attempt
    output, size, sha256  the file in the manifest's folder, how many bytes it has, and a digest of them
    cause     of a failure: "error", "time", "memory" or "lost" (its process or its worker went away)
    bound     that a failure by time [s] or memory [MB] came up against
    beside    the files that belong to the output, likewise, with their digests; some are other clips', too
    problems  what is wrong with the motion, worst first: `Flaw`s as tables
    notes     what the output's format could not hold
    figures   of a recording: what was measured, before and after, by what it says and its unit
    """

    clip: str
    source: str
    state: State = "queued"
    input: str = ""
    attempts: int = 0
    seconds: float | None = None
    worker: str = ""
    output: str = ""
    size: int = 0
    sha256: str = ""
    cause: str = ""
    bound: float | None = None
    error: str = ""
    problems: tuple[dict[str, Any], ...] = ()
    figures: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    beside: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def line(self) -> str:
        """As JSON, without what there is nothing to say about."""
        told = {key: value for key, value in asdict(self).items() if value not in ("", None, 0, (), {})}
        return json.dumps(told) + "\n"

    @classmethod
    def of(cls, data: dict[str, Any]) -> Entry:
        """From JSON; raises ValueError or TypeError."""
        entry = cls(**data)
        if not isinstance(entry.problems, list | tuple) or not all(map(_is_problem, entry.problems)):
            raise TypeError(f"'problems' is {entry.problems!r}")
        if not isinstance(entry.figures, dict) or not all(map(_is_pair, entry.figures.values())):
            raise TypeError(f"'figures' is {entry.figures!r}")
        if not isinstance(entry.beside, dict) or not all(isinstance(value, str) for value in entry.beside.values()):
            raise TypeError(f"'beside' is {entry.beside!r}")
        if not isinstance(entry.notes, list | tuple) or not all(isinstance(note, str) for note in entry.notes):
            raise TypeError(f"'notes' is {entry.notes!r}")
        entry = replace(entry, problems=tuple(entry.problems), notes=tuple(entry.notes))
        if entry.state not in STATES:
            raise ValueError(f"no state '{entry.state}'; states: {', '.join(STATES)}")
        for name, kind in (
            ("clip", str),
            ("source", str),
            ("input", str),
            ("output", str),
            ("size", int),
            ("sha256", str),
        ):
            if not isinstance(getattr(entry, name), kind):
                raise TypeError(f"'{name}' is {getattr(entry, name)!r}")
        for name in (entry.clip, entry.output, *entry.beside):
            if not is_below(name):
                raise ValueError(f"'{name}' is no path in this folder")
        if not isinstance(entry.attempts, int):
            raise TypeError(f"'attempts' is {entry.attempts!r}")
        return entry

    def holds(self, folder: Path) -> bool:
        """Whether the output and what belongs to it are there with every byte that was written."""
        try:
            if not self.output or (folder / self.output).stat().st_size != self.size:
                return False
            written = {self.output: self.sha256, **self.beside}
            return all(_digest(folder / name) == digest for name, digest in written.items())
        except OSError:
            return False


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def digest_of(data: bytes) -> str:
    """What a manifest says of an output's bytes."""
    return hashlib.sha256(data).hexdigest()


def is_below(name: str) -> bool:
    """Whether a clip's name is a path that leads down from the manifest's folder."""
    path = PurePosixPath(name)
    parts = name.replace("\\", "/").split("/")
    return not (path.is_absolute() or PureWindowsPath(name).drive or ".." in parts or "\0" in name)


def check_below(folder: Path, name: str) -> None:
    """Raises UserError if a file is not to be written there: a link leads out of the manifest's folder."""
    if not lies_in(folder / name, folder):
        where = os.path.realpath(folder / name)
        raise UserError(f"'{folder / name}' leads out of the folder, to '{where}'; remove the link")


def _is_problem(told: Any) -> bool:
    """Whether a batch can say and compare it."""
    return isinstance(told, dict) and isinstance(told.get("text"), str) and _is_above(told, "amount", "bound")


def _is_pair(told: Any) -> bool:
    return isinstance(told, list | tuple) and len(told) == 2 and all(isinstance(value, int | float) for value in told)


def _is_above(told: dict[str, Any], *names: str) -> bool:
    return all(isinstance(told.get(name), int | float) and told[name] > 0 for name in names)


@dataclass
class Manifest:
    """The manifest of a folder, by whoever holds the folder's lock."""

    path: Path
    entries: dict[str, Entry] = field(default_factory=dict)
    _whole: bool = False  # its last line, that is

    @classmethod
    def of(cls, folder: Path) -> Manifest:
        """Read, or new and empty; raises UserError for a file that is none."""
        manifest = cls(folder / NAME)
        check_below(folder, NAME)
        if manifest.path.exists():
            manifest.entries = _read(manifest.path)
        return manifest

    def record(self, entries: Iterable[Entry], *, firmly: bool = True) -> None:
        """Adds a line for each.

        firmly  wait until the disk has it; what is not firm survives the end of this program, but not of the machine
        """
        if not self._whole:
            self.rewrite()
        entries = list(entries)
        try:
            with self.path.open("ab") as stream:
                stream.write("".join(entry.line() for entry in entries).encode())
                stream.flush()
                if firmly:
                    os.fsync(stream.fileno())
        except OSError as error:
            self._whole = False
            raise UserError(f"cannot write '{self.path}': {error.strerror}") from None
        self.entries |= {entry.clip: entry for entry in entries}

    def rewrite(self) -> None:
        """One line a clip, whole or not at all."""
        with Replacement(self.path) as temporary, temporary.open("wb") as stream:
            stream.write(f"{json.dumps({'dynsplines batch': VERSION})}\n".encode())
            stream.write("".join(entry.line() for entry in self.entries.values()).encode())
        self._whole = True


def _read(path: Path) -> dict[str, Entry]:
    """The last line about every clip. A last line that was cut short is as if it had not been begun."""
    lines = path.read_bytes().split(b"\n")
    lines.pop()  # nothing, or what was cut short
    entries: dict[str, Entry] = {}
    for number, line in enumerate(lines, 1):
        try:
            data = json.loads(line)
            if number == 1 and isinstance(data, dict) and "dynsplines batch" in data:
                if data["dynsplines batch"] != VERSION:
                    raise UserError(f"{path}: written by another version of this program")
                continue
            entry = Entry.of(data)
        except (ValueError, TypeError) as error:
            why = " ".join(str(error).split())
            raise UserError(f"{path}: line {number} is not what became of a clip ({why}); remove it") from None
        entries[entry.clip] = entry
    return entries
