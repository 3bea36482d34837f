"""A motion as a clip's file: its source tables, or its keyframes as tables, with the files of the scene next to it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from dynsplines import models
from dynsplines.solver.curve.frame import Frame, Timeline

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

OF_MOTIONS = ("figure", "fps", "scene")  # tables of a clip with a recording that also apply without the recording
AS_SPLINE = {"variable": 0, "frames": 0, "evaluations": 1}  # [solve] keys that return the raw spline unchanged


def write(saved: Saved, target: Path, *, note: str = "", exact: bool = False, overwrite: bool) -> list[Path]:
    """Write a clip (.toml) and return the files written, including the scene of a figure that is not shipped.

    Args:
        note: A comment for the first lines.
        exact: Whether the [solve] table returns the spline through the keyframes unchanged.
        overwrite: Whether to overwrite a different scene next to the clip.

    Raises:
        UserError: `exact` is set, but the motion has variable frames or partial keyframes, which the spline through
            the keyframes of a clip does not reproduce.
    """
    check(target)
    if exact or not _follows_shipped(saved):
        saved = standalone(saved)
    if exact and not saved.timeline.fixed.all():
        raise UserError(
            f"'{target}': only a motion that is the spline through its complete keyframes can be written with 'exact'; "
            "thin this one first, or write a .npz"
        )
    if saved.text:
        table = table_of(saved.text, saved.name)
    else:
        keys = keyframe_tables(saved.figure, saved.keys)
        named = {"figure": shipped_scene(saved.scene), "fps": saved.fps, "solve": _solve_table(saved), "keyframe": keys}
        table = ClipTable.unchecked(**named)
    if exact:
        table = table.changed(solve=table.solve.model_copy(update={**AS_SPLINE, **_ends(saved)}))
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


def standalone(saved: Saved) -> Saved:
    """Return a motion that follows a recording as an independent clip, without a reference to the recording.

    Every frame becomes a complete keyframe. Other motions are returned unchanged.
    """
    table = table_of(saved.text, saved.name) if saved.text else None
    if table is None or table.recording is None:
        return saved
    timeline, figure = saved.timeline, saved.figure
    everything = [[True] * timeline.width] * timeline.times.size
    keys = tuple(Frame.many(timeline.times, figure.to_qpos(timeline.states), everything))
    frames = tuple(Frame.many(timeline.times, timeline.states, everything))
    entries = {key: value for key, value in table.specified.items() if key in OF_MOTIONS}
    text = written(ClipTable.unchecked(**entries, solve=_solve_table(saved), keyframe=keyframe_tables(figure, keys)))
    return replace(saved, text=text, keys=keys, timeline=Timeline(frames, timeline.end_slope, timeline.ends))


def _follows_shipped(saved: Saved) -> bool:
    """Return whether the recording that a motion follows, if any, is a shipped clip."""
    recording = table_of(saved.text, saved.name).recording if saved.text else None
    return recording is None or recording.file in models.clips()


def searching(solve: SolveTable) -> SolveTable:
    """Return a [solve] table for a search: without the keys that return the spline unchanged."""
    is_spline = all(getattr(solve, key) == value for key, value in AS_SPLINE.items())
    return solve.without(*AS_SPLINE) if is_spline else solve


def check(target: Path) -> None:
    """Raise UserError unless a clip can be written to the target."""
    if target.suffix != ".toml":
        raise UserError(f"{target}: a clip's name ends in .toml")
    check_target(target)


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
    return SolveTable.unchecked(coordinates=saved.figure.coordinates, **_ends(saved), **around(saved).specified)


def _ends(saved: Saved) -> dict[str, str]:
    """Return the ends of a motion as a key of [solve]; empty for ends that other keyframes hold."""
    return {"ends": saved.timeline.ends} if saved.timeline.ends != "held" else {}
