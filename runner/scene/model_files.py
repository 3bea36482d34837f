"""Files to which an MJCF file refers, from its text, before MuJoCo reads them.

A model can include further text, and can attach whole models by `<model file="arm.xml"/>`. Paths of meshes and images
of these are relative to their own folders.
"""

from __future__ import annotations

import html
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

from . import file_access

FOLDERS = ("meshdir", "texturedir", "assetdir")
TAG = re.compile(r"<\s*([\w:.-]+)([^<>]*)")
ATTRIBUTE = re.compile(r"([\w:.-]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")


@dataclass
class Model:
    """A model and its references; texts: the model's file, included files, and the files of its flexible bodies."""

    folder: Path
    folders: set[str] = field(default_factory=lambda: {""})
    files: set[str] = field(default_factory=set)
    texts: set[Path] = field(default_factory=set)


def is_there(path: Path) -> bool:
    """Return whether a file exists. The name may be untrusted: some names raise an error of the operating system."""
    return os.path.isfile(path)  # noqa: PTH113


def models_in(path: Path) -> list[Model]:
    """Return a model and the models that it attaches. Raises UserError for text outside its folder."""
    models = [Model(path.parent)]
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
            inside = {place for place in places if file_access.is_allowed() or file_access.lies_in(place, path.parent)}
            for place in sorted(places) if not inside else ():
                file_access.check(place, path.parent, file)
            paths |= inside
    return sorted({Path(os.path.normpath(place)) for place in paths})


def _walk(path: Path, model: Model, attached: list[Model], home: Path, visited: set[Path]) -> None:
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
                file_access.check(place, home, file)
            if tag == "flexcomp" and is_there(there[0]):
                model.texts.add(there[0])
            if tag == "flexcomp" or there[0] in visited or not is_there(there[0]):
                continue
            visited.add(there[0])
            if tag == "model":
                attached.append(Model(there[0].parent))
            _walk(there[0], attached[-1] if tag == "model" else model, attached, home, visited)


def elements(text: str) -> Iterator[tuple[str, Mapping[str, str]]]:
    """Yield name and attributes of every element. In invalid XML, which MuJoCo may read, similar text counts too."""
    try:
        yield from [(element.tag, element.attrib) for element in ElementTree.fromstring(text).iter()]
    except ElementTree.ParseError:
        for tag, attributes in TAG.findall(text):
            yield tag, {name: html.unescape(a or b) for name, a, b in ATTRIBUTE.findall(attributes)}
