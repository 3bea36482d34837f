"""The shipped clips by Gauss-Newton steps alone and with the last stage by NLopt, and what going on gains."""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import functools
import time
from dataclasses import replace

from bench import Effort, Section, Target, alternated, median, worst

from dynsplines.clip import load as clips
from dynsplines.solver import Solution, inbetween
from dynsplines.solver.search.descent import Descent

CLIPS = (
    "cartwheel", "hand_on_rail", "jump_over_box", "run_and_step", "run_loop", "sit_down", "stairs", "walk_loop",
)  # fmt: skip
QUICK_CLIPS = ("run_loop", "sit_down")
ALONE, NLOPT = "none", "lbfgs"
REPEATS = 3
FINE = 1e-8
MORE_EVALUATIONS = 60
CLOSE, LONGEST = 1.01, 2.0


def solve(problem: clips.Clip, method: str) -> Solution:
    """The work of `dynsplines solve`, with one optimiser."""
    return inbetween(replace(problem.problem, settings=replace(problem.settings, optimiser=method)))


def continued(motion: Solution, method: str) -> tuple[float, float]:
    """Continue after a solve, on the same frames: the decrease of E [%], and its duration [s]."""
    descent = Descent(motion.objective, motion.timeline)
    before = descent.problem(descent.problem.unknowns.start).value
    begin = time.perf_counter()
    minimum = descent.run(optimiser=method, max_evaluations=MORE_EVALUATIONS, tolerance=FINE)
    return 100 * (1 - minimum.value / before), time.perf_counter() - begin


def measure(effort: Effort) -> Section:
    columns = ("clip", "E alone", "E lbfgs", "alone [s]", "lbfgs [s]", "time ratio", "more alone", "more lbfgs")
    section = Section("The shipped clips: Gauss-Newton steps alone, and with the last stage by NLopt", columns)
    shares: list[float] = []
    ratios: list[float] = []
    rates: dict[str, list[float]] = {ALONE: [], NLOPT: []}
    for name in QUICK_CLIPS if effort.quick else CLIPS:
        effort.report(name)
        problem = clips.load(name)
        works = {method: functools.partial(solve, problem, method) for method in rates}
        times, motions = alternated(works, effort.count(REPEATS, 1), warm=False)
        values = {method: motion.trace[-1][2] for method, motion in motions.items()}
        seconds = {method: median(spent_times) for method, spent_times in times.items()}
        shares.append(values[NLOPT] / values[ALONE])
        ratios.append(median([a / b for a, b in zip(times[NLOPT], times[ALONE], strict=True)]))
        more = {method: continued(motions[ALONE], method) for method in rates}
        for method, (gain, spent) in more.items():
            rates[method].append(gain / spent)
        cells = (f"{gain:.2f} % in {spent:.1f} s" for gain, spent in more.values())
        section.add(name, values[ALONE], values[NLOPT], seconds[ALONE], seconds[NLOPT], ratios[-1], *cells)
        section.data[name] = {"E": values, "seconds": times, "more": more}
    section.targets = [
        Target("largest E with NLopt beside that of Gauss-Newton alone", worst(shares), CLOSE),
        Target("largest time with NLopt beside that of Gauss-Newton alone", worst(ratios), LONGEST),
    ]
    section.notes = [
        f"more: from the end of the default's solve on the same frames, to a tolerance of {FINE:g} or "
        f"{MORE_EVALUATIONS} evaluations; median gain {median(rates[ALONE]):.2g} % a second by Gauss-Newton, "
        f"{median(rates[NLOPT]):.2g} % with NLopt",
        "E has several minima where contacts come and go: the two need not end in the same one",
    ]
    return section
