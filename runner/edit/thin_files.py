"""The command `thin`: from a motion's file to the clip of its keyframes, and its summary line."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from dynsplines import models

from .. import motion, recordings, solving
from ..clip.load import load_motion
from ..errors import UserError
from ..exchange.formats import is_foreign, stem
from ..exchange.motion_import import import_recording
from ..motion import Saved
from ..system.output import check_target
from ..system.progress import Progress
from ..system.quantity import length
from . import thinning
from .thinning import ThinnedMotion

ROUNDING = 1e-6  # [1] tolerance of the bound for the rounding of numbers in a file


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


def bound(error: str, angle: float) -> tuple[float, float]:
    """Return the two options in metres and radians. Raises UserError for invalid bounds."""
    if not 0 < angle <= 180:
        raise UserError(f"--max-angle {angle:g}: give degrees, above 0 and up to 180")
    return length(error, "--max-error"), float(np.radians(angle))


def run(
    recording: Recording,
    bound: tuple[float, float],
    target: Path | None,
    *,
    solve: bool = False,
    exact: bool = False,
    overwrite: bool,
    progress: Progress,
) -> Path:
    """Thin a motion and write the result. A clip's file is read and solved again, to report its deviations.

    Args:
        bound: The error bounds [m], [rad].
        target: The output; None: SOURCE_thin.toml.
        solve: Whether the bound applies to the solved motion, not only to the spline.
        exact: Whether the clip's settings return the spline unchanged.
    """
    if solve and exact:
        raise UserError("--solve bounds the solved motion, --exact writes a clip that is not searched: give one")
    source = Path(recording.source)
    target = target or Path(f"{stem(source)}_thin.toml")
    thinning.check(target)
    check_target(target, overwrite=overwrite)
    saved = recording.read(progress)
    result = thinning.thinned(saved, *bound, solve=solve, progress=progress)
    written = thinning.write(result, target, exact=exact, overwrite=overwrite)
    lines = [result.line]
    if target.suffix == ".toml":
        solved = solving.solve(recordings.load(str(target)), progress).motion.timeline
        after = thinning.measured(thinning.recorded_of(saved, *bound), replace(result.motion, timeline=solved))
        lines = [after.line] if solve or exact else [f"{result.line}: the spline", _as_solved(after)]
        thinning.write(result, target, exact=exact, note="; ".join(lines), overwrite=True)
    for line in lines:
        progress.report(line)
    progress.report(f"wrote {' and '.join(map(str, written))}")
    return target


def _as_solved(result: ThinnedMotion) -> str:
    """Return a line on the deviation of the motion that the clip's settings produce."""
    beyond = "; more than requested: use --solve to stay within it, or --exact to keep the spline"
    return f"solved with the clip's settings: {result.misses}{beyond if result.excess > 1 + ROUNDING else ''}"
