"""The C² cubic B-spline through a timeline's frames (eqs. 2-6): linear in the frames, so every sample is a fixed linear
map of them, and a gradient with respect to samples pulls back to frames by the transposed map.

M frames and M knots span M + 2 cubic B-splines; the two rows that eq. 5 leaves open are the end slopes (free, clamped
or held) or the two conditions of a periodic curve. The collocation matrix is banded: factorised once, O(M) a solve.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import sparse

from ..array import Array, Index
from .banded import Tridiagonal
from .frame import Timeline

if TYPE_CHECKING:
    from scipy.sparse.linalg import SuperLU

DEGREE = 3  # cubic: the least that is C²
FELT = 100  # knots away, where 2⁻¹⁰⁰ of a value is left
SHORT = 150  # coefficients up to which a dense inverse is quicker than a sparse solve
Complex = NDArray[np.complex128]
TAYLOR = np.arange(2, -1, -1)[:, None] + np.arange(DEGREE + 1)  # powers of (t - knot) in y, y', y'' by coefficient


class Spline:
    """Cubic B-splines with one knot at each of M rising times [s], and the map from rows (M + 2, N) to their curve.

    Rows are the states at the times and, below them, the slopes at the first and the last time; with ends "periodic"
    these two rows are the jumps of y' and y'' from end to start (zero for a loop; see `jumps_of`).
    """

    def __init__(self, times: ArrayLike, ends: str = "free") -> None:
        self.times = np.array(times, float)
        self.times.setflags(write=False)
        self.ends = ends
        first, last = self.times[0], self.times[-1]
        self.knots = np.concatenate([[first] * DEGREE, self.times, [last] * DEGREE])
        # (M − 1, 4, 4): at the beginning of every span, its 4 B-splines (last axis) and three derivatives
        self._begin = _basis_values(self.knots, np.arange(DEGREE, DEGREE + self.times.size - 1), self.times[:-1])
        # at a knot three B-splines are not zero, at the ends one; the slopes there see two
        self.at_times = np.concatenate([self._begin[:, 0, :DEGREE], [[0.0, 0.0, 1.0]]])
        step = DEGREE / np.diff(self.times)[[0, -1], None]
        self._slopes = np.concatenate([-step, step], axis=1)
        self._collocation = self._closed() if ends == "periodic" else self._tridiagonal()

    @property
    def factor_size(self) -> int:
        """How many numbers the factor of the collocation matrix holds."""
        factor = self._collocation
        return factor.size if isinstance(factor, Tridiagonal) else factor.L.nnz + factor.U.nnz

    def _closed(self) -> SuperLU:
        """The factor of the collocation matrix of a periodic curve, whose last two rows are the jumps at the seam."""
        from scipy.sparse.linalg import splu  # only here: it takes a while, and only loops need it

        first, last = self.times[[0, -1]]
        closing = [self.basis([last], k) - self.basis([first], k) for k in (1, 2)]
        return splu(sparse.csc_matrix(sparse.vstack([self.basis(self.times, 0), *closing])))

    def _tridiagonal(self) -> Tridiagonal:
        """The factor of the collocation matrix: each slope beside the value at its end, it has three diagonals."""
        at, (first, last) = self.at_times, self._slopes
        count = self.times.size
        self._order = np.concatenate([[0, count], np.arange(1, count - 1), [count + 1, count - 1]])
        lower, diagonal, upper = np.zeros(count + 1), np.empty(count + 2), np.zeros(count + 1)
        diagonal[[0, 1, -2, -1]] = at[0, 0], first[1], last[0], at[-1, 2]
        lower[0], upper[-1] = first[0], last[1]
        lower[1:-2], diagonal[2:-2], upper[2:-1] = at[1:-1].T
        return Tridiagonal(lower, diagonal, upper)

    @property
    def size(self) -> int:
        """M + 2, the number of basis functions."""
        return self.times.size + 2

    def basis(self, t: ArrayLike, order: int) -> sparse.csr_matrix:
        """(S, M + 2) values of the order-th derivatives of the B-splines at t (S,) [s]: 4 non-zeros a row.

        At a knot the third derivative is the one of the span to the right (at the last knot, to the left).
        """
        t = np.atleast_1d(np.asarray(t, float))
        first = self._spans(t)
        values = _basis_values(self.knots, first + DEGREE, t)[:, order]
        return _four_a_row(first, values, self.size)

    def local(self, t: Array) -> tuple[Index, Array]:
        """The first (S,) of the 4 B-splines that live at each t (S,), and y, y', y'' of the four: (S, 3, 4)."""
        first = self._spans(t)
        u = t - self.times[first]
        powers = np.zeros((t.size, 6))
        powers[:, 2] = 1
        powers[:, 3] = u
        powers[:, 4] = u * u / 2
        powers[:, 5] = powers[:, 4] * u / 3
        return first, np.matmul(powers[:, TAYLOR], self._begin[first])

    def _spans(self, t: Array) -> Index:
        """The number (S,) of the span that each t lies in, the one to the right at a knot."""
        span = self.times.searchsorted(t, side="right") - 1
        return np.minimum(np.maximum(span, 0), self.times.size - 2)

    def coefficients(self, rows: Array) -> Array:
        """C = Φ⁻¹ Y (eq. 6): rows (M + 2, N) -> B-spline coefficients (M + 2, N)."""
        if isinstance(self._collocation, Tridiagonal):
            return self._collocation.solved(rows[self._order])
        return self._collocation.solve(np.ascontiguousarray(rows))

    def coefficients_transposed(self, gradient: Array) -> Array:
        """Φ⁻ᵀ: the gradient with respect to coefficients pulled back to rows, (M + 2, N) -> (M + 2, N)."""
        if isinstance(self._collocation, Tridiagonal):
            rows = np.empty(gradient.shape)
            rows[self._order] = self._collocation.solved(gradient, transposed=True)
            return rows
        return self._collocation.solve(np.ascontiguousarray(gradient), trans="T")

    def states_and_slopes(self, c: Array) -> Array:
        """(M + 2, N): the states at the times and the slopes at both ends, of coefficients (M + 2, N)."""
        out, at = np.empty(c.shape), self.at_times[:, :, None]
        out[:-2] = at[:, 0] * c[:-2] + at[:, 1] * c[1:-1] + at[:, 2] * c[2:]
        out[-2], out[-1] = self._slopes[0] @ c[:2], self._slopes[1] @ c[-2:]
        return out

    def states_and_slopes_transposed(self, gradient: Array) -> Array:
        """The gradient with respect to `states_and_slopes` as one with respect to coefficients, (M + 2, N)."""
        out, at = np.zeros(gradient.shape), self.at_times[:, :, None]
        for k in range(DEGREE):
            out[k : k + self.times.size] += at[:, k] * gradient[:-2]
        out[:2] += self._slopes[0][:, None] * gradient[-2]
        out[-2:] += self._slopes[1][:, None] * gradient[-1]
        return out

    def rows_by_coefficients(self) -> tuple[Index, Array]:
        """What `states_and_slopes` sums for every row: the first coefficient (M + 2,), and weights of 3 (M + 2, 3)."""
        count = self.times.size
        weights = np.zeros((count + 2, DEGREE))
        weights[:count], weights[count, :2], weights[count + 1, 1:] = self.at_times, *self._slopes
        return np.append(np.arange(count), [0, count - 1]), weights

    def jumps_of(self, factor: complex) -> Complex:
        """(2, M) complex: the jumps, as a map of the states, with which a periodic spline's column comes back as so
        many times itself, a factor of length 1.

        By −1 comes a quaternion after a full turn: smooth across the seam are then −q' and −q'', not q' and q''. By
        exp(iθ) comes a pair of columns, read as x + iy, that is turned by θ.
        """
        start = sparse.vstack([self.basis(self.times[0], k) for k in (1, 2)])
        by_rows = self.coefficients_transposed(start.toarray().T).T
        change = factor - 1
        return np.linalg.solve(np.eye(2) - change * by_rows[:, -2:], change * by_rows[:, :-2]).astype(complex)

    def held_shares(self) -> Array:
        """(2, M + 2): with which shares of all rows the second and the last frame but one keep y'' at both ends.

        They are no shares of each other, nor of themselves.
        """
        seen = self.basis(self.times[[0, -1]], 2).toarray()
        by_rows = self.coefficients_transposed(seen.T).T
        beside = [1, self.times.size - 2]
        own = by_rows[:, beside]
        by_rows[:, beside] = 0
        return np.negative(np.linalg.solve(own, by_rows), dtype=float)

    def evaluate(self, rows: Array, t: ArrayLike, order: int = 0) -> Array:
        """y, y', y'' or y''' at t (S,): (S, N)."""
        return self.basis(t, order) @ self.coefficients(rows)


