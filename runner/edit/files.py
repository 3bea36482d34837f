"""Edits of files: motions or clips in, a new one out."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from dynsplines import models

from .. import motion, recordings, solving
from ..clip.build import Clip
from ..clip.half_cycle import MIRRORED, whole_cycle
from ..clip.load import clip_from_motion
from ..clip.mirror import mirrored_tables
from ..clip.parse import Parsed, table_of
from ..clip.table import ClipTable, PenaltyTable
from ..clip.text import text_of
from ..errors import UserError
from ..measure.bounds import Violation
from ..measure.violation import is_recording, violations
from ..motion import Saved
from ..system.output import Replacement, check_target
from ..system.progress import Progress
from . import edits

Written = tuple[Path, tuple[Violation, ...]]  # a written motion or clip, and the violations of a motion


def mirror(source: str, target: Path | None, *, overwrite: bool, progress: Progress, append: bool = False) -> Written:
    """Exchange left and right in a motion or a clip. The scene of a motion is unchanged.

    Args:
        append: Whether to keep the keyframes of half a gait cycle, and to append their mirror image.
    """
    target, one = _prepare(source, target, "mirrored", overwrite, writes_clips=True)
    if append:
        table = table_of(one.text, source) if target.suffix == ".toml" else None
        if table is None or table.solve.ends != MIRRORED:
            raise UserError("--append: give half a gait cycle, a clip with ends = 'mirrored', and write a clip, .toml")
        half = Parsed.of(one.text, one.name, source)
        return _write_clip(whole_cycle(half, one.figure).table, source, target)
    symmetry = edits.mirror_of(one)
    if target.suffix == ".toml":
        return _write_clip(mirrored_tables(table_of(one.text, source), one.figure, symmetry), source, target)
    saved = solving.saved_motion(one, progress)
    if saved.text:
        scene = table_of(saved.text, saved.name).scene
        if mirrored_tables(ClipTable(figure="", scene=scene), saved.figure, symmetry).scene != scene:
            progress.report("note: step and obstacles are not mirrored; to mirror them, mirror the clip: -o NAME.toml")
    return _write_motion(edits.mirror(saved), "mirrored", target, one)


def retime(
    source: str,
    speed: float | None,
    duration: float | None,
    target: Path | None,
    *,
    overwrite: bool,
    progress: Progress,
) -> Written:
    """Change the speed of a motion or a clip by a factor, or to a duration [s]."""
    if (speed is None) == (duration is None):
        raise UserError("give --speed, such as 1.5, or --duration, in seconds: one of them")
    for name, value in (("speed", speed), ("duration", duration)):
        if value is not None and not 1e-6 <= value <= 1e6:
            raise UserError(f"--{name} {value:g}: give a number above 0")
    target, one = _prepare(source, target, "retimed", overwrite, writes_clips=True)
    rate = speed if speed is not None else (one.keys[-1].time - one.keys[0].time) / (duration or 1.0)
    if target.suffix == ".toml":
        return _write_clip(retimed_tables(table_of(one.text, source), rate), source, target)
    return _write_motion(edits.retime(solving.saved_motion(one, progress), rate), "retimed", target, one)


def trim(
    source: str, first: float | None, last: float | None, target: Path | None, *, overwrite: bool, progress: Progress
) -> Written:
    """Cut a motion to the interval from `first` to `last` [s]; None: the motion's start or end."""
    if first is None and last is None:
        raise UserError("give --from, --to, or both, in seconds")
    target, one = _prepare(source, target, "trimmed", overwrite)
    interval = one.keys[0].time if first is None else first, one.keys[-1].time if last is None else last
    edits.check_interval(one, *interval)
    return _write_motion(edits.trim(solving.saved_motion(one, progress), *interval), "trimmed", target, one)


def _prepare(
    source: str, target: Path | None, word: str, overwrite: bool, *, writes_clips: bool = False
) -> tuple[Path, Clip | Saved]:
    """Return the output, by default the input's name with a word, and the loaded input.

    writes_clips  whether the edit of a clip can be a clip
    """
    if target is None:
        is_clip = writes_clips and Path(source).suffix.lower() == ".toml"
        target = Path(f"{Path(source).stem}_{word}{'.toml' if is_clip else '.npz'}")
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: an edit is written as a motion, .npz, or as a clip, .toml")
    check_target(target, overwrite=overwrite)
    one = motion.load(Path(source)) if motion.is_motion(source) else recordings.load(source)
    if target.suffix == ".toml" and not (writes_clips and isinstance(one, Clip) and one.text):
        raise UserError(
            f"{target}: only `mirror` and `retime` of a clip write a clip; write a motion, .npz, which a clip can "
            "follow as its recording"
        )
    return target, one


def _write_motion(edited: Saved, word: str, target: Path, source: Clip | Saved) -> Written:
    """Write a motion edited from another one. Messages do not refer to keyframes that are samples of a recording."""
    saved = replace(edited, name=target.stem, search={"stopped because": f"not searched: {word}"})
    motion.save(saved, target)
    listed = violations(clip_from_motion(saved), saved)
    if edits.follows_recording(source) or (isinstance(source, Saved) and is_recording(source)):
        listed = tuple(each for each in listed if each.keyframe is None)
    return target, listed


def _write_clip(table: ClipTable, source: str, target: Path) -> Written:
    """Write a clip from another one's tables, with the figure's path relative to it; raises UserError if invalid."""
    if table.figure not in models.figures():
        figure = Path(source).parent / table.figure
        table = table.change(figure=Path(os.path.relpath(figure, target.parent)).as_posix())
    text = text_of(table)
    recordings.from_text(text, name=target.stem, where=str(target), folder=target.parent)
    with Replacement(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return target, ()


def retimed_tables(clip: ClipTable, speed: float) -> ClipTable:
    """Return a clip's tables with the times of keyframes, contacts, grasps, flights and a cycle at another speed."""
    if clip.recording is not None:
        raise UserError("recording: set its speed in the clip, or retime the solved motion: -o NAME.npz")
    start = clip.keyframe[0].time

    def later(time: float) -> float:
        return start + (time - start) / speed

    return clip.change(
        keyframe=[row.change(time=later(row.time)) for row in clip.keyframe],
        contact=[row.change(start=later(row.start), end=later(row.end)) for row in clip.contact],
        grasp=[row.change(start=later(row.start), end=later(row.end)) for row in clip.grasp],
        penalty=[_pace(row, later, speed) for row in clip.penalty],
    )


def _pace(penalty: PenaltyTable, later: Callable[[float], float], speed: float) -> PenaltyTable:
    options = dict(penalty.options)
    if options.get("intervals"):
        options["intervals"] = [[later(first), later(last)] for first, last in options["intervals"]]
    if options.get("period"):
        options["period"] = options["period"] / speed
    return PenaltyTable.of(penalty.kind, **options)
