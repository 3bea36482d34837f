"""Edits of files: motions or clips in, a new one out."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from dynsplines import models

from .. import motion, recordings, solving
from ..clip.build import Clip
from ..clip.load import load_motion
from ..clip.mirror import mirrored_tables
from ..clip.parse import table_of
from ..clip.table import ClipTable, PenaltyTable
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
    is_editable = edit.clip is not None and Path(sources[0]).suffix.lower() == ".toml"
    target = target or Path(f"{Path(sources[0]).stem}_{edit.word}{'.toml' if is_editable else '.npz'}")
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: an edit is written as a motion, .npz, or as a clip, .toml")
    check_target(target, overwrite=overwrite)
    inputs = [load_motion(Path(item)) if motion.is_motion(item) else recordings.load(item) for item in sources]
    edit.check(inputs)
    if target.suffix == ".toml":
        one = inputs[0]
        if edit.clip is None or not isinstance(one, Clip) or not one.text:
            raise UserError(
                f"{target}: only `mirror` and `retime` of a clip write a clip; write a motion, .npz, which a clip can "
                "follow as its recording"
            )
        _write_clip(edit.clip(table_of(one.text, sources[0]), one), sources[0], target)
        return target, ()
    saved = edit.motions([solving.saved(item, progress) for item in inputs], progress)
    saved = replace(saved, name=target.stem, search={"stopped because": f"not searched: {edit.word}"})
    motion.save(saved, target)
    violations = Solved.of(saved).violations
    return target, tuple(f for f in violations if f.keyframe is None) if any(map(_is_sampled, inputs)) else violations


def _is_sampled(source: Clip | Saved) -> bool:
    """Return whether keyframes are samples of a recording, to which messages should not refer."""
    return edits.follows_recording(source) or (isinstance(source, Saved) and violation.is_recording(source))


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
        if saved.text:
            scene, mirror = table_of(saved.text, saved.name).scene, edits.mirror_of(saved)
            if mirrored_tables(ClipTable(figure="", scene=scene), saved.figure, mirror).scene != scene:
                progress.report(
                    "note: step and obstacles are not mirrored; to mirror them, mirror the clip: -o NAME.toml"
                )
        return edits.mirrored(saved)

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
        lambda table, clip: retimed_tables(table, rate(clip.keys)),
    )


def retimed_tables(clip: ClipTable, speed: float) -> ClipTable:
    """Return a clip's tables with the times of keyframes, contacts, grasps, flights and a cycle at another speed."""
    if clip.recording is not None:
        raise UserError("recording: set its speed in the clip, or retime the solved motion: -o NAME.npz")
    start = clip.keyframe[0].time

    def later(time: float) -> float:
        return start + (time - start) / speed

    return clip.changed(
        keyframe=[row.changed(time=later(row.time)) for row in clip.keyframe],
        contact=[row.changed(start=later(row.start), end=later(row.end)) for row in clip.contact],
        grasp=[row.changed(start=later(row.start), end=later(row.end)) for row in clip.grasp],
        penalty=[_paced(row, later, speed) for row in clip.penalty],
    )


def _paced(penalty: PenaltyTable, later: Callable[[float], float], speed: float) -> PenaltyTable:
    options = dict(penalty.options)
    if options.get("intervals"):
        options["intervals"] = [[later(first), later(last)] for first, last in options["intervals"]]
    if options.get("period"):
        options["period"] = options["period"] / speed
    return PenaltyTable.of(penalty.kind, **options)


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
