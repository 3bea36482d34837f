"""Solve a clip, measure a motion."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Improvement, Solution
from dynsplines.solver.search.minimum import Stop

from .clip.build import Clip
from .measure.violation import is_recording
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


def measure(clip: Clip, motion: Saved, progress: Progress, reason: str = "not searched") -> Saved:
    """Return a motion that solves a clip with its report. Ctrl-C during it has no effect.

    Args:
        reason: The stop reason of motions that were neither searched nor cleaned.
    """
    from .measure.report import report  # imported here because most commands measure nothing

    if is_recording(motion) and not motion.is_raw:
        reason = "cleaned recording"
    with _without_interrupts():
        progress.step("measuring", 0.0, force=True)
        data = report(clip, motion)
        progress.step("measuring", 1.0, force=True)
    return replace(motion, report=data | {"stopped because": motion.search.get("stopped because", reason)})


def solve(clip: Clip, progress: Progress, *, with_report: bool = False) -> Saved:
    """Return the motion of a clip, and report every improvement. Ctrl-C stops the search and returns the best path.

    Args:
        with_report: Measure the motion. A second Ctrl-C has no effect on it.
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
        motion = motion_of(clip, solution, seconds)
        return measure(clip, motion, progress) if with_report else motion


def solve_first(clip: Clip, progress: Progress) -> Saved:
    """Return the motion of a clip for another computation. Ctrl-C ends both: it raises KeyboardInterrupt."""
    motion = solve(clip, progress)
    if motion.stop is Stop.INTERRUPTED:
        raise KeyboardInterrupt
    return motion


def motion_of(clip: Clip, solution: Solution, seconds: float | None = None) -> Saved:
    """Return the motion of a solved clip, without a report.

    Args:
        seconds: The duration of the search [s], if known.
    """
    raw = raw_spline(clip)
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


def raw_spline(clip: Clip) -> Saved:
    """Return the raw spline of a clip, to inspect keyframes."""
    raw = clip.problem.raw
    return Saved(clip.name, clip.text, clip.scene, clip.figure, clip.fps, clip.keys, raw, raw, [], {})


def saved_motion(source: Clip | Saved, progress: Progress) -> Saved:
    """Return a saved motion unchanged, or that of a clip without a report."""
    return source if isinstance(source, Saved) else solve(source, progress)
