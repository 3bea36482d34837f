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
from dynsplines.solver.edit.thin import Recorded, refine, thin

from .. import motion, recordings, solving
from ..clip import text as clip_text
from ..clip.build import around
from ..clip.load import of_motion
from ..clip.parse import SHORTEST
from ..errors import UserError
from ..exchange.formats import is_foreign, stem
from ..exchange.motion_import import import_recording
from ..motion import RESAMPLED, Saved
from ..system.output import check_target
from ..system.progress import Progress
from ..system.quantity import length
from .edits import without_clip

LOOSE = 4.0  # [1] factor on the bound for the first selection of keyframes with `solve`, which the search refines


@dataclass(frozen=True)
class MotionDifference:
    """The largest differences between two motions at equal times.

    Attributes:
        distance: Largest distance [m] between the positions of a body's origin, or of a site, in the two motions.
        where: Name of this body or site.
        time: Time of the largest distance [s].
        angle: Largest angle [degrees] between the orientations of a body in the two motions.
        turned: Name of the body with the largest angle.
        turned_time: Time of the largest angle [s].
    """

    distance: float
    where: str
    time: float
    angle: float
    turned: str
    turned_time: float

    @classmethod
    def of(cls, recorded: Recorded, timeline: Timeline) -> MotionDifference:
        """Compare a timeline with recorded samples."""
        (distance, far, where), (angle, turned, name) = recorded.worst(timeline)
        times = recorded.times[[far, turned]].tolist()
        return cls(distance, where, times[0], float(np.degrees(angle)), name, times[1])

    def __str__(self) -> str:
        return (
            f"at most {100 * self.distance:.3g} cm at {self.time:.2f} s ({self.where}), "
            f"{self.angle:.3g}° at {self.turned_time:.2f} s ({self.turned})"
        )


def thin_motion(
    saved: Saved, distance: float, angle: float, *, solve: bool = False, progress: Progress | None = None
) -> Saved:
    """Return a motion with few keyframes that stays within `distance` [m] and `angle` [rad] of the original.

    With `solve` the bounds apply to the solved motion, not only to the raw spline.
    """
    progress, saved = progress or Progress(), without_clip(saved)
    recorded = recorded_of(saved, distance, angle)

    def report(note: str) -> None:
        progress.step("thinning", None, note)

    def solved(keys: Sequence[Frame]) -> Timeline:
        return solving.solve_first(of_motion(replace(saved, keys=tuple(keys))), progress).timeline

    loosely = replace(recorded, distance=LOOSE * distance, angle=LOOSE * angle)
    if solve:
        instants, timeline = refine(recorded, thin(loosely, report)[0], solved, report)
    else:
        instants, timeline = thin(recorded, report)
    keys = tuple(recorded.frames(instants))
    return replace(saved, keys=keys, timeline=timeline, raw=recorded.spline(keys))


def recorded_of(saved: Saved, distance: float, angle: float) -> Recorded:
    """Return the samples for comparison: of a recording, its own; of a solved motion, dense ones and its keyframes."""
    for value, what, example in ((distance, "metres", "0.02"), (angle, "radians", "0.1")):
        if not (np.isfinite(value) and value > 0):
            raise UserError(
                f"a motion cannot be thinned to within {value:g} {what}; give more than 0, such as {example}"
            )
    keys = np.array([key.time for key in saved.keys])
    times, figure = _instants(saved, keys), saved.figure
    qpos = figure.to_qpos(path_of(saved.timeline).at(times))
    back = around(saved)
    travel, turn = back.travel, None if back.turn is None else float(np.radians(back.turn))
    return Recorded(figure, times, qpos, distance, angle, saved.timeline.ends, travel, turn)


def _instants(saved: Saved, keys: Array) -> Array:
    first, last = keys[0], keys[-1]
    if np.diff(keys).mean() <= 1.01 / saved.fps:
        return keys
    rate = min(saved.fps * np.ceil(RESAMPLED / saved.fps), 1 / SHORTEST)
    grid = first + np.arange(int((last - first) * rate) + 1) / rate
    after = keys[np.searchsorted(keys, grid).clip(1, keys.size - 1)]
    before = keys[np.searchsorted(keys, grid, side="right").clip(1, keys.size - 1) - 1]
    apart = np.minimum(np.abs(after - grid), np.abs(grid - before))
    return np.sort(np.concatenate([keys, grid[apart > SHORTEST]]))


def bound_of(error: float | str, angle: float, names: tuple[str, str]) -> tuple[float, float]:
    """Return bounds, a length and an angle [degrees], in metres and radians. Raises UserError for invalid ones."""
    if not 0 < angle <= 180:
        raise UserError(f"{names[1]} {angle:g}: give degrees, above 0 and up to 180")
    return length(error, names[0]), float(np.radians(angle))


def run(
    source: str,
    bound: tuple[float, float],
    target: Path | None,
    *,
    figure: str | None = None,
    kind: str | None = None,
    fps: float | None = None,
    solve: bool = False,
    overwrite: bool,
    progress: Progress,
) -> Path:
    """Thin a motion and write the result. A clip's file is read and solved again, to report its deviations.

    Args:
        source: The file, or a shipped clip.
        bound: The error bounds [m], [rad].
        target: The output; None: SOURCE_thin.toml.
        figure: Figure of a recording that contains none; also `kind`, its format, and `fps`, its rate [1/s].
        solve: Whether the bound applies to the solved motion, not only to the spline.
    """
    target = target or Path(f"{stem(Path(source))}_thin.toml")
    if target.suffix not in (".npz", ".toml"):
        raise UserError(f"{target}: a thinned motion is written as a clip, .toml, or as a motion, .npz")
    check_target(target, overwrite=overwrite)
    is_imported = figure is not None or kind is not None
    if not is_imported and motion.is_motion(source) and not is_foreign(Path(source)):
        saved = motion.load(Path(source))
    elif not is_imported and (source in models.clips() or Path(source).suffix.lower() == ".toml"):
        saved = solving.saved_motion(recordings.load(source), progress)
    else:
        saved = import_recording(Path(source), kind, figure=figure, fps=fps, progress=progress)
    recorded = recorded_of(without_clip(saved), *bound)
    compact = replace(thin_motion(saved, *bound, solve=solve, progress=progress), name=target.stem)
    head = f"{len(compact.keys)} keyframes of {recorded.times.size}"
    lines, written = [f"{head}; {MotionDifference.of(recorded, compact.timeline)}"], [target]
    if target.suffix == ".npz":
        motion.save(compact, target)
    else:
        clip_text.write(compact, target, overwrite=overwrite)
        timeline = solving.solve(recordings.load(str(target)), progress).timeline
        after = MotionDifference.of(recorded, timeline)
        is_exceeded = recorded.excess(timeline).max() > 1 + 1e-6  # numbers in a file are rounded
        beyond = "; more than requested: use --solve to stay within it" if is_exceeded else ""
        as_solved = f"solved with the clip's settings: {after}{beyond}"
        lines = [f"{head}; {after}"] if solve else [f"{lines[0]}: the spline", as_solved]
        written = clip_text.write(compact, target, note="; ".join(lines), overwrite=True)
    for line in lines:
        progress.report(line)
    progress.report(f"wrote {' and '.join(map(str, written))}")
    return target
