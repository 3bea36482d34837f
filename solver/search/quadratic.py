"""The model that a step of the search minimises: E to second order, with one-sided residuals kept one-sided.

    m(δ) = gᵀδ + ½ δᵀ(H + λF)δ + Σ_p c_p max(0, d_p + r_pᵀδ)²

δ moves the B-splines' coefficients: a sample sees 4 of them, so all matrices are banded and cost and memory are linear
in the length of the clip. H is the Gauss-Newton curvature, F the flat acceleration energy that damps the step, d_p how
far a point is in the floor (below zero: over it). What is fixed, keyframes and a loop's seam, is held by springs, stiff
beside everything else; they shape the step, the keyframes themselves are no unknowns and stay exact.

H of smooth terms is summed over a few nodes a span; that of terms that begin, end or peak anywhere over E's own
samples, or it would promise what E does not keep.

m is convex and piecewise quadratic: Newton steps on the residuals that count at present, with a line search, end at
its minimum after a few factorisations (semismooth Newton; M. Hintermüller, K. Ito & K. Kunisch, SIAM J. Optim. 2002).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise, product
from typing import Any, NamedTuple

import numpy as np

from .. import compiled
from ..array import Array, Index, Mask
from ..curve import banded
from ..curve.quadrature import gauss_nodes
from ..curve.seam import Seam
from ..curve.spline import DEGREE, Path, Piece, Sampling, Spline
from ..figure.kinematics import Samples
from ..objective import Discretised, Seen, Term
from ..penalty.curvature import Curvature
from ..penalty.one_sided import OneSided

POINTS = 2  # a span: smooth terms' curvature is no E
SPANS_AT_ONCE, SPAN_ENTRIES = 32, 2000  # least, and by columns: their blocks stay in cache
STIFF = 1e6  # times the median curvature: what is held moves by a millionth
FAINT = 1e-9  # of the median curvature, so that Cholesky's factor exists
SHARE_OF_POSITION = 0.3  # of the flat metric, beside acceleration
MOST_CHANGES = 15  # of which one-sided residuals count
SETTLED = 0.05  # of the model's decrease: a change that gains less is the last
ENTRIES_AT_ONCE = 2_000_000  # of rows over four coefficients, 16 MB
LOCAL = DEGREE + 1  # B-splines that a sample sees
LEAST = 1e-12  # median of a curvature, where that is nought
SHORTEST = 1e-3  # of a step to the minimum of one piece: one that must be shorter yet leads nowhere

Picked = Index | slice


class Layout:
    """Where everything stands in the banded matrices of one timeline: coefficients (M + 2) by columns (N).

    A loop's coefficients are taken alternately from both ends, so that its seam is in the band too.

    sided  indices of the terms that have one-sided residuals, as far as is known
    """

    def __init__(self, problem: Discretised) -> None:
        self.problem = problem
        spline, unknowns = problem.spline, problem.unknowns
        self.count, self.width = spline.size, problem.timeline.width
        self.is_loop = spline.ends == "periodic"
        order = np.arange(self.count)
        if self.is_loop:
            order = np.ravel(np.column_stack([order, order[::-1]]))[: self.count]
        self.rank = np.empty(self.count, np.intp)
        self.rank[order] = np.arange(self.count)
        self.order = order
        self.blocks = min(2 * LOCAL if self.is_loop else LOCAL, self.count)
        self.place = unknowns.place
        t, self.weights = gauss_nodes(np.asarray(spline.times), POINTS)
        sampling = Sampling.of(spline, t)
        at_once = max(SPANS_AT_ONCE, SPAN_ENTRIES // self.width)
        edges = [*range(0, spline.times.size - 1, at_once), spline.times.size - 1]
        self.pieces = [
            (sampling.piece(slice(POINTS * a, POINTS * b)), self._pairs(a, b - a)) for a, b in pairwise(edges)
        ]
        self.sided = list(range(len(problem.objective.terms)))
        self.flat = self._flat(sampling.values)

    @cached_property
    def springs(self) -> Array:
        """The springs' matrix on what is fixed, of about unit size."""
        return self._springs()

    def springs_by_column(self) -> Array:
        """(M + 2, K + 1, N): the springs that hold entries of single columns, those of ties and seams left out."""
        free = np.zeros((self.count, self.width))
        free.reshape(-1)[self.place] = 1.0
        room = np.zeros((self.count, self.blocks + 1, self.width))
        first, weights = self.problem.spline.rows_by_coefficients()
        column, apart, values = self._column_springs(first, weights, 1 - free)
        np.add.at(room, (column, apart), values)
        return room

    def empty(self) -> Array:
        """Room for a matrix's blocks: (M + 2, N, K + 1, N), [j, c, k, r] its entry at row (j + k, r), column (j, c)."""
        return np.zeros((self.count, self.width, self.blocks + 1, self.width))

    def diagonal(self, room: Array) -> Array:
        """(M + 2, K + 1, N): the entries of a matrix's blocks that join a column with itself, to be added to."""
        return np.einsum("jckc->jkc", room)

    def _pairs(self, first: int, count: int) -> list[Pair]:
        """Where the B-splines of spans first ... first + count − 1 stand by pairs in the lower half."""
        if not self.is_loop:
            return [
                Pair(slice(None), b, slice(b, LOCAL), slice(first + b, first + b + count), slice(0, LOCAL - b))
                for b in range(LOCAL)
            ]
        found, spans = [], np.arange(first, first + count)
        for a, b in np.ndindex(LOCAL, LOCAL):
            row, column = self.rank[spans + a][:, None], self.rank[spans + b][:, None]
            some = np.flatnonzero(row >= column)
            found.append(Pair(some, b, slice(a, a + 1), column[some], (row - column)[some]))
        return found

    def add_blocks(self, room: Array, curvature: Curvature, piece: Piece, pairs: list[Pair]) -> None:
        """Adds what a curvature has as blocks; its samples are the nodes of neighbouring spans."""
        if compiled.kernel is not None:
            for columns, squares in curvature.squares():
                compiled.call("add_blocks", room, self.rank, piece.first, piece.values, columns, squares, self.width)
            return
        for columns, blocks in curvature.blocks(piece.values, POINTS):
            local = blocks.transpose(0, 2, 4, 1, 3, 5)
            for part, seen in _seen_blocks(room, columns, local):
                for spot in pairs:
                    seen[spot.j, spot.k] += part[spot.spans, spot.b, spot.a]

    def add_rows(self, room: Array, *parts: tuple[Curvature, Piece]) -> None:
        """Adds what curvatures, each at any samples, have as rows."""
        by_kernel, found = compiled.kernel is not None, []
        for curvature, piece in parts:
            if by_kernel:
                for at, rows in curvature.rows_by_y():
                    self.add_rows_by_y(room, piece, at, rows)
            others = curvature.rows(piece.values, without_y=by_kernel)
            found += [(piece.first[at], rows) for at, rows in others]
        if not found:
            return
        spans = np.concatenate([own for own, _ in found])
        order = np.argsort(spans, kind="stable")
        place, rows, begin = np.empty_like(order), np.empty((order.size, LOCAL * self.width)), 0
        place[order] = np.arange(order.size)
        for own, part in found:
            rows[place[begin : begin + own.size]] = part
            begin += own.size
        self.add_squared(room, spans[order], rows)

    def add_squared(self, room: Array, spans: Index, rows: Array) -> None:
        """Adds Σ rowᵀrow of rows (P, 4 N) over the coefficients of their spans (P,), rising."""
        edges = np.flatnonzero(np.diff(spans)) + 1
        for first, last in zip(np.append(0, edges), np.append(edges, spans.size), strict=True):
            if first < last:
                self.add_square(room, int(spans[first]), rows[first:last])

    def add_rows_by_y(self, room: Array, seen: Piece | Sampling, at: Index, rows: Array, sign: float = 1.0) -> None:
        """Adds Σ rowᵀrow of rows (P, N) by y at samples (P,), rising, or takes it off."""
        bases = seen.values[:, 0]
        if compiled.kernel is not None:
            compiled.call("add_squares", room, self.rank, seen.first, bases, at, rows, np.full(at.size, sign))
            return
        spans, width = seen.first[at], LOCAL * self.width
        few = max(1, ENTRIES_AT_ONCE // width)  # over four coefficients all take four times the memory
        edges = [0, *(np.flatnonzero(np.diff(spans)) + 1).tolist(), at.size]
        for begin, end in pairwise(edges):
            for first in range(begin, end, few):
                run = slice(first, min(first + few, end))
                wide = (bases[at[run], :, None] * rows[run, None, :]).reshape(-1, width)
                self.add_square(room, int(spans[begin]), wide, sign)

    def add_square(self, room: Array, span: int, rows: Array, sign: float = 1.0) -> None:
        """Adds Σ rowᵀrow of rows (P, 4 N) over the coefficients of one span, or takes it off."""
        width, upper = self.width, banded.squared(rows, sign)
        if self.is_loop:
            self._add_folded(room, span, upper + np.triu(upper, 1).T)
            return
        for b in range(LOCAL):
            slab = upper[b * width : (b + 1) * width, b * width :]
            room[span + b, :, : LOCAL - b] += slab.reshape(width, LOCAL - b, width)

    def _add_folded(self, room: Array, span: int, local: Array) -> None:
        """Adds a symmetric matrix (4 N, 4 N) over the coefficients of one span of a loop."""
        blocks = local.reshape(LOCAL, self.width, LOCAL, self.width)
        for a in range(LOCAL):
            for b in range(LOCAL):
                row, column = self.rank[span + a], self.rank[span + b]
                if row >= column:
                    room[column, :, row - column] += blocks[b, :, a]

    def factor(self, room: Array) -> Array | None:
        """The banded Cholesky factor of a matrix's blocks, or None if it is not positive."""
        size = self.blocks * self.width
        flat = room.reshape(self.count, self.width, -1)
        strides = (flat.strides[0], flat.strides[1] + flat.strides[2], flat.strides[2])
        band = np.lib.stride_tricks.as_strided(flat, (self.count, self.width, size), strides)
        return banded.factored(np.array(band).reshape(-1, size))

    def solved(self, factor: Array, right: Array) -> Array:
        """H⁻¹ v for v (M + 2, N)."""
        solution = banded.solved(factor, right[self.order].reshape(-1, 1))
        return solution.reshape(self.count, self.width)[self.rank]

    def coloured(self, factor: Array, z: Array) -> Array:
        """L⁻ᵀ z (M + 2, N) for z flat, in the matrices' order."""
        return banded.other_half_solved(factor, z.reshape(-1, 1)).reshape(self.count, self.width)[self.rank]

    def whitened(self, factor: Array, gradient: Array) -> Array:
        """L⁻¹ v, flat, in the matrices' order, for v (M + 2, N)."""
        return banded.half_solved(factor, gradient[self.order].reshape(-1, 1)).ravel()

    def to_x(self, coefficients: Array) -> Array:
        """The step in the unknowns (n,) that a step of the coefficients (M + 2, N) means."""
        return self.problem.spline.states_and_slopes(coefficients).reshape(-1)[self.place]

    def from_x(self, gradient: Array) -> Array:
        """A gradient with respect to the unknowns (n,) as one with respect to coefficients, (M + 2, N)."""
        rows = np.zeros(self.count * self.width)
        rows[self.place] = gradient
        return self.problem.spline.states_and_slopes_transposed(rows.reshape(self.count, self.width))

    def _springs(self) -> Array:
        spline, unknowns = self.problem.spline, self.problem.unknowns
        room = self.empty()
        free = np.zeros((self.count, self.width))
        free.reshape(-1)[self.place] = 1.0
        first, weights = spline.rows_by_coefficients()
        held = np.asarray(free.min(axis=1) == 0)
        if self.is_loop:
            held[-3:] = False
            for order in range(3):
                self._tie_seam(room, spline, order)
        if spline.ends == "held":
            held[[1, -4]] = False
            self._hold_curvature(room, spline)
        if unknowns.ties is not None:
            tied = held & np.diff(unknowns.ties.indptr).reshape(free.shape).any(axis=1)
            for i in np.flatnonzero(tied):
                own: Any = unknowns.matrix[i * self.width : (i + 1) * self.width]  # SciPy does not say what a slice is
                moves = own[:, np.unique(own.indices)].toarray()
                each = np.tile(weights[i][:, None], self.width)
                self._hold(room, first[i] + np.arange(DEGREE), each, np.eye(self.width) - moves @ np.linalg.pinv(moves))
            held &= ~tied
        self._hold_columns(room, first[held], weights[held], 1 - free[held])
        return room

    def _hold_columns(self, room: Array, first: Index, weights: Array, hold: Array) -> None:
        """For each of some rows, springs on the columns of hold (R, N) of the sum of 3 coefficients, weights (R, 3)."""
        column, apart, values = self._column_springs(first, weights, hold)
        index = np.arange(self.width)
        place = (column[:, None], index, apart[:, None], index)
        flat = np.ravel_multi_index(np.broadcast_arrays(*place), room.shape)
        np.add.at(room.reshape(-1), flat.ravel(), values.ravel())

    def _column_springs(self, first: Index, weights: Array, hold: Array) -> tuple[Index, Index, Array]:
        """Of such springs: the matrix's columns (S,), how far below each (S,), and their entries (S, N)."""
        weights = weights / np.sqrt(np.sum(weights**2, axis=1, keepdims=True))
        rank = self.rank[first[:, None] + np.arange(DEGREE)]
        apart = rank[:, :, None] - rank[:, None, :]
        row, a, b = np.nonzero(apart >= 0)
        return rank[row, b], apart[row, a, b], (weights[row, a] * weights[row, b])[:, None] * hold[row]

    def _tie_seam(self, room: Array, spline: Spline, order: int) -> None:
        """y, y' or y'' of a step at the end equal to that at the start, as it comes back after a period.

        A loop's shift is constant: no step has any.
        """
        start, end = (spline.basis([t], order) for t in spline.times[[0, -1]])
        back, still = Seam.of(self.problem.objective.figure, self.problem.timeline).matrix(), np.eye(self.width)
        parts = [(j, -w * back) for j, w in zip(start.indices.tolist(), start.data.tolist(), strict=True)]
        parts += [(j, w * still) for j, w in zip(end.indices.tolist(), end.data.tolist(), strict=True)]
        size = float(start.data @ start.data + end.data @ end.data)
        for (ja, a), (jb, b) in product(parts, parts):
            row, column = self.rank[ja], self.rank[jb]
            if row >= column:
                room[column, :, row - column, :] += b.T @ a / size

    def _hold_curvature(self, room: Array, spline: Spline) -> None:
        """No step of y'' at either end."""
        for end in spline.times[[0, -1]]:
            seen = spline.basis([end], 2)
            weights = np.tile(np.asarray(seen.data, float)[:, None], self.width)
            self._hold(room, np.asarray(seen.indices, np.intp), weights, np.eye(self.width))

    def _hold(self, room: Array, coefficients: Index, weights: Array, hold: Array) -> None:
        """A spring on `hold` (N, N) of Σ_j weights_j * c_j, weights (k, N)."""
        weights = weights / np.sqrt(np.sum(weights**2) / self.width)
        for ja, wa in zip(coefficients, weights, strict=True):
            for jb, wb in zip(coefficients, weights, strict=True):
                row, column = self.rank[ja], self.rank[jb]
                if row >= column:
                    room[column, :, row - column, :] += wb[:, None] * hold * wa

    def _flat(self, bases: Array) -> Array:
        """(M + 2, K + 1): ∫ φ''φ''ᵀ + ε φφᵀ of the coefficients, for each column the same."""
        timeline = self.problem.timeline
        keys = max(len(timeline.frames) - timeline.variable_count, 2)
        spacing = (timeline.times[-1] - timeline.times[0]) / keys
        value, acceleration = bases[:, 0], bases[:, 2]
        density = acceleration[:, :, None] * acceleration[:, None, :]
        density += SHARE_OF_POSITION / spacing**4 * value[:, :, None] * value[:, None, :]
        local = (self.weights[:, None, None] * density).reshape(-1, POINTS, LOCAL, LOCAL).sum(axis=1)
        flat = np.zeros((self.count, self.blocks + 1))
        for spot in self._pairs(0, len(local)):
            flat[spot.j, spot.k] += local[spot.spans, spot.b, spot.a]
        return flat


class Pair(NamedTuple):
    """Where B-spline b of some spans stands with B-splines a in a matrix's blocks: at [j, k], shape (spans, a)."""

    spans: Picked
    b: int
    a: slice
    j: Picked
    k: Picked


def _seen_blocks(room: Array, columns: Index, blocks: Array) -> Iterator[tuple[Array, Array]]:
    """Where blocks (..., n, k, k) of the columns (n, k), which rise, stand in a matrix: parts of them with the entries
    (M + 2, K + 1, ...) to be added to. All at once if the columns are one run, else by pairs of runs."""
    if np.all(np.diff(columns.ravel()) == 1):
        some = slice(int(columns[0, 0]), int(columns[-1, -1]) + 1)
        seen = room[:, some, :, some]
        yield blocks, np.einsum("jnxkny->jknxy", seen.reshape(len(room), *columns.shape, room.shape[2], *columns.shape))
        return
    for i, own in enumerate(columns):
        edges = [0, *(np.flatnonzero(np.diff(own) != 1) + 1).tolist(), own.size]
        runs = [slice(a, b) for a, b in pairwise(edges)]
        for x, y in product(runs, runs):
            rows, cols = (slice(int(own[run.start]), int(own[run.stop - 1]) + 1) for run in (x, y))
            yield blocks[..., i, x, y], room[:, rows, :, cols].swapaxes(1, 2)


def middle(values: Array) -> float:
    """The median."""
    half = values.size // 2
    parted = values.flatten()
    parted.partition((half - 1, half))
    return float(parted[half] if values.size % 2 else (parted[half - 1] + parted[half]) / 2)


@dataclass(frozen=True, eq=False)
class OneSidedTerms:
    """The one-sided residuals of all terms: each adds weight max(0, value + row · δy)², δy the step at its sample.

    sides   of all terms, one after the other;  weight  (P,)
    """

    sides: OneSided
    weight: Array
    sampling: Sampling

    @classmethod
    def of(cls, layout: Layout, every: Sequence[Seen]) -> OneSidedTerms | None:
        problem, parts, sided = layout.problem, list[tuple[float, OneSided]](), set[int]()
        terms = problem.objective.terms
        for seen in every:
            for k in layout.sided:
                sides = terms[k].penalty.sides(seen.samples, seen.blocks[k])
                if sides is not None:
                    sided.add(k)
                    parts.append((terms[k].factor, sides.shifted(seen.piece.which.start)))
        layout.sided = sorted(sided)
        parts = [(factor, sides) for factor, sides in parts if sides.at.size]
        if not parts:
            return None
        sides, order = OneSided.joined([sides for _, sides in parts]).sorted()
        factor = np.concatenate([np.full(sides.at.size, factor) for factor, sides in parts])[order]
        return cls(sides, factor * problem.weights[sides.at], problem.sampling)

    @property
    def value(self) -> Array:
        """(P,)"""
        return self.sides.value

    def changed(self, step: Array) -> Array:
        """(P,): how the residuals change with a step (M + 2, N) of the coefficients."""
        moved = self.sampling.bases[0] @ step
        return np.concatenate([rows.moved(moved) for rows in self.sides.gradients])

    def pulled_back(self, forces: Array) -> Array:
        """(M + 2, N): the gradient of forces · residuals, forces (P,)."""
        count = self.sampling.t.size
        pulled = [rows.pulled_back(forces[run], count) for run, rows in self.sides.parts()]
        return self.sampling.bases[0].T @ np.add.reduce(pulled)

    def squares(self, some: Mask, factor: Array) -> tuple[Index, Array]:
        """Samples (A,), rising, and rows (A, N) by y with the Σ rowᵀrow of some (P,) residuals, each times a factor."""
        parts = []
        for run, rows in self.sides.parts():
            own = np.flatnonzero(some[run])
            if own.size:
                parts.append(rows.squared(own, factor[run][own]))
        at, rows = np.concatenate([at for at, _ in parts]), np.concatenate([rows for _, rows in parts])
        if np.any(at[1:] < at[:-1]):
            order = np.argsort(at, kind="stable")
            at, rows = at[order], rows[order]
        return at, rows


class Proposal(NamedTuple):
    """The minimum of m: the step (n,) of the unknowns to it, how far m falls, and Cholesky's factor of its curvature.

    The factor is None where the curvature has none.
    """

    step: Array
    promised: float
    factor: Array | None


class Model:
    """m(δ) at one path.

    scale  the size of E's curvature in y'', a unit for the damping λ
    """

    def __init__(self, layout: Layout, x: Array, gradient: Array, scale: float | None = None) -> None:
        """x (n,) with dE/dx (n,) there; scale where it is known."""
        self.layout = layout
        every = layout.problem.seen(x)
        self.held = layout.springs.copy()
        self.scale = self._add_smooth(layout.problem.path(x), every, scale)
        self.sided = OneSidedTerms.of(layout, every)
        self.gradient = layout.from_x(gradient)
        if self.sided is not None:
            pull = 2 * self.sided.weight * np.maximum(self.sided.value, 0)
            self.gradient -= self.sided.pulled_back(pull)

    def _add_smooth(self, path: Path, every: Sequence[Seen], scale: float | None) -> float:
        """Adds the curvature of the two-sided residuals; its median density in y'', unless it is known."""
        layout, problem = self.layout, self.layout.problem
        room, sizes, rows = layout.empty(), [], []
        terms = problem.objective.terms
        sharp = [k for k, term in enumerate(terms) if term.penalty.normalization.is_sharp]
        smooth = [term for k, term in enumerate(terms) if k not in sharp]

        def curved(piece: Piece, some: Sequence[Term], weights: Array) -> Curvature:
            samples = Samples(problem.objective.figure, *piece.samples(path.coefficients), t=piece.t)
            curvature = Curvature(samples)
            for term in some:
                term.penalty.curvature(samples, curvature, term.factor * weights)
            return curvature

        for seen in every:
            curvature = Curvature(seen.samples)
            for k in sharp:
                weights = terms[k].factor * problem.weights[seen.piece.which]
                terms[k].penalty.curvature(seen.samples, curvature, weights, seen.blocks[k])
            rows.append((curvature, seen.piece))
        for piece, pairs in layout.pieces:
            weights = layout.weights[piece.which]
            few = curved(piece, smooth, weights)
            rows.append((few, piece))
            layout.add_blocks(room, few, piece, pairs)
            if scale is None:
                sizes.append(few.acceleration() / weights[:, None])
        layout.add_rows(room, *rows)
        for term, sampling in problem.instants:
            layout.add_rows(room, (curved(sampling.whole, [term], np.ones(sampling.t.size)), sampling.whole))
        diagonal = layout.diagonal(room)[:, 0]
        size = max(middle(diagonal), LEAST)
        diagonal += FAINT * size
        self.held *= STIFF * size
        self.held += room
        return max(middle(np.concatenate(sizes)), LEAST) if scale is None else scale

    def minimised(self, damping: float) -> Proposal:
        """The minimum of m with λ = damping."""
        layout, sided = self.layout, self.sided
        held = self.held.copy()
        diagonal = layout.diagonal(held)
        diagonal += damping * layout.flat[:, :, None]
        if sided is None:
            factor = layout.factor(held)
            if factor is None:
                return Proposal(np.zeros(layout.place.size), 0.0, None)
            step = -layout.solved(factor, self.gradient)
            return Proposal(layout.to_x(step), -0.5 * float(np.sum(step * self.gradient)), factor)
        return self._one_sided(held, sided)

    def _one_sided(self, held: Array, sided: OneSidedTerms) -> Proposal:
        """Newton on the residuals that count, changing them until they settle."""
        layout, last = self.layout, None
        step, pull = np.zeros_like(self.gradient), np.zeros_like(self.gradient)  # δ and H δ
        over, root = sided.value, np.sqrt(2 * sided.weight)
        worth = first = float(sided.weight @ np.maximum(over, 0) ** 2)
        counted = np.zeros(over.size, bool)  # which residuals `held` has in it
        for _ in range(MOST_CHANGES):
            active = over > 0
            for sign, some in ((1.0, active & ~counted), (-1.0, counted & ~active)):
                if some.any():
                    layout.add_rows_by_y(held, sided.sampling, *sided.squares(some, root), sign)
            counted = active
            factor = layout.factor(held)
            if factor is None:
                break
            last = factor
            push = 2 * sided.weight * active
            target = -layout.solved(factor, self.gradient + sided.pulled_back(push * sided.value))
            over_target = sided.value + sided.changed(target)
            pull_target = -self.gradient - sided.pulled_back(push * over_target)
            share, previous = 1.0, worth
            while True:
                at = step + share * (target - step)
                there = over + share * (over_target - over)
                force = pull + share * (pull_target - pull)
                worth = float(np.sum((self.gradient + 0.5 * force) * at) + sided.weight @ np.maximum(there, 0) ** 2)
                if worth <= previous or share < SHORTEST:
                    break
                share /= 2
            if worth > previous:
                worth = previous
                break
            step, over, pull = at, there, force
            if previous - worth <= SETTLED * (first - worth):
                break
        return Proposal(layout.to_x(step), first - worth, last)
