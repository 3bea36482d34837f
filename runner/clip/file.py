"""A motion as a clip's file again: the tables that it came from, or its keyframes as tables, beside it its scene."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from dynsplines import models

from ..errors import UserError
from ..motion import Saved
from ..scene.assets import Scene
from ..scene.compose import compose, figure_spec
from ..system.output import Replacement, check_target
from . import load as clips
from .text import keyframe_tables, tables, written

AS_SPLINE = {"variable": 0, "frames": 0, "evaluations": 1}  # [solve] that leaves the raw spline as it is


def write(saved: Saved, target: Path, *, note: str = "", exact: bool = False, overwrite: bool) -> list[Path]:
    """Writes a clip, .toml, and gives the files written: its figure's whole scene is one, if it is none that ships.

    note   the comment at its head
    exact  its [solve] leaves the spline through its keyframes as it is
    """
    check(target)
    if saved.text:
        said = tables(clips.table_of(saved.text, saved.name))
    else:
        said: dict[str, Any] = {"figure": shipped_scene(saved.scene), "fps": saved.fps, "solve": _ends(saved)}
        said["keyframe"] = keyframe_tables(saved.figure, saved.keys)
    if exact:
        said["solve"] = said.get("solve", {}) | AS_SPLINE
    files: list[tuple[Path, bytes]] = []
    if said["figure"] not in models.figures() or (saved.text and not _tells_scene(saved)):
        scene = target.with_suffix(".xml")
        if scene.exists() and scene.read_text(encoding="utf-8") != saved.mjcf and not overwrite:
            raise UserError(
                f"'{scene}' is there already, and the clip's figure goes there; choose another name or overwrite it"
            )
        said = {key: value for key, value in said.items() if key != "scene"} | {"figure": scene.name}
        files.append((scene, saved.mjcf.encode()))
        for name, data in saved.scene.assets.items():
            file = target.parent / name
            if file in (target, scene):
                raise UserError(f"'{file}' would be both the clip's and a file of its figure; choose another name")
            if file.exists() and file.read_bytes() != data and not overwrite:
                raise UserError(f"'{file}' is there already, and a file of the clip's figure goes there")
            files.append((file, data))
    files.append((target, ((f"# {note}\n" if note else "") + written(said)).encode()))
    for path, data in files:
        with Replacement(path) as temporary:
            temporary.write_bytes(data)
    return [path for path, _ in files]


def searching(solve: dict[str, Any]) -> dict[str, Any]:
    """A [solve] table of a clip that is to be searched: without what leaves the spline as it is."""
    held = all(solve.get(key) == value for key, value in AS_SPLINE.items())
    return {key: value for key, value in solve.items() if not (held and key in AS_SPLINE)}


def check(target: Path) -> None:
    """Raises UserError unless a clip can be written there."""
    if target.suffix != ".toml":
        raise UserError(f"{target}: a clip's name ends in .toml")
    check_target(target)


def shipped_scene(scene: Scene) -> str:
    """The shipped figure that a scene is, on the bare stage, or none."""
    return next((name for name in models.figures() if compose(figure_spec(name)).mjcf == scene.mjcf), "")


def _tells_scene(saved: Saved) -> bool:
    """Whether the tables alone make the scene that the motion is in; what they refer to may be gone."""
    try:
        return clips.from_text(saved.text, name=saved.name).mjcf == saved.mjcf
    except UserError:
        return False


def _ends(saved: Saved) -> dict[str, Any]:
    """What [solve] says of a motion's ends and coordinates."""
    out: dict[str, Any] = {"coordinates": saved.figure.coordinates}
    if saved.timeline.ends in ("periodic", "clamped"):
        out["ends"] = saved.timeline.ends
    return out | clips.around(saved)
