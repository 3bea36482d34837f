"""The shipped clips by Gauss-Newton steps alone and with NLopt's refinement of each, and what going on gains."""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import functools
import time
from dataclasses import replace

from bench import Effort, Section, Target, alternated, median, worst

from runner import clip as clips
from solver import Motion, inbetween
from solver.descent import NEWTON, Descent
from solver.optimiser import Minimum

CLIPS = (
    "cartwheel", "hand_on_rail", "jump_over_box", "run_and_step", "run_loop", "sit_down", "stairs", "walk_loop",
)  # fmt: skip
QUICK_CLIPS = ("run_loop", "sit_down")
NLOPT = "lbfgs"
REPEATS = 3
FINE = 1e-8
MORE_EVALUATIONS = 60
CLOSE, LONGEST = 1.01, 2.0


def solve(problem: clips.Clip, method: str) -> Motion:
    """What `dynsplines solve` calls, by one optimiser."""
    return inbetween(
        problem.figure,
        problem.keys,
        problem.penalties,
        replace(problem.settings, method=method),
        ends=problem.ends,
        end_slope=problem.end_slope,
        travel=problem.travel,
    )


def gone_on(motion: Motion, problem: clips.Clip, method: str) -> tuple[float, float, Minimum]:
    """From the end of a default solve on the same frames: % of E gained, seconds, and how it ended."""
    objective = motion.objective
    if problem.settings.renormalise:
        objective = objective.renormalised(motion.raw_path)
    descent = Descent(objective, motion.timeline)
    before = descent.problem(descent.problem.unknowns.start).value
    begin = time.perf_counter()
    found = descent.run(method=method, max_evaluations=MORE_EVALUATIONS, tolerance=FINE)
    return 100 * (1 - found.value / before), time.perf_counter() - begin, found
