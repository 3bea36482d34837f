"""The steps that a search may take: curves that are zero wherever a whole keyframe, or an end slope, is given.

Each such condition takes one of the spline's coefficients away: it follows from its neighbours. A sample still sees
four of those that are left, so all that is made of B-splines is made of these as well.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..array import Array, Index, Mask
from ..curve.banded import Tridiagonal
from ..curve.spline import DEGREE, Piece, Spline

LOCAL = DEGREE + 1  # coefficients that a sample sees


@dataclass(frozen=True, eq=False)
class Steps:
    """Splines by C of their M + 2 coefficients.

    count   C
    beside  (M + 2, 2) the two coefficients, of the C, that each one follows from; and their shares (M + 2, 2)
    first   (M − 1,) the first of the four, of the C, that each span sees
    """

    count: int
    beside: Index
    shares: Array
    first: Index

    @classmethod
    def of(cls, spline: Spline, fixed: Mask) -> Steps:
        """Those of which some rows of the spline's `states_and_slopes`, fixed (M + 2,), are zero.

        All steps, if there would be fewer than four coefficients.
        """
        size, last = spline.size, spline.times.size - 1
        if size - np.count_nonzero(fixed) < LOCAL:
            fixed = np.zeros(size, bool)
        rows = np.flatnonzero(fixed)
        follows = np.concatenate([[0], np.arange(2, last + 1), [last + 2, 1, last + 1]])[rows]
        rows, follows = rows[np.argsort(follows)], np.sort(follows)
        kept = np.ones(size, bool)
        kept[follows] = False
        place = np.cumsum(kept) - 1  # of a kept coefficient; of another, of the one before it
        count = int(place[-1]) + 1
        beside = np.column_stack([place, place])
        beside[follows, 1] += 1
        shares = np.zeros((size, 2))
        shares[kept, 0] = 1.0
        if rows.size:
            shares[follows] = _shares(spline, rows, follows, kept)
        beside, first = beside.clip(0, count - 1), place[:last].clip(0, count - LOCAL)
        return cls(count, beside, shares, first)

    def to_spline(self, steps: Array) -> Array:
        """The spline's coefficients (M + 2, N) of these (C, N)."""
        return np.einsum("mk,mkn->mn", self.shares, steps[self.beside])

    def from_spline(self, gradient: Array) -> Array:
        """A gradient with respect to the spline's coefficients (M + 2, N) as one with respect to these, (C, N)."""
        out = np.zeros((self.count, gradient.shape[1]))
        np.add.at(out, self.beside, self.shares[:, :, None] * gradient[:, None])
        return out

    @cached_property
    def by_span(self) -> Array:
        """(M − 1, 4, 4): a span's four coefficients of the spline from the four that it sees here."""
        spans = np.arange(self.first.size)
        out = np.zeros((spans.size, LOCAL, LOCAL))
        for a in range(LOCAL):
            for side in range(2):
                share = self.shares[spans + a, side]
                at = np.where(share != 0, self.beside[spans + a, side] - self.first, 0)
                out[spans, a, at] += share
        return out

    def piece(self, piece: Piece) -> Piece:
        """The same samples as these coefficients see them."""
        values = np.matmul(piece.values, self.by_span[piece.first])
        return replace(piece, first=self.first[piece.first], values=values)

    def weights(self, first: Index, weights: Array) -> tuple[Index, Array]:
        """Sums of up to four neighbouring coefficients of the spline, the first (R,), weights (R, k, ...): the first
        (R,) and weights (R, 4, ...) of those here."""
        span = np.minimum(first, self.first.size - 1)
        padded = np.zeros((first.size, LOCAL, *weights.shape[2:]))
        for k in range(weights.shape[1]):
            padded[np.arange(first.size), first - span + k] = weights[:, k]
        return self.first[span], np.einsum("rab,ra...->rb...", self.by_span[span], padded)


def _shares(spline: Spline, rows: Index, follows: Index, kept: Mask) -> Array:
    """(R, 2): how coefficients `follows` (R,) that make rows of the spline zero follow from the next kept ones on
    either side. Those of neighbours follow from each other, too: a matrix of three diagonals."""
    begin, weights = spline.rows_by_coefficients()
    dense = np.zeros((rows.size, 3))  # at the coefficient before, itself, the one after
    for k in range(DEGREE):
        at = begin[rows] + k - follows + 1
        inside = (at >= 0) & (at < 3)
        dense[np.flatnonzero(inside), at[inside]] += weights[rows[inside], k]
    near = np.clip(follows[:, None] + [-1, 1], 0, kept.size - 1)
    right = np.where(kept[near], -dense[:, [0, 2]], 0.0)
    joined = ~kept[near] & (near != follows[:, None])
    lower, upper = (dense[:, 0] * joined[:, 0])[1:], (dense[:, 2] * joined[:, 1])[:-1]
    if rows.size > 2:
        return Tridiagonal(lower, dense[:, 1], upper).solved(right)
    return np.asarray(np.linalg.solve(np.diag(dense[:, 1]) + np.diag(lower, -1) + np.diag(upper, 1), right), float)
