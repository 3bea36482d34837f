"""What is named on the command line becomes clips, and a clip the files that go to a worker, which shares no disk."""

from __future__ import annotations

import glob
import os
import sys
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath

from dynsplines import models

from ..clip import parse as clip
from ..errors import UserError, unknown
from ..exchange import formats
from ..scene import outside
from ..scene.model_files import FOLDERS, elements, is_there
from ..scene.outside import lies_in
from .task import Cleaning, Files

ENDINGS = (".toml", ".xml")


@dataclass(frozen=True)
class Source:
    """A clip to solve, or a recording to clean.

    path   its file; None for a shipped clip
    name   what its output is to be called, without an ending: its path below the folder that was named, or its stem
    """

    path: Path | None
    name: PurePosixPath

    def place(self, folder: Path) -> str:
        """How a manifest in that folder calls it: a path that starts there, so that both may be moved together."""
        if self.path is None:
            return f"shipped:{self.name}"
        try:
            return Path(os.path.relpath(self.path, folder)).as_posix()
        except ValueError:  # another drive
            return self.path.as_posix()


def sources(words: Iterable[str], listed: str | None = None, *, recordings: bool = False) -> list[Source]:
    """Clips by name, files, folders (every .toml below) and patterns; none of them twice, in the order given.

    listed      a file of such words, one a line; "-" is the standard input. Raises UserError for what is not there.
    recordings  the words name recordings: files of any name; in folders, those whose endings tell that they are some
    """
    found: dict[object, Source] = {}
    for word in (*words, *(_lines(listed) if listed else ())):
        for source in _recordings(word) if recordings else _named(word):
            _check_written(source)
            found.setdefault(source.path or source.name, source)
    if not found and recordings:
        raise UserError("no recordings; give files, folders, patterns, or --list FILE")
    if not found:
        raise UserError("no clips; give names, .toml or .xml files, folders, patterns, or --list FILE")
    return list(found.values())


def _check_written(source: Source) -> None:
    """Raises UserError for a path that is no text: neither the manifest nor a worker could be told of it."""
    path = str(source.path or source.name)
    try:
        path.encode()
    except UnicodeEncodeError:
        shown = path.encode("utf-8", "backslashreplace").decode()
        raise UserError(f"'{shown}': its name is not UTF-8 text; rename it") from None


def named_apart(fresh: list[Source], taken: Collection[str]) -> list[Source]:
    """Every source with a name of its own: with as many of the folders above it as it takes, or numbered.

    taken  names that are given away; case does not count, as on some disks
    """
    depth = dict.fromkeys(range(len(fresh)), 0)
    names = [source.name for source in fresh]
    while True:
        count = Counter(str(name).casefold() for name in names)
        twins = [i for i, name in enumerate(names) if count[str(name).casefold()] > 1]
        longer = [i for i in twins if _above(fresh[i], depth[i] + 1) is not None]
        if not longer:
            break
        for i in longer:
            depth[i] += 1
            names[i] = _above(fresh[i], depth[i]) or names[i]
    used = {name.casefold() for name in taken}
    out: list[Source] = []
    for source, name in zip(fresh, names, strict=True):
        number, free = 1, name
        while str(free).casefold() in used:
            number += 1
            free = name.with_name(f"{name.name}-{number}")
        used.add(str(free).casefold())
        out.append(replace(source, name=free))
    return out


def files_of(source: Source, figures: dict[Path, dict[Path, bytes]], cleaning: Cleaning | None = None) -> Files:
    """Reads a clip and all that it refers to; what is missing is left to whoever loads it.

    figures   those that have been read before, by their path
    cleaning  what is to be done to it if it is a recording

    Raises OSError, and UserError for a model that reads files outside its folder.
    """
    if source.path is None:
        name = str(source.name)
        return Files(name, {f"{name}.toml": models.clip_text(name).encode()})
    path = source.path
    data = path.read_bytes()
    if cleaning is not None:
        return _with_recording(path, data, cleaning, figures)
    if path.suffix.lower() == ".xml":
        return _packed(path, _model_files(path, figures))
    files, figure = _clip_files(path, data, figures, ())
    return _packed(path, files, figure)


def _clip_files(
    path: Path, data: bytes, figures: dict[Path, dict[Path, bytes]], before: tuple[Path, ...]
) -> tuple[dict[Path, bytes], Path | None]:
    """A clip, its figure, and the recording that it follows, a clip perhaps; the figure where its path is absolute.

    before  the clips that follow this one
    """
    named, recording = clip.references(data.decode("utf-8", errors="replace"))
    files, absolute = {path: data}, None
    if named is not None and named not in models.figures():
        figure = Path(os.path.normpath(path.parent / named))
        if is_there(figure):
            files |= _model_files(figure, figures)
            absolute = figure if Path(named).is_absolute() else None
    if recording is not None and recording not in models.clips():
        file = Path(os.path.normpath(path.parent / recording))
        if is_there(file) and file not in (path, *before) and (outside.is_allowed() or lies_in(file, path.parent)):
            own = file.read_bytes()
            is_clip = file.suffix == ".toml"
            files |= _clip_files(file, own, figures, (path, *before))[0] if is_clip else {file: own}
    return files, absolute


