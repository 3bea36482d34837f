"""A clip file (TOML, degrees, names) becomes a problem: figure, keyframes, soft constraints, settings.

The three stages are `parse` (text), `pose` (keyframes of a figure) and `build` (problem). Other inputs are a figure
with times and configurations, and a solved motion. Nothing is solved here; `recordings` loads clips that follow others.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure

from ..errors import UserError
from ..motion import Saved
from ..scene.assets import Scene
from ..scene.compose import KINDS, Obstacle, stage
from ..scene.configuration import first_wrong
from .build import Clip, build, build_following, edits_of, solve_of
from .half_cycle import whole_cycle
from .parse import Parsed, check_times, keyframe_label, table_of
from .pose import pose
from .posing import notes
from .table import BarTable, BoxTable, ClipTable, SceneTable, SolveTable, SphereTable, StepTable
from .tracking.recording import pose_at, recording_to_follow, track_of


def from_parsed(
    source: Parsed,
    *,
    figure_file: str | None = None,
    fps: float | None = None,
    spec: mujoco.MjSpec | None = None,
    unmet: list[str] | None = None,
    like: Clip | None = None,
    recording: Saved | None = None,
) -> Clip:
    """Return the clip of a parsed text.

    Args:
        figure_file: The present path of the figure, if it has moved.
        fps: Samples per second [1/s] of outputs, instead of the clip's.
        spec: The figure, instead of the one that the text names.
        unmet: Receives a line for every keyframe with unreachable positions, which otherwise raises an error.
        like: A clip from which this one was edited. Its figure and scene are reused if the text has the same.
        recording: The motion that the text follows, if any.

    Raises:
        UserError: In one line with the clip, the keyframe and the key.
    """
    table, where = source.table, source.where
    if like is not None and _has_ground(like, table):
        scene, figure = like.scene, like.figure
    else:
        scene, figure = scene_and_figure(source, figure_file, spec)
    source = whole_cycle(source, figure)
    table = source.table
    follows = None if table.recording is None else recording_to_follow(table.recording, figure, recording, where)
    keys, unreached = pose(source, figure, None if follows is None else partial(pose_at, follows, where))
    if unreached and unmet is None:
        raise UserError(f"{where}: {_unmet_error(unreached, is_file=where.endswith('.toml'))}")
    if unmet is not None:
        unmet += unreached
    if follows is not None:
        return build_following(source, scene, follows, keys, fps or table.fps)
    clip = build(source, scene, figure, keys, fps or table.fps)
    return replace(clip, notes=(*clip.notes, *notes.on_tables(figure, table.keyframe, clip.problem.raw)))


def scene_and_figure(
    source: Parsed, figure_file: str | None = None, spec: mujoco.MjSpec | None = None
) -> tuple[Scene, Figure]:
    """Return the scene of a clip, and its figure in this scene.

    Raises:
        UserError: For a figure or obstacles that do not compile, for a model that the solver does not support, and for
            keyframes with unknown joints or <key>s.
    """
    table = source.table
    figure = figure_file or table.figure if spec is None else spec
    try:
        around, rows = obstacles(table.scene), list(zip(source.labels, table.keyframe, strict=True))
        joints = [(label, name) for label, row in rows for name in row.joints]
        keys = [(f"{label}: others", row.model_key) for label, row in rows if row.model_key is not None]
        scene, model = stage(figure, source.folder, around, joints, keys)
        return scene, Figure(model)
    except (UserError, ValueError) as error:
        raise UserError(f"{source.where}: {error}") from None


def obstacles(scene: SceneTable) -> tuple[Obstacle, ...]:
    """Return the obstacles of a scene's tables: the step, and the others in the order of their kinds."""
    numbered = ((kind, pair) for kind in KINDS for pair in enumerate(getattr(scene, kind), start=1))
    others = (_obstacle(kind, table.name or f"{kind} {number}", table) for kind, (number, table) in numbered)
    return (*(() if scene.step is None else (_step(scene.step),)), *others)


def _step(table: StepTable) -> Obstacle:
    """Return a step: its front face is at x, its top at its height, its bottom on the ground."""
    half = (table.length / 2, table.width / 2, table.height / 2)
    return Obstacle("step", "box", half, np.array([table.x + half[0], table.y, half[2]]), np.array([1.0, 0, 0, 0]))


