"""A clip's text while it is edited, with unlimited undo and redo, and a copy of unsaved work on the disk."""

from __future__ import annotations

import re
import tomllib
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from dynsplines import models

from ..errors import UserError, unknown
from ..system.output import Replacement

if TYPE_CHECKING:
    from ..clip.text import TomlTable
    from .blocks import Blocks

MODELS = (".xml", ".mjcf", ".urdf")
PLAIN = re.compile(r"[^/\\\0:*?\"<>|]+")
FILMS = (".mp4", ".webm", ".gif", ".png")  # extensions of rendered files


class Step(NamedTuple):
    """An edit that undo or redo changes: a part of the present text becomes another one."""

    words: str
    begin: int
    end: int
    part: str

    @classmethod
    def to(cls, text: str, present: str, words: str) -> Step:
        """Return the step from the present text to another one."""
        begin = _equal(present, text)
        rest = _equal(present[begin:][::-1], text[begin:][::-1])
        return cls(words, begin, len(present) - rest, text[begin : len(text) - rest])

    def apply(self, present: str) -> str:
        return present[: self.begin] + self.part + present[self.end :]


@lru_cache(maxsize=8)
def parse(text: str) -> TomlTable:
    """Return a TOML text as plain tables, which are shared: callers must not change them."""
    return tomllib.loads(text)


def text_of(file: Path) -> tuple[str, str]:
    """Return a file's text with line feeds, and its line ending. Raises OSError, and UserError for other encodings."""
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{file}: not UTF-8 text (byte {error.start + 1})") from None
    return text.replace("\r\n", "\n"), "\r\n" if "\r\n" in text else "\n"


def inside(folder: Path, name: Any) -> Path:
    """Return a file of a folder by its name. Raises UserError for a file elsewhere."""
    if not isinstance(name, str) or not PLAIN.fullmatch(name) or name.startswith(".") or len(name) > 120:
        raise UserError(f"'{name}': give a plain name of a file in the folder '{folder.name}'")
    path = (folder / name).resolve()
    if path.parent != folder.resolve():
        raise UserError(f"'{name}' lies outside the folder '{folder.name}'")
    return path


def open_document(source: str) -> Document:
    """Open a clip file or a shipped clip. Raises UserError."""
    if source in models.clips():
        return Document(source, models.clip_text(source), Path.cwd(), saved=models.clip_text(source))
    path = Path(source)
    if path.is_dir():
        raise UserError(f"'{source}' is a folder; open a clip (.toml), or a shipped clip")
    if not path.exists():
        raise UserError(f"no file '{source}'" if path.suffix else unknown("clip", source, models.clips()))
    if path.suffix.lower() in MODELS:
        raise UserError(f"'{source}' is a model; write a clip for it: dynsplines new {source}")
    if path.suffix.lower() != ".toml":
        raise UserError(
            f"'{source}' is no clip (.toml); open the clip of this motion, or write one: dynsplines thin {source}"
        )
    try:
        text, newline = text_of(path)
    except OSError as error:
        raise UserError(f"{path}: cannot be read: {error.strerror}") from None
    path = path.resolve()
    return Document(path.stem, text, path.parent, file=path, saved=text, newline=newline)


