"""The objective E(Y) = Σ_j α_j ∫ f_j dt (eq. 1), its renormalisation (eq. 7), and its gradient.

Equation 7 divides f_j(t) by its value on the raw spline, the spline through the keyframes alone. This value is zero at
every keyframe. Here f_j is divided by its integral over the raw spline instead. These divisors are computed once and do
not change with subdivision.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .array import IN_CACHE, Array, segments_at
from .curve.frame import Timeline
from .curve.quadrature import Quadrature, gauss_nodes
from .curve.spline import Path, Piece, Sampling, spline_of
from .curve.unknowns import Unknowns
from .figure.adjoint import Cotangent
from .figure.dynamics import Size
from .figure.figure import Figure
from .figure.kinematics import Samples
from .penalty import Block, Dense, Penalty, Role
from .penalty.block import sum_of_blocks

# see `tension`: LONG [s] time between keyframes from which tension rises; exponent of the rise; upper limit of tension
LONG, TENSION_POWER, MAX_TENSION = 0.25, 4.0, 8.0
FROM_REST = 0.3  # [1] share of the first or the last segment over which tension rises from an end at rest
SMALL_SHARE = 0.01  # [1] share of the clip's length in the smallest divisor of a term, see `renormalise`
# [1] see `_typical`: percentile of segment means, cap in multiples of that percentile, smallest share of an integral
MOST_OF_TIME, VIOLENT, LEAST_TYPICAL = 0.8, 4.0, 0.1
HEAVY = 10.0  # [1] multiple of the raw spline's cost; above this multiple, gross violations dominate E
HIDDEN = 0.003  # [m] depth between samples that is ignored, of an adult
RUN = 400  # [1] smallest number of samples in a run


@dataclass(frozen=True)
class Term:
    """One soft constraint f_j of the objective.

    Attributes:
        weight: Its weight α_j [1].
        factor: The multiplier of f_j in the objective: α_j, or α_j / ∫ f_j,raw after renormalisation.
    """

    penalty: Penalty
    weight: float
    factor: float


@dataclass(frozen=True)
class Objective:
    """E as a functional of paths.

    Attributes:
        terms: The soft constraints, with their weights and factors.
        heavy: Cap on the value of E that relative tolerances refer to. A path with gross violations has a large E,
            which would make tolerances loose.
        key_times: Times of the keyframes, (K,) [s], from which tension is computed. If None, the tension is 1
            everywhere.
        at_rest: Whether the figure is at rest at the first and at the last keyframe, as end conditions.
    """

    figure: Figure
    terms: tuple[Term, ...]
    quadrature: Quadrature = field(default_factory=Quadrature)
    heavy: float = np.inf
    key_times: Array | None = None
    at_rest: tuple[bool, bool] = (False, False)

    @classmethod
    def of(
        cls,
        figure: Figure,
        penalties: Sequence[tuple[Penalty, float]],
        *,
        quadrature: Quadrature | None = None,
    ) -> Objective:
        """Return the objective (eq. 1) of pairs of penalty and weight, without renormalisation.

        Raises:
            ValueError: A weight is negative or not finite.
        """
        for penalty, weight in penalties:
            if not (np.isfinite(weight) and weight >= 0):
                raise ValueError(f"the weight of '{penalty.name}' is {weight}; it must be a number, at least 0")
        terms = tuple(Term(penalty, float(weight), float(weight)) for penalty, weight in penalties)
        return cls(figure, terms, quadrature or Quadrature())

    def renormalise(self, raw: Path, initial_guess: Path | None = None) -> Objective:
        """Return the objective with every term divided by its integral over the raw path (eq. 7).

        The divisor of a term is limited to an interval:

        - Lower limit, for terms that are nearly zero on the raw path: `Normalization.reference`, the penalty's value at
          a violation of 1 cm or 1°, integrated over 1 % of the clip.
        - Upper limit, for terms that measure violations: the same value integrated over the whole clip. A raw path deep
          in the floor therefore does not make the floor soft.
        - Upper limit, for all other terms: `Normalization.raw_cap` times the length of the clip.

        Segments with exceptionally large costs contribute only in part, see `_typical`. The divisor of
        a term with `normalize_by` is its reference value times the divisor of the term named there.

        Args:
            initial_guess: A path near the optimum, if one is available. Terms other than violations are divided by the
                larger of their integrals over the two paths.
        """
        integrals = self._typical(raw, self.integrals(raw))
        if initial_guess is not None:
            costs = np.array([not term.penalty.role.is_violation for term in self.terms])
            guessed = self._typical(initial_guess, self.integrals(initial_guess))
            integrals = np.where(costs, np.maximum(integrals, guessed), integrals)
        (first, last), size = raw.span, Size.of(self.figure)
        spacing = (last - first) / (raw.spline.times.size - 1)
        terms = []
        for term, integral in zip(self.terms, integrals, strict=True):
            scale = term.penalty.normalization
            whole = scale.reference * size.length**scale.length_power * (last - first) / spacing**scale.time_power
            most = whole if term.penalty.role.is_violation else scale.raw_cap * (last - first)
            terms.append(replace(term, factor=term.weight / min(max(float(integral), SMALL_SHARE * whole), most)))
        measures = {term.penalty.name: term for term in terms if term.weight > 0}
        for i, term in enumerate(terms):
            scale = term.penalty.normalization
            if scale.normalize_by in measures:
                other = measures[scale.normalize_by]
                slowed = size.time ** (other.penalty.normalization.time_power - scale.time_power)
                reference = scale.reference * size.length**scale.length_power * slowed
                terms[i] = replace(term, factor=term.weight * other.factor / other.weight / reference)
        return replace(self, terms=tuple(terms), heavy=HEAVY * self.raw_cost or np.inf)

    @property
    def raw_cost(self) -> float:
        """The cost of the raw spline without violations [1]: the sum of the weights α_j of `raw_normalized`."""
        return sum(term.weight for term in self.raw_normalized)

    @property
    def raw_normalized(self) -> tuple[Term, ...]:
        """The terms whose divisor is their integral over the raw spline; terms that measure violations are excluded."""
        return tuple(
            t for t in self.terms if not t.penalty.role.is_violation and not t.penalty.normalization.normalize_by
        )

    def _typical(self, raw: Path, integrals: Array) -> Array:
        """Return the integrals of the terms over the raw path, with outlying segments capped, (terms,). Violations are
        not changed. For any other term, the mean over each segment between knots is capped at four times the 80th
        percentile of all segment means, weighted by time. The result is at least a tenth of the integral."""
        times = np.asarray(raw.spline.times)
        costs = [i for i, term in enumerate(self.terms) if not term.penalty.role.is_violation]
        plain = tuple(replace(self.terms[i], factor=1.0) for i in costs)
        if not plain:
            return integrals
        shares = segment_integrals(replace(self, terms=plain), raw, times)
        typical, spans = integrals.copy(), np.diff(times)
        for i, share in zip(costs, shares.T, strict=True):
            order = np.argsort(share / spans)
            middle = order[np.searchsorted(np.cumsum(spans[order]), MOST_OF_TIME * spans.sum())]
            capped = np.minimum(share, VIOLENT * share[middle] / spans[middle] * spans)
            if share.sum() > 0:
                typical[i] *= max(float(capped.sum() / share.sum()), LEAST_TYPICAL)
        return typical

    def tension(self, t: Array) -> Array:
        """Return the dimensionless tension (S,) at times t (S,) [s].

        The tension is 1 where neighbouring keyframes are at most LONG apart. Beyond LONG, it rises with the fourth
        power of the time between them, up to MAX_TENSION. Keyframes that are far apart determine the acceleration
        between them poorly. Acceleration terms are divided by the tension there, so that joints do not overshoot, see
        `Normalization.by_tension`. Next to an end at rest, tension rises gradually, so that the figure does not start
        or stop with a jerk.
        """
        if self.key_times is None:
            return np.ones(t.size)
        segment = segments_at(self.key_times, t)
        gaps = np.diff(self.key_times)
        tension = ((gaps / (LONG * Size.of(self.figure).time)) ** TENSION_POWER).clip(1.0, MAX_TENSION)[segment]
        for at_rest, end, first in zip(self.at_rest, (0, -1), (0, gaps.size - 1), strict=True):
            if at_rest:
                share = np.abs(t - self.key_times[end]) / (FROM_REST * gaps[end])
                tension = np.where(segment == first, 1 + (tension - 1) * share.clip(0, 1), tension)
        return tension

    def factor(self, term: Term, t: Array) -> Array:
        """Return `term.factor` times the power of tension in its normalization, at times t (S,) [s]; (S,)."""
        return term.factor * self._tension_share(term, t)

    def _tension_share(self, term: Term, t: Array) -> Array:
        """Return the power of tension that multiplies f_j of a term at times t (S,) [s], (S,)."""
        power = term.penalty.normalization.by_tension
        return self.tension(t) ** power if power else np.ones(t.size)

    def nodes(self, times: Array) -> tuple[Array, Array, Array]:
        """Return the quadrature nodes of a spline with knots at `times` [s].

        Returns:
            The times in ascending order, (S,) [s]; the weights of an integral, (S,) [s]; and the weights of each term,
            including tension, (terms, S) [s].
        """
        t, w = self.quadrature.nodes(times)
        return t, w, np.array([w * self._tension_share(term, t) for term in self.terms]).reshape(-1, t.size)

    def integrals(self, path: Path, times: Array | None = None) -> Array:
        """Return ∫ f_j dt of every term without weight or factor, (terms,).

        Args:
            times: The edges of the integration spans [s]; None: the knots of the path.
        """
        t, _, w = self.nodes(path.spline.times if times is None else times)
        out = np.zeros(len(self.terms))
        for piece in Sampling.of(path.spline, t).pieces(run_of(self.figure)):
            samples = Samples(self.figure, *piece.samples(path.coefficients), t=piece.t)
            out += [v[piece.which] @ term.penalty.evaluate(samples) for v, term in zip(w, self.terms, strict=True)]
        return out

    def samples(self, path: Path, t: Array) -> Samples:
        """Return the figure's motion at times t (S,) [s] along a path."""
        return Samples(self.figure, *path.motion(t), t=t)

    def value(self, path: Path, times: Array | None = None) -> float:
        """Return E of a path, integrated over the spans between `times` [s]; None: between its knots."""
        return float(sum(term.factor * v for term, v in zip(self.terms, self.integrals(path, times), strict=True)))

    def watching(self, path: Path) -> Objective:
        """Return E with terms that evaluate, of all pairs of limbs, those that touch on a path or did so on others."""
        lazy = [type(term.penalty).watching is not Penalty.watching for term in self.terms]
        if not any(lazy):
            return self
        edges = self.quadrature.panels(path.spline.times)
        t = np.sort(np.append(edges, 0.5 * (edges[1:] + edges[:-1])))
        parts = self.samples(path, t).parts(run_of(self.figure))
        penalties = [term.penalty.watching(parts) for term in self.terms]
        if all(penalty is term.penalty for penalty, term in zip(penalties, self.terms, strict=True)):
            return self
        terms = (replace(term, penalty=penalty) for penalty, term in zip(penalties, self.terms, strict=True))
        return replace(self, terms=tuple(terms))

    def finer(self, path: Path) -> Objective:
        """Return E with more samples where they miss a collision of a path, or this one if they miss none.

        A search tends to move a short collision, such as that of a toe and the edge of a step, between two samples.
        Panels in which the samples see less than half of a depth above HIDDEN are therefore cut into quarters.
        """
        obstacles = [term.penalty for term in self.terms if term.penalty.role in (Role.COLLISION, Role.OBSTACLE)]
        if self.quadrature.kind != "gauss" or not obstacles:
            return self
        edges = self.quadrature.panels(path.spline.times)
        length = np.diff(edges)

        def depths(edges: Array) -> Array:
            t, _ = gauss_nodes(edges, self.quadrature.points)
            parts = self.samples(path, t).parts(run_of(self.figure))
            squares = np.concatenate([sum(penalty.evaluate(part) for penalty in obstacles) for part in parts])
            return np.sqrt(squares.reshape(length.size, -1).max(axis=1))

        depth = depths(np.sort(np.append(edges, edges[:-1] + length / 2)))
        deep = depth > HIDDEN * Size.of(self.figure).length
        if not deep.any():
            return self
        missed = np.flatnonzero(deep & (depth > 2 * depths(edges)))
        cuts = edges[missed, None] + length[missed, None] * [0.25, 0.5, 0.75]
        return self.cut_at(cuts.ravel().tolist())

    def cut_at(self, times: Iterable[float]) -> Objective:
        """Return E with panels of the quadrature cut at more times [s], or this one if there are none."""
        more = [time for time in times if time not in self.quadrature.cuts]
        quadrature = replace(self.quadrature, cuts=(*self.quadrature.cuts, *more))
        return replace(self, quadrature=quadrature) if more else self

    def density(self, samples: Samples) -> Array:
        """Return the integrand Σ_j factor_j f_j at every sample, (S,)."""
        values, first = np.zeros(samples.count), 0
        for part in samples.parts(run_of(self.figure)):
            for term in self.terms:
                values[first : first + part.count] += self.factor(term, part.t) * term.penalty.evaluate(part)
            first += part.count
        return values

    def sample_gradients(self, samples: Samples) -> tuple[Array, Array, Array]:
        """Return g₀ = ∂f/∂y, g₁ = ∂f/∂y', g₂ = ∂f/∂y'' of f = Σ_j factor_j f_j, each (S, N)."""
        parts = []
        for part in samples.parts(run_of(self.figure)):
            cotangent = Cotangent(part)
            for term in self.terms:
                term.penalty.evaluate(part, cotangent, self.factor(term, part.t))
            parts.append(cotangent.gradients())
        g0, g1, g2 = parts[0] if len(parts) == 1 else (np.concatenate(gs) for gs in zip(*parts, strict=True))
        return g0, g1, g2

    def on(self, timeline: Timeline) -> Discretised:
        """Return E as a function of the timeline's unknowns."""
        return Discretised(self, timeline)


