"""The model that a step of the search minimises: E to second order, with one-sided residuals kept one-sided.

    m(δ) = gᵀδ + ½ δᵀ(H + λF)δ + Σ_p c_p max(0, d_p + r_pᵀδ)²

δ moves the B-splines' coefficients: a sample sees 4 of them, so all matrices are banded and cost and memory are linear
in the length of the clip. H is the Gauss-Newton curvature, F the flat acceleration energy that damps the step, d_p how
far a point is in the floor (below zero: over it). What is fixed, keyframes and a loop's seam, is held by springs, stiff
beside everything else; they shape the step, the keyframes themselves are no unknowns and stay exact.

m is convex and piecewise quadratic: Newton steps on the residuals that count at present, with a line search, end at
its minimum after a few factorisations (semismooth Newton; M. Hintermüller, K. Ito & K. Kunisch, SIAM J. Optim. 2002).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import sparse

from . import banded
from .curvature import Curvature
from .objective import Discretised
from .quadrature import gauss_nodes
from .quaternion import Array, Index
from .spline import DEGREE, Path, Spline

POINTS = 2
SPANS_AT_ONCE = 32
STIFF = 1e6
FAINT = 1e-9
SHARE_OF_POSITION = 0.3
MOST_CHANGES = 15
SETTLED = 0.05
LOCAL = DEGREE + 1


class Layout:
    """Where everything stands in the banded matrices of one timeline: coefficients (M + 2) by columns (N).

    A loop's coefficients are taken alternately from both ends, so that its seam is in the band too.
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
        self.rows = sparse.csr_matrix(
            sparse.vstack([spline.basis(spline.times, 0), spline.basis(spline.times[[0, -1]], 1)])
        )
        self.rows_transposed = self.rows.T.tocsr()
        self.place = unknowns.place
        times = np.asarray(spline.times)
        self.t, self.weights = gauss_nodes(times, POINTS)
        self.bases = local_bases(spline, self.t)
        self.springs = self._springs()
        self.flat = self._flat()

    def empty(self) -> Array:
        """Room for a matrix's blocks: (M + 2, N, K + 1, N), [j, c, k, r] its entry at row (j + k, r), column (j, c)."""
        return np.zeros((self.count, self.width, self.blocks + 1, self.width))

    def add_curvature(self, room: Array, spans: Index, curvature: Curvature, bases: Array) -> None:
        """Adds a curvature whose samples lie on these spans (S,), rising."""
        for at, rows in curvature.rows(bases):
            self.add_squared(room, spans[at], rows)
        first = np.flatnonzero(np.diff(spans, prepend=-1))
        for columns, blocks in curvature.blocks(bases):
            local = np.add.reduceat(blocks, first, axis=0)
            for a in range(LOCAL):
                for b in range(LOCAL):
                    row, column = self.rank[spans[first] + a], self.rank[spans[first] + b]
                    lower = np.flatnonzero(row >= column)
                    own = (row - column)[lower, None, None, None]
                    place = (column[lower, None, None, None], columns[:, :, None], own, columns[:, None, :])
                    room[place] += local[lower, :, b, :, a, :]

    def add_squared(self, room: Array, spans: Index, rows: Array) -> None:
        """Adds Σ rowᵀrow of rows (P, 4 N) over the coefficients of their spans (P,), rising."""
        width = self.width
        edges = np.flatnonzero(np.diff(spans)) + 1
        for first, last in zip(np.append(0, edges), np.append(edges, spans.size), strict=True):
            if first == last:
                continue
            upper = banded.squared(rows[first:last])
            span = int(spans[first])
            if self.is_loop:
                self._add_folded(room, span, upper + np.triu(upper, 1).T)
                continue
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

    def to_x(self, coefficients: Array) -> Array:
        """The step in the unknowns (n,) that a step of the coefficients (M + 2, N) means."""
        return np.asarray(self.rows @ coefficients).ravel()[self.place]

    def from_x(self, gradient: Array) -> Array:
        """A gradient with respect to the unknowns (n,) as one with respect to coefficients, (M + 2, N)."""
        rows = np.zeros(self.count * self.width)
        rows[self.place] = gradient
        return np.asarray(self.rows_transposed @ rows.reshape(self.count, self.width))

    def _springs(self) -> Array:
        """The springs' matrix, of about unit size."""
        spline, width = self.problem.spline, self.width
        last = self.count - 3
        room = self.empty()
        free = np.zeros((self.count, width), bool)
        free.reshape(-1)[self.place] = True
        ties = self.problem.unknowns.matrix
        for i in range(self.count):
            if self.is_loop and i >= last:
                self._tie_seam(room, spline, i - last)
            elif not free[i].all():
                hold = np.diag(1.0 - free[i])
                own = ties[i * width : (i + 1) * width]
                columns = np.unique(own.indices)
                if columns.size:
                    moves = own[:, columns].toarray()
                    hold = np.eye(width) - moves @ np.linalg.pinv(moves)
                row = self.rows[i]
                weights = np.array(row.data, float)[:, None] + np.zeros(width)
                self._hold(room, np.asarray(row.indices, np.intp), weights, hold)
        return room

    def _tie_seam(self, room: Array, spline: Spline, order: int) -> None:
        """y, y' or y'' at the end equal to that at the start, or its negative for quaternions that come back so."""
        start, end = (spline.basis([t], order) for t in spline.times[[0, -1]])
        states = self.problem.timeline.rows
        sign = np.ones(self.width)
        for columns in self.problem.objective.figure.tables.quaternion_columns.T:
            sign[columns] = 1.0 if states[0, columns] @ states[self.count - 3, columns] >= 0 else -1.0
        both = sparse.csr_matrix(sparse.vstack([start, end]))
        weights = np.array(both.data, float)[:, None] + np.zeros(self.width)
        weights[: start.nnz] *= -sign
        self._hold(room, np.asarray(both.indices, np.intp), weights, np.eye(self.width))

    def _hold(self, room: Array, coefficients: Index, weights: Array, hold: Array) -> None:
        """A spring on `hold` (N, N) of Σ_j weights_j * c_j, weights (k, N)."""
        weights = weights / np.sqrt(np.sum(weights**2) / self.width)
        for ja, wa in zip(coefficients, weights, strict=True):
            for jb, wb in zip(coefficients, weights, strict=True):
                row, column = self.rank[ja], self.rank[jb]
                if row >= column:
                    room[column, :, row - column, :] += wb[:, None] * hold * wa

    def _flat(self) -> Array:
        """(P, 4, 4): ∫ φ''φ''ᵀ + ε φφᵀ over every span, for each column the same."""
        frames = self.problem.timeline.frames
        keys = max(sum(not frame.is_variable for frame in frames), 2)
        spacing = (frames[-1].time - frames[0].time) / keys
        value, acceleration = self.bases[:, 0], self.bases[:, 2]
        density = acceleration[:, :, None] * acceleration[:, None, :]
        density += SHARE_OF_POSITION / spacing**4 * value[:, :, None] * value[:, None, :]
        return (self.weights[:, None, None] * density).reshape(-1, POINTS, LOCAL, LOCAL).sum(axis=1)


