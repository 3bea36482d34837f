"""Edits of files: motions or clips in, a new one out."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from dynsplines import models

from .. import motion, recordings, solving
from ..clip import file as clip_file
from ..clip.build import Clip
from ..clip.load import load_motion
from ..clip.mirror import mirrored_tables
from ..clip.parse import table_of
from ..clip.table import ClipTable
from ..clip.text import written
from ..errors import UserError
from ..measure import violation
from ..measure.violation import Violation
from ..motion import Saved
from ..solving import Solved
from ..system.output import Replacement, check_target
from ..system.progress import Progress
from . import edits

Violations = tuple[Violation, ...]


@dataclass(frozen=True)
class Edit:
    """An edit of files.

    Attributes:
        word: The verb for file names and reports.
        motions: Edits motions.
        clip: Edits a clip's tables; None if that is impossible.
        check: Raises UserError for impossible edits, before anything is solved.
    """

    word: str
    motions: Callable[[Sequence[Saved], Progress], Saved]
    clip: Callable[[ClipTable, Clip], ClipTable] | None = None
    check: Callable[[Sequence[Clip | Saved]], object] = lambda sources: None


def run(
    sources: list[str], edit: Edit, target: Path | None, *, overwrite: bool, progress: Progress
) -> tuple[Path, Violations]:
    """Apply an edit; return the written motion or clip (.toml), and the violations of a motion."""
    direct = edit.clip is not None and not motion.is_motion(sources[0])
    ending = ".toml" if direct and Path(sources[0]).suffix.lower() == ".toml" else ".npz"
    target = target or Path(f"{Path(sources[0]).stem}_{edit.word}{ending}")
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: an edit is written as a motion, .npz, or as a clip, .toml")
    check_target(target, overwrite=overwrite)
    inputs = [load_motion(Path(item)) if motion.is_motion(item) else recordings.load(item) for item in sources]
    edit.check(inputs)
    one, is_clip = inputs[0], target.suffix == ".toml"
    if is_clip and edit.clip is not None and isinstance(one, Clip) and one.text:
        _write_clip(edit.clip(table_of(one.text, sources[0]), one), sources[0], target)
        return target, ()
    saved = edit.motions([solving.saved(item, progress) for item in inputs], progress)
    if is_clip:
        if not saved.text:
            raise UserError(f"{target}: '{sources[0]}' has no clip file to edit; write an .npz")
        if isinstance(one, Clip):
            _write_clip(table_of(saved.text, sources[0]), sources[0], target)
        else:
            clip_file.write(replace(saved, name=target.stem), target, overwrite=overwrite)
        return target, ()
    search = {"stopped because": f"not searched: {edit.word}"}
    saved = replace(saved, name=target.stem, trace=[], report={}, search=search)
    motion.save(saved, target)
    violations = Solved.of(saved).violations
    return target, tuple(f for f in violations if f.keyframe is None) if any(map(_is_sampled, inputs)) else violations


def _is_sampled(source: Clip | Saved) -> bool:
    """Return whether keyframes are samples of a recording, to which messages should not refer."""
    if isinstance(source, Clip):
        return source.has_recording
    follows = bool(source.text) and table_of(source.text, source.name).recording is not None
    return follows or violation.is_recording(source)


def _write_clip(table: ClipTable, source: str, target: Path) -> None:
    """Write a clip from another one's tables, with the figure's path relative to it; raises UserError if invalid."""
    if table.figure not in models.figures():
        figure = Path(source).parent / table.figure
        table = table.changed(figure=Path(os.path.relpath(figure, target.parent)).as_posix())
    text = written(table)
    recordings.from_text(text, name=target.stem, where=str(target), folder=target.parent)
    with Replacement(target) as temporary:
        temporary.write_text(text, encoding="utf-8")


def mirrored() -> Edit:
    """Return the edit that exchanges left and right."""

    def motion_alone(sources: Sequence[Saved], progress: Progress) -> Saved:
        (saved,) = sources
        out = edits.mirrored(saved)
        if saved.text and table_of(out.text, saved.name).scene != table_of(saved.text, saved.name).scene:
            progress.report("note: step and obstacles are not mirrored; to mirror them, mirror the clip: -o NAME.toml")
        return out

    return Edit(
        "mirrored",
        motion_alone,
        lambda table, source: mirrored_tables(table, source.figure, edits.mirror_of(source)),
        lambda source: edits.mirror_of(source[0]),
    )


def retimed(speed: float | None, duration: float | None) -> Edit:
    """Return the edit that changes the speed or the duration."""
    if (speed is None) == (duration is None):
        raise UserError("give --speed, such as 1.5, or --duration, in seconds: one of them")
    for name, value in (("speed", speed), ("duration", duration)):
        if value is not None and not 1e-6 <= value <= 1e6:
            raise UserError(f"--{name} {value:g}: give a number above 0")

    def rate(keys: Any) -> float:
        return speed if speed is not None else (keys[-1].time - keys[0].time) / (duration or 1.0)

    return Edit(
        "retimed",
        lambda saved, _: edits.retimed(saved[0], rate(saved[0].keys)),
        lambda table, clip: edits.retimed_tables(table, rate(clip.keys)),
    )


def trimmed(first: float | None, last: float | None) -> Edit:
    """Return the edit that trims from one time to another; default: the motion's start or end."""
    if first is None and last is None:
        raise UserError("give --from, --to, or both, in seconds")

    def interval(sources: Sequence[Clip | Saved]) -> tuple[float, float]:
        begin, end = sources[0].keys[0].time, sources[0].keys[-1].time
        return begin if first is None else first, end if last is None else last

    return Edit(
        "trimmed",
        lambda saved, _: edits.trimmed(saved[0], *interval(saved)),
        check=lambda sources: edits.check_interval(sources[0], *interval(sources)),
    )


def joined(transition: float) -> Edit:
    """Return the edit that joins two motions."""
    edits.check_transition(transition)

    def both(saved: Sequence[Saved], progress: Progress) -> Saved:
        before, after = saved
        if before.scene != after.scene:
            progress.report(f"note: the scene is that of '{before.name}'")
        return edits.joined(before, after, transition, progress)

    return Edit("joined", both, check=lambda sources: edits.check_alike(*sources))
