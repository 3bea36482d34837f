"""The state of every clip of a batch, in a file of JSON lines in the folder of the results.

A line is appended whenever the state of a clip changes, and the last line of a clip counts. A killed program loses at
most one line. When a batch begins and ends, the file is rewritten atomically with one line per clip.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Annotated, Literal

from pydantic import AfterValidator, TypeAdapter, ValidationError

from ..errors import UserError
from ..scene.file_access import lies_in
from ..system.output import Replacement
from .task import Result

NAME = "manifest.jsonl"
VERSION = 1  # version of the file's format
EMPTY = ("", None, 0, (), {})  # values of omitted fields
HEADER = re.compile(rb'\{"dynsplines batch": (\d+)\}')


def _below(name: str) -> str:
    """Return a path inside the manifest's folder. Raises ValueError for others."""
    parts = name.replace("\\", "/").split("/")
    if PurePosixPath(name).is_absolute() or PureWindowsPath(name).drive or ".." in parts or "\0" in name:
        raise ValueError(f"'{name}' is not a path in this folder")
    return name


Below = Annotated[str, AfterValidator(_below)]


@dataclass(frozen=True, kw_only=True)
class Entry(Result):
    """A clip, its state, and its last result.

    Attributes:
        clip: Its unique name, also that of its output without extension.
        source: Its path relative to the manifest's folder; "shipped:NAME" for a shipped clip.
        input: A hash of everything on which the output depends; "" before it has been read.
        attempts: The number of attempts of the last run.
        files: The files of the result in the manifest's folder, with their hashes: the output first, then files that
            belong to it, such as meshes. Several clips may share such a file.
    """

    clip: Below
    source: str
    state: Literal["queued", "running", "done", "failed"] = "queued"
    input: str = ""
    attempts: int = 0
    files: Mapping[Below, str] = field(default_factory=dict)

    def line(self) -> str:
        """Return the entry as JSON, without empty fields."""
        values = {"clip": self.clip, "source": self.source, "state": self.state, **asdict(self)}
        return json.dumps({key: value for key, value in values.items() if value not in EMPTY}) + "\n"

    def is_intact(self, folder: Path) -> bool:
        """Return whether all files of the result exist and have not changed."""
        try:
            intact = [digest_of((folder / name).read_bytes()) == value for name, value in self.files.items()]
        except OSError:
            return False
        return bool(intact) and all(intact)


ENTRY = TypeAdapter(Entry)


def digest_of(data: bytes) -> str:
    """Return the hash of a file's content."""
    return hashlib.sha256(data).hexdigest()


def check_below(folder: Path, name: str) -> None:
    """Raise UserError if a link leads a file out of the manifest's folder."""
    if not lies_in(folder / name, folder):
        where = os.path.realpath(folder / name)
        raise UserError(f"'{folder / name}' leads out of the folder, to '{where}'; remove the link")


@dataclass
class Manifest:
    """The manifest of a folder, for the program that holds the folder's lock."""

    path: Path
    entries: dict[str, Entry] = field(default_factory=dict)
    _is_complete: bool = False  # whether the file ends with a complete line

    @classmethod
    def of(cls, folder: Path) -> Manifest:
        """Read a manifest, or begin an empty one. Raises UserError for an invalid file."""
        check_below(folder, NAME)
        path = folder / NAME
        return cls(path, _read(path) if path.exists() else {})

    def record(self, entries: Iterable[Entry]) -> None:
        """Append a line for each entry."""
        if not self._is_complete:
            self.rewrite()
        entries = list(entries)
        try:
            with self.path.open("ab") as stream:
                stream.write("".join(entry.line() for entry in entries).encode())
        except OSError as error:
            self._is_complete = False
            raise UserError(f"cannot write '{self.path}': {error.strerror}") from None
        self.entries |= {entry.clip: entry for entry in entries}

    def rewrite(self) -> None:
        """Write one line per clip, atomically."""
        with Replacement(self.path) as temporary, temporary.open("wb") as stream:
            stream.write(f"{json.dumps({'dynsplines batch': VERSION})}\n".encode())
            stream.write("".join(entry.line() for entry in self.entries.values()).encode())
        self._is_complete = True

    def close(self) -> None:
        """Queue the running clips, and rewrite the file, unless its folder has been removed."""
        running = [entry for entry in self.entries.values() if entry.state == "running"]
        self.entries |= {entry.clip: replace(entry, state="queued") for entry in running}
        if self.path.exists():
            self.rewrite()


def _read(path: Path) -> dict[str, Entry]:
    """Return the last entry of every clip; an incomplete last line is ignored."""
    entries: dict[str, Entry] = {}
    for number, line in enumerate(path.read_bytes().split(b"\n")[:-1], 1):
        if number == 1 and (header := HEADER.fullmatch(line)):
            if int(header[1]) != VERSION:
                raise UserError(f"{path}: written by another version of this program")
            continue
        try:
            entry = ENTRY.validate_json(line, strict=True)
        except ValidationError as error:
            first = error.errors()[0]
            place = "".join(f"{key}: " for key in first["loc"] if first["type"] != "value_error")
            why = place + first["msg"].removeprefix("Value error, ")
            raise UserError(f"{path}: line {number} is not an entry of a clip ({why}); remove it") from None
        entries[entry.clip] = entry
    return entries
