"""Clips and motions from files: `load` a clip, `load_motion` a solved motion, `import_motion` a recording."""

from __future__ import annotations

import os
from pathlib import Path

from .. import motion as files
from .. import recordings
from ..clip import load as clips
from ..clip.build import Clip, CustomPenalties, with_custom_penalties
from ..errors import UserError
from ..scene import file_access
from ..scene.model_inputs import is_text, spec_of_text
from ..system.mujoco_warnings import as_python_warnings
from ..system.quantity import positive
from .motion import Motion


@as_python_warnings()
def load(
    source: str | os.PathLike[str],
    *,
    fps: float | None = None,
    custom_penalties: CustomPenalties = (),
    allow_outside: bool = False,
) -> Clip:
    """Load a clip.

    Args:
        source: Name of a shipped clip (see `clips()`), path of a .toml file or of an MJCF file with <keyframe>
            elements, or TOML or MJCF text. A string with a line break is taken as text, not as a path.
        fps: Samples per second [1/s] of outputs, instead of the clip's.
        custom_penalties: Custom soft constraints with their weights, [(Calm(), 0.1)]; files do not store them.
        allow_outside: Let the model read files outside its folder.

    Returns:
        The clip, for `inbetween`.

    Raises:
        UserError: For an invalid clip. The message is one line that names the file, the keyframe and the key.
    """
    if not isinstance(source, str | os.PathLike):
        raise UserError(
            f"a clip is a name, a path or text, not of type {type(source).__name__}; build makes one of a model"
        )
    source = str(os.fspath(source))
    fps = None if fps is None else positive(fps, "fps =")
    if is_text(source):
        with file_access.allowed(allow_outside):
            return with_custom_penalties(clips.from_spec("clip", spec_of_text(source), fps, "clip"), custom_penalties)
    if "\n" in source:
        with file_access.allowed(allow_outside):
            return with_custom_penalties(
                recordings.from_text(source, name="clip", where="clip", fps=fps), custom_penalties
            )
    if files.is_motion(source):
        raise UserError(f"'{source}' is a motion, solved already; load_motion opens it")
    with file_access.allowed(allow_outside):
        return with_custom_penalties(recordings.load(source, fps=fps), custom_penalties)


@as_python_warnings()
def load_motion(source: str | os.PathLike[str]) -> Motion:
    """Load a motion.

    Args:
        source: A motion file (.npz) of `Motion.save` or `dynsplines solve`.

    Returns:
        The motion.

    Raises:
        UserError: For any other file.
    """
    if not files.is_motion(os.fspath(source)):
        raise UserError(f"'{source}': a motion is an .npz file; load opens a clip, import_motion a recording")
    return Motion(clips.load_motion(Path(source)))


@as_python_warnings()
def import_motion(
    source: str | os.PathLike[str],
    figure: str | os.PathLike[str] | None = None,
    *,
    format: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    allow_outside: bool = False,
) -> Motion:
    """Import a recording of another program. Every sample becomes a keyframe; there is no search.

    Args:
        source: The recording.
        figure: Name of a shipped figure, or path of an MJCF file, if the recording contains no figure.
        format: Name of the format (see `dynsplines formats`), if the file's extension is ambiguous.
        fps: Samples per second [1/s], if the file has no rate.
        scale: Unit of length of the file [m], instead of the inferred one.
        allow_outside: Let the figure's model read files outside its folder.

    Returns:
        The motion.

    Raises:
        UserError: For an invalid file, or one that does not fit the figure. The message is one line.
    """
    from ..exchange.motion_import import import_recording

    if figure is not None and not isinstance(figure, str | os.PathLike):
        raise UserError(f"figure is a name or a path to MJCF, not of type {type(figure).__name__}")
    figure = None if figure is None else str(os.fspath(figure))
    with file_access.allowed(allow_outside):
        return Motion(import_recording(Path(source), format, figure=figure, fps=fps, scale=scale))