def local_bases(spline: Spline, t: Array) -> Array:
    """(S, 3, 4): the B-splines that live at each t, and two derivatives."""
    return np.stack([np.array(spline.basis(t, k).data, float).reshape(-1, LOCAL) for k in range(3)], axis=1)


@dataclass(frozen=True, eq=False)
class OneSided:
    """The one-sided residuals of all terms: each adds weight max(0, value + row · δ)².

    value, weight  (P,);  rows  (P, (M + 2) N) sparse;  span  (P,), rising;  local  (P, 4 N) the rows' non-zeros
    """

    value: Array
    weight: Array
    span: Index
    local: Array
    rows: sparse.csr_matrix
    transposed: sparse.csr_matrix

    @classmethod
    def of(cls, problem: Discretised, path: Path) -> OneSided | None:
        samples = problem.objective.samples(path, problem.sampling.t)
        found = [(term.factor, term.penalty.sides(samples)) for term in problem.objective.terms]
        parts = [(factor, sides) for factor, sides in found if sides is not None and sides.at.size]
        if not parts:
            return None
        at = np.concatenate([sides.at for _, sides in parts])
        order = np.argsort(at, kind="stable")
        weight = np.concatenate([np.full(sides.at.size, factor) for factor, sides in parts]) * problem.weights[at]
        value = np.concatenate([sides.value for _, sides in parts])
        rows = np.concatenate([sides.rows for _, sides in parts])
        at, rows, value, weight = at[order], rows[order], value[order], weight[order]
        basis = path.spline.basis(problem.sampling.t[at], 0)
        span = basis.indices.reshape(-1, LOCAL)[:, 0].astype(np.intp)
        local = (basis.data.reshape(-1, LOCAL)[:, :, None] * rows[:, None, :]).reshape(at.size, -1)
        width = rows.shape[1]
        used = np.flatnonzero(local)
        pair, column = np.divmod(used, local.shape[1])
        place = (pair, span[pair] * width + column)
        matrix = sparse.csr_matrix((local.ravel()[used], place), shape=(at.size, path.spline.size * width))
        return cls(value, weight, span, local, matrix, matrix.T.tocsr())


