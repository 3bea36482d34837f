"""The clips or recordings that a command names, and the files that each needs at a worker without a shared disk."""

from __future__ import annotations

import glob
import os
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath

from dynsplines import models

from ..clip.parse import files_read
from ..errors import UserError, unknown
from ..exchange import formats
from ..scene.file_access import paths_read
from .task import BatchOptions, Task

ENDING = ".toml"  # of clips
Contents = dict[Path, bytes]  # of files
DEFAULTS = BatchOptions()


@dataclass(frozen=True)
class InputSource:
    """A clip to solve, or a recording to clean.

    Attributes:
        path: Its file; None for a shipped clip.
        name: The name of its output without extension: its path in the named folder, or its stem.
    """

    path: Path | None
    name: PurePosixPath

    def place(self, folder: Path) -> str:
        """Return its path relative to a manifest's folder, so that both can be moved together."""
        if self.path is None:
            return f"shipped:{self.name}"
        try:
            return Path(os.path.relpath(self.path, folder)).as_posix()
        except ValueError:  # another drive
            return self.path.as_posix()


def sources(words: Iterable[str], listed: str | None = None, *, recordings: bool = False) -> list[InputSource]:
    """Return the clips that names, files, folders and patterns denote, in order and without duplicates.

    Raises UserError for words that denote nothing.

    Args:
        listed: A file of such words, one per line; "-" is the standard input.
        recordings: Whether they denote recordings. Folders then contribute files with the extension of a motion or
            format.
    """
    unique: dict[object, InputSource] = {}
    for word in (*words, *(_lines(listed) if listed else ())):
        for source in _sources(word, recordings):
            path = str(source.path or source.name)
            if path != path.encode("utf-8", "replace").decode():  # the manifest and the workers need text
                shown = path.encode("utf-8", "backslashreplace").decode()
                raise UserError(f"'{shown}': its name is not UTF-8 text; rename it")
            unique.setdefault(source.path or source.name, source)
    if not unique:
        kind, names = ("recordings", "") if recordings else ("clips", "names, .toml ")
        raise UserError(f"no {kind}; give {names}files, folders, patterns, or --list FILE")
    return list(unique.values())


def task_of(source: InputSource, figures: dict[Path, Contents], options: BatchOptions = DEFAULTS) -> Task:
    """Return a clip with all files to which it refers. The worker reports missing ones.

    Raises OSError, and UserError for a model that refers to files outside its folder.

    Args:
        figures: A cache of the files of models, by the path of the model.
    """
    path, others, cleaning = source.path, dict[str, Path](), options.cleaning
    if path is None:
        text = models.clip_text(str(source.name)).encode()
        return Task(str(source.name), {f"{source.name}.toml": text}, options=options)
    if cleaning is not None:
        roles = {"figure": cleaning.figure, "scene": cleaning.scene, "map": cleaning.map}
        others = {role: _absolute(Path(name)) for role, name in roles.items() if name and name not in models.figures()}
        files = {place: place.read_bytes() for place in (path, *others.values())}
        files |= _model(others["figure"], figures) if "figure" in others else {}
    else:
        files, figure = files_read(path, partial(_model, figures=figures))
        others = {} if figure is None else {"figure": figure}
    root = Path(os.path.commonpath([file.parent for file in files]))

    def below(file: Path) -> str:
        return file.relative_to(root).as_posix()

    packed = {below(file): data for file, data in files.items()}
    return Task(below(path), packed, {role: below(file) for role, file in others.items()}, options)


def _model(path: Path, figures: dict[Path, Contents]) -> Contents:
    if path not in figures:
        figures[path] = {file: file.read_bytes() for file in paths_read(path)}
    return figures[path]


def _lines(listed: str) -> list[str]:
    try:
        text = sys.stdin.read() if listed == "-" else Path(listed).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"--list {listed}: not UTF-8 text (byte {error.start + 1})") from None
    except OSError as error:
        raise UserError(f"--list {listed}: {error.strerror}") from None
    lines = (line.strip() for line in text.splitlines())
    return [line for line in lines if line and not line.startswith("#")]


def _sources(word: str, recordings: bool) -> Iterator[InputSource]:
    """Yield a shipped clip, a file, or files in a folder or of a pattern with the extension of a clip or recording."""
    path = Path(word)
    if not recordings and word in models.clips():
        yield InputSource(None, PurePosixPath(word))
    elif path.is_file():
        if not recordings and path.suffix.lower() != ENDING:
            raise UserError(
                f"'{word}': a clip is a .toml file, or a shipped name; recordings need --clean or --retarget"
            )
        yield _source(path, path.parent, recordings)
    elif path.is_dir() or glob.has_magic(word):
        files = path.rglob("*") if path.is_dir() else Path(path.anchor).glob(str(path.relative_to(path.anchor)))
        chosen = [file for file in sorted(files) if file.is_file() and _is_input(file, recordings)]
        if not chosen and recordings:
            raise UserError(f"'{word}': it contains no recordings; `dynsplines formats` lists the endings")
        if not chosen:
            where = "in it or below" if path.is_dir() else "is called so"
            raise UserError(f"'{word}': no .toml file {where}")
        yield from (_source(file, path if path.is_dir() else file.parent, recordings) for file in chosen)
    else:
        is_file = recordings or path.suffix
        raise UserError(f"no file '{word}'" if is_file else unknown("clip", word, models.clips()))


def _source(file: Path, root: Path, recordings: bool) -> InputSource:
    stem = formats.stem(file) if recordings else file.stem
    return InputSource(_absolute(file), PurePosixPath(file.relative_to(root)).with_name(stem))


def _is_input(file: Path, recordings: bool) -> bool:
    """Return whether the extension is that of a clip; of recordings, that of a motion or of a format that can be
    read."""
    form = formats.by_ending(file) if recordings else None
    return form.reads if form is not None else file.suffix.lower() == (".npz" if recordings else ENDING)


def _absolute(path: Path) -> Path:
    """Return an absolute path without following links: a clip that is a link is named after the link."""
    return Path(os.path.normpath(path.absolute()))
