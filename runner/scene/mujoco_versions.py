"""Names that differ in MuJoCo 3.2.7 to 3.3: the only file that checks MuJoCo's version."""

from __future__ import annotations

import contextlib
import ctypes
import re
import tempfile
from collections.abc import Iterator
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

DIGITS = 15  # of numbers in MJCF texts: as many as bring 0.1 back as 0.1


class Lamp(Enum):
    """The kinds of light."""

    SPOT = "spot"
    DIRECTIONAL = "directional"
    POINT = "point"
    IMAGE = "image"


def lamp(model: mujoco.MjModel, light: int) -> Lamp:
    """The type of a light. Before 3.3.1 all are directional or spots."""
    if not hasattr(model, "light_type"):
        return Lamp.DIRECTIONAL if model.light_directional[light] else Lamp.SPOT
    return _lamp_of(model.light_type[light])


def _lamp_of(kind: int) -> Lamp:
    kinds = mujoco.mjtLightType
    named = {
        kinds.mjLIGHT_DIRECTIONAL: Lamp.DIRECTIONAL,
        kinds.mjLIGHT_POINT: Lamp.POINT,
        kinds.mjLIGHT_IMAGE: Lamp.IMAGE,
    }
    return {int(value): name for value, name in named.items()}.get(int(kind), Lamp.SPOT)


def drawn_lamp(light: Any) -> Lamp:
    """The type of a light of a scene to be drawn (MjvLight)."""
    if not hasattr(light, "type"):
        return Lamp.DIRECTIONAL if light.directional else Lamp.SPOT
    return _lamp_of(light.type)


def without_shadow(model: mujoco.MjModel, geoms: Any) -> None:
    """Lets geoms (a mask or numbers) cast no shadow, where this MuJoCo can."""
    if hasattr(model, "geom_castshadow"):
        model.geom_castshadow[geoms] = 0


def remove(spec: mujoco.MjSpec, element: Any) -> None:
    """Remove an element, a body with all its children. Compile before the model is written."""
    if hasattr(spec, "delete"):
        spec.delete(element)
    elif isinstance(element, type(spec.worldbody)):
        spec.detach_body(element)
    else:
        element.delete()


def portable_text(spec: mujoco.MjSpec) -> str:
    """A compiled model's text that older versions read as well: without attributes that state their defaults.

    Without materials that there are none of, too: a class within another whose material is given up by material="" is
    written as if it kept it.

    Numbers have 15 digits, where MuJoCo's own default is 6: masses and lengths differ by up to 5e-6 with these.

    Before 3.3.3 or so MuJoCo writes the elevations of a height field upside down; here they are turned back.
    """
    text = re.sub(r"<light [^>]*>", lambda found: _plain_light(found[0]), _precise_text(spec))
    materials = {material.name for material in spec.materials}
    text = re.sub(r' material="([^"]*)"', lambda found: found[0] if found[1] in materials else "", text)
    text = re.sub(r"<texture [^>]*>", lambda found: found[0].replace(' colorspace="auto"', ""), text)
    return re.sub(r"<hfield [^>]*>", lambda found: _upright(found[0]), text) if _turns_height_fields() else text


def last_text(model: mujoco.MjModel) -> str:
    """The text of the model that MuJoCo read last from a file or text, with the numbers of `model`.

    It may be another model: MuJoCo keeps no text of a compiled one. Raises ValueError where there is none.
    """
    with tempfile.TemporaryDirectory() as folder, _precise():
        path = Path(folder) / "model.xml"
        try:
            mujoco.mj_saveLastXML(str(path), model)
        except mujoco.FatalError as error:
            raise ValueError(str(error)) from None
        return path.read_text(encoding="utf-8")


def _precise_text(spec: mujoco.MjSpec) -> str:
    with _precise():
        return spec.to_xml()


