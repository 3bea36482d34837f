"""run_and_step from the command line and inside: seconds to solve, to the first better path, to the help text."""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from bench import CLIP, Effort, Section, Target, alternated, dynsplines, median

from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.solver import Improvement, Solution, StopSearch, inbetween


def solve(problem: clips.Clip) -> Solution:
    """The work of `dynsplines solve`, with every penalty and subdivision."""
    return inbetween(problem.problem)


def first_report() -> float:
    """Time from starting `dynsplines solve` to its first line on an improvement [s]; it is stopped then."""
    with tempfile.TemporaryDirectory() as folder:
        command = dynsplines("solve", CLIP, "-o", str(Path(folder) / "motion.npz"))
        begin = time.perf_counter()
        process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, cwd=folder)
        spent = float("nan")
        for line in process.stderr or ():
            if "evaluation" in line:
                spent = time.perf_counter() - begin
                break
        process.kill()
        process.communicate()
    return spent


def first_better() -> float:
    """Time from starting a process to the first path better than the raw one [s], in `inbetween`'s callback."""
    begin = time.time()
    command = [sys.executable, str(Path(__file__).resolve()), repr(begin)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return float(json.loads(done.stdout.splitlines()[-1])["seconds"])


def help_time() -> float:
    """`dynsplines --help` [s]."""
    begin = time.perf_counter()
    subprocess.run(dynsplines("--help"), capture_output=True, check=True, env=os.environ | {"TERM": "dumb"})
    return time.perf_counter() - begin


def measure(effort: Effort) -> Section:
    section = Section("run_and_step, every penalty, on one core", ("what", "median [s]", "least", "most"))
    problem = recordings.load(CLIP)
    clocks: dict[str, list[float]] = {}
    effort.report("solving")
    times, results = alternated({"solve": lambda: solve(problem)}, effort.repeats)
    clocks["solve, subdivision included"] = times["solve"]
    stages: dict[str, Any] = {
        "`dynsplines solve`: start to its first line about a path": first_report,
        "start of a process to the first path better than the raw one": first_better,
        "`dynsplines --help`": help_time,
    }
    for i in range(effort.repeats):
        for name, work in stages.items():
            effort.report(f"{name}, run {i + 1}")
            clocks.setdefault(name, []).append(work())
    for name, values in clocks.items():
        section.add(name, median(values), min(values), max(values))
    motion: Solution = results["solve"]
    middle = {name: median(values) for name, values in clocks.items()}
    solved, line, better, help_text = middle.values()
    section.targets = [
        Target("solve, subdivision included", solved, 0.5, unit="s"),
        Target("start of `dynsplines solve` to its first path told", line, 1.5, unit="s"),
        Target("start to the first path better than the raw one", better, 1.5, unit="s"),
        Target("`dynsplines --help`", help_text, 0.3, unit="s"),
    ]
    section.notes = [
        f"{motion.evaluations} evaluations, {motion.timeline.variable_count} variable frames, E "
        f"{motion.trace[0][2]:.4g} → {motion.trace[-1][2]:.4g}, {motion.stop.name.lower()}",
        "the first path that the command tells of is its first evaluation, which is the raw spline's; "
        "the first better one is timed in a process that loads the clip and stops in `improved`",
    ]
    section.data = {"clocks": clocks, "evaluations": motion.evaluations}
    return section


def _until_better(begin: float) -> None:
    problem = recordings.load(CLIP)

    def improved(step: Improvement) -> None:
        if step.evaluation > 1:
            step.path.at([step.path.span[0]])
            print(json.dumps({"seconds": time.time() - begin, "evaluation": step.evaluation}))
            raise StopSearch

    inbetween(problem.problem, improved=improved)


if __name__ == "__main__":
    _until_better(float(sys.argv[1]))
