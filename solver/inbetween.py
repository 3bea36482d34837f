"""In-betweening: motion from keyframes and soft constraints, by the five steps of the paper's figure 5.

1. Keyframes and penalties: `Problem.raw`, `Problem.objective`
2. Variable frames between the keyframes: `Settings.beginning`
3. A C² spline through all frames: `curve.spline`
4. Descent, which moves the variable frames to lower E: `search.descent`
5. Subdivision where the path is badly approximated: `refine.subdivision`; continue with step 3
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import cache, partial
from operator import itemgetter

import numpy as np
from threadpoolctl import ThreadpoolController

from .array import Array
from .curve.frame import Timeline
from .curve.raw import straighten
from .curve.spline import path_of
from .objective import Discretised, Evaluation, Objective, segment_integrals
from .penalty import Role
from .problem import Improvement, Problem, Settings, Solution, initial_guess
from .refine.parts import SearchPart, is_long, windows
from .refine.subdivision import CRITERIA, midpoints, split
from .search.descent import minimise, optimiser_of
from .search.minimum import Optimiser, Stop
from .search.nlopt_methods import NONE
from .search.restarts import (
    cost_increased,
    is_poor_minimum,
    is_pose_outlier,
    is_resolved,
    select_best,
    violation_dominates,
)
from .tolerances import NEGLIGIBLE, ROUNDING

ROUGH = 2e-2  # [1] tolerance of all rounds except the last, relative to E
SHARE_OF_PROMISE = 0.1  # [1] predicted reduction of a step relative to that of new frames, below which a round ends
MOST_FRAMES = 12  # default limit of variable frames, on average per segment between keyframes
CLEARLY = 0.5  # [1] share of the first E, below which a path without short quaternions is better than the raw one
MOST_REFINEMENTS = 3  # [1] how often a search continues after it ended, with more samples


def inbetween(problem: Problem, *, improved: Callable[[Improvement], None] | None = None) -> Solution:
    """Return smooth motion through keyframes that minimises soft constraints.

    The path meets the keyframes exactly, even if the search is interrupted.

    Args:
        problem: The keyframes, soft constraints and settings.
        improved: Called with every improvement. It may raise `StopSearch` to end the search with the best path.

    Returns:
        The best path and the trace of the search.

    Raises:
        TimelineError: The keyframes are invalid.
    """
    raw = problem.raw
    return _search_result(problem, raw, raw, improved, lambda loop: loop.better_than(raw, loop.over(raw)))


def continue_from(
    problem: Problem,
    begin: Timeline,
    *,
    improved: Callable[[Improvement], None] | None = None,
) -> Solution:
    """Continue from a warm start, such as the solution before a keyframe was moved.

    The search ends in the nearest minimum. Unlike `inbetween`, it does not restart after a poor local minimum.

    Args:
        problem: The keyframes, soft constraints and settings.
        begin: A timeline through the keyframes with variable frames, see `refine.warm_start`.

    Returns:
        The best path and the trace of the search.

    Raises:
        TimelineError: The keyframes are invalid.
    """
    raw = problem.raw
    return _search_result(problem, raw, begin, improved, lambda loop: loop.continue_from(raw, begin))


def _search_result(
    problem: Problem,
    raw: Timeline,
    begin: Timeline,
    improved: Callable[[Improvement], None] | None,
    search: Callable[[_Loop], Timeline],
) -> Solution:
    """Return the result of a search. If interrupted, it is the best path so far, or `begin` before any evaluation."""
    with one_thread():
        loop = _Loop(problem.objective, problem.settings, improved)
        try:
            timeline = search(loop)
        except KeyboardInterrupt:
            latest = begin if loop.best is None else loop.best()
            timeline, loop.stop = loop.best_of(latest, begin), Stop.INTERRUPTED
    objective = replace(loop.objective, terms=problem.objective.terms)
    return Solution(problem.figure, objective, timeline, raw, tuple(loop.trace), loop.evaluations, loop.stop)


@contextmanager
def one_thread() -> Iterator[None]:
    """Run a block with one thread of BLAS, then restore the number of threads. On matrices as small as a band's blocks,
    several threads mostly wait."""
    libraries = _libraries()
    if all(library.num_threads == 1 for library in libraries.lib_controllers):
        yield
        return
    with libraries.limit(limits=1):
        yield


@cache
def _libraries() -> ThreadpoolController:
    """Return the BLAS libraries of NumPy and SciPy, cached because the search takes as long as a small solve."""
    return ThreadpoolController().select(user_api="blas")


class _Loop:
    """Rounds of descent and subdivision, on the whole clip or on a part of it.

    Attributes:
        trace: (evaluation, round, E, parts) of every improvement.
        best: Builds the best timeline so far; None before any evaluation.
        ends: The whole timelines after the rounds of the searched part.
        part: The searched part of the clip; None: the whole clip is searched at once.
        last: The terms of E at the last evaluation, by name.
        least: The least E since the samples changed, if they did.
    """

    def __init__(self, objective: Objective, settings: Settings, improved: Callable | None) -> None:
        self.objective, self.settings, self.improved = objective, settings, improved
        self.trace: list[tuple[int, int, float, dict[str, float]]] = []
        self.evaluations, self.round, self.least = 0, 0, np.inf
        self.best: Callable[[], Timeline] | None = None
        self.ends: list[Timeline] = []
        self.stop = Stop.CONVERGED
        self.optimiser = self.new_optimiser()
        self.part: SearchPart | None = None
        self.last: dict[str, float] = {}

    @property
    def outside_terms(self) -> Array:
        """The contribution of segments outside the searched part to the terms of E, (terms,)."""
        return np.zeros(len(self.objective.terms)) if self.part is None else self.part.outside_terms

    def new_optimiser(self) -> Optimiser:
        return optimiser_of(self.settings.optimiser, self.objective.figure.width, self.settings.tolerance)

    def better_than(self, raw: Timeline, candidate: Timeline) -> Timeline:
        """Return the better of two timelines, or `candidate` without a comparison if E has clearly decreased."""
        if self.stop is Stop.INTERRUPTED:  # it may have missed what happens between its samples
            return self.best_of(candidate, raw)
        is_clear = self.trace and self.trace[-1][2] < CLEARLY * self.trace[0][2]
        if is_clear and is_resolved(self.objective.figure, candidate):
            return candidate
        return select_best(self.objective.watching(path_of(raw)), [candidate, raw])

    def best_of(self, latest: Timeline, begin: Timeline) -> Timeline:
        """Return the best of two timelines and of those after rounds, on samples that are common to all."""
        return select_best(self.objective.watching(path_of(begin)), [latest, *reversed(self.ends), begin])

    def over(self, raw: Timeline) -> Timeline:
        """Return the best timeline through the keyframes of a raw one. Long clips are solved in windows."""
        settings = self.settings
        in_windows = settings.quadrature.kind == "gauss" and is_long(raw)
        first = split(raw, settings.beginning(raw.times, in_windows=in_windows))
        if in_windows:
            return self.over_windows(raw, first)
        most = settings.frames if settings.variable is None else first.variable_count
        guess = initial_guess(self.objective, first, most) if first.variable_count else None
        if guess is not None and self.objective.value(path_of(guess)) < self.objective.value(path_of(first)):
            first = guess
        return self.search(first, len(raw.frames) - 1, settings.frames)

    def continue_from(self, raw: Timeline, begin: Timeline) -> Timeline:
        """Return the nearest minimum from a timeline."""
        budget = self.settings.frames
        limit = None if budget is None else max(budget, begin.variable_count)
        timeline, self.stop = self.run(begin, len(raw.frames) - 1, limit)[-1]
        return timeline

    def over_windows(self, raw: Timeline, timeline: Timeline) -> Timeline:
        """Return the whole timeline after a search of its windows in order, from another one."""
        segments, budget = len(raw.frames) - 1, self.settings.frames
        terms, changed = np.zeros((segments, len(self.objective.terms))), slice(0, segments)
        for window in windows(segments):
            path = path_of(timeline)
            terms[changed] = segment_integrals(self.objective, path, raw.times[changed.start : changed.stop + 1])
            self.part = SearchPart.of(path, timeline, raw.times, window, terms)
            self.optimiser, self.ends = self.new_optimiser(), [timeline]
            count, limit = window.end - window.first, budget
            if budget is not None:
                others = timeline.variable_count - self.part.timeline.variable_count
                limit = min(round(budget * count / segments), budget - others)
            timeline = self.part.put_back(self.search(self.part.timeline, count, limit))
            changed = slice(window.begin, window.end)
            if self.stop is Stop.INTERRUPTED:
                break
            self.round += 1
        return timeline

    def search(self, timeline: Timeline, segments: int, budget: int | None) -> Timeline:
        """Return the best timeline of several searches, each started only if the minimum before it is poor.

        The first search starts from `timeline`, the second from the straight path between keyframes. The order is
        reversed if `timeline` is a pose outlier. If violations dominate or the cost increased in the better of both,
        two more starts follow: minima without limits of joints, near the straight path and near `timeline`. With one
        evaluation, only the initial path is evaluated.
        """
        ends: list[tuple[Timeline, Stop]] = []
        quadrature, cuts = self.objective.quadrature, set[float]()
        minima: list[tuple[float, dict[str, float]]] = []
        waiting = self._starts(timeline)
        while waiting:
            if ends:
                self.round += 1
                self.optimiser = self.new_optimiser()
                if self.objective.quadrature is not quadrature:  # its added samples are for other paths
                    self._replace(replace(self.objective, quadrature=quadrature))
            ends += self.run(waiting.pop(0)(), segments, budget)
            cuts |= set(self.objective.quadrature.cuts)
            minima.append((sum(self.last.values()), dict(self.last)))
            if self.stop is Stop.INTERRUPTED or not self._is_poor(ends[-1][0], minima):
                break
        self.objective = replace(self.objective, quadrature=quadrature).cut_at(cuts)
        selected = select_best(self.objective, [timeline for timeline, _ in reversed(ends)])
        stop = next(stop for timeline, stop in reversed(ends) if timeline is selected)
        self.stop = Stop.INTERRUPTED if self.stop is Stop.INTERRUPTED else stop
        return selected

    def _starts(self, timeline: Timeline) -> list[Callable[[], Timeline]]:
        """Return the functions that compute the initial guesses, in their order."""
        figure = self.objective.figure
        starts: list[Callable[[], Timeline]] = [lambda: timeline, lambda: straighten(figure, timeline)]
        if self.settings.max_evaluations == 1:
            return starts[:1]
        if is_pose_outlier(self.objective, timeline):
            starts.reverse()
        return [
            *starts,
            lambda: self.search_without_limits(straighten(figure, timeline)),
            lambda: self.search_without_limits(timeline),
        ]

    def _is_poor(self, timeline: Timeline, minima: Sequence[tuple[float, dict[str, float]]]) -> bool:
        """Return whether another search should follow the one that ended at `timeline`; minima: E and its terms."""
        _, parts = min(minima, key=itemgetter(0))
        if violation_dominates(self.objective, parts) or cost_increased(self.objective, parts):
            return True
        return len(minima) == 1 and is_poor_minimum(self.objective, timeline, parts)

    def run(self, timeline: Timeline, segments: int, budget: int | None) -> list[tuple[Timeline, Stop]]:
        """Return the results of rounds, until no segment needs a frame or the budget of frames is spent. A round that
        another may follow ends early, once its next step is predicted to gain little compared with new frames. After
        every round, E gets more samples where they miss violations."""
        ends: list[tuple[Timeline, Stop]] = []
        tolerance, refinements = self.settings.tolerance, 0
        budget = MOST_FRAMES * segments if budget is None else budget
        rough = max(ROUGH, tolerance)
        self._replace(self.objective.watching(path_of(timeline)))
        while True:
            is_last = timeline.variable_count >= budget
            timeline = self.descend(timeline, tolerance if is_last else rough)
            ends.append((timeline, self.stop))
            self.ends.append(timeline if self.part is None else self.part.put_back(timeline))
            if self.stop is Stop.INTERRUPTED:
                return ends
            finer = self.objective
            if self.stop is Stop.CONVERGED and refinements < MOST_REFINEMENTS:
                finer = self.objective.watching(path_of(timeline)).finer(path_of(timeline))
            is_finer = finer is not self.objective
            chosen, promise = (
                (np.zeros(0), 0.0) if is_last else self.choose_segments(timeline, budget - timeline.variable_count)
            )
            if not chosen.size and (is_last or rough <= tolerance):
                if not is_finer:
                    return ends
                refinements += 1
            if is_finer:
                self._replace(finer)
            rough = float(np.clip(SHARE_OF_PROMISE * promise, tolerance, rough)) if chosen.size else tolerance
            timeline = split(timeline, chosen)
            self.round += bool(chosen.size) or is_finer

    def _replace(self, objective: Objective) -> None:
        """Change the objective, and the value of the best path under it, which is so high that the path counts again.

        It may be larger than before. The path is not that of the present search if an earlier one ended better.
        """
        if objective is not self.objective:
            self.objective = objective
            self.least = np.inf if self.best is None else objective.value(path_of(self.best())) * (1 + ROUNDING)

    def search_without_limits(self, timeline: Timeline) -> Timeline:
        """Return the minimum of a rough search without limits of joints, which can trap a limb on the wrong side."""
        terms = tuple(term for term in self.objective.terms if term.penalty.role is not Role.LIMIT)
        problem = replace(self.objective, terms=terms).on(timeline)
        minimum = minimise(problem, optimiser=NONE, max_evaluations=self.settings.max_evaluations, tolerance=ROUGH)
        self.evaluations += minimum.evaluations
        if minimum.stop is Stop.INTERRUPTED:
            raise KeyboardInterrupt
        return timeline.with_rows(problem.unknowns.rows(minimum.x))

    def descend(self, timeline: Timeline, tolerance: float) -> Timeline:
        problem = self.objective.on(timeline)
        before, outside_terms = self.evaluations, self.outside_terms
        elsewhere = float(outside_terms.sum())

        def report(count: int, evaluation: Evaluation, x: Array) -> None:
            self.evaluations, self.last = before + count, evaluation.parts
            value = elsewhere + evaluation.value
            # a new round sums E over other samples, so its first values may exceed those of the last round
            if value >= self.least:
                return
            self.least = value
            self.best = partial(_insert, self.part, problem, x)
            parts = dict(evaluation.parts)
            for term, more in zip(self.objective.terms, outside_terms, strict=True):
                parts[term.penalty.name] += float(more)
            self.trace.append((before + count, self.round, value, parts))
            if self.improved is not None:
                self.improved(Improvement(before + count, self.round, value, parts, self.best))

        minimum = minimise(
            problem,
            optimiser=self.optimiser,
            max_evaluations=self.settings.max_evaluations,
            tolerance=tolerance,
            improved=report,
        )
        self.evaluations = before + minimum.evaluations
        self.stop = minimum.stop
        return timeline.with_rows(problem.unknowns.rows(minimum.x))

    def choose_segments(self, timeline: Timeline, max_count: int) -> tuple[Array, float]:
        """Return the middles of the segments to split next, and their predicted reduction as a share of E."""
        scores = CRITERIA[self.settings.criterion](self.objective, timeline)
        threshold, present = self.settings.threshold, 0.0
        if self.settings.criterion == "weak" and self.trace:
            present = max(self.trace[-1][2] - float(self.outside_terms.sum()), NEGLIGIBLE * self.trace[0][2])
            threshold *= present / max(sum(not frame.is_variable for frame in timeline.frames) - 1, 1)
        most = min(max_count, max(1, round(self.settings.batch * scores.size)))
        middles = midpoints(timeline)
        if self.part is not None:  # its fixed segments are not split
            scores = np.where(middles > self.part.since, scores, -np.inf)
        order = np.argsort(scores)[::-1][:most]
        order = order[scores[order] > threshold]
        promise = float(scores[order].sum()) / present if present > 0 else 0.0
        return np.sort(middles[order]), promise


def _insert(part: SearchPart | None, problem: Discretised, x: Array) -> Timeline:
    """Return the whole clip with the searched part at the unknowns x (n,)."""
    solved = problem.timeline.with_rows(problem.unknowns.rows(x))
    return solved if part is None else part.put_back(solved)
