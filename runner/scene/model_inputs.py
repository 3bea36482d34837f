"""Models for the Python API: a shipped name, a path, MJCF text, an MjSpec or an MjModel."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from dynsplines import models

from ..errors import UserError, words_of
from ..system.mujoco_warnings import quietly
from . import file_access
from .compose import figure_spec
from .file_access import elements
from .mujoco_versions import last_text

CLOSE = 1e-6  # [1] relative difference of numbers after a model is written as text
KINDS = "give the name of a figure that ships, a path to MJCF or URDF, MJCF text, an MjSpec or an MjModel"
NO_TEXT = (
    "figure: MuJoCo writes an MjModel as MJCF only if it is the one that was read last, unchanged and without "
    "meshes or other files; give the path, the MJCF text or the MjSpec that it was made of"
)


def is_text(source: object) -> bool:
    """Return whether a source is MJCF or URDF text, not a path."""
    return isinstance(source, str) and source.lstrip("\ufeff \t\r\n").startswith("<")


def spec_of(figure: object) -> tuple[mujoco.MjSpec, str]:
    """Return a model for changes, and its name in a clip's text: a shipped name, a path, or the model's name.

    Raises UserError for other objects, and for an MjModel that MuJoCo cannot write as MJCF.
    """
    if isinstance(figure, mujoco.MjSpec):
        spec = figure.copy()
    elif isinstance(figure, mujoco.MjModel):
        spec = _of_model(figure)
    elif isinstance(figure, str) and is_text(figure):
        spec = spec_of_text(figure)
    elif isinstance(figure, str | os.PathLike):
        called = os.fspath(figure)
        if not isinstance(called, str):
            raise UserError(f"figure is a path of bytes; {KINDS}")
        return figure_spec(called), called if called in models.figures() else Path(called).resolve().as_posix()
    else:
        raise UserError(f"figure is of type {type(figure).__name__}; {KINDS}")
    return spec, f"{spec.modelname or 'figure'}.xml"


def spec_of_text(text: str) -> mujoco.MjSpec:
    """Return the model of MJCF text, whose files are relative to the current folder."""
    for tag, attributes in elements(text):
        if tag in ("include", "model") and attributes.get("file"):
            file_access.check(Path(attributes["file"]), Path(), attributes["file"])
    try:
        with quietly():
            return mujoco.MjSpec.from_string(text)
    except ValueError as error:
        raise UserError(f"figure: MuJoCo cannot read the text: {words_of(error)}") from None


def _of_model(model: mujoco.MjModel) -> mujoco.MjSpec:
    """Return the model that MuJoCo writes as text, if it is the same model."""
    try:
        with quietly():
            text = last_text(model)
            spec = mujoco.MjSpec.from_string(text)
            again = spec.copy().compile()
    except (ValueError, mujoco.FatalError):
        raise UserError(NO_TEXT) from None
    if not _is_same(model, again):
        raise UserError(NO_TEXT)
    return spec


def _is_same(one: mujoco.MjModel, two: mujoco.MjModel) -> bool:
    return one.names == two.names and all(
        _is_close(getattr(mine, name), getattr(other, name))
        for mine, other in ((one, two), (one.opt, two.opt))
        for name in _numbers(mine)
    )


def _numbers(holder: Any) -> list[str]:
    return [
        name for name in dir(holder) if name[0] != "_" and isinstance(getattr(holder, name), int | float | np.ndarray)
    ]


def _is_close(one: Any, two: Any) -> bool:
    a, b = np.asarray(one), np.asarray(two)
    if a.shape != b.shape:
        return False
    return (
        bool(np.array_equal(a, b)) if a.dtype.kind not in "f" else bool(np.allclose(a, b, CLOSE, CLOSE, equal_nan=True))
    )
