"""Thinning: a motion reduced to few keyframes, with the error measured on the result.

The bound applies to the raw spline through the keyframes, or with `solve` to the motion that the default soft
constraints produce. A thinned clip has ordinary settings, so that it is solved like any other after an edit. The
deviation of that solution from the motion is also measured.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from dynsplines import models
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.thin import Bound, Recorded, Worst, refined, thin

from .. import motion, recordings, solving
from ..clip import file as clip_file
from ..clip.build import around, radians
from ..clip.load import load_motion, of_motion
from ..clip.parse import SHORTEST
from ..errors import UserError
from ..exchange.formats import is_foreign, stem
from ..exchange.motion_import import import_recording
from ..motion import Saved
from ..system.output import check_target
from ..system.progress import Progress
from ..system.quantity import length
from .edits import without_clip

RATE = 100.0  # [1/s] minimum sampling rate of a motion between keyframes
LOOSE = 4.0  # [1] factor on the bound for the first selection of keyframes with `solve`, which the search refines
ROUNDING = 1e-6  # [1] tolerance of the bound for the rounding of numbers in a file


@dataclass(frozen=True)
class ThinnedMotion:
    """The result of thinning: the motion through the remaining keyframes, and its errors at the samples.

    Attributes:
        instants: The number of samples.
        distance: The largest error of a body's origin, a site or a tip [m].
        angle: The largest error of a link [rad].
        times: The times of both [s].
        excess: The largest error as a multiple of its bound; above 1 the bound is exceeded.
    """

    motion: Saved
    instants: int
    distance: Worst
    angle: Worst
    times: tuple[float, float]
    excess: float

    @property
    def line(self) -> str:
        """ "14 keyframes of 331; at most 1.8 cm at 0.83 s (left_hand), 3.1° at 0.40 s (neck)" """
        return f"{len(self.motion.keys)} keyframes of {self.instants}; {self.misses}"

    @property
    def misses(self) -> str:
        """The second half of the line: the errors."""
        return (
            f"at most {100 * self.distance.value:.3g} cm at {self.times[0]:.2f} s ({self.distance.name}), "
            f"{np.degrees(self.angle.value):.3g}° at {self.times[1]:.2f} s ({self.angle.name})"
        )


def thinned(
    saved: Saved, distance: float, angle: float, *, solve: bool = False, progress: Progress | None = None
) -> ThinnedMotion:
    """Return a motion with few keyframes that stays within `distance` [m] and `angle` [rad] of the original.

    With `solve` the bounds apply to the solved motion, not only to the raw spline.
    """
    progress, saved = progress or Progress(), without_clip(saved)
    recorded = recorded_of(saved, distance, angle)

    def report(note: str) -> None:
        progress.step("thinning", None, note)

    def solved(keys: Sequence[Frame]) -> Timeline:
        return solving.solve(of_motion(replace(saved, keys=tuple(keys))), progress).motion.timeline

    loosely = replace(recorded, bound=Bound(LOOSE * distance, LOOSE * angle))
    reduced = refined(recorded, thin(loosely, report).instants, solved, report) if solve else thin(recorded, report)
    keys = tuple(recorded.frames(reduced.instants))
    return measured(recorded, replace(saved, keys=keys, timeline=reduced.timeline, raw=recorded.spline(keys)))


def measured(recorded: Recorded, motion: Saved) -> ThinnedMotion:
    """Return the deviation of a motion from a recording."""
    worst = recorded.worst(motion.timeline)
    times = float(recorded.times[worst[0].instant]), float(recorded.times[worst[1].instant])
    return ThinnedMotion(motion, recorded.times.size, *worst, times, float(recorded.excess(motion.timeline).max()))


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


def bound_of(error: str, angle: float) -> tuple[float, float]:
    """Return the two options of the command in metres and radians. Raises UserError for invalid bounds."""
    if not 0 < angle <= 180:
        raise UserError(f"--max-angle {angle:g}: give degrees, above 0 and up to 180")
    return length(error, "--max-error"), float(np.radians(angle))


@dataclass(frozen=True)
class Recording:
    """A motion's file, and options that a file of another program may need.

    Attributes:
        source: The file, or a shipped clip.
        fps: Samples per second [1/s].
    """

    source: str
    figure: str | None = None
    kind: str | None = None
    fps: float | None = None

    def read(self, progress: Progress) -> Saved:
        """Return a saved motion, the solution of a clip, or an imported file."""
        is_foreign_file = self.figure is not None or self.kind is not None
        path = Path(self.source)
        if not is_foreign_file and motion.is_motion(self.source) and not is_foreign(path):
            return load_motion(path)
        if not is_foreign_file and (self.source in models.clips() or path.suffix.lower() == ".toml"):
            return solving.saved(recordings.load(self.source), progress)
        return import_recording(path, self.kind, figure=self.figure, fps=self.fps, progress=progress)


def run(
    recording: Recording,
    bound: tuple[float, float],
    target: Path | None,
    *,
    solve: bool = False,
    overwrite: bool,
    progress: Progress,
) -> Path:
    """Thin a motion and write the result. A clip's file is read and solved again, to report its deviations.

    Args:
        bound: The error bounds [m], [rad].
        target: The output; None: SOURCE_thin.toml.
        solve: Whether the bound applies to the solved motion, not only to the spline.
    """
    target = target or Path(f"{stem(Path(recording.source))}_thin.toml")
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: a thinned motion is written as a clip, .toml, or as a motion, .npz")
    check_target(target, overwrite=overwrite)
    saved = recording.read(progress)
    result = thinned(saved, *bound, solve=solve, progress=progress)
    compact = replace(result.motion, name=target.stem)
    lines, written = [result.line], [target]
    if target.suffix == ".npz":
        motion.save(compact, target)
    else:
        clip_file.write(compact, target, overwrite=overwrite)
        clip = recordings.load(str(target))
        timeline = solving.solve(clip, progress).motion.timeline
        after = measured(recorded_of(saved, *bound), replace(result.motion, timeline=timeline))
        lines = [after.line] if solve else [f"{result.line}: the spline", _as_solved(after)]
        written = clip_file.write(compact, target, note="; ".join(lines), overwrite=True)
    for line in lines:
        progress.report(line)
    progress.report(f"wrote {' and '.join(map(str, written))}")
    return target


def _as_solved(result: ThinnedMotion) -> str:
    """Return a line on the deviation of the motion that the clip's settings produce."""
    beyond = "; more than requested: use --solve to stay within it"
    return f"solved with the clip's settings: {result.misses}{beyond if result.excess > 1 + ROUNDING else ''}"