class Model:
    """m(δ) at one path.

    scale  the size of E's curvature in y'', a unit for the damping λ
    """

    def __init__(self, layout: Layout, x: Array, gradient: Array) -> None:
        """x (n,) with dE/dx (n,) there."""
        self.layout = layout
        problem = layout.problem
        path = problem.path(x)
        self.held = layout.springs.copy()
        self.scale = self._add_smooth(path)
        self.sided = OneSided.of(problem, path)
        self.gradient = layout.from_x(gradient)
        if self.sided is not None:
            pull = 2 * self.sided.weight * np.maximum(self.sided.value, 0)
            self.gradient -= (self.sided.transposed @ pull).reshape(self.gradient.shape)

    def _add_smooth(self, path: Path) -> float:
        """Adds the curvature of the two-sided residuals; its median density in y''."""
        layout, objective = self.layout, self.layout.problem.objective
        room, sizes = layout.empty(), []
        spans = layout.t.size // POINTS
        for first in range(0, spans, SPANS_AT_ONCE):
            some = np.arange(first, min(first + SPANS_AT_ONCE, spans))
            nodes = slice(POINTS * some[0], POINTS * (some[-1] + 1))
            samples = objective.samples(path, layout.t[nodes])
            curvature = Curvature(samples)
            for term in objective.terms:
                term.penalty.curvature(samples, curvature, term.factor * layout.weights[nodes])
            layout.add_curvature(room, np.repeat(some, POINTS), curvature, layout.bases[nodes])
            sizes.append(curvature.acceleration() / layout.weights[nodes, None])
        index = np.arange(layout.width)
        middle = float(np.median(room[:, index, 0, index]))
        self.held *= STIFF * max(middle, 1e-12)
        self.held += room
        self.held[:, index, 0, index] += FAINT * max(middle, 1e-12)
        return max(float(np.median(np.concatenate(sizes))), 1e-12)

    def minimised(self, damping: float) -> tuple[Array, float]:
        """The step (n,) of the unknowns to the minimum of m with λ = damping, and how far m falls."""
        layout, sided = self.layout, self.sided
        held = self.held.copy()
        index = np.arange(layout.width)
        some = np.arange(layout.flat.shape[0])
        for a in range(LOCAL):
            for b in range(LOCAL):
                row, column = layout.rank[some + a], layout.rank[some + b]
                lower = np.flatnonzero(row >= column)
                place = (column[lower, None], index, (row - column)[lower, None], index)
                held[place] += damping * layout.flat[lower, a, b, None]
        if sided is None:
            factor = layout.factor(held)
            if factor is None:
                return np.zeros(layout.place.size), 0.0
            step = -layout.solved(factor, self.gradient)
            return layout.to_x(step), -0.5 * float(np.sum(step * self.gradient))
        return self._one_sided(held, sided)

    def _one_sided(self, held: Array, sided: OneSided) -> tuple[Array, float]:
        """Newton on the residuals that count, changing them until they settle."""
        layout = self.layout
        step, pull = np.zeros_like(self.gradient), np.zeros_like(self.gradient)  # δ and H δ
        over, root = sided.value, np.sqrt(2 * sided.weight)
        worth = first = float(sided.weight @ np.maximum(over, 0) ** 2)
        for _ in range(MOST_CHANGES):
            active = over > 0
            room = held.copy()
            layout.add_squared(room, sided.span[active], sided.local[active] * root[active, None])
            factor = layout.factor(room)
            if factor is None:
                break
            push = 2 * sided.weight * active
            target = -layout.solved(factor, self.gradient + self._back(push * sided.value))
            over_target = sided.value + sided.rows @ target.ravel()
            pull_target = -self.gradient - self._back(push * over_target)
            share, previous = 1.0, worth
            while True:
                at = step + share * (target - step)
                there = over + share * (over_target - over)
                force = pull + share * (pull_target - pull)
                worth = float(np.sum((self.gradient + 0.5 * force) * at) + sided.weight @ np.maximum(there, 0) ** 2)
                if worth <= previous or share < 1e-3:
                    break
                share /= 2
            if worth > previous:
                worth = previous
                break
            step, over, pull = at, there, force
            if previous - worth <= SETTLED * (first - worth):
                break
        return layout.to_x(step), first - worth

    def _back(self, forces: Array) -> Array:
        """Rᵀ f, (M + 2, N)."""
        assert self.sided is not None
        return (self.sided.transposed @ forces).reshape(self.gradient.shape)
