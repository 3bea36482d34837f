"""Import of a recording: as a motion of a figure, with a keyframe at every sample, without optimisation."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import TimelineError

from ..clip import load as clips
from ..errors import UserError
from ..motion import Saved
from ..scene.assets import taken_along
from ..scene.compose import compose, figure_spec, first_line, quietly
from ..solving import unsolved
from ..system.progress import Progress
from . import gaps, winding
from .formats import Reader, read_by, recording, stem


@dataclass(frozen=True)
class ImportedMotion:
    """A file of another program, read for a figure.

    spec, model  the figure; time  (T,) [s]; qpos  (T, nq), hinges without wraps; fps  [1/s]
    loops        whether the file declares its last sample to be the first again, translated
    """

    name: str
    spec: mujoco.MjSpec
    model: mujoco.MjModel
    time: Array
    qpos: Array
    fps: float
    loops: bool


def read_recording(
    source: Path,
    kind: str | Reader | None = None,
    *,
    figure: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    progress: Progress | None = None,
) -> ImportedMotion:
    """Read a file of another program.

    figure  name of a shipped figure or path to MJCF, for files that contain none
    fps, scale  [1/s], [m] rate and unit of length, for files that lack them
    progress  receives notes on how the file was read

    Raises UserError.
    """
    progress = progress or Progress()
    spec = None if figure is None else figure_spec(figure)
    if spec is not None:
        spec.assets = dict(taken_along(spec))  # under the names that compose assigns, so that MuJoCo finds the meshes
    model = None if spec is None else _compiled(spec, str(figure))
    if kind is None or isinstance(kind, str):
        record = recording(source, kind, model=model, fps=fps, scale=scale)
    else:
        record = read_by(kind, source, model, fps)
    record = gaps.without_missing(record, source)
    if record.mjcf is not None:
        spec = mujoco.MjSpec.from_string(record.mjcf, assets=dict(record.assets))
        model = _compiled(spec, str(source))
    assert spec is not None and model is not None, "a reader returns a figure or requires one"
    qpos, notes = winding.unwrapped(model, record.time, record.qpos)
    for note in (*record.notes, *notes):
        progress.report(f"note: {note}")
    rate = record.fps or (float(np.round(1 / np.median(np.diff(record.time)), 6)) if record.time.size > 1 else 30.0)
    return ImportedMotion(stem(source), spec, model, record.time, qpos, rate, record.loops)


def _compiled(spec: mujoco.MjSpec, figure: str) -> mujoco.MjModel:
    """Compile a figure; raises UserError if MuJoCo cannot, as for a robot that refers to a floor of its scene file."""
    try:
        with quietly():
            return spec.compile()
    except ValueError as error:
        raise UserError(f"{figure}: MuJoCo cannot compile it: {first_line(error)}") from None


def import_recording(
    source: Path,
    kind: str | Reader | None = None,
    *,
    figure: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    progress: Progress | None = None,
) -> Saved:
    """Return the motion in a file of another program: the spline through all its samples.

    The arguments are those of `read_recording`. A file that declares a loop becomes one if its last pose is its first,
    translated. Raises UserError.
    """
    progress = progress or Progress()
    record = read_recording(source, kind, figure=figure, fps=fps, scale=scale, progress=progress)
    clip = clips.from_qpos(
        record.name, compose(record.spec, bare=record.model), record.time, record.qpos, record.fps, source.name
    )
    if record.loops:
        try:
            return unsolved(clip.with_problem(ends="periodic")).saved(progress, with_report=False)
        except TimelineError:
            progress.report("note: marked as a loop, but its last pose differs from its first: read without a loop")
    return unsolved(clip).saved(progress, with_report=False)
