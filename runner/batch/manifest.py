"""The results of the clips of a batch, in a file of JSON lines in the folder of the results.

A line is appended when a clip is solved or fails, and the last line of a clip counts. A killed program loses at
most one line.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Literal

from pydantic import TypeAdapter, ValidationError

from ..errors import UserError
from ..scene.file_access import lies_in
from ..system.progress import Progress
from .task import Result

NAME = "manifest.jsonl"
MOST_FAILURES = 50  # listed clips
EMPTY = ("", (), {})  # values of omitted fields


@dataclass(frozen=True, kw_only=True)
class Entry(Result):
    """A clip and its last result.

    Attributes:
        clip: Its unique name, also that of its output without extension.
        source: Its path relative to the manifest's folder; "shipped:NAME" for a shipped clip.
        input: A hash of everything on which the output depends; "" to try the clip again, if it could not be read or
            its workers ended.
        files: The files of the result in the manifest's folder, with their hashes. Several clips may share a file that
            belongs to an output.
    """

    clip: str
    source: str
    state: Literal["done", "failed"]
    input: str = ""
    files: Mapping[str, str] = field(default_factory=dict)

    def line(self) -> str:
        """Return the entry as JSON, without empty fields."""
        values = {"clip": self.clip, "source": self.source, "state": self.state, **asdict(self)}
        return json.dumps({key: value for key, value in values.items() if value not in EMPTY}) + "\n"

    def is_intact(self, folder: Path) -> bool:
        """Return whether all files of the result exist and have not changed."""

        def is_same(name: str, value: str) -> bool:
            return lies_in(folder / name, folder) and digest_of((folder / name).read_bytes()) == value

        try:
            return bool(self.files) and all(is_same(name, value) for name, value in self.files.items())
        except (OSError, ValueError):
            return False


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
    """The manifest of a folder: its path, and the last entry of every clip."""

    path: Path
    entries: dict[str, Entry]

    @classmethod
    def of(cls, folder: Path) -> Manifest:
        """Read a manifest, or begin an empty one, without an incomplete last line. Raises UserError for others."""
        check_below(folder, NAME)
        path = folder / NAME
        data = path.read_bytes() if path.exists() else b""
        complete = data[: data.rfind(b"\n") + 1]
        entries = {}
        for number, line in enumerate(complete.splitlines(), 1):
            try:
                entry = ENTRY.validate_json(line, strict=True)
            except ValidationError as error:
                first = error.errors()[0]
                why = "".join(f"{key}: " for key in first["loc"]) + first["msg"].removeprefix("Value error, ")
                raise UserError(f"{path}: line {number} is not an entry of a clip ({why}); give another -o") from None
            entries[entry.clip] = entry
        if len(complete) < len(data):
            os.truncate(path, len(complete))
        return cls(path, entries)

    def record(self, entry: Entry) -> None:
        """Append a line."""
        try:
            with self.path.open("ab") as stream:
                stream.write(entry.line().encode())
        except OSError as error:
            raise UserError(f"cannot write '{self.path}': {error.strerror}") from None
        self.entries[entry.clip] = entry


@dataclass(frozen=True)
class Tally:
    """The entries of all clips of a batch at its end, and the number of clips that this run has solved."""

    entries: tuple[Entry, ...]
    solved: int

    @property
    def failed(self) -> list[Entry]:
        return sorted((entry for entry in self.entries if entry.state == "failed"), key=lambda entry: entry.clip)

    @property
    def good(self) -> list[Entry]:
        return [entry for entry in self.entries if entry.state == "done"]

    @property
    def wrong(self) -> list[Entry]:
        """Solved clips with violations, worst first, by the ratio of the worst violation to its bound."""

        def severity(entry: Entry) -> tuple[float, str]:
            return entry.violations[0]["amount"] / entry.violations[0]["bound"], entry.clip

        return sorted((entry for entry in self.good if entry.violations), key=severity, reverse=True)

    @property
    def line(self) -> str:
        unchanged = len(self.entries) - self.solved - len(self.failed)
        return f"{self.solved} solved{f', {unchanged} already there' if unchanged else ''}, {len(self.failed)} failed"

    def report(self, progress: Progress) -> None:
        """Report the worst violation, and failures."""
        good, wrong, failed = self.good, self.wrong, self.failed
        share = f"{len(wrong)} of {len(good)} clips {'has' if len(wrong) == 1 else 'have'} violations"
        for entry in wrong[:1]:
            progress.report(f"{share}; worst: {entry.clip}: {entry.violations[0]['text']}")
        for entry in failed[:MOST_FAILURES]:
            progress.report(f"failed: {entry.clip}: {entry.error}")
        if len(failed) > MOST_FAILURES:
            progress.report(f"... and {len(failed) - MOST_FAILURES} more; the manifest has them all")
