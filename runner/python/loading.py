"""From files: `load` a clip, `load_motion` a solved one, `import_motion` what another program recorded."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from .. import motion as files
from .. import recordings
from ..clip import load as clips
from ..clip.build import Clip, Own, with_own
from ..errors import UserError
from ..scene import outside
from ..scene.model_inputs import is_text, spec_of_text
from ..system.mujoco_warnings import as_python_warnings
from .motion import Motion

if TYPE_CHECKING:
    from ..exchange.formats import Reader


@as_python_warnings()
def load(
    source: str | os.PathLike[str], *, fps: float | None = None, own: Own = (), allow_outside: bool = False
) -> Clip:
    """A clip, ready to be in-betweened.

    source  the name of a clip that ships (see `clips()`), a .toml file, an MJCF file with <keyframe> elements, or the
            text of either: of TOML with a line break in it
    fps     samples a second of what is made of it, instead of the clip's own
    own     soft constraints of your own with their weights: [(Calm(), 0.1)]; no file holds them
    allow_outside  let its model read files that lie outside the model's own folder

    Raises UserError, in one line that names the file, the keyframe and the key.
    """
    if not isinstance(source, str | os.PathLike):
        raise UserError(
            f"a clip is a name, a path or text, not of type {type(source).__name__}; build makes one of a model"
        )
    source = str(os.fspath(source))
    if is_text(source):
        with outside.allowed(allow_outside):
            return with_own(clips.from_spec("clip", spec_of_text(source), fps, "clip"), own)
    if "\n" in source:
        with outside.allowed(allow_outside):
            return with_own(recordings.from_text(source, name="clip", where="clip", fps=fps), own)
    if files.is_motion(source):
        raise UserError(f"'{source}' is a motion, solved already; load_motion opens it")
    with outside.allowed(allow_outside):
        return with_own(recordings.load(source, fps=fps), own)


@as_python_warnings()
def load_motion(source: str | os.PathLike[str]) -> Motion:
    """A motion that `Motion.save` or `dynsplines solve` wrote, .npz; raises UserError for any other file."""
    return Motion(clips.load_motion(Path(source)))


@as_python_warnings()
def import_motion(
    source: str | os.PathLike[str],
    figure: str | os.PathLike[str] | None = None,
    *,
    format: str | Reader | None = None,
    fps: float | None = None,
    scale: float | None = None,
    skip_rest: bool = False,
    allow_outside: bool = False,
) -> Motion:
    """A recording of another program; every instant of it is a keyframe, and nothing is searched.

    figure  the figure of the motion, where the file contains none: the name of a shipped figure, or a path to MJCF
    format  by name (`dynsplines formats` lists them), where the file's ending is ambiguous; or a custom
        reader, an object with read(path, model, fps)
    fps     frames per second, where the file has no rate
    scale   the file's unit of length [m], where it would be inferred
    skip_rest  leave out a T-pose, or the figure's rest pose, that stands before the motion
    allow_outside  let the figure's model read files that lie outside the model's own folder

    Raises UserError, in one line, for a file that does not fit.
    """
    from ..clean import lead_in
    from ..exchange.imported import imported

    if figure is not None and not isinstance(figure, str | os.PathLike):
        raise UserError(f"figure is a name or a path to MJCF, not of type {type(figure).__name__}")
    figure = None if figure is None else str(os.fspath(figure))
    with outside.allowed(allow_outside):
        found = imported(Path(source), format, figure=figure, fps=fps, scale=scale)
    return Motion(lead_in.without(found) if skip_rest else found)