def _obstacle(kind: str, name: str, table: BoxTable | SphereTable | BarTable) -> Obstacle:
    ends = None
    if isinstance(table, BoxTable):
        size = tuple(0.5 * length for length in table.size)
    elif isinstance(table, SphereTable):
        size = (table.radius,)
    else:
        ends = None if table.start is None or table.end is None else np.array([*table.start, *table.end])
        size = (table.radius,) if table.length is None else (table.radius, 0.5 * table.length)
    place = np.array(table.position or (0.0, 0, 0))
    turn = np.array([1.0, 0, 0, 0]) if table.rotation is None else table.rotation.quaternion()
    return Obstacle(name, kind, size, place, turn, ends, table.color, table.body, table.mass)


def _unmet_error(lines: Sequence[str], *, is_file: bool) -> str:
    """Return the error on keyframes with unreachable positions, the first few, and a command that shows the poses."""
    more = [f"and {len(lines) - 3} keyframes more"] if len(lines) > 3 else []
    shows = ["`dynsplines render CLIP --only keys` shows the nearest poses"] if is_file else []
    return "; ".join([*lines[:3], *more, *shows])


def figure_of(scene: Scene, where: str) -> Figure:
    """Return the figure of a scene; raises UserError for a model that the solver does not support."""
    try:
        return Figure(scene.model())
    except ValueError as error:
        raise UserError(f"{where}: {error}") from None


def _has_ground(clip: Clip, table: ClipTable) -> bool:
    """Return whether a clip's text has the same figure in the same scene."""
    if not clip.text:
        return False
    old = table_of(clip.text, clip.context.where)
    named = {row.model_key for row in table.keyframe} - {None}
    return (old.figure, old.scene) == (table.figure, table.scene) and named <= {row.model_key for row in old.keyframe}


def from_qpos(name: str, scene: Scene, time: Array, qpos: Array, fps: float, where: str) -> Clip:
    """Return the clip of complete keyframes from arrays, with defaults for everything else.

    Args:
        time: Times, (K,) [s].
        qpos: Configurations, (K, nq).
        fps: Samples per second [1/s] of outputs.

    Raises:
        UserError: For arrays that do not fit the figure.
    """
    figure = figure_of(scene, where)
    if time.ndim != 1 or qpos.shape != (time.size, figure.width):
        raise UserError(
            f"{where}: time {time.shape} and qpos {qpos.shape} do not fit the figure: "
            f"they should be (K,) and (K, {figure.width})"
        )
    if wrong := first_wrong(figure.model, time, qpos):
        raise UserError(f"{where}: {keyframe_label(wrong[0] + 1, time[wrong[0]])}: {wrong[1]}")
    check_times(time.tolist(), where)
    keys = [Frame.key(t, q) for t, q in zip(time, qpos, strict=True)]
    return build(Parsed.of("", name, where).with_solve(SolveTable(), time.tolist()), scene, figure, keys, fps)


def of_motion(saved: Saved) -> Clip:
    """Return the clip that a saved motion solves, with the keyframes and the ends of the motion itself."""
    source = Parsed.of(saved.text, saved.name, saved.name)
    source = whole_cycle(source, saved.figure)
    source = source.with_solve(solve_of(saved, source.table.solve), [key.time for key in saved.keys])
    return build(source, saved.scene, saved.figure, saved.keys, saved.fps)


def clip_from_motion(saved: Saved) -> Clip:
    """Return the clip that a saved motion solves, with the recording that it follows, if any.

    A text of another version that this program cannot read is ignored.

    Raises:
        UserError: For a recording's stances that are damaged or of another figure.
    """
    try:
        source = Parsed.of(saved.text, saved.name, saved.name)
        if source.table.recording is None:
            return of_motion(saved)
    except UserError:
        return of_motion(replace(saved, text=""))
    edits = edits_of(saved.keys, source.table)
    recorded = track_of(saved.figure, saved.raw)
    clip = build_following(source, saved.scene, recorded, edits, saved.fps, saved.search.get("stances"))
    return replace(clip, problem=replace(clip.problem, keys=saved.keys))  # the recording may be missing