def _basis_values(knots: Array, span: Index, t: Array) -> Array:
    """(S, 4, 4): values and three derivatives at t of the four cubic B-splines that live on each t's span.

    The triangular scheme of de Boor (A Practical Guide to Splines, ch. X): lower-degree B-splines, then differences.
    """
    near = knots[span[:, None] + np.arange(1 - DEGREE, DEGREE + 1)]
    left, right = near[:, :DEGREE], near[:, DEGREE:]
    before, after = t[:, None] - left, right - t[:, None]

    def share(lower: Array, degree: int) -> Array:
        return lower / (right[:, :degree] - left[:, DEGREE - degree :])

    def raised(part: Array, out: Array) -> Array:
        degree = part.shape[1]
        np.multiply(part, after[:, :degree], out=out[:, :-1])
        out[:, -1] = 0
        out[:, 1:] += part * before[:, DEGREE - degree :]
        return out

    linear = raised(share(np.ones((t.size, 1)), 1), np.empty((t.size, 2)))
    step = share(np.ones((t.size, 1)), 1) * np.array([-1.0, 1.0])
    first = share(linear, 2)
    change = 2 * np.stack([first, share(step, 2)], axis=1)
    lower = np.zeros((t.size, 3, 3))  # degree 2: values and two derivatives
    raised(first, lower[:, 0])
    lower[:, 1:, :-1] -= change
    lower[:, 1:, 1:] += change
    lower /= (right - left)[:, None]
    out = np.zeros((t.size, 4, 4))
    raised(lower[:, 0], out[:, 0])
    lower *= DEGREE
    out[:, 1:, :-1] -= lower
    out[:, 1:, 1:] += lower
    return out


