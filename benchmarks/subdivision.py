"""Adaptive against uniform subdivision: how many variable frames each needs for the same gap to the fine optimum."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from bench import Effort, Section, Target, median, worst
from rotations import energy, solved, track

from dynsplines import recordings
from dynsplines.solver import Improvement, Objective, Path, Quadrature, Settings, Solution, inbetween

FIRST_SEED = 4000
RATIO = 20.0
SETS = {"moderate": (20, 2), "random": (20, 2)}
KEYFRAMES = 7
UNIFORM, FINEST = 3, 15
SAME = 1.1
TIGHT: dict[str, Any] = {"tolerance": 1e-9, "max_evaluations": 2000}
CLIP_UNIFORM, CLIP_FINEST = (2, 3), 12
CLIP_QUADRATURE = Quadrature("gauss", 4, 0.02)


def rounds(solve: Callable[[Callable[[Improvement], None]], Solution]) -> list[Path]:
    """The best path of every round of subdivision, in order."""
    last: dict[int, Path] = {}

    def improved(step: Improvement) -> None:
        last[step.round] = step.path

    motion = solve(improved)
    last[max(last, default=0)] = motion.path
    return list(last.values())


def fewest(paths: list[Path], keyframes: int, value: Callable[[Path], float], goal: float) -> float:
    """The fewest variable frames of a path whose value is at most `goal`; infinite where none is."""
    return min((p.spline.times.size - keyframes for p in paths if value(p) <= goal), default=np.inf)


def of_set(kind: str, seed: int) -> dict[str, Any]:
    """One uneven set: frames for the gap that three in every segment leave."""
    keys = track(kind, seed, KEYFRAMES, RATIO)
    finest = energy(solved(keys, Settings(variable=FINEST, frames=0, **TIGHT)).path)
    uniform = solved(keys, Settings(variable=UNIFORM, frames=0, **TIGHT))
    count = uniform.timeline.variable_count
    paths: list[Path] = []
    for start in (0, 1):
        one_by_one = Settings(variable=start, frames=count, batch=1e-9, threshold=0.0, **TIGHT)
        paths += rounds(partial(solved, keys, one_by_one))
    least = min([finest, *map(energy, paths)])
    gap = energy(uniform.path) - least
    need = fewest(paths, KEYFRAMES, energy, least + SAME * gap)
    return {
        "kind": kind,
        "seed": seed,
        "uniform frames": count,
        "adaptive frames": need,
        "share": need / count,
        "uniform gap": gap / least,
        "adaptive gap at as many frames": min(map(energy, paths)) / least - 1,
    }


def of_clip(effort: Effort) -> list[dict[str, Any]]:
    """run_and_step: frames for the gaps that two and three in every segment leave, judged on one fine quadrature."""
    problem = recordings.load("run_and_step")

    def solve(settings: Settings, improved: Any = None) -> Solution:
        return inbetween(problem.with_problem(settings=settings).problem, improved=improved)

    def settings(**more: Any) -> Settings:
        return replace(Settings(quadrature=CLIP_QUADRATURE, max_evaluations=1000, tolerance=1e-6), **more)

    effort.report("run_and_step, the fine optimum")
    fine = solve(settings(variable=effort.count(CLIP_FINEST, 6), frames=0))
    judge: Objective = fine.objective
    segments = len(problem.keys) - 1
    effort.report("run_and_step, adaptive")
    most = CLIP_UNIFORM[-1] * segments
    adaptive = settings(variable=0, frames=most, batch=0.2 if effort.quick else 1e-9, threshold=0.0)
    paths = rounds(partial(solve, adaptive))
    even = {}
    for variable in CLIP_UNIFORM:
        effort.report(f"run_and_step, {variable} a segment")
        even[variable] = judge.value(solve(settings(variable=variable, frames=0)).path)
    values = {id(path): judge.value(path) for path in paths}
    least = min([judge.value(fine.path), *values.values(), *even.values()])
    rows = []
    for variable, value in even.items():
        count, gap = variable * segments, value - least
        need = fewest(paths, len(problem.keys), lambda p: values[id(p)], least + SAME * gap)
        row = {"kind": "run_and_step", "uniform frames": count, "adaptive frames": need, "share": need / count}
        rows.append(
            row | {"uniform gap": gap / least, "adaptive gap at as many frames": values[id(paths[-1])] / least - 1}
        )
    return rows


def measure(effort: Effort) -> Section:
    section = Section(
        "Variable frames for the same gap to the fine optimum (within 10 %): adaptive by the weak form, and evenly",
        (
            "keyframes",
            "uniform: frames",
            "gap",
            "adaptive: frames",
            "adaptive / uniform",
            "worst",
            "gap at as many frames",
        ),
    )
    rows: list[dict[str, Any]] = []
    for kind, counts in SETS.items():
        results = []
        for i in range(effort.count(*counts)):
            effort.report(f"{kind}, set {i + 1} of {effort.count(*counts)}")
            results.append(of_set(kind, FIRST_SEED + i))
        rows += results
        _add_row(section, f"{len(results)} {kind} sets of {KEYFRAMES}, uneven {RATIO:g} : 1", results)
    clip_rows = of_clip(effort)
    for row in clip_rows:
        _add_row(section, f"run_and_step, {row['uniform frames']} evenly", [row])
    for kind in SETS:
        shares = [row["share"] for row in rows if row["kind"] == kind]
        section.targets.append(Target(f"{kind}: adaptive / uniform frames, median", median(shares), 0.5))
    shares = [row["share"] for row in clip_rows]
    section.targets.append(Target("run_and_step: adaptive / uniform frames, worse of both", worst(shares), 0.5))
    section.notes = [
        f"uniform: {UNIFORM} variable frames in every segment (run_and_step: {CLIP_UNIFORM[0]} and {CLIP_UNIFORM[1]}); "
        "adaptive: from none and from one a segment (run_and_step: from none), one more a round where the weak form "
        "promises most, up to as many as uniform has; every round converged; the fewest; medians over sets",
        f"gap: over the least of all paths, {FINEST} a segment among them (run_and_step: {CLIP_FINEST}, its E with "
        "every penalty on 20 ms panels); 'inf': not with as many frames",
    ]
    section.data = {"sets": rows, "run_and_step": clip_rows}
    return section


def _add_row(section: Section, words: str, rows: list[dict[str, Any]]) -> None:
    def middle(name: str) -> float:
        return median([row[name] for row in rows])

    most = worst([row["share"] for row in rows])
    last = middle("adaptive gap at as many frames")
    section.add(
        words, middle("uniform frames"), middle("uniform gap"), middle("adaptive frames"), middle("share"), most, last
    )
