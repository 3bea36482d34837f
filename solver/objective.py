"""The objective E(Y) = Σ_j α_j ∫ f_j dt (eq. 1), renormalised by the raw spline's integrals (eq. 7), and its gradient.

Equation 7 read pointwise divides by zero at every keyframe; here each term is divided by its own integral over the raw
spline, once, and the factors stay through all rounds of subdivision.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .array import Array
from .curve.frame import Timeline
from .curve.quadrature import Quadrature, gauss_nodes
from .curve.spline import Path, Piece, Sampling, spline_of
from .curve.unknowns import Unknowns
from .figure.adjoint import Cotangent
from .figure.figure import Figure
from .figure.kinematics import Samples
from .penalty import Block, Dense, Penalty
from .penalty.block import summed
from .penalty.penalty import instants_of

LONG, TENSION_POWER, MAX_TENSION = 0.25, 4.0, 8.0  # [s] between keyframes, beyond which tension rises, see `tension`
SMALL_SHARE = 0.01  # of the clip: a violation of 1 cm over so much of it is the unit of a term that is nearly nought
# share of the clip, times its mean there, least share: see _typical
MOST_OF_TIME, VIOLENT, LEAST_TYPICAL = 0.8, 4.0, 0.1
HEAVY = 10.0  # relative to the cost of the raw spline: E above it is dominated by gross violations
NODES = 4  # per span, of integrals by segments
RUN = 400
RUN_ENTRIES = 8000  # samples times columns at once, whose arrays stay in cache


@dataclass(frozen=True)
class Term:
    """One soft constraint with its weight α_j, and the factor α_j / ∫ f_j,raw that multiplies f_j."""

    penalty: Penalty
    weight: float
    factor: float


@dataclass(frozen=True)
class Objective:
    """E as a functional of paths.

    Attributes:
        figure: The figure.
        terms: The soft constraints with their weights and factors.
        quadrature: The quadrature rule of the integral.
        heavy: The upper limit of E in relative tolerances, so that gross violations do not make the search inexact.
        key_times: The times of the keyframes between which tension acts, (K,) [s]; None: it is 1 everywhere.
    """

    figure: Figure
    terms: tuple[Term, ...]
    quadrature: Quadrature = field(default_factory=Quadrature)
    heavy: float = np.inf
    key_times: Array | None = None

    @classmethod
    def of(
        cls,
        figure: Figure,
        penalties: Sequence[tuple[Penalty, float]],
        *,
        quadrature: Quadrature | None = None,
    ) -> Objective:
        """Return the objective of penalties with their weights, not renormalised (eq. 1).

        Raises:
            ValueError: A weight is negative or not finite.
        """
        for penalty, weight in penalties:
            if not (np.isfinite(weight) and weight >= 0):
                raise ValueError(f"the weight of '{penalty.name}' is {weight}; it must be a number, at least 0")
        terms = tuple(Term(penalty, float(weight), float(weight)) for penalty, weight in penalties)
        return cls(figure, terms, quadrature or Quadrature())

    def renormalised(self, raw: Path, initial_guess: Path | None = None) -> Objective:
        """Eq. 7: every term divided by its integral over the raw path.

        initial_guess  a path near the optimum, where one is known: a term that costs more on it than on the raw path,
             and is no violation, is divided by its integral there

        A term that is (nearly) zero there is divided by its value for a violation of 1 cm (1°) over 1 % of the clip;
        and a violation by no more than that of 1 cm (1°) over the whole clip, for a raw path that is deep in the floor
        must not make the floor soft. Nor must one jerk make all of the clip soft: segments that are violent beside the
        others count as less, see `_typical`.
        """
        integrals = self._typical(raw, self.integrals(raw))
        if initial_guess is not None:
            costs = np.array([not term.penalty.normalization.is_violation for term in self.terms])
            guessed = self._typical(initial_guess, self.integrals(initial_guess))
            integrals = np.where(costs, np.maximum(integrals, guessed), integrals)
        first, last = raw.span
        spacing = (last - first) / (raw.spline.times.size - 1)
        terms = []
        for term, integral in zip(self.terms, integrals, strict=True):
            scale, instants = term.penalty.normalization, instants_of(term.penalty)
            length = instants.size or last - first
            whole = scale.reference * length / spacing**scale.time_power
            most = whole if scale.is_violation else scale.raw_cap * length
            terms.append(replace(term, factor=term.weight / min(max(float(integral), SMALL_SHARE * whole), most)))
        measures = {term.penalty.name: term.factor / term.weight for term in terms if term.weight > 0}
        for i, term in enumerate(terms):
            normalize_by = term.penalty.normalization.normalize_by
            if normalize_by in measures:
                terms[i] = replace(
                    term, factor=term.weight * measures[normalize_by] / term.penalty.normalization.reference
                )
        return replace(self, terms=tuple(terms), heavy=HEAVY * self.raw_cost or np.inf)

    @property
    def raw_cost(self) -> float:
        """The cost of motion on the raw spline: the sum of weights of the terms divided by their own integral there."""
        return sum(term.weight for term in self.measured)

    @property
    def measured(self) -> tuple[Term, ...]:
        """The terms that are divided by their own integrals over the raw spline."""
        return tuple(
            t
            for t in self.terms
            if not t.penalty.normalization.is_violation and not t.penalty.normalization.normalize_by
        )

    def _typical(self, raw: Path, integrals: Array) -> Array:
        """Integrals (terms,) over the raw path with what its violent segments have too much taken off.

        A term's mean over a segment counts up to four times what it stays below in four fifths of the time; but a
        tenth of the integral is left at least.
        """
        times = np.asarray(raw.spline.times)
        costs = [i for i, term in enumerate(self.terms) if not term.penalty.normalization.is_violation]
        plain = tuple(replace(self.terms[i], factor=1.0) for i in costs)
        if times.size < 3 or not plain:
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
        """Return how much keyframes around times t (S,) [s] are farther apart than those that specify motion, (S,).

        It is 1 up to LONG, and rises from there with the fourth power of the time between the keyframes. Few keyframes
        specify little about accelerations: their cost fades, so that a joint does not swing far out between them, see
        `Normalization.by_tension`.
        """
        if self.key_times is None:
            return np.ones(t.size)
        segment = np.searchsorted(self.key_times, t, side="right").clip(1, self.key_times.size - 1) - 1
        gaps = np.diff(self.key_times)[segment]
        return ((gaps / LONG) ** TENSION_POWER).clip(1.0, MAX_TENSION)

    def factor(self, term: Term, t: Array) -> Array:
        """Return what multiplies f_j of a term at times t (S,) [s], (S,)."""
        power = term.penalty.normalization.by_tension
        return term.factor * (self.tension(t) ** power if power else np.ones(t.size))

    def nodes(self, times: Array) -> tuple[Array, Array, Array]:
        """For a spline with knots at `times`: sample times (S,) [s], rising, their weights in an integral (S,) and in
        every term (terms, S): the instants of momentary terms are samples too, which count there and nowhere else."""
        t, w = self.quadrature.nodes(times)
        instants_by_term = [instants_of(term.penalty) for term in self.terms]
        instants = np.unique(np.concatenate([*instants_by_term, np.zeros(0)]))
        instants = instants[(instants >= times[0]) & (instants <= times[-1])]
        t, w = np.append(t, instants), np.append(w, 0 * instants)
        order = np.argsort(t, kind="stable")
        is_instant = np.append(np.zeros(w.size - instants.size, bool), np.ones(instants.size, bool))[order]
        t, w = t[order], w[order]
        tension = self.tension(t)
        powers = [term.penalty.normalization.by_tension for term in self.terms]
        weights_by_term = np.array([w * tension**power for power in powers]).reshape(len(self.terms), w.size)
        for k, term_instants in enumerate(instants_by_term):
            if term_instants.size:
                weights_by_term[k] = np.isin(t, term_instants) & is_instant
        return t, w, weights_by_term

    def integrals(self, path: Path, times: Array | None = None) -> Array:
        """Return ∫ f_j dt of every term, Σ f_j of momentary ones, without weight or factor, (terms,).

        Args:
            path: The path.
            times: The edges of the spans to sum over [s]; None: the path's own frames.
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
        """Return E of a path, summed over the spans between `times` [s], or between its own frames."""
        return float(sum(term.factor * v for term, v in zip(self.terms, self.integrals(path, times), strict=True)))

    def density(self, samples: Samples) -> Array:
        """Return Σ_j factor_j f_j at every sample, (S,)."""
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
    """Return every term's contribution to E between neighbouring times, (segments, terms).

    An instant at an edge belongs to the following segment, at the end to the last one.
    """
    knots = np.asarray(path.spline.times)
    knots = knots[(knots >= times[0]) & (knots <= times[-1])]
    edges = np.union1d(knots, times)
    t, w = gauss_nodes(edges, NODES)
    out = np.zeros((times.size - 1, len(objective.terms)))
    segment = np.clip(np.searchsorted(times, t, side="right") - 1, 0, times.size - 2)
    for piece in Sampling.of(path.spline, t).pieces(run_of(objective.figure)):
        samples, run = Samples(objective.figure, *piece.samples(path.coefficients), t=piece.t), piece.which
        for k, term in enumerate(objective.terms):
            weights = objective.factor(term, t[run]) * w[run]
            np.add.at(out[:, k], segment[run], weights * term.penalty.evaluate(samples))
    for k, term in enumerate(objective.terms):
        at = instants_of(term.penalty)
        at = at[(at >= times[0]) & ((at < times[-1]) | (at == path.spline.times[-1]))]
        if at.size:
            segment = np.clip(np.searchsorted(times, at, side="right") - 1, 0, times.size - 2)
            np.add.at(out[:, k], segment, term.factor * term.penalty.evaluate(objective.samples(path, at)))
    return out


