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
from .task import Result

NAME = "manifest.jsonl"
EMPTY = ("", (), {})  # values of omitted fields


@dataclass(frozen=True, kw_only=True)
class Entry(Result):
    """A clip and its last result.

    Attributes:
        clip: Its unique name, also that of its output without extension.
        source: Its path relative to the manifest's folder; "shipped:NAME" for a shipped clip.
        input: A hash of everything on which the output depends; "" to try the clip again, if it could not be read or
            its workers ended.
        files: The files of the result in the manifest's folder, with their hashes: the output first, then files that
            belong to it, such as meshes. Several clips may share such a file.
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
