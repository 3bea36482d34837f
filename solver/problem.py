"""The in-betweening problem: keyframes of a figure, soft constraints with their weights, settings of the search."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .array import Array
from .curve.frame import Frame, Timeline
from .curve.quadrature import Quadrature
from .curve.spline import path_of
from .curve.unknowns import raw_timeline
from .figure.figure import Figure
from .objective import Objective
from .penalty import Guide, Penalty, Posture, Role
from .refine.subdivision import CRITERIA
from .search.minimum import Optimiser
from .search.refinement import LBFGS

FEW, MORE = 2, 3  # initial variable frames per segment: of a clip solved at once, and of one solved in windows
TINY = 0.05  # of the spacing of adjacent frames: a shorter segment gets none, since with some E is hard to lower
SPACING = 0.3  # [s] between the frames to begin with in a long segment, so that it can follow adjacent segments
# defaults: share of the mean E from which a segment is split; evaluations in a round, relative progress in it
THRESHOLD, MOST_EVALUATIONS, TOLERANCE = 1e-3, 250, 1e-5


@dataclass(frozen=True)
class Settings:
    """Settings of the search.

    variable         variable frames in every segment between keyframes to begin with; None: 2, and 3 in a clip so long
                     that it is solved window by window, where more rounds would take too long
    frames           limit of subdivision: the total number of variable frames; None: twelve a segment between keyframes
    criterion        which segments are split: "weak", "residual", "objective", "resolution"
    threshold        a segment is split if its criterion exceeds this; weak: share of the mean E between two keyframes;
                     the other criteria have units of their own
    batch            share of the segments that are split in one round, at most
    optimiser        NLopt's algorithm for the last stage, by name; "none": Gauss-Newton steps alone; or a function for
                     all of the search
    max_evaluations  budget of evaluations in each round
    tolerance        relative progress at which the last round ends
    renormalise      divide each term by its integral over the raw spline (eq. 7)
    """

    variable: int | None = None
    frames: int | None = None
    criterion: str = "weak"
    threshold: float = THRESHOLD
    batch: float = 1.0
    optimiser: str | Optimiser = LBFGS
    max_evaluations: int = MOST_EVALUATIONS
    tolerance: float = TOLERANCE
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
        """(V,) [s] of the variable frames to begin with between keyframes at times (K,) [s]: so many in every segment,
        more in long ones and none in one that is tiny next to its neighbours, unless `variable` sets the number."""
        spans = np.diff(times)
        count = np.full(spans.size, self.in_each(spans.size, in_windows=in_windows))
        if self.variable is None:
            longer = np.maximum(count, np.ceil(spans / SPACING).astype(int) - 1)
            if self.frames is None or longer.sum() <= self.frames:
                count = longer
            spacing = np.pad(spans / (count + 1), 1)
            count[spans < TINY * np.maximum(spacing[:-2], spacing[2:])] = 0
        return np.concatenate(
            [a + h * np.arange(1, n + 1) / (n + 1) for a, h, n in zip(times[:-1], spans, count, strict=True)]
        )

    def in_each(self, segments: int, *, in_windows: bool) -> int:
        """Variable frames to begin with in every one of so many segments between keyframes."""
        if self.variable is not None:
            return self.variable
        if not in_windows:
            return FEW
        return MORE if self.frames is None else max(FEW, min(MORE, self.frames // segments))


@dataclass(frozen=True, eq=False)
class Problem:
    """Keyframes of a figure, to be in-betweened by a path that keeps soft constraints small.

    keys       keyframes holding *qpos* (nq,) and the mask of what is fixed, at least two, in order of time
    penalties  soft constraints with their weights α
    ends       "free", "clamped", "clamped start", "clamped end" (with end_slope (2, N), in the figure's coordinates) or
               "periodic"
    travel     (3,) [m] displacement of a loop's root per period; None: that of the keyframes in x and y
    turn       [rad] by how much the root of a loop is turned by then; None: as in the keyframes
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
        """The timeline of the spline through the keyframes alone. Raises TimelineError for frames that make no clip."""
        return raw_timeline(self.figure, list(self.keys), self.ends, self.end_slope, self.travel, self.turn)

    @cached_property
    def plain_objective(self) -> Objective:
        """E without renormalisation (eq. 1)."""
        return Objective.of(self.figure, self.penalties, quadrature=self.settings.quadrature)

    @cached_property
    def objective(self) -> Objective:
        """E as the search minimises it with these settings (eq. 7)."""
        return renormalised(self.plain_objective, self.raw) if self.settings.renormalise else self.plain_objective


def renormalised(objective: Objective, raw: Timeline) -> Objective:
    """Return E with every term divided by its integral over the raw path, or over the initial path of a term.

    With the soft constraint of posture, tension acts between the keyframes.
    """
    guide = guide_of(objective)
    out = objective.renormalised(path_of(raw), None if guide is None else path_of(guide.initial_guess(raw, None)))
    is_tense = any(isinstance(term.penalty, Posture) and term.weight > 0 for term in objective.terms)
    return replace(out, key_times=raw.times) if is_tense else out


@dataclass(frozen=True)
class Guides:
    """Several soft constraints that provide an initial path, applied in sequence."""

    parts: tuple[Guide, ...]

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """See `Guide.initial_guess`."""
        for guide in self.parts:
            timeline = guide.initial_guess(timeline, most)
        return timeline


def guide_of(objective: Objective) -> Guide | Guides | None:
    """Return the soft constraints that provide an initial path, limits last; None without any."""
    guides = [term.penalty for term in objective.terms if isinstance(term.penalty, Guide) and term.weight > 0]
    guides.sort(key=lambda guide: guide.role is Role.LIMIT)
    return Guides(tuple(guides)) if len(guides) > 1 else next(iter(guides), None)
