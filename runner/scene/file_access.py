"""Files that a model reads: those to which its MJCF text refers, and whether they may be outside its folder.

A model can include further text, and can attach whole models by `<model file="arm.xml"/>`. Paths of meshes and images
of these are relative to their own folders. They are read from the text, before MuJoCo reads the model.

An untrusted model could name any file of the user, so only files in its folder may be read by default. Exceptions are
`with allowed():` around code that reads models, `--allow-outside` on the command line, and `allow_outside=True` in
Python.
"""

from __future__ import annotations

import html
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

from ..errors import UserError

FOLDERS = ("meshdir", "texturedir", "assetdir")
TAG = re.compile(r"<\s*([\w:.-]+)([^<>]*)")
ATTRIBUTE = re.compile(r"([\w:.-]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_allowed: ContextVar[bool] = ContextVar("allowed", default=False)


@contextmanager
def allow(yes: bool = True) -> Iterator[None]:
    """Allow models to refer to files anywhere, within this block; yes=False restores the default."""
    before = _allowed.set(yes or _allowed.get())
    try:
        yield
    finally:
        _allowed.reset(before)


def is_allowed() -> bool:
    """Return whether models may refer to files outside their folders now."""
    return _allowed.get()


def check(place: Path, folder: Path, name: str) -> None:
    """Raise UserError for a file outside the model's folder, after resolving links.

    Args:
        place: The path of the file.
        folder: The model's folder.
        name: The file's name in the model.
    """
    if not is_allowed() and not lies_in(place, folder):
        home = os.path.realpath(folder)
        real = os.path.realpath(place)
        resolved = "" if name == real else f" ('{real}')"
        raise UserError(
            f"the model refers to '{name}'{resolved}, outside its folder '{home}'; if it may read that file, "
            "--allow-outside lets it (allow_outside=True in Python)"
        )


def lies_in(place: Path, folder: Path) -> bool:
    """Return whether a file is in a folder or below it, after resolving links."""
    return Path(os.path.realpath(place)).is_relative_to(os.path.realpath(folder))


@dataclass
class ModelFile:
    """A model and its references; texts: the model's file, included files, and the files of its flexible bodies."""

    folder: Path
    folders: set[str] = field(default_factory=lambda: {""})
    files: set[str] = field(default_factory=set)
    texts: set[Path] = field(default_factory=set)


def is_there(path: Path) -> bool:
    """Return whether a file exists. The name may be untrusted: some names raise an error of the operating system."""
    return os.path.isfile(path)  # noqa: PTH113


def models_in(path: Path) -> list[ModelFile]:
    """Return a model and the models that it attaches. Raises UserError for text outside its folder."""
    models = [ModelFile(path.parent)]
    _walk(path, models[0], models, path.parent, {path})
    return models


def paths_read(path: Path) -> list[Path]:
    """Return the paths of all files that a model reads, in every folder where MuJoCo may look for them.

    Raises UserError for a file that exists only outside the model's folder, unless that is allowed.
    """
    paths = {path}
    for model in models_in(path):
        paths |= model.texts
        folders = [*(model.folder / folder for folder in model.folders), *(text.parent for text in model.texts)]
        for file in sorted(model.files):
            names = {file, Path(file).name}
            places = {folder / name for folder in folders for name in names if is_there(folder / name)}
            inside = {place for place in places if is_allowed() or lies_in(place, path.parent)}
            for place in sorted(places) if not inside else ():
                check(place, path.parent, file)
            paths |= inside
    return sorted({Path(os.path.normpath(place)) for place in paths})


def _walk(path: Path, model: ModelFile, attached: list[ModelFile], home: Path, visited: set[Path]) -> None:
    """Collect the files of a text and of all included text in `model`, and the attached models in `attached`."""
    model.texts.add(path)
    for tag, attrs in list(elements(path.read_bytes().decode("utf-8-sig", errors="replace"))):
        model.folders |= {attrs[name].replace("\\", "/") for name in FOLDERS if tag == "compiler" and name in attrs}
        named = [value.replace("\\", "/") for key, value in attrs.items() if key.startswith("file") and value]
        if tag not in ("include", "model", "flexcomp"):
            model.files |= set(named)
            continue
        for file in named:
            places = [
                path.parent / file,
                model.folder / file,
                *(model.folder / sub / file for sub in model.folders),
            ]
            there = [place for place in places if is_there(place)] or places[:1]
            for place in there:
                check(place, home, file)
            if tag == "flexcomp" and is_there(there[0]):
                model.texts.add(there[0])
            if tag == "flexcomp" or there[0] in visited or not is_there(there[0]):
                continue
            visited.add(there[0])
            if tag == "model":
                attached.append(ModelFile(there[0].parent))
            _walk(there[0], attached[-1] if tag == "model" else model, attached, home, visited)


def elements(text: str) -> Iterator[tuple[str, Mapping[str, str]]]:
    """Yield name and attributes of every element. In invalid XML, which MuJoCo may read, similar text counts too."""
    try:
        yield from [(element.tag, element.attrib) for element in ElementTree.fromstring(text).iter()]
    except ElementTree.ParseError:
        for tag, attributes in TAG.findall(text):
            yield tag, {name: html.unescape(a or b) for name, a, b in ATTRIBUTE.findall(attributes)}
