"""From files: `load` a clip, `load_motion` a solved one, `import_motion` what another program recorded."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from .. import motion as files
from ..clip import load as clips
from ..clip.load import Clip
from ..clip.own import Own, with_own
from ..errors import UserError
from ..scene import outside
from ..system.mujoco_warnings import as_python_warnings
from .motion import Motion

if TYPE_CHECKING:
    from ..exchange.formats import Reader


@as_python_warnings()
def load(
    source: str | os.PathLike[str], *, fps: float | None = None, own: Own = (), allow_outside: bool = False
) -> Clip:
    """A clip, ready to be in-betweened.

    source  the name of a clip that ships (see `clips()`), a .toml file, an MJCF file with <keyframe> elements, or TOML
            text itself, which has a line break in it
    fps     samples a second of what is made of it, instead of the clip's own
    own     soft constraints of your own with their weights: [(Calm(), 0.1)]; no file holds them
    allow_outside  let its model read files that lie outside the model's own folder

    Raises UserError, in one line that names the file, the keyframe and the key.
    """
    source = os.fspath(source)
    if "\n" in source:
        with outside.allowed(allow_outside):
            return with_own(clips.from_text(source, name="clip", where="clip", fps=fps), own)
    if files.is_motion(source):
        raise UserError(f"'{source}' is a motion, solved already; load_motion opens it")
    with outside.allowed(allow_outside):
        return with_own(clips.load(source, fps=fps), own)


@as_python_warnings()
def load_motion(source: str | os.PathLike[str]) -> Motion:
    """A motion that `Motion.save` or `dynsplines solve` wrote, .npz; raises UserError for any other file."""
    return Motion(files.load(Path(source)))


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

    figure  whose motion it is, where the file brings none: the name of a figure that ships, or a path to MJCF
    format  by name (`dynsplines formats` lists them), where the file's ending does not tell it; or a reader of your
            own, anything with read(path, model, fps)
    fps     images a second, where the file does not tell them
    scale   the file's unit of length [m], where it is guessed
    skip_rest  leave out a T-pose, or the figure's rest pose, that stands before the motion
    allow_outside  let the figure's model read files that lie outside the model's own folder

    Raises UserError, in one line, for a file that does not fit.
    """
    from ..edit import lead_in
    from ..exchange.imported import imported

    figure = None if figure is None else os.fspath(figure)
    with outside.allowed(allow_outside):
        found = imported(Path(source), format, figure=figure, fps=fps, scale=scale)
    return Motion(lead_in.without(found) if skip_rest else found)