@dataclass
class Document:
    """A clip's text and its history.

    Attributes:
        name: Its display name: that of its file or of its source.
        file: The file to which it is saved; None before the first save.
        saved: The text on the disk.
        newline: The line ending on the disk; the text itself has line feeds.
        numbered_since: The first revision with the present numbers of tables.
        steps: The edits that "undo" and "redo" change, the next one last.
    """

    name: str
    text: str
    folder: Path
    file: Path | None = None
    saved: str | None = None
    revision: int = 0
    newline: str = "\n"
    numbered_since: int = 0
    _copy: str | None = None  # unsaved work on the disk, if this document wrote or adopted it
    _stroke: str | None = None  # of the last edit
    steps: dict[str, list[Step]] = field(default_factory=lambda: {"undo": [], "redo": []})

    @property
    def is_dirty(self) -> bool:
        """Whether there is unsaved work."""
        return self.text != self.saved

    def read_changed(self) -> str | None:
        """Return the file's text if another program has changed it since it was opened or saved, else None.

        Raises UserError for a file that is not text.
        """
        try:
            text = None if self.file is None else text_of(self.file)[0]
        except OSError:  # the file is gone, or cannot be read
            return None
        return None if text == self.saved else text

    @property
    def place(self) -> str:
        return self.file.name if self.file else f"{self.name}.toml"

    @property
    def unsaved_file(self) -> Path:
        """The copy of unsaved work."""
        return self.folder / f".{self.place}.unsaved"

    def check_numbers(self, revision: int) -> None:
        """Raise UserError if tables of an older revision, such as keyframes, may have other numbers now."""
        if not self.numbered_since <= revision <= self.revision:
            raise UserError("the clip has changed meanwhile; check it, and try again")

    def state(self) -> dict[str, object]:
        """Return the state of the document for pages; `undo` and `redo` describe the edits that they would change."""
        return {
            "name": self.name,
            "file": self.file.name if self.file else None,
            "dirty": self.is_dirty,
            "revision": self.revision,
            **{verb: steps[-1].words if steps else None for verb, steps in self.steps.items()},
        }

    def tree(self) -> Blocks:
        """Return the text in editable blocks. Raises UserError for invalid TOML."""
        from .blocks import Blocks  # imported here because it is only needed for edits

        return Blocks.of(self.text, self.place)

    def tree_rows(self) -> list[TomlTable]:
        """Return the [[keyframe]] tables as plain ones."""
        return parse(self.text).get("keyframe", [])

    def commit(self, text: str, words: str, stroke: str | None = None) -> None:
        """Set the present text; `words` describe the edit. Consecutive edits of one stroke are undone together."""
        if text == self.text:
            return
        undo, before = self.steps["undo"], self.text
        if stroke is not None and stroke == self._stroke:
            words, before = undo[-1].words, undo.pop().apply(self.text)
        if before == text:  # the stroke has returned to its beginning
            stroke = None
        else:
            undo.append(Step.to(before, text, words))
        self._stroke = stroke
        self.steps["redo"].clear()
        self._put(text)

    def step(self, verb: str) -> None:
        """Undo or redo an edit."""
        self._stroke = None
        step = self.steps[verb].pop()
        text = step.apply(self.text)
        self.steps["redo" if verb == "undo" else "undo"].append(Step.to(self.text, text, step.words))
        self._put(text)

    def save(self, file: Path) -> None:
        """Write the text atomically, and remove the copy of unsaved work."""
        with Replacement(file) as temporary:
            temporary.write_bytes(self.text.replace("\n", self.newline).encode())
        self.discard()
        self.file, self.saved, self.name, self.folder = file, self.text, file.stem, file.parent

    @property
    def poses(self) -> Path:
        """The folder of saved poses, files with the entries of a keyframe."""
        return self.folder / "poses"

    def pose_names(self) -> list[str]:
        """Return the names of the saved poses."""
        return sorted(path.stem for path in self.poses.glob("*.toml"))

    def read_pose(self, name: str) -> TomlTable:
        """Return the entries of a saved pose. Raises UserError."""
        file = inside(self.poses, f"{name}.toml")
        try:
            return parse(text_of(file)[0])
        except (OSError, ValueError) as error:
            raise UserError(f"the pose '{name}': {error}") from None

    def save_pose(self, name: str, entries: TomlTable, *, overwrite: bool) -> None:
        """Save entries of a keyframe as a pose. Raises UserError, also if there is a pose of this name."""
        from ..clip.text import text_of  # imported here, because it needs MuJoCo

        file = inside(self.poses, f"{name}.toml")
        if file.exists() and not overwrite:
            raise UserError(f"there is a pose '{name}' already; choose another name, or overwrite it")
        try:
            self.poses.mkdir(exist_ok=True)
        except OSError as error:
            raise UserError(f"the folder '{self.poses.name}' cannot be made: {error.strerror}") from None
        with Replacement(file) as temporary:
            temporary.write_text(text_of(entries), encoding="utf-8")

    def write_unsaved(self) -> None:
        """Write unsaved work to a file next to the clip; remove the file if there is none.

        Raises:
            UserError: The file cannot be written, or contains the unsaved work of another studio.
        """
        if not self.is_dirty:
            self.discard()
            return
        try:
            if self.unsaved_file.exists() and (self._copy is None or self._read_copy() != self._copy):
                raise UserError(f"{self.unsaved_file.name} belongs to another studio with this clip")
            with Replacement(self.unsaved_file) as temporary:
                temporary.write_bytes(self.text.encode())
        except (UserError, OSError) as error:
            raise UserError(f"unsaved work is not stored, save the clip: {error}") from None
        self._copy = self.text

    def read_unsaved(self) -> str | None:
        """Return the unsaved work of an earlier session; None if there is none, or if it equals this text."""
        text = self._read_copy()
        if text == self.text:
            self._copy = text
        return None if text == self.text else text

    def adopt(self, text: str) -> None:
        """Make the copy of unsaved work that of this document, which may replace or remove it."""
        self._copy = text

    def discard(self) -> None:
        """Remove the copy of unsaved work if it is that of this document."""
        if self._copy is not None and self._read_copy() == self._copy:
            with suppress(OSError):
                self.unsaved_file.unlink(missing_ok=True)
        self._copy = None

    def _read_copy(self) -> str | None:
        try:
            return self.unsaved_file.read_bytes().decode()
        except (OSError, UnicodeDecodeError):
            return None

    def _put(self, text: str) -> None:
        self.revision += 1
        if _counts(text) != _counts(self.text):
            self.numbered_since = self.revision
        self.text = text


def _equal(one: str, other: str) -> int:
    """Return the number of characters up to the first different one."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((i for i, (a, b) in pairs if a != b), min(len(one), len(other)))


def _counts(text: str) -> dict[str, int]:
    """Return the number of tables by the name of their list."""
    tables = parse(text)
    scene = tables.get("scene", {})
    return {name: len(rows) for name, rows in [*tables.items(), *scene.items()] if isinstance(rows, list)}
