"""Files to which a model refers (meshes, images, height fields, skins), as bytes.

MuJoCo reads them by name from a dictionary, `MjModel.from_xml_string(text, assets)`, as well as from a disk. Names are
made plain and unique here, so that the result does not depend on the model's folder or its compiler's settings.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import mujoco

from ..errors import UserError
from ..system import mujoco_warnings, size_limit
from . import file_access
from .file_access import FOLDERS, ModelFile, elements, is_there
from .mujoco_versions import mesh_folder, texture_folder

mujoco_warnings.install()  # here, because all code that uses MuJoCo imports this module

Assets = Mapping[str, bytes]
ODD = re.compile(r"[\x00-\x1f\x7f/\\:*?\"<>|]")  # characters that are not portable in names of files


@dataclass(frozen=True)
class Scene:
    """A self-contained model: its MJCF text, and the files to which the text refers by name."""

    mjcf: str
    assets: Assets = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Raise ValueError for names that are not plain, because they are used as names of files later."""
        for name in self.assets:
            if not is_plain(name):
                raise ValueError(f"its file '{name}' is not a plain file name")

    @classmethod
    def receive(cls, mjcf: str, assets: Assets) -> Scene:
        """Return a scene from an untrusted file. Raises ValueError if it refers to any other files."""
        scene = cls(mjcf, assets)
        if file_access.is_allowed():
            return scene
        for tag, attrs in elements(mjcf):
            if tag == "include":
                raise ValueError(f"its model includes '{attrs.get('file', '')}'; a file brings its whole model along")
            folder = next((name for name in FOLDERS if tag == "compiler" and attrs.get(name)), None)
            if folder is not None:
                raise ValueError(f"its model has a {folder}, '{attrs[folder]}'; a file brings its model's files along")
            for file in (value for key, value in attrs.items() if key.startswith("file") and value):
                if file not in assets:
                    raise ValueError(f"its model refers to '{file}', which it does not bring along")
        return scene

    def model(self) -> mujoco.MjModel:
        """Return the compiled model. Raises ValueError."""
        return mujoco.MjModel.from_xml_string(self.mjcf, dict(self.assets))

    def spec(self) -> mujoco.MjSpec:
        """Return the model for changes. Raises ValueError."""
        return mujoco.MjSpec.from_string(self.mjcf, assets=dict(self.assets))


@dataclass(frozen=True)
class _Reference:
    """A reference to a file in a model, the model's folder for its kind, and a function that renames it."""

    file: str
    folder: str
    rename: Callable[[str], None]


def taken_along(spec: mujoco.MjSpec) -> Assets:
    """Return the files to which a model refers, by new names that the model then uses. Raises UserError."""
    assets: dict[str, bytes] = {}
    names: dict[str, str] = {}
    embedded = dict(spec.assets)
    base = Path(spec.modelfiledir)
    for reference in list(_references(spec)):
        where, data = _read(reference, base, embedded)
        if where not in names:
            names[where] = _unused_name(_plain(Path(reference.file.replace("\\", "/")).name), assets)
            assets[names[where]] = data
        reference.rename(names[where])
    size_limit.check("the model", sum(map(len, assets.values())), "what the files it refers to hold")
    spec.meshdir = spec.texturedir = spec.modelfiledir = ""
    spec.strippath = False
    spec.assets = {}
    return assets


def check_places(spec: mujoco.MjSpec, models: Sequence[ModelFile]) -> None:
    """Raise UserError for files outside the model's folder, and complete the paths of files of attached models.

    `models` are the model itself and those that it attaches.
    """
    base = Path(spec.modelfiledir)
    for reference in list(_references(spec)):
        file, folder = reference.file.replace("\\", "/"), reference.folder.replace("\\", "/")
        naming = [model for model in models[1:] if file in model.files and folder in model.folders]
        theirs = [place for model in naming if is_there(place := model.folder / folder / file)]
        is_own = not theirs or (file in models[0].files and folder in models[0].folders)
        places = [place for place in _places(reference, base) if is_there(place)][:1] if is_own else []
        for place in [*places, *theirs] or [base / folder / file]:
            file_access.check(place, base, reference.file)
        if len({place.read_bytes() for place in [*places, *theirs]}) > 1:
            listed = " and ".join(f"'{place}'" for place in [*places, *theirs])
            raise UserError(f"models that are attached use different files of one name: {listed}; rename one")
        if theirs and not places:
            reference.rename(str(theirs[0].absolute()))


def _references(spec: mujoco.MjSpec) -> Iterator[_Reference]:
    for element, folder in (
        *((mesh, mesh_folder(spec, mesh)) for mesh in spec.meshes),
        *((grid, mesh_folder(spec, grid)) for grid in spec.hfields),
        *((skin, mesh_folder(spec, skin)) for skin in spec.skins),
        *((texture, texture_folder(spec, texture)) for texture in spec.textures),
    ):
        if element.file:
            yield _Reference(element.file, folder, partial(setattr, element, "file"))
    for texture in spec.textures:
        for side, file in enumerate(texture.cubefiles):
            if file:
                yield _Reference(file, texture_folder(spec, texture), partial(texture.cubefiles.__setitem__, side))


def _read(reference: _Reference, base: Path, assets: Assets) -> tuple[str, bytes]:
    """Return the path and content of a file, from the model's assets or from the disk in MuJoCo's order."""
    folder, file = reference.folder.replace("\\", "/"), reference.file.replace("\\", "/")
    for name in (reference.file, file, str(Path(folder) / file), Path(file).name):
        if name in assets:
            return name, assets[name]
    places = _places(reference, base)
    for place in places:
        if is_there(place):
            file_access.check(place, base, reference.file)
            try:
                return str(place.resolve()), place.read_bytes()
            except OSError as error:
                raise UserError(f"the model refers to '{place}': it cannot be read: {error.strerror}") from None
    raise UserError(f"the model refers to the file '{reference.file}', which is not there: no '{places[0]}'")


def _places(reference: _Reference, base: Path) -> list[Path]:
    """Return the paths at which MuJoCo searches for a file, in order; the last one assumes that all folders exist."""
    folder, file = reference.folder.replace("\\", "/"), reference.file.replace("\\", "/")
    first = base / folder / file
    return [first, base / file, base / folder / Path(file).name, Path(os.path.normpath(first))]


def is_plain(name: str) -> bool:
    """Return whether a name is a plain file name, without a path, on every system."""
    return bool(name) and not name.startswith(".") and not ODD.search(name) and len(name.encode()) <= 255


def _plain(name: str) -> str:
    name = ODD.sub("_", name).lstrip(".") or "file"
    return name if is_plain(name) else f"file{Path(name).suffix[:16]}"


def _unused_name(name: str, taken: Assets) -> str:
    """Return a file's name, with a number if it is already used."""
    path, number = Path(name), 1
    lower = {other.lower() for other in taken}
    while name.lower() in lower:
        number += 1
        name = f"{path.stem}_{number}{path.suffix}"
    return name
