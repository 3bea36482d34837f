"""The model that a step of the search minimises: E to second order, with one-sided residuals kept one-sided.

    m(δ) = gᵀδ + ½ δᵀ(H + λF)δ + Σ_p c_p max(0, d_p + r_pᵀδ)²

δ is a step of a spline that is zero at whole keyframes, see `Elimination`. H is the Gauss-Newton curvature, and F the
flat acceleration energy that damps the step. d_p is a one-sided residual, such as the depth of a point in the floor
(negative above it). A sample depends on 4 coefficients of δ, so all matrices are banded, and time and memory are linear
in the length of the clip.

The degrees of freedom that partial keyframes fix, and a loop's seam, are held by springs that are stiff relative to H.
The springs only shape the step: fixed degrees of freedom are not unknowns and stay exact.

The H of smooth terms is summed over a few nodes per span. The H of terms that begin, end or peak within a span is
summed over the samples of E; otherwise the model would predict reductions that E does not have.

m is convex and piecewise quadratic. Newton steps on the active residuals, with an exact line search, reach its minimum
after a few factorisations (semismooth Newton; M. Hintermüller, K. Ito & K. Kunisch, SIAM J. Optim. 2002).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise, product
from typing import Any, NamedTuple

import numpy as np

from .. import compiled
from ..array import ENTRIES_AT_ONCE, IN_CACHE, Array, Index, Mask
from ..curve import banded
from ..curve.elimination import LOCAL, Elimination
from ..curve.quadrature import gauss_nodes
from ..curve.seam import Seam
from ..curve.spline import DEGREE, Path, Piece, Sampling
from ..figure.kinematics import Samples
from ..objective import Discretised, EvaluatedRun
from ..penalty.block import one_sided_residuals
from ..penalty.curvature import Curvature, OneSidedResiduals
from ..tolerances import ROUNDING, TINY

POINTS = 2  # nodes per span for the curvature of smooth terms, which needs fewer nodes than E
SPANS_AT_ONCE = 32  # least number of spans in a run
STIFF = 1e6  # [1] stiffness of springs relative to the median curvature, so that fixed entries hardly move
SHARE_OF_POSITION = 0.3  # [1] weight of positions in F, relative to accelerations at the keyframes' spacing
MOST_CHANGES = 15  # maximum number of changes of the active set
SETTLED = 0.1  # [1] gain of a change of the active set, relative to the total reduction, at which it is the last
BLOCKED = 0.1  # [1] share of a Newton step below which inactive residuals block it, so that another change follows


class Layout:
    """The layout of the banded matrices of one timeline: coefficients of a step (C) by columns of the state (N).

    A loop's coefficients are ordered alternately from both ends, so that its seam is within the band. A matrix is
    stored as blocks (C, N, K + 1, N): [j, c, k, r] is its entry at row (j + k, r) and column (j, c), lower half.

    Attributes:
        basis: The basis of the steps.
        sampling: Its functions at the samples of E.
        pieces: Runs of the nodes at which the curvature of smooth terms is computed: of the spline, and of the basis.
        order: The coefficients in the order of the matrices, (C,); `rank` is its inverse.
        used: The ranks of coefficients whose functions are not zero.
        place: The unknowns as indices into the flattened states and slopes, (n,).
    """

    def __init__(self, problem: Discretised) -> None:
        self.problem = problem
        spline, unknowns = problem.spline, problem.unknowns
        self.width = problem.timeline.width
        self.free = np.zeros((spline.size, self.width), bool)
        self.free.reshape(-1)[unknowns.place] = True
        self.tied = np.zeros(spline.size, bool)
        if unknowns.ties is not None:
            self.tied = np.diff(unknowns.ties.indptr).reshape(self.free.shape).any(axis=1)
        self.is_loop = spline.ends == "periodic"
        is_fixed = np.asarray(~self.tied & ~self.free.any(axis=1))
        is_fixed[-2:] &= not self.is_loop  # rows of jumps
        self.basis = Elimination(spline, is_fixed)
        self.sampling = self.basis.sample(problem.sampling)
        self.count = self.basis.size
        order = np.arange(self.count)
        if self.is_loop:
            order = np.ravel(np.column_stack([order, order[::-1]]))[: self.count]
        self.rank = np.empty(self.count, np.intp)
        self.rank[order] = np.arange(self.count)
        self.order, self.used = order, self.rank[: self.basis.count]
        self.blocks = min(2 * LOCAL if self.is_loop else LOCAL, self.count)
        self.place = unknowns.place
        t, self.weights = gauss_nodes(np.asarray(spline.times), POINTS)
        nodes = Sampling.of(spline, t)
        sampling = self.basis.sample(nodes)
        at_once = max(SPANS_AT_ONCE, IN_CACHE // self.width)
        edges = [*range(0, spline.times.size - 1, at_once), spline.times.size - 1]
        runs = [slice(POINTS * a, POINTS * b) for a, b in pairwise(edges)]
        self.pieces = [(nodes.piece(run), sampling.piece(run)) for run in runs]
        self.flat = self._flat(sampling.whole)

    @cached_property
    def springs(self) -> tuple[Index, Array]:
        """The springs on fixed degrees of freedom, of about unit size: their entries in a flat matrix, and values."""
        springs = self._springs().reshape(-1)
        place = np.flatnonzero(springs)
        return place, springs[place]

    def empty(self) -> Array:
        return np.zeros((self.count, self.width, self.blocks + 1, self.width))

    def diagonal(self, matrix: Array) -> Array:
        """Return a writable view (C, K + 1, N) of the entries that couple a column of the state with itself."""
        return np.einsum("jckc->jkc", matrix)

    def _pairs(self, first: Index) -> Iterator[tuple[Index, int, int, Index, Index]]:
        """Yield spans and their functions a and b with the positions j, k of the pair in the matrix's blocks, in its
        lower half, (pairs,); `first` (spans,) are the spans' first functions."""
        for a, b in np.ndindex(LOCAL, LOCAL):
            row, column = self.rank[first + a], self.rank[first + b]
            lower = np.flatnonzero(row >= column)
            if lower.size:
                yield lower, a, b, column[lower], (row - column)[lower]

    def add_blocks(self, matrix: Array, curvature: Curvature, piece: Piece) -> None:
        """Add the part of a curvature that is stored as blocks. Its samples are the nodes of neighbouring spans."""
        if compiled.kernel is not None:
            for columns, squares in curvature.squares():
                compiled.call("add_blocks", matrix, self.rank, piece.first, piece.values, columns, squares, self.width)
            return
        pairs = list(self._pairs(piece.first[::POINTS]))
        phi = piece.values
        products = (phi[:, :, None, :, None] * phi[:, None, :, None, :]).reshape(-1, POINTS * 9, LOCAL**2)
        for columns, squares in curvature.squares():
            by_orders = squares.transpose(0, 2, 4, 1, 3, 5)
            local = np.matmul(products.swapaxes(1, 2), by_orders.reshape(len(products), POINTS * 9, -1))
            local = local.reshape(-1, LOCAL, LOCAL, *by_orders.shape[3:])
            for spans, a, b, j, k in pairs:
                place = j[:, None, None, None], columns[:, None, :], k[:, None, None, None], columns[:, :, None]
                np.add.at(matrix, place, local[spans, a, b])

    def add_rows(self, matrix: Array, *parts: tuple[Curvature, Piece]) -> None:
        """Add the parts of curvatures that are stored as rows, which may be at any samples."""
        use_kernel, factors = compiled.kernel is not None, []
        for curvature, piece in parts:
            if use_kernel:
                for at, rows, weight in curvature.rows_by_y():
                    self.add_rows_by_y(matrix, piece, at, rows, weight)
            for at, directions, rows in curvature.rows(piece.values, without_y=use_kernel):
                spans = piece.first[at]
                edges = np.searchsorted(spans, np.arange(spans[0], spans[-1] + 2))
                factors.append((int(spans[0]), edges.tolist(), directions, rows))
        for span in range(self.count - DEGREE):
            local = []
            for first, edges, directions, rows in factors:
                if 0 <= span - first < len(edges) - 1 and edges[span - first] < edges[span - first + 1]:
                    run = slice(edges[span - first], edges[span - first + 1])
                    local.append(np.matmul(directions[run], rows[run]).reshape(-1, LOCAL * self.width))
            if local:
                self.add_square(matrix, span, np.concatenate(local))

    def add_rows_by_y(self, matrix: Array, sampling: Piece | Sampling, at: Index, rows: Array, weight: Array) -> None:
        """Add Σ weight rowᵀrow of rows (P, N) with respect to y at ascending samples (P,), all weights of one sign."""
        bases = sampling.values[:, 0]
        if compiled.kernel is not None:
            compiled.call("add_squares", matrix, self.rank, sampling.first, bases, at, rows, weight)
            return
        spans, width, sign = sampling.first[at], LOCAL * self.width, float(np.sign(weight.sum()))
        rows = rows * np.sqrt(np.abs(weight))[:, None]
        at_once = max(1, ENTRIES_AT_ONCE // width)  # over four coefficients, rows take four times the memory
        edges = [0, *(np.flatnonzero(np.diff(spans)) + 1).tolist(), at.size]
        for begin, end in pairwise(edges):
            for first in range(begin, end, at_once):
                run = slice(first, min(first + at_once, end))
                wide = (bases[at[run], :, None] * rows[run, None, :]).reshape(-1, width)
                self.add_square(matrix, int(spans[begin]), wide, sign)

    def add_square(self, matrix: Array, span: int, rows: Array, sign: float = 1.0) -> None:
        """Add sign · Σ rowᵀrow of rows (P, 4 N) over the coefficients of one span."""
        width, upper = self.width, banded.square(rows, sign)
        if self.is_loop:
            self._add_folded(matrix, span, upper + np.triu(upper, 1).T)
            return
        for b in range(LOCAL):
            slab = upper[b * width : (b + 1) * width, b * width :]
            matrix[span + b, :, : LOCAL - b] += slab.reshape(width, LOCAL - b, width)

    def _add_folded(self, matrix: Array, span: int, local: Array) -> None:
        """Add a symmetric matrix (4 N, 4 N) over the coefficients of one span of a loop."""
        blocks = local.reshape(LOCAL, self.width, LOCAL, self.width)
        for a in range(LOCAL):
            for b in range(LOCAL):
                row, column = self.rank[span + a], self.rank[span + b]
                if row >= column:
                    matrix[column, :, row - column] += blocks[b, :, a]

    def factor(self, matrix: Array) -> Array | None:
        """Return the banded Cholesky factor of a matrix, or None if it is not positive definite."""
        size = self.blocks * self.width
        flat = matrix.reshape(self.count, self.width, -1)
        strides = (flat.strides[0], flat.strides[1] + flat.strides[2], flat.strides[2])
        band = np.lib.stride_tricks.as_strided(flat, (self.count, self.width, size), strides)
        return banded.cholesky(np.array(band).reshape(-1, size))

    def solve(self, factor: Array, right: Array) -> Array:
        """Return H⁻¹ v for v (C, N)."""
        solution = banded.solve(factor, right[self.order].reshape(-1, 1))
        return solution.reshape(self.count, self.width)[self.rank]

    def unwhiten(self, factor: Array, z: Array) -> Array:
        """Return L⁻ᵀ z (C, N) for flat z in the order of the matrices."""
        return banded.other_half_solved(factor, z.reshape(-1, 1)).reshape(self.count, self.width)[self.rank]

    def whiten(self, factor: Array, gradient: Array) -> Array:
        """Return L⁻¹ v, flat in the order of the matrices, for v (C, N)."""
        return banded.half_solved(factor, gradient[self.order].reshape(-1, 1)).ravel()

    def to_x(self, step: Array) -> Array:
        """Return the step of the unknowns (n,) for coefficients of a step (C, N)."""
        return self.problem.spline.states_and_slopes(self.basis.matrix @ step).reshape(-1)[self.place]

    def from_x(self, gradient: Array) -> Array:
        """Return the gradient with respect to the coefficients (C, N) for one with respect to the unknowns (n,)."""
        rows = np.zeros(self.free.shape)
        rows.reshape(-1)[self.place] = gradient
        return self.basis.transposed @ self.problem.spline.states_and_slopes_transposed(rows)

    @cached_property
    def _held(self) -> Index:
        """The frames of which some degrees of freedom are fixed, except whole keyframes and a loop's last frame."""
        is_free = np.asarray(self.free.all(axis=1))
        frames = np.flatnonzero(~(is_free | self.basis.held)[:-2])
        return frames[frames < len(self.free) - 3] if self.is_loop else frames

    def _springs(self) -> Array:
        timeline, unknowns = self.problem.timeline, self.problem.unknowns
        matrix, times = self.empty(), timeline.times
        if self.is_loop:
            self._tie_seam(matrix, times)
        is_tied: Mask = np.take(self.tied, self._held)
        for i in self._held[is_tied]:
            block: Any = unknowns.matrix[i * self.width : (i + 1) * self.width]  # SciPy has no type for a slice
            moves = block[:, np.unique(block.indices)].toarray()
            at = self._sample(times[[i]])
            self._hold(matrix, int(at.first[0]), at.values[0, 0], np.eye(self.width) - moves @ np.linalg.pinv(moves))
        column, offset, values = self._column_springs(self._held[~is_tied])
        index = np.arange(self.width)
        place = (column[:, None], index, offset[:, None], index)
        flat = np.ravel_multi_index(np.broadcast_arrays(*place), matrix.shape)
        np.add.at(matrix.reshape(-1), flat.ravel(), values.ravel())
        return matrix

    def _sample(self, times: Array) -> Sampling:
        """Return the functions of the basis at times (S,) [s]."""
        return self.basis.sample(Sampling.of(self.problem.spline, times))

    def _column_springs(self, frames: Index) -> tuple[Index, Index, Array]:
        """Return the springs on fixed columns of frames (R,), and on unused functions of the basis: columns (S,),
        offsets from the diagonal (S,), and entries (S, N)."""
        at, unused = self._sample(self.problem.timeline.times[frames]), self.rank[self.basis.count :]
        weights = at.values[:, 0] / np.linalg.norm(at.values[:, 0], axis=1, keepdims=True)
        rank = self.rank[at.first[:, None] + np.arange(LOCAL)]
        offset = rank[:, :, None] - rank[:, None, :]
        row, a, b = np.nonzero(offset >= 0)
        values = (weights[row, a] * weights[row, b])[:, None] * ~self.free[frames[row]]
        values = np.concatenate([values, np.ones((unused.size, self.width))])
        return np.append(rank[row, b], unused), np.append(offset[row, a, b], 0 * unused), values

    def _tie_seam(self, matrix: Array, times: Array) -> None:
        """Tie y, y' and y'' of a step at the end to the same at the start, mapped by the seam. A loop's shift is
        constant, so it does not affect steps."""
        returned, identity = Seam.of(self.problem.objective.figure, self.problem.timeline).matrix(), np.eye(self.width)
        ends = self._sample(times[[0, -1]])
        first, last = (range(first, first + LOCAL) for first in ends.first.tolist())
        is_zero = int(self.basis.held[-3])  # in the basis, at both ends
        for start, end in zip(*ends.values[:, is_zero:], strict=True):
            parts = [(j, -w * returned) for j, w in zip(first, start, strict=True) if w]
            parts += [(j, w * identity) for j, w in zip(last, end, strict=True) if w]
            size = float(start @ start + end @ end)
            for (ja, a), (jb, b) in product(parts, parts):
                row, column = self.rank[ja], self.rank[jb]
                if row >= column:
                    matrix[column, :, row - column, :] += b.T @ a / size

    def _hold(self, matrix: Array, first: int, weights: Array, hold: Array) -> None:
        """Add a spring on `hold` (N, N) times Σ_j weights_j c_j, of 4 coefficients from `first` on."""
        weights = weights / np.linalg.norm(weights)
        for a, b in np.ndindex(LOCAL, LOCAL):
            row, column = self.rank[first + a], self.rank[first + b]
            if row >= column:
                matrix[column, :, row - column, :] += weights[a] * weights[b] * hold

    def _flat(self, nodes: Piece) -> Array:
        """Return ∫ φ''φ''ᵀ + ε φφᵀ of the coefficients, the same for every column, (C, K + 1)."""
        timeline = self.problem.timeline
        keys = max(len(timeline.frames) - timeline.variable_count, 2)
        spacing = (timeline.times[-1] - timeline.times[0]) / keys
        value, acceleration = nodes.values[:, 0], nodes.values[:, 2]
        density = acceleration[:, :, None] * acceleration[:, None, :]
        density += SHARE_OF_POSITION / spacing**4 * value[:, :, None] * value[:, None, :]
        local = (self.weights[:, None, None] * density).reshape(-1, POINTS, LOCAL, LOCAL).sum(axis=1)
        flat = np.zeros((self.count, self.blocks + 1))
        for spans, a, b, j, k in self._pairs(nodes.first[::POINTS]):
            np.add.at(flat, (j, k), local[spans, b, a])
        return flat


def middle(values: Array) -> float:
    """Return the median."""
    half = values.size // 2
    parted = values.flatten()
    parted.partition((half - 1, half))
    return float(parted[half] if values.size % 2 else (parted[half - 1] + parted[half]) / 2)


class OneSidedTerms:
    """The one-sided residuals of all terms at the samples of E. Each adds weight · max(0, value + row · δy)², with the
    step δy at its sample.

    Attributes:
        value: The residuals, (P,); positive ones are active.
        weight: Their weights in E, (P,).
    """

    def __init__(self, layout: Layout, parts: Sequence[tuple[float, OneSidedResiduals]]) -> None:
        """Join residuals, each part with the factor of its term."""
        self.sampling = layout.sampling
        edges = np.cumsum([0, *(residuals.at.size for _, residuals in parts)]).tolist()
        self._parts = [(slice(a, b), residuals) for (a, b), (_, residuals) in zip(pairwise(edges), parts, strict=True)]
        self.value = np.concatenate([residuals.value for _, residuals in parts])
        weights = layout.problem.weights
        self.weight = np.concatenate([factor * weights[residuals.at] for factor, residuals in parts])

    @classmethod
    def of(cls, layout: Layout, evaluated: Sequence[EvaluatedRun]) -> OneSidedTerms | None:
        """Collect the one-sided residuals of evaluated samples; None if there are none."""
        parts = list[tuple[float, OneSidedResiduals]]()
        for run in evaluated:
            for term, blocks in zip(layout.problem.objective.terms, run.blocks, strict=True):
                residuals = one_sided_residuals(blocks, run.samples)
                if residuals is not None and residuals.at.size:
                    parts.append((term.factor, residuals.shift(run.piece.which.start)))
        return cls(layout, parts) if parts else None

    def change(self, step: Array) -> Array:
        """Return the change (P,) of the residuals for coefficients of a step (C, N)."""
        change = self.sampling.bases[0] @ step
        return np.concatenate([residuals.changes(change) for _, residuals in self._parts])

    def pulled_back(self, forces: Array) -> Array:
        """Return the gradient (C, N) of forces · residuals, forces (P,)."""
        total = np.zeros((self.sampling.t.size, self._parts[0][1].rows.shape[1]))
        for run, residuals in self._parts:
            residuals.pull_back(forces[run], total)
        return self.sampling.basis_transposed @ total

    def rows(self, chosen: Mask) -> tuple[Index, Array, Array]:
        """Return samples (A,), in ascending order, gradients (A, N) and weights (A,) of chosen residuals."""
        parts = [residuals.select(np.flatnonzero(chosen[run])) for run, residuals in self._parts if chosen[run].any()]
        at = np.concatenate([residuals.at for residuals in parts])
        order = np.argsort(at, kind="stable")
        return at[order], np.concatenate([residuals.rows for residuals in parts])[order], self.weight[chosen][order]


def line_minimum(slope: float, bend: float, weight: Array, value: Array, change: Array) -> float:
    """Return the s in [0, 1] of least slope · s + ½ bend · s² + Σ weight max(0, value + s · change)².

    Args:
        slope: Negative; the function decreases at s = 0.
        bend: Not negative, so that the function is convex.
        weight: (P,).
        value: (P,).
        change: (P,).
    """
    pull = 2 * weight * change
    if slope + bend + pull @ np.maximum(value + change, 0) <= 0:
        return 1.0
    # the derivative is linear between the values of s at which a residual becomes active (change > 0) or inactive
    active, crosses = value > 0, (value > 0) != (value + change > 0)
    s = -value[crosses] / change[crosses]
    order = np.argsort(s)
    s, value_step, change_step = s[order], (np.abs(pull) * value)[crosses][order], (pull * change)[crosses][order]
    sign = np.sign(change[crosses][order])
    constant = slope + pull[active] @ value[active] + np.append(0.0, np.cumsum(value_step))
    linear = bend + pull[active] @ change[active] + np.append(0.0, np.cumsum(sign * change_step))
    part = int(np.searchsorted(constant[:-1] + linear[:-1] * s > 0, True))
    return float(np.clip(-constant[part] / max(linear[part], TINY), 0, 1))


class Proposal(NamedTuple):
    """The minimum of the model m.

    Attributes:
        step: The step of the unknowns to the minimum, (n,).
        factor: The Cholesky factor of the curvature; None if it is not positive definite.
    """

    step: Array
    predicted_reduction: float
    factor: Array | None


class QuadraticModel:
    """The model m(δ) at one path.

    Attributes:
        curvature: The matrix of H and the springs, in blocks.
        scale: The size of E's curvature in y'', the unit of the damping λ.
        sided: The one-sided residuals; None without any.
        gradient: The gradient of the two-sided part with respect to the coefficients, (C, N).
    """

    def __init__(self, layout: Layout, x: Array, gradient: Array, scale: float | None = None) -> None:
        """Build the model.

        Args:
            x: The unknowns, (n,).
            gradient: dE/dx there, (n,).
            scale: The unit of the damping; None: from this model.
        """
        self.layout = layout
        evaluated = layout.problem.evaluated_runs(x)
        self.curvature = layout.empty()
        self.scale = self._add_smooth(layout.problem.path(x), evaluated, scale)
        self.sided = OneSidedTerms.of(layout, evaluated)
        self.gradient = layout.from_x(gradient)
        if self.sided is not None:
            pull = 2 * self.sided.weight * np.maximum(self.sided.value, 0)
            self.gradient -= self.sided.pulled_back(pull)

    def _add_smooth(self, path: Path, evaluated: Sequence[EvaluatedRun], scale: float | None) -> float:
        """Add the curvature of the two-sided residuals; return its median density in y'', or `scale` unless None."""
        layout, problem = self.layout, self.layout.problem
        matrix, sizes, rows = self.curvature, [], []
        terms = problem.objective.terms
        sharp = [k for k, term in enumerate(terms) if term.penalty.is_sharp]
        smooth = [term for k, term in enumerate(terms) if k not in sharp]

        for run in evaluated:
            curvature = Curvature(run.samples)
            for k in sharp:
                weights = terms[k].factor * problem.weights[run.piece.which]
                for block in run.blocks[k]:
                    block.add_to(curvature, weights)
            rows.append((curvature, layout.sampling.piece(run.piece.which)))
        for nodes, piece in layout.pieces:
            weights = layout.weights[nodes.which]
            samples = Samples(problem.objective.figure, *nodes.samples(path.coefficients), t=nodes.t)
            smooth_curvature = Curvature(samples)
            for term in smooth:
                for block in term.penalty.residuals(samples):
                    block.add_to(smooth_curvature, problem.objective.factor(term, samples.t) * weights)
            rows.append((smooth_curvature, piece))
            layout.add_blocks(matrix, smooth_curvature, piece)
            if scale is None:
                sizes.append(smooth_curvature.acceleration() / weights[:, None])
        layout.add_rows(matrix, *rows)
        diagonal = layout.diagonal(matrix)[:, 0]
        size = max(middle(diagonal[layout.used]), TINY)
        diagonal += ROUNDING * size  # so that the Cholesky factor exists
        place, springs = layout.springs
        matrix.reshape(-1)[place] += STIFF * size * springs
        return max(middle(np.concatenate(sizes)), TINY) if scale is None else scale

    def minimise(self, damping: float) -> Proposal:
        """Return the minimum of m with λ = damping."""
        layout, sided = self.layout, self.sided
        curvature = self.curvature.copy()
        diagonal = layout.diagonal(curvature)
        diagonal += damping * layout.flat[:, :, None]
        if sided is None:
            factor = layout.factor(curvature)
            if factor is None:
                return Proposal(np.zeros(layout.place.size), 0.0, None)
            step = -layout.solve(factor, self.gradient)
            return Proposal(layout.to_x(step), -0.5 * float(np.sum(step * self.gradient)), factor)
        return self._one_sided(curvature, sided)

    def _one_sided(self, curvature: Array, sided: OneSidedTerms) -> Proposal:
        """Return the minimum by Newton steps on the active residuals, until the active set settles."""
        layout, last = self.layout, None
        step, force_step = np.zeros_like(self.gradient), np.zeros_like(self.gradient)  # δ and H δ
        residual = sided.value
        value = first_value = float(sided.weight @ np.maximum(residual, 0) ** 2)
        included = np.zeros(residual.size, bool)  # residuals whose rows are in `curvature`
        for _ in range(MOST_CHANGES):
            active = residual > 0
            for sign, changed in ((1.0, active & ~included), (-1.0, included & ~active)):
                if changed.any():
                    at, rows, weight = sided.rows(changed)
                    layout.add_rows_by_y(curvature, sided.sampling, at, rows, sign * 2 * weight)
            included = active
            factor = layout.factor(curvature)
            if factor is None:
                break
            last = factor
            push = 2 * sided.weight * active
            target = -layout.solve(factor, self.gradient + sided.pulled_back(push * sided.value))
            residual_target = sided.value + sided.change(target)
            force_target = -self.gradient - sided.pulled_back(push * residual_target)
            toward, change = target - step, residual_target - residual
            slope = float(np.sum((self.gradient + force_step) * toward))
            bend = float(np.sum((force_target - force_step) * toward))
            share = line_minimum(slope, bend, sided.weight, residual, change)
            step, residual = step + share * toward, residual + share * change
            force_step, previous = force_step + share * (force_target - force_step), value
            one_sided = sided.weight @ np.maximum(residual, 0) ** 2
            value = float(np.sum((self.gradient + 0.5 * force_step) * step) + one_sided)
            is_blocked = 0 < share < BLOCKED
            if not is_blocked and previous - value <= SETTLED * (first_value - value):
                break
        return Proposal(layout.to_x(step), first_value - value, last)
