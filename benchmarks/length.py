"""Looped running with every penalty at 10, 100 and 1000 keyframes: time a keyframe, memory, and a clip of 60 s.

    python benchmarks/length.py KEYFRAMES      one length in this process, its figures as JSON

The stride of run_and_step (its keyframes at 0 … 0.63 s) is repeated every 0.75 s, moved on so that the left foot comes
down where the next loop's stance has it. Every length is solved in a process of its own, for its peak memory.
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import json
import re
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from bench import Effort, Section, Target
from rekeyed import with_keys

from dynsplines import models, recordings
from dynsplines.clip import load as clips
from dynsplines.solver import Frame, Solution, inbetween
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import places_of, site_points

STRIDE, PERIOD = 6, 0.75
LENGTHS = (10, 100, 1000)
MINUTE = 480
LIMIT = 900.0
MOST_MEMORY = 8 * 1024**3
PLAIN = re.compile(r"^\[scene\]\n.*\n", re.MULTILINE)


def looped(count: int) -> clips.Clip:
    """The clip's penalties and settings on a floor without a step, through `count` keyframes of running."""
    text, replaced = PLAIN.subn("", models.clip_text("run_and_step"))
    if replaced != 1:
        raise ValueError("run_and_step.toml no longer has a [scene] of one line")
    problem = recordings.from_text(text, name="looped running")
    stride = problem.keys[:STRIDE]
    shift = _shift(problem, stride)
    keys = []
    for i in range(count):
        loop, part = divmod(i, STRIDE)
        qpos = np.array(stride[part].state)
        qpos[0] += loop * shift
        keys.append(Frame.key(loop * PERIOD + stride[part].time, qpos))
    return with_keys(problem, keys)


def _shift(problem: clips.Clip, stride: tuple[Frame, ...]) -> float:
    """The length of a stride [m]: from the left heel's first stance to its position in the last keyframe."""
    figure = problem.figure
    states = np.array([figure.to_state(stride[i].state) for i in (0, -1)])
    heel = places_of(site_points(figure, ["left_heel"]), Samples(figure, states, 0 * states, 0 * states))[0]
    return float(heel[0, 0, 1] - heel[0, 0, 0])


def solve(count: int) -> dict[str, Any]:
    """One length: seconds on the clock of `inbetween`, peak memory of this process before and after [MB]."""
    problem = looped(count)
    before = _peak()
    begin = time.perf_counter()
    motion: Solution = inbetween(problem.problem)
    spent = time.perf_counter() - begin
    return {
        "keyframes": count,
        "seconds": spent,
        "plays [s]": problem.keys[-1].time - problem.keys[0].time,
        "peak [MB]": _peak(),
        "peak before solving [MB]": before,
        "evaluations": motion.evaluations,
        "variable frames": motion.timeline.variable_count,
        "stop": motion.stop.name,
        "objective": motion.trace[-1][2],
        "raw": motion.trace[0][2],
    }


def _peak() -> float:
    """The peak memory of this process [MB]; getrusage on Linux includes its parent's."""
    status = Path("/proc/self/status")
    if status.is_file():
        lines = dict(line.split(":", 1) for line in status.read_text(encoding="utf-8").splitlines())
        return float(lines["VmHWM"].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def in_child(count: int, limit: float) -> dict[str, Any]:
    """One length in a process of its own; what it printed, or why there is nothing."""
    command = [sys.executable, str(Path(__file__).resolve()), str(count)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return {"keyframes": count, "failed": f"not within {limit:.0f} s"}
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        return {"keyframes": count, "failed": lines[-1] if lines else f"ended with {done.returncode}"}
    return json.loads(done.stdout.splitlines()[-1])


def measure(effort: Effort) -> Section:
    section = Section(
        "Looped running, the clip's own penalties with torque, subdivision included",
        ("keyframes", "plays [s]", "solved in [s]", "ms a keyframe", "× playing", "peak [MB]", "variable frames",
         "evaluations"),
    )  # fmt: skip
    limit, runs = (60.0 if effort.quick else LIMIT), []
    for count in sorted({*LENGTHS, MINUTE}):
        repeats = effort.count(5 if count <= 100 else 1, 1)
        samples = []
        for i in range(repeats):
            effort.report(f"{count} keyframes, run {i + 1} of {repeats}")
            samples.append(in_child(count, limit))
        runs.append(_middle(samples))
        _add_row(section, runs[-1])
    by = {run["keyframes"]: run for run in runs}
    section.targets = _targets(by)
    section.notes = [
        "a process for each length; the clock is that of `inbetween` alone, the peak that of the whole process "
        f"({by[10].get('peak before solving [MB]', np.nan):.0f} MB before it solves); lengths up to 100: the median of "
        "5 runs, longer ones once",
        f"a length fails if it takes longer than {limit:.0f} s or more than {MOST_MEMORY / 1024**3:g} GB of addresses",
    ]
    section.data = {"runs": runs}
    return section


def _middle(runs: list[dict[str, Any]]) -> dict[str, Any]:
    """The run of median time; a failed one if there is any."""
    failed = [run for run in runs if "failed" in run]
    return failed[0] if failed else sorted(runs, key=lambda run: run["seconds"])[len(runs) // 2]


def _add_row(section: Section, run: dict[str, Any]) -> None:
    count = run["keyframes"]
    if "failed" in run:
        section.add(count, "–", run["failed"], *["–"] * 5)
        return
    spent = run["seconds"]
    faster = run["plays [s]"] / spent
    more = (run["peak [MB]"], run["variable frames"], run["evaluations"])
    section.add(count, run["plays [s]"], spent, 1e3 * spent / count, faster, *more)


def _targets(by: dict[int, dict[str, Any]]) -> list[Target]:
    def each(count: int) -> float:
        return by[count].get("seconds", np.inf) / count

    growth = max(each(count) for count in LENGTHS) / each(LENGTHS[0])
    extra = {n: by[n].get("peak [MB]", np.inf) - by[n].get("peak before solving [MB]", 0.0) for n in LENGTHS}
    playing = by[MINUTE].get("plays [s]", 0.0) / by[MINUTE].get("seconds", np.inf)
    return [
        Target("time a keyframe, longest clip / 10 keyframes", each(LENGTHS[-1]) / each(LENGTHS[0]), 1.5),
        Target("the same, worst of all lengths", growth, 1.5),
        Target("peak memory at 1000 keyframes", by[1000].get("peak [MB]", np.inf), 1024.0, unit="MB"),
        Target("memory for 100 → 1000 keyframes / 10 × that for 10 → 100", _linearity(extra), 1.5),
        Target("a clip of 60 s: playing / solving", playing, 5.0, least=True),
    ]


def _linearity(extra: dict[int, float]) -> float:
    few, middle, many = (extra[n] for n in LENGTHS)
    return (many - middle) / max(10 * (middle - few), 1e-9)


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    print(json.dumps(solve(int(sys.argv[1]))))
