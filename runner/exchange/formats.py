"""The formats by name, and the two ways: `export` a motion to one, `recording` from one."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import mujoco

from ..errors import UserError, unknown
from ..motion import Replacement, Saved, check_target
from .take import Recording, Take


@dataclass(frozen=True)
class Format:
    """A file format: its name, the ending of its files, one line on what it is, and the module here that knows it.

    The module has `write(take, path)` if others can read what we write, and `read(path, model, fps)`, which gives a
    Recording, if we can read what others write; model is None where the user named no figure. Both raise UserError.
    extra  of `pip install 'dynamic-splines[...]'`, where the format needs more than the main job
    """

    name: str
    ending: str
    says: str
    module: str
    writes: bool = True
    reads: bool = False
    extra: str | None = None


FORMATS = (
    Format("csv", ".csv", "a row an instant: time, then qpos, under the joints' names", "csv_table", reads=True),
    Format("gltf", ".glb", "meshes and one animation, for Blender, engines and the web", "gltf", extra="gltf"),
    Format("html", ".html", "one page that plays before and after, in any browser, from the disk", "html"),
)  # fmt: skip


def writers() -> dict[str, Format]:
    """The formats that a motion can be exported to, by name."""
    return {each.name: each for each in FORMATS if each.writes}


def readers() -> dict[str, Format]:
    """The formats that a motion can be imported from, by name."""
    return {each.name: each for each in FORMATS if each.reads}


def writer(name: str) -> Format:
    """The format to export to; raises UserError that lists them."""
    if name not in writers():
        raise UserError(unknown("format", name, writers()))
    return writers()[name]


def export(saved: Saved, kind: str, target: Path | None = None, *, fps: float | None = None) -> Path:
    """Writes a motion in another format, whole or not at all; where to, if not said, its name and the format's ending.

    Raises UserError for an unknown format, a missing extra, and what the format cannot hold.
    """
    form = writer(kind)
    target = target or Path(f"{saved.name}{form.ending}")
    check_target(target)
    write = _module(form).write
    with Replacement(target) as temporary:
        write(Take.of(saved, fps), temporary)
    return target


def recording(
    source: Path, kind: str | None = None, *, model: mujoco.MjModel | None = None, fps: float | None = None
) -> Recording:
    """Reads a file of others, of the format that it is said to be or that its ending tells.

    model  the figure that it is for; fps [1/s] of files that do not tell it
    """
    known = readers()
    if kind is None:
        fitting = [each for each in known.values() if source.name.lower().endswith(each.ending)]
        if len(fitting) != 1:
            names = ", ".join(each.name for each in fitting or known.values())
            raise UserError(f"'{source}': its ending does not tell its format; give --from, one of: {names}")
        form = fitting[0]
    elif kind not in known:
        raise UserError(unknown("format", kind, known))
    else:
        form = known[kind]
    if not source.is_file():
        raise UserError(f"'{source}' is a folder, not a file" if source.is_dir() else f"no file '{source}'")
    return _module(form).read(source, model, fps)


def _module(form: Format) -> Any:
    """A format's module; raises UserError that says how to install what it needs."""
    try:
        return import_module(f".{form.module}", __package__)
    except ModuleNotFoundError as error:
        if form.extra is None:
            raise
        raise UserError(
            f"the format '{form.name}' needs '{error.name}'; install it: pip install 'dynamic-splines[{form.extra}]'"
        ) from None
