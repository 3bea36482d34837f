"""The C² cubic B-spline through a timeline's frames (eqs. 2-6): linear in the frames, so every sample is a fixed linear
map of them, and a gradient with respect to samples pulls back to frames by the transposed map.

M frames and M knots span M + 2 cubic B-splines; the two rows that eq. 5 leaves open are the end slopes (free or
clamped) or the two conditions of a periodic curve. The collocation matrix is banded: factorised once, O(M) a solve.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike
from scipy import sparse
from scipy.interpolate import CubicSpline
from scipy.sparse.linalg import splu

from .quaternion import Array, Index

DEGREE = 3
SHORT = 150


class Spline:
    """Cubic B-splines with one knot at each of M rising times [s], and the map from rows (M + 2, N) to their curve.

    Rows are the states at the times and, below them, the slopes at the first and the last time; with ends "periodic"
    these two rows are the jumps of y' and y'' from end to start (zero for a loop; see `opposite_jumps`).
    """

    def __init__(self, times: ArrayLike, ends: str = "free") -> None:
        self.times = np.array(times, float)
        self.times.setflags(write=False)
        self.ends = ends
        first, last = self.times[0], self.times[-1]
        self.knots = np.concatenate([[first] * DEGREE, self.times, [last] * DEGREE])
        if ends == "periodic":
            closing = [self.basis([last], k) - self.basis([first], k) for k in (1, 2)]
        else:
            closing = [self.basis([first, last], 1)]
        self._collocation = splu(sparse.csc_matrix(sparse.vstack([self.basis(self.times, 0), *closing])))

    @property
    def size(self) -> int:
        """M + 2, the number of basis functions."""
        return self.times.size + 2

    def basis(self, t: ArrayLike, order: int) -> sparse.csr_matrix:
        """(S, M + 2) values of the order-th derivatives of the B-splines at t (S,) [s]: 4 non-zeros a row.

        At a knot the third derivative is the one of the span to the right (at the last knot, to the left).
        """
        t = np.atleast_1d(np.asarray(t, float))
        count = self.times.size
        span = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, count - 2)
        values = _basis_values(self.knots, span + DEGREE, t, order)
        columns = span[:, None] + np.arange(DEGREE + 1)
        starts = np.arange(0, values.size + 1, DEGREE + 1)
        return sparse.csr_matrix((values.ravel(), columns.ravel(), starts), shape=(t.size, count + 2))

    def coefficients(self, rows: Array) -> Array:
        """C = Φ⁻¹ Y (eq. 6): rows (M + 2, N) -> B-spline coefficients (M + 2, N)."""
        return self._collocation.solve(np.ascontiguousarray(rows))

    def coefficients_transposed(self, gradient: Array) -> Array:
        """Φ⁻ᵀ: the gradient with respect to coefficients pulled back to rows, (M + 2, N) -> (M + 2, N)."""
        return self._collocation.solve(np.ascontiguousarray(gradient), trans="T")

    def opposite_jumps(self) -> Array:
        """(2, M): the jumps, as a map of the states, with which a periodic spline's column comes back as its negative.

        So does a quaternion after a full turn: smooth across the seam are then −q' and −q'', not q' and q''.
        """
        first, last = self.times[[0, -1]]
        sums = sparse.vstack([self.basis(last, k) + self.basis(first, k) for k in (1, 2)])
        by_rows = self.coefficients_transposed(sums.toarray().T).T
        return np.negative(np.linalg.solve(by_rows[:, -2:], by_rows[:, :-2]), dtype=float)

    def evaluate(self, rows: Array, t: ArrayLike, order: int = 0) -> Array:
        """y, y', y'' or y''' at t (S,): (S, N)."""
        return self.basis(t, order) @ self.coefficients(rows)


def _basis_values(knots: Array, span: Index, t: Array, order: int) -> Array:
    """(S, 4): the order-th derivatives at t of the four cubic B-splines that live on each t's span.

    The triangular scheme of de Boor (A Practical Guide to Splines, ch. X): lower-degree B-splines, then differences.
    """
    values = np.ones((t.size, 1))
    for degree in range(1, DEGREE + 1):
        right = knots[span[:, None] + 1 + np.arange(degree)]
        left = knots[span[:, None] + 1 - degree + np.arange(degree)]
        lower = np.zeros((t.size, degree + 1))
        if degree <= DEGREE - order:
            share = values / (right - left)
            lower[:, :-1] += share * (right - t[:, None])
            lower[:, 1:] += share * (t[:, None] - left)
        else:
            share = degree * values / (right - left)
            lower[:, :-1] -= share
            lower[:, 1:] += share
        values = lower
    return values


@dataclass(frozen=True, eq=False)
class Sampling:
    """A spline seen at sample times: y, y', y'' of any rows, and the pull-back of their gradients (method of §2)."""

    spline: Spline
    t: Array
    bases: tuple[sparse.csr_matrix, sparse.csr_matrix, sparse.csr_matrix]

    @classmethod
    def of(cls, spline: Spline, t: ArrayLike) -> Sampling:
        t = np.asarray(t, float)
        b0, b1, b2 = (spline.basis(t, order) for order in range(3))
        return cls(spline, t, (b0, b1, b2))

    def samples(self, rows: Array) -> tuple[Array, Array, Array]:
        """(y, y', y'') at the sample times, each (S, N)."""
        c = self.coefficients(rows)
        b0, b1, b2 = self.bases
        return b0 @ c, b1 @ c, b2 @ c

    def pulled_back(self, gradients: Sequence[Array]) -> Array:
        """dE/dY (M + 2, N) from dE/dy, dE/dy', dE/dy'', each (S, N)."""
        total = sum(b.T @ g for b, g in zip(self.bases, gradients, strict=True))
        return self.coefficients_transposed(np.asarray(total))

    @cached_property
    def _inverse(self) -> Array | None:
        """Φ⁻¹ of a spline so short that a product with it is quicker than a sparse solve."""
        return self.spline.coefficients(np.eye(self.spline.size)) if self.spline.size <= SHORT else None

    def coefficients(self, rows: Array) -> Array:
        """The spline's `coefficients`, made for many calls."""
        return self.spline.coefficients(rows) if self._inverse is None else self._inverse @ rows

    def coefficients_transposed(self, gradient: Array) -> Array:
        """The spline's `coefficients_transposed`, made for many calls."""
        return self.spline.coefficients_transposed(gradient) if self._inverse is None else self._inverse.T @ gradient

    def pieces(self, longest: int) -> tuple[Piece, ...]:
        """The samples in nearly equal runs of at most `longest`: what is made of so few of them stays in cache."""
        count = -(-self.t.size // longest)
        edges = [self.t.size * k // count for k in range(count + 1)]
        return tuple(self._piece(slice(a, b)) for a, b in pairwise(edges))

    def _piece(self, which: slice) -> Piece:
        basis = sparse.csr_matrix(sparse.vstack([b[which] for b in self.bases]))
        seen = slice(int(basis.indices.min()), int(basis.indices.max()) + 1)
        basis = sparse.csr_matrix(basis[:, seen])
        return Piece(which, self.t[which], seen, basis, sparse.csr_matrix(basis.T))


@dataclass(frozen=True, eq=False)
class Piece:
    """A run of a sampling's samples, and the few coefficients that they see.

    which       the samples
    t           (S,) [s]
    seen        the coefficients, C of them
    basis       (3 S, C) y, y' and y'' of all samples, one below the other
    transposed  (C, 3 S)
    """

    which: slice
    t: Array
    seen: slice
    basis: sparse.csr_matrix
    transposed: sparse.csr_matrix

    def samples(self, coefficients: Array) -> Array:
        """y, y', y'' (3, S, N) from the spline's coefficients (M + 2, N)."""
        return (self.basis @ coefficients[self.seen]).reshape(3, self.t.size, -1)

    def add_pulled_back(self, into: Array, gradients: Sequence[Array]) -> None:
        """Adds dE/dC from dE/dy, dE/dy', dE/dy'', each (S, N), into (M + 2, N)."""
        into[self.seen] += self.transposed @ np.concatenate(gradients)


@dataclass(frozen=True, eq=False)
class Path:
    """A curve of states over time: a spline and its rows (M + 2, N). Every iterate of the optimiser is one."""

    spline: Spline
    rows: Array

    def at(self, t: ArrayLike, order: int = 0) -> Array:
        """The order-th derivative (0-3) of the state at times t (S,): (S, N)."""
        return self.spline.evaluate(self.rows, t, order)

    @property
    def span(self) -> tuple[float, float]:
        """First and last time [s]."""
        return float(self.spline.times[0]), float(self.spline.times[-1])


def natural_spline(times: ArrayLike, values: ArrayLike) -> CubicSpline:
    """The interpolating C² cubic with y'' = 0 at both ends: the paper's raw spline, componentwise."""
    return CubicSpline(np.asarray(times, float), np.asarray(values, float), bc_type="natural")
