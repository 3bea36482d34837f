"""Shipped clips, solved once for all tests of a run, whichever of its processes asks first."""

from __future__ import annotations

import hashlib
import os
import pickle
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from quiet import quiet

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables
from dynsplines.motion import Saved
from dynsplines.solver.solution import Solution
from dynsplines.solving import Solved
from dynsplines.system.progress import Progress

SOLVE = solving.solve  # whatever `share` puts in its place, which would wait for its own lock
PLACE = "DYNSPLINES_TESTS_SOLVED"  # the folder of this run's solved clips; its other processes inherit it


def open_folder() -> None:
    """Makes this run's folder, in the first of its processes."""
    if PLACE not in os.environ:
        os.environ[PLACE] = tempfile.mkdtemp(prefix="dynsplines-tests-")


def remove_folder() -> None:
    shutil.rmtree(os.environ[PLACE], ignore_errors=True)


@cache
def solved(name: str) -> Solved:
    """A shipped clip as `dynsplines solve` solves it."""
    return _cached(recordings.load(name), quiet(), SOLVE)


@cache
def unsolved(name: str) -> Saved:
    """The raw motion of a shipped clip, without a report."""
    return solving.unsolved(recordings.load(name)).saved(quiet(), with_report=False)


def _cached(problem: Clip, progress: Progress, solve: Callable[[Clip, Progress], Solved]) -> Solved:
    file = Path(os.environ[PLACE]) / _key(problem)
    with _locked(file.with_suffix(".lock")):
        if not file.exists():
            solved, motion = (result := solve(problem, progress)), result.motion
            about = motion.trace, motion.evaluations, motion.stop
            timeline = None if motion.timeline is motion.raw else replace(motion.timeline)  # without its cached spline
            file.write_bytes(pickle.dumps((timeline, about, solved.seconds)))
            return solved
        timeline, about, seconds = pickle.loads(file.read_bytes())
    raw = problem.problem.raw
    motion = Solution(problem.figure, problem.problem.objective, raw if timeline is None else timeline, raw, *about)
    return Solved(problem, motion, seconds)


def _key(problem: Clip) -> str:
    """A hash of all inputs of the search."""
    content = tables(table_of(problem.text, problem.name)) if problem.text else {}
    keys = [(key.time, key.state.tobytes(), key.fixed.tobytes(), key.known.tobytes()) for key in problem.keys]
    weights = [(penalty.name, weight) for penalty, weight in problem.penalties]
    posed, slope = problem.problem, problem.problem.end_slope
    end = problem.ends, posed.travel, posed.turn, None if slope is None else slope.tobytes()
    scene = problem.scene.mjcf, sorted(problem.scene.assets.items()), problem.figure.coordinates
    return hashlib.sha256(repr((content, keys, weights, end, problem.settings, scene)).encode()).hexdigest()


def share(monkeypatch: pytest.MonkeyPatch) -> None:
    """From here on whatever is solved in a test is solved once for all tests of a run that ask for the same."""
    solve = solving.solve

    def shared(problem: Clip, progress: Progress, **more: Any) -> Solved:
        return (
            solve(problem, progress, **more) if more or problem.custom_penalties else _cached(problem, progress, solve)
        )

    monkeypatch.setattr(solving, "solve", shared)


@contextmanager
def _locked(file: Path) -> Iterator[None]:
    """With no other process of this run in the same place, where the system has locks."""
    if os.name == "nt":
        yield
        return
    import fcntl

    with file.open("w") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        yield
