"""Thinning: a recorded motion reduced to few keyframes, with the error measured on the result.

The bound applies to the raw spline through the keyframes, or with `solve` to the motion that the clip's penalties
produce. The clip has ordinary settings, so that it is solved like any other after an edit. The deviation of that
solution from the recording is also measured (`thin_files`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.thin import Bound, Recorded, Worst, refined, thin

from .. import solving
from ..clip import file as clip_file
from ..clip.build import Clip, around, radians
from ..clip.load import of_motion
from ..clip.parse import SHORTEST, table_of
from ..clip.text import keyframe_tables, written
from ..errors import UserError
from ..motion import Saved, save
from ..system.output import check_target
from ..system.progress import Progress

RATE = 100.0  # [1/s] minimum sampling rate of a motion between keyframes
LOOSE = 4.0  # [1] factor on the bound for the first selection of keyframes with `solve`, which the search refines


@dataclass(frozen=True)
class ThinnedMotion:
    """The result of thinning: the motion through the remaining keyframes, and its errors at the samples.

    Attributes:
        instants: The number of samples.
        distance: The largest error of a body's origin, a site or a tip [m].
        angle: The largest error of a link [rad].
        times: The times of both [s].
        slipped: The largest error of ends of limbs while they are still [m].
        excess: The largest error as a multiple of its bound; above 1 the bound is exceeded.
    """

    motion: Saved
    instants: int
    distance: Worst
    angle: Worst
    times: tuple[float, float]
    slipped: float
    excess: float

    @property
    def line(self) -> str:
        """ "14 keyframes of 331; at most 1.8 cm at 0.83 s (left_hand), 3.1° at 0.40 s (neck); standing 0.4 cm" """
        return f"{len(self.motion.keys)} keyframes of {self.instants}; {self.misses}"

    @property
    def misses(self) -> str:
        """The second half of the line: the errors."""
        standing = f"; hands and feet that stand, {100 * self.slipped:.2g} cm" if self.slipped > 0 else ""
        return (
            f"at most {100 * self.distance.value:.3g} cm at {self.times[0]:.2f} s ({self.distance.name}), "
            f"{np.degrees(self.angle.value):.3g}° at {self.times[1]:.2f} s ({self.angle.name}){standing}"
        )


def thinned(
    saved: Saved, distance: float, angle: float, *, solve: bool = False, progress: Progress | None = None
) -> ThinnedMotion:
    """Return a motion with few keyframes that stays within `distance` [m] and `angle` [rad] of the original.

    With `solve` the bounds apply to the solved motion, not only to the raw spline.
    """
    progress, saved = progress or Progress(), clip_file.standalone(saved)
    recorded = recorded_of(saved, distance, angle)

    def report(note: str) -> None:
        progress.step("thinning", None, note)

    def problem(keys: Sequence[Frame]) -> Clip:
        return of_motion(replace(saved, text=_text(saved, keys), keys=tuple(keys)), contacts=True)

    def solved(keys: Sequence[Frame]) -> Timeline:
        return solving.solve(problem(keys), progress).motion.timeline

    loosely = replace(recorded, bound=Bound(LOOSE * distance, LOOSE * angle))
    reduced = refined(recorded, thin(loosely, report).instants, solved, report) if solve else thin(recorded, report)
    keys = tuple(recorded.frames(reduced.instants))
    raw = recorded.spline(keys)
    compact = replace(
        saved, text=_text(saved, keys), keys=keys, timeline=reduced.timeline, raw=raw, trace=[], report={}
    )
    return measured(recorded, compact)


def measured(recorded: Recorded, motion: Saved) -> ThinnedMotion:
    """Return the deviation of a motion from a recording."""
    worst = recorded.worst(motion.timeline)
    times = float(recorded.times[worst[0].instant]), float(recorded.times[worst[1].instant])
    slipped, excess = recorded.slipped(motion.timeline), float(recorded.excess(motion.timeline).max())
    return ThinnedMotion(motion, recorded.times.size, *worst, times, slipped, excess)


def recorded_of(saved: Saved, distance: float, angle: float) -> Recorded:
    """Return the samples for comparison: those of a recording, or of a solved motion at RATE and its keyframes."""
    for value, what, example in ((distance, "metres", "0.02"), (angle, "radians", "0.1")):
        if not (np.isfinite(value) and value > 0):
            raise UserError(
                f"a motion cannot be thinned to within {value:g} {what}; give more than 0, such as {example}"
            )
    keys = np.array([key.time for key in saved.keys])
    times, figure = _instants(saved, keys), saved.figure
    qpos = figure.to_qpos(path_of(saved.timeline).at(times))
    back = around(saved)
    travel, turn = back.travel, radians(back.turn)
    return Recorded(figure, times, qpos, Bound(distance, angle), saved.timeline.ends, travel, turn)


def _instants(saved: Saved, keys: Array) -> Array:
    first, last = keys[0], keys[-1]
    if np.diff(keys).mean() <= 1.01 / saved.fps:
        return keys
    rate = min(saved.fps * np.ceil(RATE / saved.fps), 1 / SHORTEST)
    grid = first + np.arange(int((last - first) * rate) + 1) / rate
    after = keys[np.searchsorted(keys, grid).clip(1, keys.size - 1)]
    before = keys[np.searchsorted(keys, grid, side="right").clip(1, keys.size - 1) - 1]
    apart = np.minimum(np.abs(after - grid), np.abs(grid - before))
    return np.sort(np.concatenate([keys, grid[apart > SHORTEST]]))


def _text(saved: Saved, keys: Sequence[Frame]) -> str:
    """Return a motion's clip text with other keyframes and the contacts within their time; "" for one without."""
    if not saved.text:
        return ""
    table, first, last = table_of(saved.text, saved.name), keys[0].time, keys[-1].time
    return written(
        table.changed(
            solve=clip_file.searching(table.solve).changed(**around(saved).specified),
            contact=[row for row in table.contact if first <= row.start and row.end <= last],
            keyframe=keyframe_tables(saved.figure, keys),
        )
    )


def write(
    result: ThinnedMotion, target: Path, *, exact: bool = False, note: str = "", overwrite: bool = False
) -> list[Path]:
    """Write a thinned motion as a clip (.toml) or as a motion (.npz); return the files written.

    With `exact` the clip's [solve] returns the spline unchanged. `note` replaces the comment at a clip's head.
    """
    check(target)
    saved = replace(result.motion, name=target.stem)
    if target.suffix == ".toml":
        return clip_file.write(saved, target, note=note or result.line, exact=exact, overwrite=overwrite)
    save(saved, target)
    return [target]


def check(target: Path) -> None:
    """Raise UserError unless a thinned motion can be written to the target."""
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: a thinned motion is written as a clip, .toml, or as a motion, .npz")
    check_target(target)
