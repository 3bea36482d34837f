"""A motion as a clip's file: its clip's tables, or its keyframes as tables, with the files of the scene next to it."""

from __future__ import annotations

from pathlib import Path

from dynsplines import models

from ..errors import UserError
from ..motion import Saved
from ..scene.assets import Scene
from ..scene.compose import compose, figure_spec
from ..system.output import Replacement, check_target
from .build import around
from .load import scene_and_figure
from .parse import Parsed, table_of
from .table import ClipTable, SolveTable
from .text import keyframe_tables, written


def write(saved: Saved, target: Path, *, note: str = "", overwrite: bool) -> list[Path]:
    """Write a clip (.toml) and return the files written, including the scene of a figure that is not shipped.

    Args:
        note: A comment for the first lines.
        overwrite: Whether to overwrite a different scene next to the clip.

    Raises:
        UserError: For a motion whose clip follows a recording in a file.
    """
    check_target(target)
    if saved.text:
        table = table_of(saved.text, saved.name)
        if table.recording is not None and table.recording.file not in models.clips():
            raise UserError(
                f"{target}: '{saved.name}' follows the recording '{table.recording.file}'; save it as a motion, .npz, "
                "which a clip can follow"
            )
    else:
        keys = keyframe_tables(saved.figure, saved.keys)
        named = {"figure": shipped_scene(saved.scene), "fps": saved.fps, "solve": _solve_table(saved), "keyframe": keys}
        table = ClipTable.unchecked(**named)
    files: dict[Path, bytes] = {}
    if table.figure not in models.figures() or (saved.text and not _defines_scene(saved)):
        scene = target.with_suffix(".xml")
        for file in (target, scene):
            if file.name in saved.scene.assets:
                raise UserError(f"'{file}' would be both the clip's and a file of its figure; choose another name")
        files = scene_files(saved.scene, scene, overwrite=overwrite)
        table = table.without("scene").changed(figure=scene.name)
    files[target] = ((f"# {note}\n" if note else "") + written(table)).encode()
    for path, data in files.items():
        with Replacement(path) as temporary:
            temporary.write_bytes(data)
    return list(files)


def scene_files(scene: Scene, target: Path, *, overwrite: bool = False) -> dict[Path, bytes]:
    """Return the files of a scene by path, its MJCF at `target`. Raises UserError if different ones exist."""
    files = {target: scene.mjcf.encode(), **{target.parent / name: data for name, data in scene.assets.items()}}
    for file, data in files.items():
        if file.exists() and file.read_bytes() != data and not overwrite:
            raise UserError(
                f"'{file}' already exists, where a file of the clip's figure would be written; give another name, or "
                "overwrite"
            )
    return files


def shipped_scene(scene: Scene) -> str:
    """Return the name of the shipped figure whose scene this is; "" for other scenes."""
    return next((name for name in models.figures() if compose(figure_spec(name)).mjcf == scene.mjcf), "")


def _defines_scene(saved: Saved) -> bool:
    """Return whether the tables alone define the motion's scene. Files to which they refer may be missing."""
    try:
        return scene_and_figure(Parsed.of(saved.text, saved.name, saved.name))[0].mjcf == saved.mjcf
    except UserError:
        return False


def _solve_table(saved: Saved) -> SolveTable:
    """Return the [solve] table of a motion's ends and coordinates."""
    ends = {"ends": saved.timeline.ends} if saved.timeline.ends != "held" else {}
    return SolveTable.unchecked(coordinates=saved.figure.coordinates, **ends, **around(saved).specified)