def _with_recording(path: Path, data: bytes, cleaning: Cleaning, figures: dict[Path, dict[Path, bytes]]) -> Files:
    """A recording and what was asked for with it: the figure with its files, the scene, the map."""
    files, others = {path: data}, dict[str, Path]()
    if cleaning.figure is not None and cleaning.figure not in models.figures():
        others["figure"] = _absolute(Path(cleaning.figure))
        files |= _model_files(others["figure"], figures)
    for word, name in (("scene", cleaning.scene), ("map", cleaning.map)):
        if name is not None:
            others[word] = _absolute(Path(name))
            files[others[word]] = others[word].read_bytes()
    packed = _packed(path, files)
    root = Path(os.path.commonpath([file.parent for file in files]))
    return replace(packed, others={word: place.relative_to(root).as_posix() for word, place in others.items()})


def _lines(listed: str) -> list[str]:
    try:
        text = sys.stdin.read() if listed == "-" else Path(listed).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"--list {listed}: not UTF-8 text (byte {error.start + 1})") from None
    except OSError as error:
        raise UserError(f"--list {listed}: {error.strerror}") from None
    lines = (line.strip() for line in text.splitlines())
    return [line for line in lines if line and not line.startswith("#")]


def _named(word: str) -> Iterator[Source]:
    if word in models.clips():
        yield Source(None, PurePosixPath(word))
        return
    path = Path(word)
    if path.is_dir():
        below = sorted(file for file in path.rglob("*.toml") if file.is_file())
        if not below:
            raise UserError(f"'{word}': no .toml file in it or below")
        yield from (Source(_absolute(file), PurePosixPath(file.relative_to(path).with_suffix(""))) for file in below)
        return
    if path.is_file():
        if path.suffix.lower() not in ENDINGS:
            raise UserError(f"'{word}': a clip is a .toml file, an MJCF .xml with keyframes, or a shipped name")
        yield Source(_absolute(path), PurePosixPath(path.stem))
        return
    if glob.has_magic(word):
        called = sorted(Path(path.anchor).glob(str(path.relative_to(path.anchor))))
        matching = [file for file in called if file.is_file() and file.suffix.lower() in ENDINGS]
        if not matching:
            raise UserError(f"'{word}': no .toml or .xml file is called so")
        yield from (Source(_absolute(file), PurePosixPath(file.stem)) for file in matching)
        return
    if path.suffix:
        raise UserError(f"no file '{word}'")
    raise UserError(unknown("clip", word, models.clips()))


def _recordings(word: str) -> Iterator[Source]:
    """Files; in folders and by patterns, those whose endings tell that they are motions or some format that is read."""
    path = Path(word)
    if path.is_file():
        yield Source(_absolute(path), PurePosixPath(formats.stem(path)))
        return
    if path.is_dir():
        called, root = path.rglob("*"), path
    elif glob.has_magic(word):
        called, root = Path(path.anchor).glob(str(path.relative_to(path.anchor))), None
    else:
        raise UserError(f"no file '{word}'")
    found = sorted(file for file in called if file.is_file() and _tells(file))
    if not found:
        raise UserError(f"'{word}': no recording's ending is there; `dynsplines formats` lists them")
    for file in found:
        name = PurePosixPath(file.name if root is None else file.relative_to(root))
        yield Source(_absolute(file), name.with_name(formats.stem(file)))


def _tells(file: Path) -> bool:
    """Whether a file's ending says that it is a motion, or of a format that is read."""
    form = formats.by_ending(file)
    return form.reads if form is not None else file.suffix.lower() == ".npz"


def _absolute(path: Path) -> Path:
    """Without following links: a clip that is a link is called after the link."""
    return Path(os.path.normpath(path.absolute()))


def _above(source: Source, count: int) -> PurePosixPath | None:
    """The name with so many more of the folders above it; None where there are no more."""
    if source.path is None:
        return None
    parts = source.path.with_suffix("").parts[1:]  # without the root
    have = len(source.name.parts) + count
    return PurePosixPath(*parts[-have:]) if have <= len(parts) else None


def _model_files(path: Path, figures: dict[Path, dict[Path, bytes]]) -> dict[Path, bytes]:
    """An MJCF file and the files that it names: what it includes, meshes, images; from wherever MuJoCo looks.

    Raises UserError for a name that leads out of the model's folder alone, unless that is allowed.
    """
    if path not in figures:
        found: dict[Path, bytes] = {}
        folders, names = {path.parent}, {path.name}
        while True:
            fresh = {
                place: place.read_bytes()
                for place in sorted(_places(folders, names) - found.keys())
                if place == path or outside.is_allowed() or lies_in(place, path.parent)
            }
            if not fresh:
                break
            found |= fresh
            for file, data in fresh.items():
                if file.suffix.lower() in (".xml", ".mjcf"):
                    for tag, said in elements(data.decode("utf-8-sig", errors="replace")):
                        values = [said[key] for key in FOLDERS if tag == "compiler" and key in said]
                        folders |= {file.parent, *(path.parent / value for value in values)}
                        names |= {value for key, value in said.items() if key.startswith("file") and value}
        for name in sorted(names):
            places = _places(folders, {name})
            for place in sorted(places) if not places & found.keys() else ():
                outside.check(place, path.parent, name)
        figures[path] = found
    return figures[path]


def _places(folders: Collection[Path], names: Collection[str]) -> set[Path]:
    """The files of these names that are in these folders."""
    places = {Path(os.path.normpath(folder / name)) for folder in folders for name in names}
    return {place for place in places if is_there(place)}


def _packed(path: Path, files: Mapping[Path, bytes], figure: Path | None = None) -> Files:
    """Files below the deepest folder that holds them all."""
    root = Path(os.path.commonpath([file.parent for file in files]))
    below = {file.relative_to(root).as_posix(): data for file, data in files.items()}
    return Files(
        path.relative_to(root).as_posix(), below, None if figure is None else figure.relative_to(root).as_posix()
    )
