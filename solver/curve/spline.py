"""The C² cubic B-spline through a timeline's frames (eqs. 2-6).

Samples are a fixed linear map of the frames, and gradients with respect to samples are pulled back to frames by the
transposed map. M frames with a knot each give M + 2 cubic B-splines. The two rows that eq. 5 leaves unspecified are the
end slopes (free, clamped or held) or the two conditions of a periodic curve. The collocation matrix is banded: it is
factorised once, and a solve takes O(M).
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
REACH = 4  # spans on either side of a frame, beyond which it moves the spline by less than 1 % of its own movement
SHORT = 150  # coefficients up to which a dense inverse is faster than a sparse solve
Complex = NDArray[np.complex128]
TAYLOR = np.arange(2, -1, -1)[:, None] + np.arange(DEGREE + 1)  # powers of (t - knot) in y, y', y'' by coefficient


class Spline:
    """Cubic B-splines with one knot at each of M rising times [s], and the map from rows (M + 2, N) to their curve.

    Rows are the states at the times and, below them, the slopes at the first and the last time. With ends "periodic"
    the last two rows are the jumps of y' and y'' from end to start, which are zero for a plain loop; see `jumps_of`.
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
        count = self.times.size
        # the row in which each coefficient is the middle one; with it, the collocation matrix is tridiagonal
        self.order = np.concatenate([[0, count], np.arange(1, count - 1), [count + 1, count - 1]])
        self._collocation = self._close() if ends == "periodic" else Tridiagonal(*self.collocation)

    def _close(self) -> SuperLU:
        from scipy.sparse.linalg import splu  # imported here: slow to load, used by loops alone

        first, last = self.times[[0, -1]]
        closing = [self.basis([last], k) - self.basis([first], k) for k in (1, 2)]
        return splu(sparse.csc_matrix(sparse.vstack([self.basis(self.times, 0), *closing])))

    @property
    def collocation(self) -> tuple[Array, Array, Array]:
        """The lower, middle and upper diagonals of the matrix from coefficients to states and slopes, in `order`."""
        at, (first, last) = self.at_times, self._slopes
        count = self.times.size
        lower, diagonal, upper = np.zeros(count + 1), np.empty(count + 2), np.zeros(count + 1)
        diagonal[[0, 1, -2, -1]] = at[0, 0], first[1], last[0], at[-1, 2]
        lower[0], upper[-1] = first[0], last[1]
        lower[1:-2], diagonal[2:-2], upper[2:-1] = at[1:-1].T
        return lower, diagonal, upper

    @property
    def size(self) -> int:
        """M + 2, the number of basis functions."""
        return self.times.size + 2

    def basis(self, t: ArrayLike, order: int) -> sparse.csr_matrix:
        """Return the order-th derivatives of the B-splines at t (S,) [s]: (S, M + 2), 4 non-zeros per row.

        At a knot the third derivative is the one of the span to the right (at the last knot, to the left).
        """
        t = np.atleast_1d(np.asarray(t, float))
        first = self._spans(t)
        values = _basis_values(self.knots, first + DEGREE, t)[:, order]
        return _four_a_row(first, values, self.size)

    def local(self, t: Array) -> tuple[Index, Array]:
        """Return the first (S,) of the 4 nonzero B-splines at each t (S,), and y, y', y'' of the four, (S, 3, 4)."""
        first = self._spans(t)
        u = t - self.times[first]
        powers = np.zeros((t.size, 6))
        powers[:, 2] = 1
        powers[:, 3] = u
        powers[:, 4] = u * u / 2
        powers[:, 5] = powers[:, 4] * u / 3
        return first, np.matmul(powers[:, TAYLOR], self._begin[first])

    def _spans(self, t: Array) -> Index:
        """Return the index (S,) of the span of each t; at a knot, of the span to the right."""
        span = self.times.searchsorted(t, side="right") - 1
        return np.minimum(np.maximum(span, 0), self.times.size - 2)

    def coefficients(self, rows: Array) -> Array:
        """Return the B-spline coefficients C = Φ⁻¹ Y (M + 2, N) for rows Y (M + 2, N) (eq. 6)."""
        if isinstance(self._collocation, Tridiagonal):
            return self._collocation.solve(rows[self.order])
        return self._collocation.solve(np.ascontiguousarray(rows))

    def coefficients_transposed(self, gradient: Array) -> Array:
        """Return the gradient with respect to rows for one with respect to coefficients, by Φ⁻ᵀ; (M + 2, N)."""
        if isinstance(self._collocation, Tridiagonal):
            rows = np.empty(gradient.shape)
            rows[self.order] = self._collocation.solve(gradient, transposed=True)
            return rows
        return self._collocation.solve(np.ascontiguousarray(gradient), trans="T")

    def states_and_slopes(self, c: Array) -> Array:
        """Return the states at the times and the slopes at both ends, (M + 2, N), for coefficients (M + 2, N)."""
        out, at = np.empty(c.shape), self.at_times[:, :, None]
        out[:-2] = at[:, 0] * c[:-2] + at[:, 1] * c[1:-1] + at[:, 2] * c[2:]
        out[-2], out[-1] = self._slopes[0] @ c[:2], self._slopes[1] @ c[-2:]
        return out

    def states_and_slopes_transposed(self, gradient: Array) -> Array:
        """Return the gradient with respect to coefficients for that with respect to `states_and_slopes`, (M + 2, N)."""
        out, at = np.zeros(gradient.shape), self.at_times[:, :, None]
        for k in range(DEGREE):
            out[k : k + self.times.size] += at[:, k] * gradient[:-2]
        out[:2] += self._slopes[0][:, None] * gradient[-2]
        out[-2:] += self._slopes[1][:, None] * gradient[-1]
        return out

    def jumps_of(self, factor: complex) -> Complex:
        """Return the jumps of y' and y'' of a column that is multiplied by `factor` per period, as a map of the states.

        Args:
            factor: Of modulus 1. It is −1 for a quaternion after a full turn, where −q' and −q'' are continuous across
                the seam; and exp(iθ) for a pair of columns, read as x + iy, that turns by θ.

        Returns:
            The map, (2, M), complex.
        """
        start = sparse.vstack([self.basis(self.times[0], k) for k in (1, 2)])
        by_rows = self.coefficients_transposed(start.toarray().T).T
        change = factor - 1
        return np.linalg.solve(np.eye(2) - change * by_rows[:, -2:], change * by_rows[:, :-2]).astype(complex)

    def evaluate(self, rows: Array, t: ArrayLike, order: int = 0) -> Array:
        """Return the order-th derivative, 0 to 3, at t (S,) [s] for rows (M + 2, N): (S, N)."""
        return self.basis(t, order) @ self.coefficients(rows)


