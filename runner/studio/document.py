"""A clip's text while it is edited, with unlimited undo and redo, and a copy of unsaved work on the disk."""

from __future__ import annotations

import re
import tomllib
from collections import deque
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from ..errors import UserError
from ..system.output import Replacement

if TYPE_CHECKING:
    from ..clip.text import TomlTable
    from .edits.tables import Blocks

MOST_SINCE = 200  # stored revisions, for pages that refer to an older one
FILMS = (".mp4", ".webm", ".gif", ".png")  # extensions of rendered files
Step = tuple[str, str]  # description of an edit, and the text before or after it


@lru_cache(maxsize=8)
def parsed(text: str) -> TomlTable:
    """Return a TOML text as plain tables, which are shared: callers must not change them."""
    return tomllib.loads(text)


def text_of(file: Path) -> tuple[str, str]:
    """Return a file's text with line feeds, and its line ending. Raises OSError, and UserError for other encodings."""
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{file}: not UTF-8 text (byte {error.start + 1})") from None
    return text.replace("\r\n", "\n"), "\r\n" if "\r\n" in text else "\n"


class Unsaved(NamedTuple):
    """Unsaved work of an earlier session: its file, when it was written [s since 1970], and its text."""

    file: Path
    time: float
    text: str


@dataclass
class Document:
    """A clip's text and its history.

    Attributes:
        name: Its display name: that of its file or of its source.
        file: The file to which it is saved; None before the first save.
        saved: The text on the disk.
        newline: The line ending on the disk; the text itself has line feeds.
        unsaved_file: The file of this document's unsaved work; None before it is written.
    """

    name: str
    text: str
    folder: Path
    file: Path | None = None
    saved: str | None = None
    revision: int = 0
    newline: str = "\n"
    unsaved_file: Path | None = None
    _back: list[Step] = field(default_factory=list)
    _forth: list[Step] = field(default_factory=list)
    _revisions: deque[tuple[int, str]] = field(default_factory=lambda: deque(maxlen=MOST_SINCE))

    @property
    def is_dirty(self) -> bool:
        """Whether there is unsaved work."""
        return self.text != self.saved

    @property
    def is_outdated(self) -> bool:
        """Whether another program has changed the file since it was opened or saved."""
        try:
            return self.file is not None and text_of(self.file)[0] != self.saved
        except OSError:  # the file is gone, or cannot be read
            return False

    @property
    def place(self) -> str:
        return self.file.name if self.file else f"{self.name}.toml"

    def state(self) -> dict[str, object]:
        """Return the state of the document for pages; `undo` and `redo` describe the edits that they would change."""
        return {
            "name": self.name,
            "file": self.file.name if self.file else None,
            "dirty": self.is_dirty,
            "revision": self.revision,
            "undo": self._back[-1][0] if self._back else None,
            "redo": self._forth[-1][0] if self._forth else None,
        }

    def tree(self) -> Blocks:
        """Return the text in editable blocks. Raises UserError for invalid TOML."""
        from .edits.tables import Blocks  # imported here because it is only needed for edits

        return Blocks.of(self.text, self.place)

    def tree_rows(self) -> list[TomlTable]:
        """Return the [[keyframe]] tables as plain ones."""
        return parsed(self.text).get("keyframe", [])

    def commit(self, text: str, words: str) -> None:
        """Set the present text; `words` describe the edit."""
        if text == self.text:
            return
        self._back.append((words, self.text))
        self._forth.clear()
        self._put(text)

    def back(self) -> Step | None:
        """Return a description and the text after undo; None if there is nothing to undo."""
        return self._back[-1] if self._back else None

    def forth(self) -> Step | None:
        """Return the same for redo."""
        return self._forth[-1] if self._forth else None

    def undo(self) -> None:
        self._swap(self._back, self._forth)

    def redo(self) -> None:
        self._swap(self._forth, self._back)

    def save(self, file: Path) -> None:
        """Write the text atomically, and remove the copy of unsaved work."""
        with Replacement(file) as temporary:
            temporary.write_bytes(self.text.replace("\n", self.newline).encode())
        self.discard()
        self.file, self.saved, self.name, self.folder = file, self.text, file.stem, file.parent

    def write_unsaved(self) -> None:
        """Write unsaved work to a file next to the clip, but never over that of another session."""
        if not self.is_dirty:
            self.discard()
            return
        with suppress(UserError, OSError):
            if self.unsaved_file is None:
                names = (self.folder / f".{self.place}.unsaved{f'-{n}' if n > 1 else ''}" for n in count(1))
                self.unsaved_file = next(file for file in names if not file.exists())
            with Replacement(self.unsaved_file) as temporary:
                temporary.write_bytes(self.text.encode())

    def read_unsaved(self) -> Unsaved | None:
        """Return the latest unsaved work of earlier sessions that differs from this text.

        A file with the same text becomes that of this document.
        """
        unsaved: list[Unsaved] = []
        with suppress(OSError):
            names = re.compile(re.escape(f".{self.place}.unsaved") + r"(-\d+)?")
            for file in filter(lambda path: names.fullmatch(path.name), self.folder.iterdir()):
                with suppress(OSError, UnicodeDecodeError):
                    unsaved.append(Unsaved(file, file.stat().st_mtime, file.read_bytes().decode()))
        self.unsaved_file = next((work.file for work in unsaved if work.text == self.text), None)
        return max((work for work in unsaved if work.text != self.text), key=lambda work: work.time, default=None)

    def discard(self) -> None:
        """Remove the file of unsaved work."""
        if self.unsaved_file is not None:
            with suppress(OSError):
                self.unsaved_file.unlink(missing_ok=True)
            self.unsaved_file = None

    def _swap(self, source: list[Step], target: list[Step]) -> None:
        if source:
            words, text = source.pop()
            target.append((words, self.text))
            self._put(text)

    def since(self, revision: int) -> list[str] | None:
        """Return the texts from a revision to the present one; None for an unknown or too old one."""
        texts = [text for number, text in self._revisions if number >= revision]
        if not self._revisions or len(texts) != self.revision - revision:
            return None
        return [*texts, self.text]

    def _put(self, text: str) -> None:
        self._revisions.append((self.revision, self.text))
        self.text = text
        self.revision += 1
