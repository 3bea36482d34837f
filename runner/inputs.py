"""The input of a command, a clip or a saved motion: loaded, solved, repeated, measured."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from . import motion, recordings
from .clip.build import Clip
from .clip.load import clip_from_motion
from .clip.parse import LONGEST
from .errors import UserError
from .motion import Saved
from .system import signals

if TYPE_CHECKING:
    from .measure.bounds import Violation
    from .system.progress import Progress


def load(source: str, *, fps: float | None = None, unmet: list[str] | None = None) -> Clip | Saved:
    """Return a saved motion, or a clip to solve; the arguments are those of `recordings.load`."""
    if motion.is_motion(source):
        return motion.load(Path(source))
    return recordings.load(source, fps=fps, unmet=unmet)


def clip_of(source: Clip | Saved) -> Clip:
    """Return the clip that a source is, or that its motion solves."""
    return clip_from_motion(source) if isinstance(source, Saved) else source


def span(source: Clip | Saved, repeat: int | None = None) -> tuple[float, float]:
    """Return the first and the last time [s] of a source that is repeated `repeat` times.

    Raises UserError for a repeated source that is not a loop, or lasts too long.
    """
    first, last = source.keys[0].time, source.keys[-1].time
    if repeat is None:
        return first, last
    ends = source.timeline.ends if isinstance(source, Saved) else source.ends
    if ends != "periodic":
        raise UserError(f"--repeat: '{source.name}' is not a loop; its ends are '{ends}', not 'periodic'")
    if repeat * (last - first) > LONGEST:
        raise UserError(f"--repeat {repeat}: give a number of periods that last {LONGEST:g} s at most")
    return first, first + repeat * (last - first)


def solution_of(
    source: Clip | Saved, progress: Progress, repeat: int | None = None, *, solve: bool = True
) -> tuple[Saved, Sequence[Violation]]:
    """Return the motion of a source, repeated `repeat` times, and the violations of one period.

    Without `solve` the clip's raw spline is returned, without violations. After a signal that ends the command, they
    are not measured.
    """
    from . import solving  # imported here because rejected clips do not need it
    from .measure import violation

    violations: Sequence[Violation] = ()
    out = solving.saved_motion(source, progress) if solve or isinstance(source, Saved) else solving.raw_spline(source)
    if solve and not signals.code(0) and not (out is source and violation.is_recording(out)):
        violations = violation.violations(clip_of(source), out)
    if repeat is not None:
        from .edit import edits  # imported here because few commands repeat

        reason = f"one period was solved and is played {repeat} times"
        out = replace(edits.repeat(out, repeat), search=out.search | {"stopped because": reason})
    return out, violations


def with_report(source: Clip | Saved, progress: Progress) -> Saved:
    """Return the motion of a source with its report, measured unless stored in its file."""
    from . import solving  # imported here, as above

    if not isinstance(source, Saved):
        return solving.solve(source, progress, with_report=True)
    if source.report:
        return source
    return solving.measure(clip_from_motion(source), source, progress, "not searched: imported")