def run_of(figure: Figure) -> int:
    """Return the number of samples evaluated at once, so few that their arrays fit in the cache."""
    return max(RUN, RUN_ENTRIES // figure.width)


@dataclass(frozen=True, eq=False)
class Seen:
    """A run of evaluated samples with every term's residuals there; None for a term without residual blocks."""

    piece: Piece
    samples: Samples
    blocks: Sequence[Sequence[Block | Dense] | None]


@dataclass(frozen=True)
class Evaluation:
    """E at one x: its value, its gradient (n,), and the contributions of terms by name."""

    value: float
    gradient: Array
    parts: dict[str, float]


class Discretised:
    """E(x) for one timeline, with the spline factorised and the samples and unknowns prepared once.

    The samples are evaluated in runs (see `run_of`) whose arrays fit in the processor's cache, so that a sample of a
    long clip costs no more than one of a short clip.

    Attributes:
        weights: The weights of the samples in an integral, (S,).
        instants: The momentary terms, each with the sampling of its own times.
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
        self.instants = [
            (term, Sampling.of(self.spline, t[weight > 0]))
            for term, weight in zip(objective.terms, weights_by_term, strict=True)
            if instants_of(term.penalty).size and weight.any()
        ]
        self._last: tuple[Array, Sequence[Seen]] | None = None
        self._shares = [factors * weights_by_term[:, piece.which] for piece in self._pieces]

    def path(self, x: Array) -> Path:
        """Return the path for unknowns x (n,)."""
        return Path(self.spline, self.unknowns.rows(x))

    def __call__(self, x: Array) -> Evaluation:
        """Return E and dE/dx at x (n,)."""
        coefficients = self.sampling.coefficients(self.unknowns.rows(x))
        gradient = np.zeros(coefficients.shape)
        parts: dict[str, float] = {}
        self._last = (x, [self._seen(coefficients, piece) for piece in self._pieces])
        for evaluated, shares in zip(self._last[1], self._shares, strict=True):
            cotangent = Cotangent(evaluated.samples)
            for term, share, blocks in zip(self.objective.terms, shares, evaluated.blocks, strict=True):
                part = float(share @ _valued(term, evaluated.samples, blocks, cotangent, share))
                parts[term.penalty.name] = parts.get(term.penalty.name, 0.0) + part
            evaluated.piece.add_pulled_back(gradient, cotangent.gradients())
        rows = self.sampling.coefficients_transposed(gradient)
        return Evaluation(sum(parts.values()), self.unknowns.pulled_back(rows), parts)

    def seen(self, x: Array) -> Sequence[Seen]:
        """Return the evaluated samples at x (n,), from the last evaluation if it was at the same x."""
        if self._last is None or self._last[0] is not x:
            coefficients = self.sampling.coefficients(self.unknowns.rows(x))
            return [self._seen(coefficients, piece) for piece in self._pieces]
        return self._last[1]

    def _seen(self, coefficients: Array, piece: Piece) -> Seen:
        samples = Samples(self.objective.figure, *piece.samples(coefficients), t=piece.t)
        return Seen(piece, samples, [term.penalty.blocks(samples) for term in self.objective.terms])


def _valued(
    term: Term, samples: Samples, blocks: Sequence[Block | Dense] | None, into: Cotangent, share: Array
) -> Array:
    """Return f of a term at every sample, (S,), and add the gradient of Σ share f to `into`."""
    if blocks is None:
        return term.penalty.evaluate(samples, into, share)
    return summed(blocks, samples, into, share)
