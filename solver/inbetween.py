"""The verb: keyframes and soft constraints in, motion out. The five steps of the paper's figure 5.

1  keyframes, whole or partial, and penalties           raw_timeline, Objective
2  variable frames between them                         beginning
3  a C² spline through all frames                       spline.Spline
4  move the variable frames to lower E                  descent.Descent
5  split where the path is badly approximated           subdivision.CRITERIA; back to 3
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import ArrayLike
from threadpoolctl import threadpool_limits

from .array import Array
from .curve.arcs import straightened
from .curve.frame import Frame, Timeline
from .curve.quadrature import Quadrature
from .curve.spline import Path, path_of
from .curve.unknowns import raw_timeline
from .figure.figure import Figure
from .objective import Evaluation, Objective
from .penalty import Guide, Penalty
from .refine.subdivision import CRITERIA, midpoints, split
from .refine.windows import Assembly, is_long, windows
from .search.astray import FAR, farthest, is_astray, is_dear, is_violent
from .search.descent import NEWTON, Descent
from .search.judgement import best
from .search.newton import FIRST_DAMPING
from .search.optimiser import Stop

NEGLIGIBLE = 1e-3
ROUGH = 1e-2
SHARE_OF_PROMISE = 0.1
FEW, MORE = 2, 3
MOST_FRAMES = 12
OF_CONTACTS = frozenset({"skate", "grounded", "planted", "resting", "hold", "flight", "support", "peak"})
OF_LIMBS = frozenset({"bend", "range"})
ALIKE = 1.1  # times the lower E of two searches: what is no higher lies in the same valley
TINY = 0.05  # of the spacing of frames beside it: a segment so short needs none, and with some E is hard to lower
SPACING = 0.3  # [s] between the frames to begin with in a long segment, so that it can follow what is beside it


@dataclass(frozen=True)
class Settings:
    """How the search goes.

    variable         variable frames in every segment between keyframes to begin with; None: 2, and 3 in a clip so long
                     that it is solved window by window, where more rounds would take too long
    frames           subdivision goes on up to so many variable frames in all; None: twelve a segment between keyframes
    criterion        which segments are split: "weak", "residual", "objective", "resolution"
    threshold        a segment is split if its criterion exceeds this; weak: share of the mean E between two keyframes;
                     the other criteria have units of their own
    batch            share of the segments that are split in one round, at most
    method           "newton" (Gauss-Newton steps), or one of NLopt's by name
    max_evaluations  budget of evaluations in each round
    tolerance        relative progress at which the last round ends
    renormalise      divide each term by its integral over the raw spline (eq. 7)
    """

    variable: int | None = None
    frames: int | None = None
    criterion: str = "weak"
    threshold: float = 1e-3
    batch: float = 1.0
    method: str = NEWTON
    max_evaluations: int = 250
    tolerance: float = 1e-5
    renormalise: bool = True
    quadrature: Quadrature = field(default_factory=Quadrature)

    def __post_init__(self) -> None:
        if self.criterion not in CRITERIA:
            raise ValueError(f"no subdivision criterion '{self.criterion}'; there are: {', '.join(CRITERIA)}")
        if (self.variable or 0) < 0 or (self.frames is not None and self.frames < 0):
            raise ValueError("settings: variable and frames must not be negative")
        if self.max_evaluations < 1 or not self.tolerance > 0 or not self.batch > 0 or self.threshold < 0:
            raise ValueError("settings: max_evaluations, tolerance and batch must be positive, threshold not negative")

    def beginning(self, segments: int, *, in_windows: bool) -> int:
        """Variable frames to begin with in every one of so many segments between keyframes."""
        if self.variable is not None:
            return self.variable
        return max(FEW, min(MORE, (self.frames or MORE * segments) // segments)) if in_windows else FEW


@dataclass(frozen=True)
class Improvement:
    """An evaluation that lowered E: its number in all, the round, E, its parts by term, and a way to its timeline."""

    evaluation: int
    round: int
    value: float
    parts: dict[str, float]
    build: Callable[[], Timeline]

    @cached_property
    def path(self) -> Path:
        """The curve as it stands."""
        return path_of(self.build())


@dataclass(frozen=True)
class Motion:
    """What came out: the best timeline and its path, the raw one to compare with, and how it went.

    trace  (evaluation, round, E, parts) of every evaluation that lowered E
    """

    figure: Figure
    objective: Objective
    timeline: Timeline
    raw: Timeline
    trace: tuple[tuple[int, int, float, dict[str, float]], ...]
    evaluations: int
    stop: Stop

    @property
    def path(self) -> Path:
        return path_of(self.timeline)

    @property
    def is_raw(self) -> bool:
        """Whether nothing was searched and it is the raw spline, as a recording is."""
        pairs = [(line.times, line.states, line.end_slope) for line in (self.raw, self.timeline)]
        return self.evaluations == 0 and all(map(np.array_equal, *pairs))

    def at(self, t: ArrayLike) -> Array:
        """MuJoCo configurations at times t (S,) [s] of the clip: (S, nq), quaternions unit."""
        first, last = self.path.span
        if np.any(np.asarray(t) < first - 1e-9) or np.any(np.asarray(t) > last + 1e-9):
            raise ValueError(f"the motion runs from {first:g} to {last:g} s; there is nothing to see outside")
        return self.figure.to_qpos(self.path.at(np.atleast_1d(np.asarray(t, float))))


def inbetween(
    figure: Figure,
    keys: Sequence[Frame],
    penalties: Sequence[tuple[Penalty, float]],
    settings: Settings | None = None,
    *,
    ends: str = "free",
    end_slope: Array | None = None,
    travel: ArrayLike | None = None,
    turn: float | None = None,
    improved: Callable[[Improvement], None] | None = None,
) -> Motion:
    """Smooth motion through keyframes that keeps to soft constraints.

    keys       keyframes holding *qpos* (nq,) and the mask of what is fixed, at least two, in order of time
    penalties  soft constraints with their weights α
    ends       "free", "clamped" (with end_slope (2, N), in the figure's coordinates) or "periodic"
    travel     (3,) [m] how far the root of a loop comes in one period; None: as far in x and y as the keyframes say
    turn       [rad] by how much the root of a loop is turned by then; None: as the keyframes say
    improved   gets every evaluation that lowers E; raise optimiser.StopSearch in it to stop and keep the best path

    The keyframes are met exactly whenever the search is stopped. Raises TimelineError for frames that make no clip.
    """
    raw = raw_timeline(figure, list(keys), ends, end_slope, travel, turn)
    with threadpool_limits(1, user_api="blas"):  # on matrices as small as these, threads only wait for each other
        return _searched(raw, len(keys) - 1, figure, penalties, settings or Settings(), improved)


def _searched(
    raw: Timeline,
    segments: int,
    figure: Figure,
    penalties: Sequence[tuple[Penalty, float]],
    settings: Settings,
    improved: Callable[[Improvement], None] | None,
) -> Motion:
    """The best path found through the keyframes of the raw timeline."""
    objective = objective_of(raw, figure, penalties, settings)
    in_windows = settings.quadrature.kind == "gauss" and is_long(raw)
    first = split(raw, beginning(raw, settings, in_windows=in_windows))
    guide = _guide(objective)
    if guide is not None and first.variable_count and not in_windows:
        led = guide.led(first, settings.frames if settings.variable is None else first.variable_count)
        first = min(first, led, key=lambda timeline: objective.value(path_of(timeline)))
    loop = _Loop(objective, settings, improved)
    try:
        found = loop.run_windows(raw, first) if in_windows else loop.searched(first, segments, settings.frames)
        timeline = best(objective, [found, raw])
    except KeyboardInterrupt:
        timeline, loop.stop = loop.best() if loop.best is not None else raw, Stop.ASKED
    return Motion(figure, objective, timeline, raw, tuple(loop.trace), loop.evaluations, loop.stop)


def objective_of(
    raw: Timeline, figure: Figure, penalties: Sequence[tuple[Penalty, float]], settings: Settings
) -> Objective:
    """E as a search of these settings minimises it, from the raw timeline through the keyframes."""
    objective = Objective.of(figure, penalties, quadrature=settings.quadrature)
    return renormalised(objective, raw) if settings.renormalise else objective


def beginning(raw: Timeline, settings: Settings, *, in_windows: bool) -> Array:
    """(V,) [s] of the variable frames to begin with: so many in every segment, more in one that is long and none in
    one that is tiny beside its neighbours, unless the settings say how many."""
    spans = np.diff(raw.times)
    count = np.full(spans.size, settings.beginning(spans.size, in_windows=in_windows))
    if settings.variable is None:
        longer = np.maximum(count, np.ceil(spans / SPACING).astype(int) - 1)
        if settings.frames is None or longer.sum() <= settings.frames:
            count = longer
        spacing = np.pad(spans / (count + 1), 1)
        count[spans < TINY * np.maximum(spacing[:-2], spacing[2:])] = 0
    return np.concatenate(
        [a + h * np.arange(1, n + 1) / (n + 1) for a, h, n in zip(raw.times[:-1], spans, count, strict=True)]
    )


def renormalised(objective: Objective, raw: Timeline) -> Objective:
    """Every term divided by its integral over the raw path, or the path that one of them knows to begin with."""
    guide = _guide(objective)
    return objective.renormalised(path_of(raw), None if guide is None else path_of(guide.led(raw, None)))


def _guide(objective: Objective) -> Guide | None:
    """The soft constraint that knows a path to begin with, if one does."""
    guides = (term.penalty for term in objective.terms if isinstance(term.penalty, Guide) and term.weight > 0)
    return next(guides, None)


@dataclass(frozen=True, eq=False)
class _End:
    """How a round ended: its timeline, why it stopped, the last damping of its steps."""

    timeline: Timeline
    stop: Stop
    damping: float


class _Loop:
    """Rounds of descent and subdivision, with the best timeline kept."""

    def __init__(self, objective: Objective, settings: Settings, improved: Callable | None) -> None:
        self.objective, self.settings, self.improved = objective, settings, improved
        self.trace: list[tuple[int, int, float, dict[str, float]]] = []
        self.evaluations, self.round = 0, 0
        self.best: Callable[[], Timeline] | None = None
        self.stop = Stop.CONVERGED
        self.damping = FIRST_DAMPING
        self.elsewhere = np.zeros(len(objective.terms))
        self.since = -np.inf
        self.whole: Callable[[Timeline], Timeline] = lambda timeline: timeline
        self.last: dict[str, float] = {}

    def searched(self, timeline: Timeline, segments: int, budget: int | None) -> Timeline:
        """The best timeline found from where one begins, and if that ended in a heap from the straight way between
        keyframes; the other way round where the beginning itself is far off.

        If those two end in a heap, or in different valleys, from where either comes to without the terms that such a
        limb is trapped by: first what feet and hands that touch something do, then bends. One that came out well but
        dear is searched once more, from where it comes to without bends. One evaluation sees what is there and looks
        for nothing.
        """
        ends: list[_End] = []
        values: list[float] = []
        waiting = self._starts(timeline)
        while waiting:
            if ends:
                self.round += 1
                self.damping = FIRST_DAMPING
            ends += self.run(waiting.pop(0)(), segments, budget)
            values.append(sum(self.last.values()))
            if self.stop is Stop.ASKED:
                break
            if self._is_settled(ends[-1].timeline, values):
                is_last_word = len(values) > 1 or not is_dear(self.objective, self.last)
                waiting = [] if is_last_word else waiting[-1:]
        found = best(self.objective, [end.timeline for end in reversed(ends)])
        end = next(end for end in reversed(ends) if end.timeline is found)
        self.stop, self.damping = Stop.ASKED if self.stop is Stop.ASKED else end.stop, end.damping
        return found

    def _starts(self, timeline: Timeline) -> list[Callable[[], Timeline]]:
        """Where searches begin, one after the other: two, and two more."""
        figure = self.objective.figure
        starts: list[Callable[[], Timeline]] = [lambda: timeline, lambda: straightened(figure, timeline)]
        if self.settings.max_evaluations == 1:
            return starts[:1]
        if farthest(figure, timeline) > FAR:
            starts.reverse()
        return [
            *starts,
            lambda: self.loosened(straightened(figure, timeline), OF_CONTACTS),
            lambda: self.loosened(timeline, OF_LIMBS),
        ]

    def _is_settled(self, timeline: Timeline, values: Sequence[float]) -> bool:
        """Whether the last search, of those that ended at these E, needs no other beside it."""
        if not is_astray(self.objective, timeline, self.last):
            return True
        same_valley = max(values) <= ALIKE * min(values)
        return len(values) == 2 and same_valley and not is_violent(self.objective, self.last)

    def run(self, timeline: Timeline, segments: int, budget: int | None) -> list[_End]:
        """Rounds until no segment deserves another frame, or their budget is spent; how each of them ended.

        A round that another may follow ends when the next step promises little beside what more frames do.
        """
        ends: list[_End] = []
        tolerance = self.settings.tolerance
        budget = MOST_FRAMES * segments if budget is None else budget
        rough = max(ROUGH, tolerance)
        while True:
            is_last = timeline.variable_count >= budget
            timeline = self.descend(timeline, tolerance if is_last else rough)
            ends.append(_End(timeline, self.stop, self.damping))
            if self.stop is Stop.ASKED or is_last:
                return ends
            chosen, promise = self.chosen(timeline, budget - timeline.variable_count)
            if not chosen.size and rough <= tolerance:
                return ends
            rough = float(np.clip(SHARE_OF_PROMISE * promise, tolerance, rough)) if chosen.size else tolerance
            timeline = split(timeline, chosen)
            self.round += bool(chosen.size)

    def loosened(self, timeline: Timeline, without: frozenset[str]) -> Timeline:
        """Where a rough search comes to without some terms."""
        terms = tuple(term for term in self.objective.terms if term.penalty.name not in without)
        descent = Descent(replace(self.objective, terms=terms), timeline)
        found = descent.run(max_evaluations=self.settings.max_evaluations, tolerance=ROUGH)
        self.evaluations += found.evaluations
        return timeline.with_rows(descent.problem.unknowns.rows(found.x))

    def run_windows(self, raw: Timeline, first: Timeline) -> Timeline:
        """The rounds of every window of a long clip, one window after the other."""
        segments = len(raw.frames) - 1
        assembly = Assembly(self.objective, raw, first)
        for window in windows(segments):
            self.whole = assembly.around(window)
            self.elsewhere = assembly.elsewhere(window)
            self.since = float(raw.times[window.first])
            self.damping = FIRST_DAMPING
            count, budget = window.last - window.first, self.settings.frames
            opened = assembly.opened(window)
            solved = self.searched(opened, count, None if budget is None else assembly.room(window, budget))
            assembly.close(window, solved)
            if self.stop is Stop.ASKED:
                break
            self.round += 1
        return assembly.timeline()

    def descend(self, timeline: Timeline, tolerance: float) -> Timeline:
        descent = Descent(self.objective, timeline, damping=self.damping)
        before, elsewhere = self.evaluations, float(self.elsewhere.sum())

        def report(count: int, evaluation: Evaluation, x: Array) -> None:
            self.evaluations, self.last = before + count, evaluation.parts
            value = elsewhere + evaluation.value
            # a new round sums E over other samples: its first evaluations need not lie below the last round's
            if self.trace and value >= self.trace[-1][2]:
                return
            self.best = partial(_built, self.whole, timeline, descent, x)
            parts = dict(evaluation.parts)
            for term, more in zip(self.objective.terms, self.elsewhere, strict=True):
                parts[term.penalty.name] += float(more)
            self.trace.append((before + count, self.round, value, parts))
            if self.improved is not None:
                self.improved(Improvement(before + count, self.round, value, parts, self.best))

        found = descent.run(
            method=self.settings.method,
            max_evaluations=self.settings.max_evaluations,
            tolerance=tolerance,
            improved=report,
        )
        self.damping = descent.damping
        self.evaluations = before + found.evaluations
        self.stop = found.stop
        return timeline.with_rows(descent.problem.unknowns.rows(found.x))

    def chosen(self, timeline: Timeline, room: int) -> tuple[Array, float]:
        """The middles of the segments to split next, the most needy ones, and the share of E that they promise."""
        scores = CRITERIA[self.settings.criterion](self.objective, timeline)
        threshold, present = self.settings.threshold, 0.0
        if self.settings.criterion == "weak" and self.trace:
            present = max(self.trace[-1][2] - float(self.elsewhere.sum()), NEGLIGIBLE * self.trace[0][2])
            threshold *= present / max(sum(not frame.is_variable for frame in timeline.frames) - 1, 1)
        most = min(room, max(1, round(self.settings.batch * scores.size)))
        middles = midpoints(timeline)
        scores = np.where(middles > self.since, scores, -np.inf)  # what a window holds is not split
        order = np.argsort(scores)[::-1][:most]
        order = order[scores[order] > threshold]
        promise = float(scores[order].sum()) / present if present > 0 else 0.0
        return np.sort(middles[order]), promise


def _built(whole: Callable[[Timeline], Timeline], timeline: Timeline, descent: Descent, x: Array) -> Timeline:
    """The whole clip with a descent on one of its timelines at x."""
    return whole(timeline.with_rows(descent.problem.unknowns.rows(x)))
