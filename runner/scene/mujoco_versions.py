"""Names that differ between MuJoCo 3.3 and 4. Only this file checks MuJoCo's version."""

from __future__ import annotations

import contextlib
import ctypes
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

DIGITS = 15  # significant digits of numbers in MJCF texts, so that decimal input such as 0.1 is reproduced


def lamp(light: Any) -> str:
    """Return the kind of a light (MjvLight or `model.light(i)`): "spot", "directional", "point" or
    "image". Before 3.3.1 all are directional or spots."""
    if not hasattr(light, "type"):
        return "directional" if np.any(light.directional) else "spot"
    return mujoco.mjtLightType(int(np.ravel(light.type)[0])).name.removeprefix("mjLIGHT_").lower()


def without_shadow(model: mujoco.MjModel, geoms: Any) -> None:
    """Disable the shadows of geoms (a mask or numbers), if this version of MuJoCo can."""
    if hasattr(model, "geom_castshadow"):
        model.geom_castshadow[geoms] = 0


def remove(spec: mujoco.MjSpec, element: Any) -> None:
    """Remove an element; a body with all its children. Compile before the model is written."""
    if hasattr(spec, "delete"):
        spec.delete(element)
    elif isinstance(element, type(spec.worldbody)):
        spec.detach_body(element)
    else:
        element.delete()


def portable_text(spec: mujoco.MjSpec) -> str:
    """Return a compiled model's text that older versions can read: without attributes at their defaults.

    Numbers have 15 digits. MuJoCo's default is 6, with which masses and lengths differ by up to 5e-6. References to
    undefined materials are removed: MuJoCo writes them for a nested class with material="". Before about 3.3.3 MuJoCo
    writes the elevations of a height field in reverse order, which is corrected.
    """
    with _precise():
        text = spec.to_xml()
    text = re.sub(r'(<light [^>]*) type="directional"', r'\1 directional="true"', text)
    text = re.sub(r'(<light [^>]*) type="spot"', r"\1", text)
    materials = {material.name for material in spec.materials}
    text = re.sub(r' material="([^"]*)"', lambda match: match[0] if match[1] in materials else "", text)
    text = re.sub(r"<texture [^>]*>", lambda match: match[0].replace(' colorspace="auto"', ""), text)
    return re.sub(r"<hfield [^>]*>", lambda match: _upright(match[0]), text) if _turns_height_fields() else text


@contextlib.contextmanager
def _precise() -> Iterator[None]:
    """Write numbers with DIGITS digits in this block, or with MuJoCo's default if its library is not found. The
    precision is a setting of the thread, for which MuJoCo's Python package has no function."""
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
    """Return MuJoCo's shared library if it can set the precision of texts; the Python package has already loaded it."""
    folder = Path(mujoco.__file__).parent
    for path in sorted((*folder.glob("libmujoco*"), *folder.glob("mujoco.dll"))):
        with contextlib.suppress(OSError):
            library = ctypes.CDLL(str(path))
            if hasattr(library, "_mjPRIVATE__set_xml_precision"):
                return library
    return None


@cache
def _turns_height_fields() -> bool:
    """Return whether this MuJoCo writes a height field in another order than it reads."""
    text = '<mujoco><asset><hfield name="h" nrow="2" ncol="2" size="1 1 1 1" elevation="0 0 1 1"/></asset></mujoco>'
    spec = mujoco.MjSpec.from_string(text)
    before = spec.compile().hfield_data
    return not np.array_equal(before, mujoco.MjModel.from_xml_string(spec.to_xml()).hfield_data)


def _upright(tag: str) -> str:
    """Return a height field's element with its rows in reverse order."""
    elevation = re.search(r'elevation="([^"]*)"', tag)
    columns = re.search(r'ncol="(\d+)"', tag)
    if elevation is None or columns is None:
        return tag
    rows = np.array(elevation[1].split()).reshape(-1, int(columns[1]))[::-1]
    return tag.replace(elevation[0], f'elevation="{" ".join(rows.ravel())}"')


def mesh_folder(spec: mujoco.MjSpec, element: Any) -> str:
    """Return the folder of a mesh, height field or skin. In newer versions attached models have separate folders."""
    return element.compiler.meshdir if hasattr(element, "compiler") else spec.meshdir


def texture_folder(spec: mujoco.MjSpec, texture: Any) -> str:
    """Return the folder of a texture's files."""
    return texture.compiler.texturedir if hasattr(texture, "compiler") else spec.texturedir