def _basis_values(knots: Array, span: Index, t: Array) -> Array:
    """Return values and three derivatives at t of the four nonzero cubic B-splines of each t's span, (S, 4, 4). The
    triangular scheme of de Boor (A Practical Guide to Splines, ch. X): lower-degree B-splines, then differences."""
    near = knots[span[:, None] + np.arange(1 - DEGREE, DEGREE + 1)]
    below, right = near[:, :DEGREE], near[:, DEGREE:]
    before, after = t[:, None] - below, right - t[:, None]

    def share(lower: Array, degree: int) -> Array:
        return lower / (right[:, :degree] - below[:, DEGREE - degree :])

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
    lower /= (right - below)[:, None]
    out = np.zeros((t.size, 4, 4))
    raised(lower[:, 0], out[:, 0])
    lower *= DEGREE
    out[:, 1:, :-1] -= lower
    out[:, 1:, 1:] += lower
    return out


def _four_a_row(first: Index, values: Array, size: int) -> sparse.csr_matrix:
    """Return a sparse (R, size) matrix with values (R, 4) at columns from `first` (R,) on."""
    columns = first[:, None] + np.arange(DEGREE + 1)
    starts = np.arange(0, values.size + 1, DEGREE + 1)
    return sparse.csr_matrix((values.ravel(), columns.ravel(), starts), shape=(first.size, size))