def _four_a_row(first: Index, values: Array, size: int) -> sparse.csr_matrix:
    """(R, size) of values (R, 4) at columns that begin with `first` (R,)."""
    columns = first[:, None] + np.arange(DEGREE + 1)
    starts = np.arange(0, values.size + 1, DEGREE + 1)
    return sparse.csr_matrix((values.ravel(), columns.ravel(), starts), shape=(first.size, size))


@dataclass(frozen=True, eq=False)
class Sampling:
    """A spline seen at sample times: y, y', y'' of any rows, and the pull-back of their gradients (method of §2)."""

    spline: Spline
    t: Array
    first: Index
    values: Array

    @classmethod
    def of(cls, spline: Spline, t: ArrayLike) -> Sampling:
        t = np.asarray(t, float)
        return cls(spline, t, *spline.local(t))

    @cached_property
    def bases(self) -> tuple[sparse.csr_matrix, sparse.csr_matrix, sparse.csr_matrix]:
        """(S, M + 2) each: the B-splines at the sample times, and two derivatives."""
        b0, b1, b2 = (_four_a_row(self.first, self.values[:, k], self.spline.size) for k in range(3))
        return b0, b1, b2

    @cached_property
    def whole(self) -> Piece:
        """All samples as one piece."""
        return self.piece(slice(0, self.t.size))

    def samples(self, rows: Array) -> Array:
        """y, y', y'' at the sample times, (3, S, N)."""
        return self.whole.samples(self.coefficients(rows))

    def pulled_back(self, gradients: Sequence[Array]) -> Array:
        """dE/dY (M + 2, N) from dE/dy, dE/dy', dE/dy'', each (S, N)."""
        total = np.zeros((self.spline.size, gradients[0].shape[1]))
        self.whole.add_pulled_back(total, gradients)
        return self.coefficients_transposed(total)

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
        if count == 1:
            return (self.whole,)
        edges = [self.t.size * k // count for k in range(count + 1)]
        return tuple(self.piece(slice(a, b)) for a, b in pairwise(edges))

    def piece(self, which: slice) -> Piece:
        """Some neighbouring samples."""
        return Piece(which, self.t[which], self.first[which], self.values[which])


@dataclass(frozen=True, eq=False)
class Piece:
    """A run of a sampling's samples.

    which   the samples
    t       (S,) [s]
    first   (S,) the first of the 4 coefficients that each sees
    values  (S, 3, 4) the B-splines of these, and two derivatives
    """

    which: slice
    t: Array
    first: Index
    values: Array

    @cached_property
    def _columns(self) -> Index:
        return self.first[:, None] + np.arange(DEGREE + 1)

    def samples(self, coefficients: Array) -> Array:
        """y, y', y'' (3, S, N) from the spline's coefficients (M + 2, N)."""
        return np.matmul(self.values, coefficients[self._columns]).swapaxes(0, 1)

    @cached_property
    def _seen(self) -> slice:
        """The coefficients that the samples see, C of them."""
        return slice(int(self.first.min()), int(self.first.max()) + DEGREE + 1)

    @cached_property
    def _transposed(self) -> sparse.csc_matrix:
        """(C, 3 S): from gradients of y, y' and y'' of all samples, one below the other, to those of coefficients."""
        values = self.values.swapaxes(0, 1).reshape(-1, DEGREE + 1)
        return _four_a_row(np.tile(self.first - self._seen.start, 3), values, self._seen.stop - self._seen.start).T

    def add_pulled_back(self, into: Array, gradients: Sequence[Array]) -> None:
        """Adds dE/dC from dE/dy, dE/dy', dE/dy'', each (S, N), into (M + 2, N)."""
        into[self._seen] += self._transposed @ np.concatenate(gradients)


@dataclass(frozen=True, eq=False)
class Path:
    """A curve of states over time: a spline and its rows (M + 2, N). Every iterate of the optimiser is one."""

    spline: Spline
    rows: Array

    @cached_property
    def coefficients(self) -> Array:
        """(M + 2, N)"""
        return self.spline.coefficients(self.rows)

    def at(self, t: ArrayLike, order: int = 0) -> Array:
        """The order-th derivative (0-3) of the state at times t (S,): (S, N)."""
        if order == DEGREE:
            return self.spline.basis(t, order) @ self.coefficients
        return self.motion(np.atleast_1d(np.asarray(t, float)))[order]

    def motion(self, t: Array) -> Array:
        """y, y', y'' at times t (S,): (3, S, N)."""
        return Sampling.of(self.spline, t).whole.samples(self.coefficients)

    @property
    def span(self) -> tuple[float, float]:
        """First and last time [s]."""
        return float(self.spline.times[0]), float(self.spline.times[-1])


def spline_of(timeline: Timeline) -> Spline:
    """The spline with a knot at every frame of a timeline, made once."""
    if "spline" not in timeline.of_times:
        timeline.of_times["spline"] = Spline(timeline.times, timeline.ends)
    return timeline.of_times["spline"]


def natural_end_slopes(times: Array, values: Array) -> Array:
    """(2, N): the slopes of `natural_spline` at its first and its last time.

    What a value says of a slope fades by at least a half a knot, so those far away say nothing that a number can hold.
    """
    if times.size > 2 * FELT:
        first, last = (natural_end_slopes(times[run], values[run]) for run in (slice(FELT), slice(-FELT, None)))
        return np.array([first[0], last[1]])
    h = np.diff(times)
    rise = 3 * np.diff(values, axis=0) / h[:, None]
    if times.size == 2:
        return np.repeat(rise / 3, 2, axis=0)
    right = np.empty(values.shape)
    right[0], right[-1] = rise[0], rise[-1]
    right[1:-1] = h[1:, None] * rise[:-1] + h[:-1, None] * rise[1:]
    diagonal = np.full(times.size, 2.0)
    diagonal[1:-1] = 2 * (h[1:] + h[:-1])
    slopes = Tridiagonal(np.append(h[1:], 1.0), diagonal, np.append(1.0, h[:-1])).solved(right)
    return slopes[[0, -1]]


def natural_spline(times: ArrayLike, values: ArrayLike) -> Path:
    """The interpolating C² cubic with y'' = 0 at both ends: the paper's raw spline, componentwise."""
    times, values = np.asarray(times, float), np.asarray(values, float)
    return Path(Spline(times), np.concatenate([values, natural_end_slopes(times, values)]))


def path_of(timeline: Timeline) -> Path:
    """The spline through a timeline's frames."""
    return Path(spline_of(timeline), timeline.rows)
