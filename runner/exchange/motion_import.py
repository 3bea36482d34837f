"""Import of a recording: as a motion of a figure, with a keyframe at every sample, without optimisation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind

from ..clip import load as clips
from ..errors import listed
from ..motion import Saved
from ..scene.assets import Scene, taken_along
from ..scene.compose import Obstacle, compiled, compose, figure_spec
from ..solving import unsolved
from ..system.progress import Progress
from ..system.quantity import positive
from . import gaps
from .formats import recording, stem

EDGE = 1e-3  # [rad] tolerance at the bounds of a turn, as files contain rounded angles


@dataclass(frozen=True)
class ImportedMotion:
    """A recording of a figure in its scene.

    time  (T,) [s]; qpos  (T, nq), hinges without wraps; fps  [1/s]
    """

    name: str
    scene: Scene
    time: Array
    qpos: Array
    fps: float


def read_recording(
    source: Path,
    kind: str | None = None,
    *,
    figure: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    progress: Progress | None = None,
    obstacles: Sequence[Obstacle] = (),
) -> ImportedMotion:
    """Read a file of another program.

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
    model = None if spec is None else compiled(spec, figure)
    record = gaps.without_missing(recording(source, kind, model=model, fps=fps, scale=scale), source)
    if record.scene is not None:
        spec = record.scene.spec()
        model = compiled(spec, source)
    assert spec is not None and model is not None, "a reader returns a figure or requires one"
    qpos, notes = _unwrap(model, record.time, record.qpos)
    for note in (*record.notes, *notes):
        progress.report(f"note: {note}")
    step = gaps.median_step(record.time)
    rate = record.fps or (float(np.round(1 / step, 6)) if step else 30.0)
    scene = compose(spec, obstacles, bare=model)
    return ImportedMotion(stem(source), scene, record.time, qpos, rate)


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
    clip = clips.from_qpos(record.name, record.scene, record.time, record.qpos, record.fps, source.name)
    if pose := gaps.initial_pose(clip.figure.model, record.time, record.qpos):
        start = np.ceil(1000 * record.time[pose] - 1e-6) / 1000
        progress.report(f"note: {gaps.POSE} {record.time[pose]:.3f} s: `dynsplines trim --from {start:g}` removes it")
    return unsolved(clip).motion


def _unwrap(model: mujoco.MjModel, time: Array, qpos: Array) -> tuple[Array, tuple[str, ...]]:
    """Return qpos (T, nq) in which hinges without limits, whose angles wrap at ±180°, are continuous, and a note."""
    out, names, first = qpos, [], np.inf
    if qpos.shape[1] != model.nq:  # reported where the keyframes are made
        return qpos, ()
    for joint in range(model.njnt):
        is_bounded = model.jnt_limited[joint] and np.ptp(model.jnt_range[joint]) < 2 * np.pi - EDGE
        if model.jnt_type[joint] != JointKind.HINGE or is_bounded:
            continue
        column = int(model.jnt_qposadr[joint])
        jumps = _whole_turns(qpos[:, column])
        if not jumps.any():
            continue
        out = qpos.copy() if out is qpos else out
        out[1:, column] -= 2 * np.pi * np.cumsum(jumps)
        names.append(model.joint(joint).name or f"joint{joint}")
        first = min(first, float(time[1 + np.flatnonzero(jumps)[0]]))
    if not names:
        return qpos, ()
    whose = listed(f"'{name}'" for name in names)
    return out, (f"{whose}: angles wrap at a whole turn, first at {first:.3f} s: unwrapped",)


def _whole_turns(angle: Array) -> Array:
    """Return the number of whole turns (T - 1,) between samples, if all angles lie within one turn, from -180° or from
    0°, and so may be wrapped."""
    is_within = any(angle.min() >= low - EDGE and angle.max() <= low + 2 * np.pi + EDGE for low in (-np.pi, 0.0))
    return np.round(np.diff(angle) / (2 * np.pi)) * is_within