def segment_integrals(objective: Objective, path: Path, times: Array) -> Array:
    """Return every term's contribution to E between neighbouring times [s], (segments, terms)."""
    knots = np.asarray(path.spline.times)
    knots = knots[(knots >= times[0]) & (knots <= times[-1])]
    edges = np.union1d(knots, times)
    t, w = gauss_nodes(edges)
    out = np.zeros((times.size - 1, len(objective.terms)))
    segment = segments_at(times, t)
    for piece in Sampling.of(path.spline, t).pieces(run_of(objective.figure)):
        samples, run = Samples(objective.figure, *piece.samples(path.coefficients), t=piece.t), piece.which
        for k, term in enumerate(objective.terms):
            weights = objective.factor(term, t[run]) * w[run]
            np.add.at(out[:, k], segment[run], weights * term.penalty.evaluate(samples))
    return out


def run_of(figure: Figure) -> int:
    """Return the number of samples in a run, small enough for its arrays to fit in the processor's cache."""
    return max(RUN, 4 * IN_CACHE // figure.width)


@dataclass(frozen=True, eq=False)
class EvaluatedRun:
    """The evaluated samples of one run.

    Attributes:
        samples: The figure's motion at the samples.
        blocks: The residual blocks of every term.
    """

    piece: Piece
    samples: Samples
    blocks: Sequence[Sequence[Block | Dense]]


@dataclass(frozen=True)
class Evaluation:
    """E at one x.

    Attributes:
        value: E.
        gradient: dE/dx, (n,).
        parts: The contribution of every term to E, by the name of its penalty.
    """

    value: float
    gradient: Array
    parts: dict[str, float]


class Discretised:
    """E as a function of the unknowns x of one timeline: its keyframes and variable frames.

    The spline's linear system is factorised, and the samples and the layout of x are prepared, once on construction.
    Samples are evaluated in runs: batches of consecutive samples that fit in the processor's cache, see `run_of`.

    Attributes:
        objective: The objective E.
        timeline: The timeline whose unknowns are x.
        unknowns: The map between x (n,) and the states of the frames, one row per frame, (M, N).
        weights: The weights of the samples in an integral, (S,) [s].
    """

    def __init__(self, objective: Objective, timeline: Timeline) -> None:
        self.objective = objective
        self.timeline = timeline
        self.spline = spline_of(timeline)
        self.unknowns = Unknowns.of(objective.figure, timeline)
        t, self.weights, weights_by_term = objective.nodes(self.spline.times)
        self.sampling = Sampling.of(self.spline, t)
        self._pieces = self.sampling.pieces(run_of(objective.figure))
        factors = np.array([[term.factor] for term in objective.terms])
        self._last: tuple[Array, Sequence[EvaluatedRun]] | None = None
        self._shares = [factors * weights_by_term[:, piece.which] for piece in self._pieces]

    def path(self, x: Array) -> Path:
        """Return the path of unknowns x (n,)."""
        return Path(self.spline, self.unknowns.rows(x))

    def __call__(self, x: Array) -> Evaluation:
        """Return E and dE/dx at x (n,)."""
        coefficients = self.sampling.coefficients(self.unknowns.rows(x))
        gradient = np.zeros(coefficients.shape)
        parts: dict[str, float] = {}
        runs: list[EvaluatedRun] = []
        for piece, shares in zip(self._pieces, self._shares, strict=True):
            samples = self._samples(coefficients, piece)
            cotangent, blocks_by_term = Cotangent(samples), list[Sequence[Block | Dense]]()
            for term, share in zip(self.objective.terms, shares, strict=True):
                blocks = tuple(term.penalty.residuals(samples))
                part = float(share @ sum_of_blocks(blocks, samples, cotangent, share))
                parts[term.penalty.name] = parts.get(term.penalty.name, 0.0) + part
                blocks_by_term.append(blocks)
            piece.add_pulled_back(gradient, cotangent.gradients())
            runs.append(EvaluatedRun(piece, samples, blocks_by_term))
        self._last = (x, runs)
        rows = self.sampling.coefficients_transposed(gradient)
        return Evaluation(sum(parts.values()), self.unknowns.pulled_back(rows), parts)

    def evaluated_runs(self, x: Array) -> Sequence[EvaluatedRun]:
        """Return the evaluated samples at x (n,), one `EvaluatedRun` per run.

        If x is the array object of the last evaluation, its samples are reused.
        """
        if self._last is None or self._last[0] is not x:
            coefficients = self.sampling.coefficients(self.unknowns.rows(x))
            return [self._evaluated_run(coefficients, piece) for piece in self._pieces]
        return self._last[1]

    def _samples(self, coefficients: Array, piece: Piece) -> Samples:
        return Samples(self.objective.figure, *piece.samples(coefficients), t=piece.t)

    def _evaluated_run(self, coefficients: Array, piece: Piece) -> EvaluatedRun:
        samples = self._samples(coefficients, piece)
        return EvaluatedRun(piece, samples, [tuple(term.penalty.residuals(samples)) for term in self.objective.terms])
