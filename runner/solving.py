"""Solve a clip, measure a motion."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Improvement, Solution
from dynsplines.solver.search.minimum import Stop

from .clip.build import Clip
from .clip.load import clip_from_motion
from .measure.bounds import Violation
from .measure.violation import is_recording, violations
from .motion import Saved
from .system.progress import Progress


@contextmanager
def _without_interrupts() -> Iterator[None]:
    """Ignore Ctrl-C in this block, so that the solution is not lost."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@dataclass(frozen=True)
class Solved:
    """A motion, and the clip that it solves."""

    clip: Clip
    motion: Saved

    @classmethod
    def of(cls, motion: Saved) -> Solved:
        """Return a motion with the clip in its file, which has no custom penalties."""
        return cls(clip_from_motion(motion), motion)

    @cached_property
    def violations(self) -> tuple[Violation, ...]:
        return violations(self.clip, self.motion.timeline, self.motion.raw, self.motion.stop)

    def measure(self, progress: Progress, reason: str = "not searched") -> Saved:
        """Return the motion with its report. Ctrl-C during it has no effect.

        Args:
            reason: The stop reason of motions that were neither searched nor cleaned.
        """
        from .measure.report import report  # imported here because most commands measure nothing

        if is_recording(self.motion) and not self.motion.is_raw:
            reason = "cleaned recording"
        with _without_interrupts():
            progress.step("measuring", 0.0, force=True)
            data = report(self.clip, self.motion)
            progress.step("measuring", 1.0, force=True)
        because = self.motion.search.get("stopped because", reason)
        return replace(self.motion, report=data | {"stopped because": because})


def solve(clip: Clip, progress: Progress, *, measure: bool = False) -> Solved:
    """Solve a clip and report every improvement. Ctrl-C stops the search and returns the best path.

    Args:
        measure: Add the motion's report. A second Ctrl-C has no effect on it.
    """
    for note in clip.notes:
        progress.report(f"note: {note}")

    def improved(improvement: Improvement) -> None:
        note = f"evaluation {improvement.evaluation}, objective {improvement.value:.4g}"
        progress.step("solving", None, note)

    begin = time.perf_counter()
    solution = inbetween(clip.problem, improved=improved)
    seconds = time.perf_counter() - begin
    with _without_interrupts():
        if solution.trace:
            first, last = solution.trace[0][2], solution.trace[-1][2]
            note = f"evaluation {solution.evaluations}, objective {first:.4g} -> {last:.4g}"
            progress.step("solving", 1.0, note, force=True)
        if solution.stop is Stop.INTERRUPTED:
            progress.report("stopped; the best path so far is kept")
        solved = Solved(clip, motion_of(clip, solution, seconds))
        return replace(solved, motion=solved.measure(progress)) if measure else solved


def motion_of(clip: Clip, solution: Solution, seconds: float | None = None) -> Saved:
    """Return the motion of a solved clip, without a report.

    Args:
        seconds: The duration of the search [s], if known.
    """
    raw = raw_spline(clip).motion
    if solution.timeline is solution.raw and solution.stop is Stop.CONVERGED:
        return raw
    search: dict[str, Any] = {"evaluations": solution.evaluations}
    if seconds is not None:
        search["seconds"] = seconds
    search |= {"stop": solution.stop.name, "stopped because": solution.stop.value}
    if stances := clip.stances:
        search["stances"] = stances
    if clip.custom_penalties:
        search["custom penalties"] = [penalty.name for penalty, _ in clip.custom_penalties]
    trace = [list(entry) for entry in solution.trace]
    return replace(raw, timeline=solution.timeline, raw=solution.raw, trace=trace, search=search)


def raw_spline(clip: Clip) -> Solved:
    """Return the raw spline of a clip, to inspect keyframes."""
    raw = clip.problem.raw
    motion = Saved(clip.name, clip.text, clip.scene, clip.figure, clip.fps, clip.keys, raw, raw, [], {})
    return Solved(clip, motion)


def saved_motion(source: Clip | Saved, progress: Progress) -> Saved:
    """Return a saved motion unchanged, or that of a clip without a report."""
    return source if isinstance(source, Saved) else solve(source, progress).motion
