"""Import of a recording: as a motion of a figure, with a keyframe at every sample, without optimisation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.tolerances import NEGLIGIBLE

from ..clip import load as clips
from ..errors import list_names
from ..motion import Saved
from ..scene.assets import taken_along
from ..scene.compose import Obstacle, compile_model, compose, figure_spec
from ..solving import raw_spline
from ..system.progress import Progress
from ..system.quantity import positive
from . import gaps
from .formats import recording, stem
from .recording import Recording
from .robot import joint_name


def read_recording(
    source: Path,
    kind: str | None = None,
    *,
    figure: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    progress: Progress | None = None,
    obstacles: Sequence[Obstacle] = (),
) -> Recording:
    """Read a file of another program: its samples, in their scene, with hinges without wraps.

    figure  name of a shipped figure or path to MJCF, for files that contain none
    fps, scale  [1/s], [m] rate and unit of length, for files that lack them
    progress  receives notes on how the file was read
    obstacles  of the scene

    Raises UserError.
    """
    for name, value in (("fps", fps), ("scale", scale)):
        if value is not None:
            positive(value, f"{name} =")
    progress = progress or Progress()
    spec = None if figure is None else figure_spec(figure)
    if spec is not None:
        spec.assets = dict(taken_along(spec))  # under the names that compose assigns, so that MuJoCo finds the meshes
    model = None if spec is None else compile_model(spec, figure)
    record = gaps.without_missing(recording(source, kind, model=model, fps=fps, scale=scale), source)
    if record.scene is not None:
        spec = record.scene.spec()
        model = compile_model(spec, source)
    assert spec is not None and model is not None, "a reader returns a figure or requires one"
    qpos, notes = _unwrap(model, record.time, record.qpos)
    for note in (*record.notes, *notes):
        progress.report(f"note: {note}")
    scene = compose(spec, obstacles, bare=model)
    return replace(record, name=stem(source), scene=scene, qpos=qpos, fps=record.rate)


def import_recording(
    source: Path,
    kind: str | None = None,
    *,
    figure: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    progress: Progress | None = None,
) -> Saved:
    """Return the motion in a file of another program: the spline through all its samples.

    The arguments are those of `read_recording`. Raises UserError.
    """
    progress = progress or Progress()
    record = read_recording(source, kind, figure=figure, fps=fps, scale=scale, progress=progress)
    assert record.scene is not None
    clip = clips.from_qpos(record.name, record.scene, record.time, record.qpos, record.rate, source.name)
    if pose := gaps.initial_pose(clip.figure.model, record.time, record.qpos):
        start = np.ceil(1000 * record.time[pose] - 1e-6) / 1000
        progress.report(f"note: {gaps.POSE} {record.time[pose]:.3f} s: `dynsplines trim --from {start:g}` removes it")
    return raw_spline(clip)


def _unwrap(model: mujoco.MjModel, time: Array, qpos: Array) -> tuple[Array, tuple[str, ...]]:
    """Return qpos (T, nq) in which hinges without limits, whose angles wrap at ±180°, are continuous, and a note."""
    if qpos.shape[1] != model.nq:  # reported where the keyframes are made
        return qpos, ()
    out, hinges = qpos.copy(), np.flatnonzero(model.jnt_type == JointKind.HINGE)
    columns = model.jnt_qposadr[hinges]
    for joint, column in zip(hinges, columns, strict=True):
        is_bounded = model.jnt_limited[joint] and np.ptp(model.jnt_range[joint]) < 2 * np.pi - NEGLIGIBLE
        low, high = qpos[:, column].min(), qpos[:, column].max()
        if not is_bounded and any(
            start - NEGLIGIBLE <= low and high <= start + 2 * np.pi + NEGLIGIBLE for start in (-np.pi, 0.0)
        ):
            out[:, column] = np.unwrap(qpos[:, column])
    is_other = np.abs(out - qpos) > np.pi
    if not is_other.any():
        return qpos, ()
    names = [joint_name(model, j) for j in hinges[is_other[:, columns].any(axis=0)].tolist()]
    whose, first = list_names(f"'{name}'" for name in names), time[is_other.any(axis=1).argmax()]
    return out, (f"{whose}: angles wrap at a whole turn, first at {first:.3f} s: unwrapped",)
