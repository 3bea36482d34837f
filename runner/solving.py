"""The main work between clip and output: solve a clip, and report on it."""

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
from dynsplines.solver.problem import renormalised
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.solution import Improvement, Solution

from .clip.build import Clip
from .clip.load import clip_from_motion
from .measure.violation import Violation, is_recording, violations
from .motion import Saved
from .system.progress import Progress


@contextmanager
def _unhurried() -> Iterator[None]:
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
    """A solved clip, and the duration of the search [s], if known."""

    clip: Clip
    motion: Solution
    seconds: float | None

    @classmethod
    def of(cls, saved: Saved) -> Solved:
        """Return the content of a motion file, without the trace of its search and custom penalties."""
        clip = clip_from_motion(saved)
        objective = clip.problem.plain_objective
        if clip.settings.renormalise:
            objective = renormalised(objective, saved.raw)
        search = saved.search
        evaluations = search.get("evaluations", 0)
        stop = Stop.__members__.get(str(search.get("stop")), Stop.CONVERGED)
        motion = Solution(saved.figure, objective, saved.timeline, saved.raw, (), evaluations, stop)
        return cls(clip, motion, search.get("seconds"))

    @cached_property
    def violations(self) -> tuple[Violation, ...]:
        return violations(self.clip, self.motion.timeline, self.motion.raw, self.motion.stop)

    @property
    def search(self) -> dict[str, Any]:
        """The data of a search that cannot be measured later; empty without a search."""
        motion = self.motion
        if motion.timeline is motion.raw and motion.stop is Stop.CONVERGED:
            return {}
        search: dict[str, Any] = {"evaluations": motion.evaluations}
        if self.seconds is not None:
            search["seconds"] = self.seconds
        search |= {"stop": motion.stop.name, "stopped because": motion.stop.value}
        if stances := self.clip.stances:
            search["stances"] = stances
        if self.clip.custom_penalties:
            search["custom penalties"] = [penalty.name for penalty, _ in self.clip.custom_penalties]
        return search

    def saved(self, progress: Progress, with_report: bool = True) -> Saved:
        """Return the content of a motion file. Ctrl-C during it has no effect."""
        clip, motion = self.clip, self.motion
        data = {}
        with _unhurried():
            if motion.stop is Stop.INTERRUPTED:
                progress.report("stopped; the best path so far is kept")
            if with_report:
                progress.step("measuring", 0.0, force=True)
                from .measure.report import report  # imported here because most commands measure nothing

                data = report(clip, motion, self.seconds)
                progress.step("measuring", 1.0, force=True)
        trace = [list(entry) for entry in motion.trace]
        timelines = motion.timeline, motion.raw
        return Saved(
            clip.name, clip.text, clip.scene, clip.figure, clip.fps, clip.keys, *timelines, trace, data, self.search
        )


def measured(saved: Saved, progress: Progress, reason: str) -> Saved:
    """Return a motion with its report; `reason` is the stop reason of motions that were neither searched nor
    cleaned."""
    solved = Solved.of(saved)
    if is_recording(saved) and not solved.motion.is_raw:
        reason = "cleaned recording"
    report = solved.saved(progress).report
    return replace(saved, report=report | {"stopped because": saved.search.get("stopped because", reason)})


def solve(clip: Clip, progress: Progress) -> Solved:
    """Solve a clip and report every improvement. Ctrl-C stops the search and returns the best path."""
    for note in clip.notes:
        progress.report(f"note: {note}")

    def improved(improvement: Improvement) -> None:
        note = f"evaluation {improvement.evaluation}, objective {improvement.value:.4g}"
        progress.step("solving", None, note)

    begin = time.perf_counter()
    solution = inbetween(clip.problem, improved=improved)
    seconds = time.perf_counter() - begin
    if solution.trace:
        first, last = solution.trace[0][2], solution.trace[-1][2]
        note = f"evaluation {solution.evaluations}, objective {first:.4g} -> {last:.4g}"
        progress.step("solving", 1.0, note, force=True)
    return Solved(clip, solution, seconds)


def saved(source: Clip | Saved, progress: Progress) -> Saved:
    """Return a saved motion unchanged, or that of a clip without a report."""
    return source if isinstance(source, Saved) else solve(source, progress).saved(progress, with_report=False)


def unsolved(clip: Clip) -> Solved:
    """Return a clip as its raw spline, to inspect keyframes."""
    problem = clip.problem
    return Solved(clip, Solution(problem.figure, problem.plain_objective, problem.raw, problem.raw), 0.0)
