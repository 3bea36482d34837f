"""Clips with the recording that they follow. A clip as a recording is solved first, a file of another program is
cleaned.

This precedes loading, which does not search.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import mujoco

from dynsplines import models

from . import motion
from .clip import load as clips
from .clip.build import Clip
from .clip.parse import Parsed, parse, read
from .errors import UserError
from .motion import Saved
from .scene import file_access
from .system.progress import silent


def load(
    source: str, *, figure_file: str | None = None, fps: float | None = None, unmet: list[str] | None = None
) -> Clip:
    """Return the clip of a shipped name or of a TOML file, after the motion that it follows, if any.

    Args:
        source: The name or path.
        figure_file: The present path of a clip's figure, if it has moved.
        fps: Samples per second [1/s] of outputs, instead of the clip's.
        unmet: Receives a line for every keyframe with unreachable positions, which otherwise raises an error.

    Raises:
        UserError: In one line with the file, the keyframe and the key; also for a recording that cannot be read, and
            for a clip that follows itself.
    """
    file = read(source)
    recording = recording_of(file, figure_file)
    return clips.from_parsed(file, figure_file=figure_file, fps=fps, unmet=unmet, recording=recording)


def from_text(
    text: str,
    *,
    name: str,
    where: str | None = None,
    folder: Path | None = None,
    fps: float | None = None,
    spec: mujoco.MjSpec | None = None,
    like: Clip | None = None,
) -> Clip:
    """Return the clip of a TOML text, see `clip.load.from_parsed`, after the motion that it follows, if any.

    Args:
        where: The label in errors; None: NAME.toml.
        fps: See `clip.load.from_parsed`; also `spec` and `like`.
    """
    source = parse(text, name, where or f"{name}.toml", folder)
    return clips.from_parsed(source, fps=fps, spec=spec, like=like, recording=recording_of(source))


def recording_of(source: Parsed, figure_file: str | None = None, following: tuple[str, ...] = ()) -> Saved | None:
    """Return the motion that a clip follows; None if it follows none.

    Args:
        figure_file: The present path of the figure, if it has moved.
        following: The chain of clips that leads to this one.

    Raises:
        UserError: For a recording that cannot be read, and for a clip that follows itself.
    """
    if source.table.recording is None:
        return None
    name, folder, where = source.table.recording.file, source.folder or Path(), f"{source.where}: recording"
    if name in models.clips():
        return _solve(name, name, where, following)
    file = folder / name
    if not file_access.is_allowed() and not file_access.lies_in(file, folder):
        raise UserError(f"{where}: '{name}' lies outside the clip's folder; --allow-outside lets it be read")
    if file.suffix == ".toml":
        return _solve(str(file), str(file.resolve()), where, following)
    figure = figure_file or source.table.figure
    if figure_file is None and figure not in models.figures() and source.folder is not None:
        figure = str(source.folder / figure)
    try:
        if motion.is_motion(str(file)):
            return motion.load(file)
        from .clean import command  # imported here because it imports many formats

        return command.moving(file, figure, source.table.scene)
    except UserError as error:
        raise UserError(f"{where}: {error}") from None


def _solve(source: str, identity: str, where: str, following: tuple[str, ...]) -> Saved:
    """Return the motion of a shipped clip or of a clip's file."""
    if identity in following:
        raise UserError(f"{where}: '{source}' follows itself")
    try:
        return _shipped_motion(source) if source in models.clips() else _solution(source, (*following, identity))
    except UserError as error:
        raise UserError(f"{where}: {error}") from None


@lru_cache(maxsize=4)
def _shipped_motion(name: str) -> Saved:
    return _solution(name, (name,))


def _solution(source: str, following: tuple[str, ...]) -> Saved:
    from . import solving  # imported here because most clips follow no other clip

    file = read(source)
    clip = clips.from_parsed(file, recording=recording_of(file, following=following))
    return solving.solve_first(clip, silent())