@dataclass(frozen=True, eq=False)
class Sampling:
    """A spline at sample times: y, y', y'' for any rows, and the pull-back of their gradients (method of §2).

    Attributes:
        t: The sample times, (S,) [s].
        first: The first of the 4 nonzero B-splines at each sample, (S,).
        values: Those B-splines and two derivatives, (S, 3, 4).
        size: The number of B-splines, M + 2.
    """

    spline: Spline
    t: Array
    first: Index
    values: Array
    size: int

    @classmethod
    def of(cls, spline: Spline, t: ArrayLike) -> Sampling:
        t = np.asarray(t, float)
        return cls(spline, t, *spline.local(t), spline.size)

    @cached_property
    def bases(self) -> tuple[sparse.csr_matrix, sparse.csr_matrix, sparse.csr_matrix]:
        """The B-splines at the sample times, and two derivatives, (S, M + 2) each."""
        b0, b1, b2 = (_four_a_row(self.first, self.values[:, k], self.size) for k in range(3))
        return b0, b1, b2

    @cached_property
    def basis_transposed(self) -> sparse.csc_matrix:
        """The transposed B-splines at the sample times, (M + 2, S)."""
        return self.bases[0].T

    @cached_property
    def whole(self) -> Piece:
        return self.piece(slice(0, self.t.size))

    def samples(self, rows: Array) -> Array:
        """Return y, y', y'' at the sample times, (3, S, N), for rows (M + 2, N)."""
        return self.whole.samples(self.coefficients(rows))

    def pulled_back(self, gradients: Sequence[Array]) -> Array:
        """Return dE/dY (M + 2, N) for dE/dy, dE/dy', dE/dy'', each (S, N)."""
        total = np.zeros((self.spline.size, gradients[0].shape[1]))
        self.whole.add_pulled_back(total, gradients)
        return self.coefficients_transposed(total)

    @cached_property
    def _inverse(self) -> Array | None:
        """Φ⁻¹ of a spline so short that a product with it is faster than a sparse solve; else None."""
        return self.spline.coefficients(np.eye(self.spline.size)) if self.spline.size <= SHORT else None

    def coefficients(self, rows: Array) -> Array:
        """Return the spline's `coefficients`; faster for repeated calls."""
        return self.spline.coefficients(rows) if self._inverse is None else self._inverse @ rows

    def coefficients_transposed(self, gradient: Array) -> Array:
        """Return the spline's `coefficients_transposed`; faster for repeated calls."""
        return self.spline.coefficients_transposed(gradient) if self._inverse is None else self._inverse.T @ gradient

    def pieces(self, longest: int) -> tuple[Piece, ...]:
        """Return the samples in nearly equal runs of at most `longest`, whose arrays fit in the cache."""
        count = -(-self.t.size // longest)
        if count == 1:
            return (self.whole,)
        edges = [self.t.size * k // count for k in range(count + 1)]
        return tuple(self.piece(slice(a, b)) for a, b in pairwise(edges))

    def piece(self, which: slice) -> Piece:
        """Return a run of neighbouring samples."""
        return Piece(which, self.t[which], self.first[which], self.values[which])


@dataclass(frozen=True, eq=False)
class Piece:
    """A run of a sampling's samples.

    Attributes:
        t: Their times, (S,) [s].
        first: The first of the 4 coefficients that each depends on, (S,).
        values: The B-splines of these, and two derivatives, (S, 3, 4).
    """

    which: slice
    t: Array
    first: Index
    values: Array

    @cached_property
    def _columns(self) -> Index:
        return self.first[:, None] + np.arange(DEGREE + 1)

    def samples(self, coefficients: Array) -> Array:
        """Return y, y', y'' (3, S, N) for the spline's coefficients (M + 2, N)."""
        return np.matmul(self.values, coefficients[self._columns]).swapaxes(0, 1)

    @cached_property
    def _range(self) -> slice:
        return slice(int(self.first.min()), int(self.first.max()) + DEGREE + 1)

    @cached_property
    def _transposed(self) -> sparse.csc_matrix:
        """The map (C, 3 S) from gradients of y, y' and y'' at all samples, concatenated, to those of coefficients."""
        values = self.values.swapaxes(0, 1).reshape(-1, DEGREE + 1)
        return _four_a_row(np.tile(self.first - self._range.start, 3), values, self._range.stop - self._range.start).T

    def add_pulled_back(self, into: Array, gradients: Sequence[Array]) -> None:
        """Add dE/dC for dE/dy, dE/dy', dE/dy'', each (S, N), to `into` (M + 2, N)."""
        into[self._range] += self._transposed @ np.concatenate(gradients)


@dataclass(frozen=True, eq=False)
class Path:
    """A curve of states over time: a spline and its rows (M + 2, N)."""

    spline: Spline
    rows: Array

    @cached_property
    def coefficients(self) -> Array:
        """The B-spline coefficients, (M + 2, N)."""
        return self.spline.coefficients(self.rows)

    def at(self, t: ArrayLike, order: int = 0) -> Array:
        """Return the order-th derivative, 0 to 3, of the state at times t (S,) [s]: (S, N)."""
        if order == DEGREE:
            return self.spline.basis(t, order) @ self.coefficients
        return self.motion(np.atleast_1d(np.asarray(t, float)))[order]

    def motion(self, t: Array) -> Array:
        """Return y, y', y'' at times t (S,) [s]: (3, S, N)."""
        return Sampling.of(self.spline, t).whole.samples(self.coefficients)

    @property
    def span(self) -> tuple[float, float]:
        """The first and the last time [s]."""
        return float(self.spline.times[0]), float(self.spline.times[-1])


def spline_of(timeline: Timeline) -> Spline:
    """Return the spline with a knot at every frame of a timeline, cached in the timeline."""
    if "spline" not in timeline.of_times:
        timeline.of_times["spline"] = Spline(timeline.times, timeline.ends)
    return timeline.of_times["spline"]


def natural_end_slopes(times: Array, values: Array) -> Array:
    """Return the slopes (2, N) of `natural_spline` at its first and its last time."""
    h = np.diff(times)
    rise = 3 * np.diff(values, axis=0) / h[:, None]
    if times.size == 2:
        return np.repeat(rise / 3, 2, axis=0)
    right = np.empty(values.shape)
    right[0], right[-1] = rise[0], rise[-1]
    right[1:-1] = h[1:, None] * rise[:-1] + h[:-1, None] * rise[1:]
    diagonal = np.full(times.size, 2.0)
    diagonal[1:-1] = 2 * (h[1:] + h[:-1])
    slopes = Tridiagonal(np.append(h[1:], 1.0), diagonal, np.append(1.0, h[:-1])).solve(right)
    return slopes[[0, -1]]


def natural_spline(times: ArrayLike, values: ArrayLike) -> Path:
    """Return the interpolating C² cubic spline with y'' = 0 at both ends, the paper's raw spline.

    Args:
        times: (M,) [s], rising.
        values: (M, N).
    """
    times, values = np.asarray(times, float), np.asarray(values, float)
    return Path(Spline(times), np.concatenate([values, natural_end_slopes(times, values)]))


def path_of(timeline: Timeline) -> Path:
    """Return the spline through a timeline's frames."""
    return Path(spline_of(timeline), timeline.rows)
