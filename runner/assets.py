"""Files that a model refers to, meshes, images, height fields and skins, brought along as bytes.

MuJoCo finds them by name in a dictionary as well as on a disk, `MjModel.from_xml_string(text, assets)`. The names are
made flat and unique here, so that neither the model's folder nor its compiler's settings matter any more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco

from .errors import UserError
from .mujoco_versions import mesh_folder, texture_folder

Assets = Mapping[str, bytes]
LARGEST = 1_000_000_000  # [bytes] of all files of a model together


@dataclass(frozen=True)
class Scene:
    """A model whole and by itself: its MJCF text, and the files that the text refers to by name."""

    mjcf: str
    assets: Assets = field(default_factory=dict)

    def model(self) -> mujoco.MjModel:
        """Compiled; raises ValueError."""
        return mujoco.MjModel.from_xml_string(self.mjcf, dict(self.assets))

    def spec(self) -> mujoco.MjSpec:
        """To be changed; raises ValueError."""
        spec = mujoco.MjSpec.from_string(self.mjcf, assets=dict(self.assets))
        spec.assets = dict(self.assets)  # 3.2.7 forgets them
        return spec


@dataclass(frozen=True)
class _Reference:
    """One place in a model that names a file, the folder that the model gives for its kind, and how to rename it."""

    file: str
    folder: str
    rename: Callable[[str], None]


def taken_along(spec: mujoco.MjSpec) -> Assets:
    """The files that a model refers to, by new names that the model then knows them by; raises UserError."""
    found: dict[str, bytes] = {}
    names: dict[str, str] = {}
    own = dict(spec.assets)
    base = Path(spec.modelfiledir)
    for reference in list(_references(spec)):
        where, data = _read(reference, base, own)
        if where not in names:
            names[where] = _fresh(Path(reference.file.replace("\\", "/")).name, found)
            found[names[where]] = data
        reference.rename(names[where])
    if sum(map(len, found.values())) > LARGEST:
        raise UserError(f"the files that the model refers to have over {LARGEST // 1_000_000} MB together")
    spec.meshdir = spec.texturedir = spec.modelfiledir = ""
    spec.strippath = False
    spec.assets = {}
    return found


def _references(spec: mujoco.MjSpec) -> Iterator[_Reference]:
    for element, folder in (
        *((mesh, mesh_folder(spec, mesh)) for mesh in spec.meshes),
        *((grid, mesh_folder(spec, grid)) for grid in spec.hfields),
        *((skin, mesh_folder(spec, skin)) for skin in spec.skins),
        *((texture, texture_folder(spec, texture)) for texture in spec.textures),
    ):
        if element.file:
            yield _Reference(element.file, folder, _renaming(element))
    for texture in spec.textures:
        for side, file in enumerate(texture.cubefiles):
            if file:
                yield _Reference(file, texture_folder(spec, texture), _renaming_side(texture, side))


def _renaming(element: Any) -> Callable[[str], None]:
    def rename(name: str) -> None:
        element.file = name

    return rename


def _renaming_side(texture: Any, side: int) -> Callable[[str], None]:
    def rename(name: str) -> None:
        texture.cubefiles[side] = name

    return rename


def _read(reference: _Reference, base: Path, own: Assets) -> tuple[str, bytes]:
    """Where a file lies and what it holds: among the model's own assets, or on the disk as MuJoCo looks for it."""
    folder, file = reference.folder.replace("\\", "/"), reference.file.replace("\\", "/")
    for name in (reference.file, file, str(Path(folder) / file), Path(file).name):
        if name in own:
            return name, own[name]
    places = [base / folder / file, base / file, base / folder / Path(file).name]
    for place in places:
        if place.is_file():
            try:
                return str(place.resolve()), place.read_bytes()
            except OSError as error:
                raise UserError(f"the model refers to '{place}': it cannot be read: {error.strerror}") from None
    raise UserError(f"the model refers to the file '{reference.file}', which is not there: no '{places[0]}'")


def _fresh(name: str, taken: Assets) -> str:
    """A file's name, or with a number where another file has it already."""
    path, number = Path(name), 1
    lower = {other.lower() for other in taken}
    while name.lower() in lower:
        number += 1
        name = f"{path.stem}_{number}{path.suffix}"
    return name