@contextlib.contextmanager
def _precise() -> Iterator[None]:
    """Texts with numbers of `DIGITS` digits, or of MuJoCo's default where its library is not found.

    The precision is a setting of the thread that MuJoCo's Python package has no function for.
    """
    library = _library()
    if library is None:
        yield
        return
    before = library._mjPRIVATE__get_xml_precision()
    library._mjPRIVATE__set_xml_precision(DIGITS)
    try:
        yield
    finally:
        library._mjPRIVATE__set_xml_precision(before)


@cache
def _library() -> ctypes.CDLL | None:
    """MuJoCo's shared library, which its Python package has loaded already, if it can set the precision of texts."""
    folder = Path(mujoco.__file__).parent
    for path in sorted((*folder.glob("libmujoco*"), *folder.glob("mujoco.dll"))):
        with contextlib.suppress(OSError):
            library = ctypes.CDLL(str(path))
            if hasattr(library, "_mjPRIVATE__set_xml_precision"):
                return library
    return None


def _plain_light(tag: str) -> str:
    return tag.replace(' type="directional"', ' directional="true"').replace(' type="spot"', "")


@cache
def _turns_height_fields() -> bool:
    """Whether this MuJoCo reads another height field from a text than the one it wrote there."""
    text = '<mujoco><asset><hfield name="h" nrow="2" ncol="2" size="1 1 1 1" elevation="0 0 1 1"/></asset></mujoco>'
    spec = mujoco.MjSpec.from_string(text)
    before = spec.compile().hfield_data
    return not np.array_equal(before, mujoco.MjModel.from_xml_string(spec.to_xml()).hfield_data)


def _upright(tag: str) -> str:
    """A height field's element with its rows in the other order."""
    elevation = re.search(r'elevation="([^"]*)"', tag)
    columns = re.search(r'ncol="(\d+)"', tag)
    if elevation is None or columns is None:
        return tag
    rows = np.array(elevation[1].split()).reshape(-1, int(columns[1]))[::-1]
    return tag.replace(elevation[0], f'elevation="{" ".join(rows.ravel())}"')


def mesh_folder(spec: mujoco.MjSpec, element: Any) -> str:
    """The folder of a mesh, height field or skin file. In newer versions attached models keep their folders."""
    return element.compiler.meshdir if hasattr(element, "compiler") else spec.meshdir


def texture_folder(spec: mujoco.MjSpec, texture: Any) -> str:
    """The folder of a texture's files."""
    return texture.compiler.texturedir if hasattr(texture, "compiler") else spec.texturedir


def keep_visuals(spec: mujoco.MjSpec) -> None:
    """Lets the compiler keep materials and geoms that only are seen: of a URDF it drops them, the stage's as well."""
    compiler = spec.compiler if hasattr(spec, "compiler") else spec
    compiler.discardvisual = False


def attach(spec: mujoco.MjSpec, other: mujoco.MjSpec, prefix: str) -> None:
    """Puts a model of lights and geoms in the world into another one's world, under names with a prefix."""
    if hasattr(spec, "attach"):
        spec.attach(other, frame=spec.worldbody.add_frame(), prefix=prefix)
        return
    frame = other.worldbody.add_frame()
    for element in [*other.geoms, *other.lights]:
        element.set_frame(frame)
    spec.worldbody.attach_frame(frame, prefix, "")


def geoms_by_number(spec: mujoco.MjSpec) -> list[Any]:
    """The geoms in the order of the compiled model: body after body."""
    return [geom for body in spec.bodies for geom in body.geoms]


def geom_named(spec: mujoco.MjSpec, name: str) -> Any:
    """The geom of a name that is there."""
    return next(geom for geom in spec.geoms if geom.name == name)


def size_of_pictures(spec: mujoco.MjSpec) -> Any:
    """The table with `offwidth` and `offheight` [pixels]."""
    return getattr(spec.visual, "global_" if hasattr(spec.visual, "global_") else "global")
