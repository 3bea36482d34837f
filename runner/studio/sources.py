"""Inputs of the studio: a clip, a model, a motion, or a recording of another program. Each becomes a clip's text."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING

from dynsplines import models

from ..errors import UserError, unknown
from .document import Document, text_of

if TYPE_CHECKING:
    from ..motion import Saved
    from ..scene.assets import Scene


EXAMPLES = "a clip (.toml), a model (.xml), a motion (.npz), a recording, or a shipped clip"


def opened(source: str, *, figure: str | None = None) -> Document:
    """Open a file as a document; `figure` is that of a recording without one. Raises UserError."""
    if source in models.clips():
        return Document(source, models.clip_text(source), Path.cwd(), saved=models.clip_text(source))
    from ..exchange.formats import by_ending  # imported here, as below, so that a page need not wait for it

    path = Path(source)
    if not path.is_file():
        if path.is_dir():
            raise UserError(f"'{source}' is a folder; open {EXAMPLES}")
        if not path.suffix:
            raise UserError(unknown("clip", source, models.clips()))
        raise UserError(f"no file '{source}'; open {EXAMPLES}")
    match path.suffix.lower():
        case ".toml":
            return _clip(path)
        case ".xml":
            return _model(path)
        case ".npz" if by_ending(path) is None:
            return _motion(path, figure)
    return _recording(path, figure)


def _clip(path: Path) -> Document:
    try:
        text, newline = text_of(path)
    except OSError as error:
        raise UserError(f"{path}: cannot be read: {error.strerror}") from None
    return Document(path.stem, text, path.resolve().parent, file=path.resolve(), saved=text, newline=newline)


def _model(path: Path) -> Document:
    """Return a starting clip, not saved yet."""
    from ..clip.starter import starter

    path = path.resolve()
    return Document(path.stem, starter(str(path), path.with_suffix(".toml")), path.parent)


def _motion(path: Path, figure: str | None) -> Document:
    """Return a solved clip's text, or a clip that follows the recorded motion."""
    from ..clip.load import load_motion
    from ..measure.violation import is_recording

    try:
        saved = load_motion(path)
    except UserError as error:
        if figure is None:
            raise error from None
        return _recording(path, figure)
    path = path.resolve()
    if saved.text and not is_recording(saved) and _has_recording(path, saved):
        return Document(saved.name, _text_in(path, saved), path.parent)
    return following(path, _scene_with(path, saved.scene))


def _has_recording(path: Path, saved: Saved) -> bool:
    """Return whether the recording that a solved clip follows, if any, is at its motion's location."""
    from ..clip.parse import table_of

    recording = table_of(saved.text, saved.name).recording
    return recording is None or _is_there(recording.file, models.clips(), path.parent)


def _text_in(path: Path, saved: Saved) -> str:
    """Return the text of a solved clip at its motion's location, with a missing figure taken from the motion."""
    from ..clip.parse import table_of
    from ..clip.text import tables, written

    table = table_of(saved.text, saved.name)
    if _is_there(table.figure, models.figures(), path.parent):
        return saved.text
    entries = {key: value for key, value in tables(table).items() if key != "scene"}
    return written(entries | {"figure": _scene_with(path, saved.scene)})


def _is_there(name: str, shipped: Collection[str], folder: Path) -> bool:
    return name in shipped or (folder / name).is_file()


def _recording(path: Path, figure: str | None) -> Document:
    """Return a clip that follows a file of another program, which is imported next to it."""
    from .. import motion
    from ..exchange.formats import stem
    from ..exchange.motion_import import import_recording

    saved = import_recording(path, figure=figure)
    target = path.resolve().with_name(f"{stem(path)}.npz")
    if target.exists() and target != path.resolve():
        raise UserError(f"'{target.name}' already exists, where {path.name} would be imported to; open that one")
    motion.save(saved, target)
    return following(target, _scene_with(target, saved.scene))


def _scene_with(path: Path, scene: Scene) -> str:
    """Return the name of a recording's shipped figure, or of its MJCF written next to the recording."""
    from ..clip.file import scene_files, shipped_scene
    from ..system.output import Replacement

    name = shipped_scene(scene)
    if name:
        return name
    target = path.with_suffix(".xml")
    for file, data in scene_files(scene, target).items():
        with Replacement(file) as temporary:
            temporary.write_bytes(data)
    return target.name


def following(path: Path, figure: str) -> Document:
    """Return a clip that follows a motion's file, in its folder."""
    from ..clip.tracking.recording import EASE

    text = f'# Keyframes here edit what was recorded; the rest stays as it is.\nfigure = "{figure}"\n\n[recording]\n'
    text += f'file = "{path.name}"\nblend = {EASE:g}                             # s before and after every keyframe\n'
    return Document(f"{path.stem}_edited", text, path.parent)
