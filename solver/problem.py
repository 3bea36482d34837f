"""The in-betweening problem: keyframes of a figure, soft constraints, settings of the search; and its solution.

"The paper" is R. Ramamoorthi, C. Ball, A. H. Barr, Dynamic Splines with Constraints for Animation, also in all other
modules of this package. Equations, figures and sections without a source are those of the paper.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .array import Array
from .curve.frame import Frame, Timeline
from .curve.quadrature import Quadrature
from .curve.raw import raw_timeline
from .curve.spline import Path, path_of
from .figure.figure import Figure
from .objective import Objective
from .penalty import Guide, Penalty, Posture, Role
from .refine.subdivision import CRITERIA, FEW, MORE
from .search.minimum import Optimiser, Stop
from .search.nlopt_methods import LBFGS
from .tolerances import ROUNDING

SHORT = 0.05  # [1] longest segment without a variable frame, relative to the frame spacing of adjacent segments
SPACING = 0.3  # [s] maximum initial spacing of frames


@dataclass(frozen=True)
class Settings:
    """Settings of the search.

    Attributes:
        variable: The initial number of variable frames (frames with no fixed entries, which the search moves) in every
            segment between keyframes. None: it depends on the length of the segment, see `beginning`.
        frames: The maximum number of variable frames in total. None: 12 times the number of segments between keyframes.
            Clip files have a smaller default, see the reference of `[solve]`.
        criterion: The criterion by which intervals between neighbouring frames are split, see `refine.subdivision`:
            "weak" (predicted decrease of the objective E) or "residual" (of the Euler-Lagrange equation, as in the
            paper).
        threshold: An interval is split if its criterion exceeds this value. "weak" is relative to E divided by the
            number of segments between keyframes.
        batch: The maximum share of the segments that are split in one round.
        optimiser: The name of the NLopt algorithm that refines the result of the Gauss-Newton steps; "none": no
            refinement. An `Optimiser` replaces the whole search.
        max_evaluations: The maximum number of evaluations of E in one round, after an insertion of frames.
        tolerance: The last round ends when a step is predicted to reduce E by a smaller share than this.
        renormalise: Whether each term is divided by its integral over the raw spline (eq. 7).
        quadrature: The quadrature rule of E.

    Raises:
        ValueError: A setting is invalid.
    """

    variable: int | None = None
    frames: int | None = None
    criterion: str = "weak"
    threshold: float = 1e-3
    batch: float = 1.0
    optimiser: str | Optimiser = LBFGS
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

    def beginning(self, times: Array, *, in_windows: bool) -> Array:
        """Return the times of the initial variable frames, (V,) [s].

        If `variable` is None, a segment has 2 frames, or 3 in a long clip that is solved window by window. More are
        added where frames would be more than 0.3 s apart. Segments much shorter than their neighbours have none.

        Args:
            times: The times of the keyframes, (K,) [s].
        """
        spans = np.diff(times)
        count = np.full(spans.size, self.in_each(spans.size, in_windows=in_windows))
        if self.variable is None:
            longer = np.maximum(count, np.ceil(spans / SPACING).astype(int) - 1)
            if self.frames is None or longer.sum() <= self.frames:
                count = longer
            spacing = np.pad(spans / (count + 1), 1)
            count[spans < SHORT * np.maximum(spacing[:-2], spacing[2:])] = 0
        return np.concatenate(
            [a + h * np.arange(1, n + 1) / (n + 1) for a, h, n in zip(times[:-1], spans, count, strict=True)]
        )

    def in_each(self, segments: int, *, in_windows: bool) -> int:
        """Return the initial number of variable frames in each of `segments` segments between keyframes."""
        if self.variable is not None:
            return self.variable
        if not in_windows:
            return FEW
        return MORE if self.frames is None else max(FEW, min(MORE, self.frames // segments))


@dataclass(frozen=True, eq=False)
class Problem:
    """Keyframes of a figure, and the soft constraints on the motion between them.

    Attributes:
        figure: The figure.
        keys: At least two keyframes in order of time. Their states are configurations qpos (nq,), with masks of the
            fixed entries.
        penalties: The soft constraints f with their weights α.
        settings: The settings of the search.
        ends: The end conditions: "free", "clamped", "clamped start", "clamped end" or "periodic".
        end_slope: The time derivatives y' of the N entries of the state at the start and the end, (2, N) [1/s times
            their units]. Rows of ends that are not clamped have no effect. None: zero.
        travel: The displacement of a loop's root per period, (3,) [m]. None: that from the first to the last keyframe
            in x and y, and zero in z.
        turn: The rotation of a loop's root about the vertical axis per period [rad]. None: that from the first to the
            last keyframe.
    """

    figure: Figure
    keys: Sequence[Frame]
    penalties: Sequence[tuple[Penalty, float]]
    settings: Settings = field(default_factory=Settings)
    ends: str = "free"
    end_slope: Array | None = None
    travel: ArrayLike | None = None
    turn: float | None = None

    @cached_property
    def raw(self) -> Timeline:
        """The timeline of the spline through the keyframes alone. Raises TimelineError if the keyframes are invalid."""
        slope = np.zeros((2, self.figure.width)) if self.end_slope is None else self.end_slope
        return raw_timeline(self.figure, list(self.keys), self.ends, slope, self.travel, self.turn)

    @cached_property
    def plain_objective(self) -> Objective:
        """E without renormalisation (eq. 1)."""
        return Objective.of(self.figure, self.penalties, quadrature=self.settings.quadrature)

    @cached_property
    def objective(self) -> Objective:
        """The objective E, renormalised (eq. 7 of the paper) unless `Settings.renormalise` is False."""
        return renormalise(self.plain_objective, self.raw) if self.settings.renormalise else self.plain_objective


def renormalise(objective: Objective, raw: Timeline) -> Objective:
    """Return E with every term divided by its integral over the raw spline (eq. 7), see `Objective.renormalise`.

    If a penalty provides an initial guess, divisors of terms other than violations are at least their integrals over
    the initial guess. If there is a `Posture` penalty, weights depend on the time between keyframes, see
    `Objective.tension`.
    """
    guess = initial_guess(objective, raw, None)
    out = objective.renormalise(path_of(raw), None if guess is None else path_of(guess))
    if not any(isinstance(term.penalty, Posture) and term.weight > 0 for term in objective.terms):
        return out
    return replace(out, key_times=raw.times, at_rest=raw.at_rest)


def initial_guess(objective: Objective, timeline: Timeline, most: int | None) -> Timeline | None:
    """Return the timeline after all soft constraints that provide an initial guess have changed it in turn, limits of
    joints last, with at most `most` variable frames; None if there are none."""
    guides = [term.penalty for term in objective.terms if isinstance(term.penalty, Guide) and term.weight > 0]
    for guide in sorted(guides, key=lambda guide: guide.role is Role.LIMIT):
        timeline = guide.initial_guess(timeline, most)
    return timeline if guides else None


@dataclass(frozen=True)
class Improvement:
    """An evaluation that lowered E, or the first one after E got more samples, which may raise it.

    Attributes:
        evaluation: The number of evaluations so far.
        round: The index of the round.
        value: E.
        parts: The contributions of terms, by name.
        build: Returns the timeline of this evaluation.
    """

    evaluation: int
    round: int
    value: float
    parts: dict[str, float]
    build: Callable[[], Timeline]

    @cached_property
    def path(self) -> Path:
        """The path of the timeline."""
        return path_of(self.build())


@dataclass(frozen=True, repr=False)
class Solution:
    """The result of in-betweening.

    Attributes:
        figure: The figure.
        objective: The objective E that the search minimised.
        timeline: The frames of the solution, including variable frames.
        raw: The timeline of the spline through the keyframes alone.
        trace: (evaluation, round, E, parts) of every improvement. E may rise where a round begins.
        evaluations: The number of evaluations.
        stop: Why the search ended.
    """

    figure: Figure
    objective: Objective
    timeline: Timeline
    raw: Timeline
    trace: tuple[tuple[int, int, float, dict[str, float]], ...] = ()
    evaluations: int = 0
    stop: Stop = Stop.CONVERGED

    def __repr__(self) -> str:
        first, last = self.path.span
        return f"<Solution: {first:g} to {last:g} s, {self.evaluations} evaluations, {self.stop.name.lower()}>"

    @property
    def path(self) -> Path:
        """The spline through all frames."""
        return path_of(self.timeline)

    def at(self, t: ArrayLike) -> Array:
        """Return MuJoCo configurations at given times.

        Args:
            t: One time, or (S,) times [s].

        Returns:
            qpos (S, nq), with unit quaternions.

        Raises:
            ValueError: A time is outside the motion.
        """
        first, last = self.path.span
        if np.any(np.asarray(t) < first - ROUNDING) or np.any(np.asarray(t) > last + ROUNDING):
            raise ValueError(f"the motion runs from {first:g} to {last:g} s; give times within")
        return self.figure.to_qpos(self.path.at(np.atleast_1d(np.asarray(t, float))))
