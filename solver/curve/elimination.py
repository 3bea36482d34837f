"""A basis of the splines that are zero at held rows, so that steps in it leave whole keyframes exact.

Each held row of the collocation matrix determines one B-spline coefficient from its two neighbours. A run of such
coefficients depends on the free ones before and after it. The functions of the new basis are therefore local, too: of
them, 4 consecutive ones are nonzero in a span.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import sparse

from ..array import Array, Mask
from .banded import Tridiagonal
from .spline import DEGREE, Sampling, Spline

LOCAL = DEGREE + 1  # functions that are nonzero at a sample


class Elimination:
    """The map c = T u from steps u (n, N) to steps c (M + 2, N) of a spline's coefficients that keep held rows zero.

    Attributes:
        held: Which rows are zero, (M + 2,).
        count: The number of functions in the basis.
        size: The number of columns of T, n: `count`, but at least 4. Further columns are zero.
        matrix: T, sparse (M + 2, n); `transposed` is Tᵀ.
    """

    def __init__(self, spline: Spline, held: Mask) -> None:
        self.held, is_eliminated = held, held[spline.order]
        free = np.flatnonzero(~is_eliminated)
        self.count, self.size = free.size, max(free.size, LOCAL)
        # indices of the free coefficients before and after each held one, and the weights of both
        before = np.cumsum(~is_eliminated) - 1
        columns = np.clip(np.column_stack([before, before + 1]), 0, self.count - 1)
        weights = -_influence(spline, is_eliminated)
        weights[free] = 1.0, 0.0
        largest = np.zeros(self.size)
        np.maximum.at(largest, columns, np.abs(weights))
        weights /= largest[columns]  # keyframes at very uneven times would give functions of very different sizes
        index = np.repeat(np.arange(spline.size), 2)
        self.matrix = sparse.csr_matrix((weights.ravel(), (index, columns.ravel())), (spline.size, self.size))
        self.transposed = self.matrix.T.tocsr()
        self._first = np.clip(before[: 1 - LOCAL], 0, self.size - LOCAL)
        self._local = np.zeros((self._first.size, LOCAL, LOCAL))  # T by span, its four coefficients, and functions
        spans = np.arange(self._first.size)
        for a in range(LOCAL):
            for column, weight in zip(columns.T, weights.T, strict=True):
                used = spans[weight[spans + a] != 0]
                self._local[used, a, column[used + a] - self._first[used]] += weight[used + a]

    def sample(self, sampling: Sampling) -> Sampling:
        """Return the functions of this basis at the sample times of its spline."""
        values = np.matmul(sampling.values, self._local[sampling.first])
        return replace(sampling, first=self._first[sampling.first], values=values, size=self.size)


def _influence(spline: Spline, held: Mask) -> Array:
    """Return B⁻¹ b (M + 2, 2) of the held rows B, for their entries b in the free coefficients before and after."""
    lower, diagonal, upper = spline.collocation
    entries = np.zeros((held.size, 2))
    entries[1:, 0], entries[:-1, 1] = lower, upper
    beyond = np.ones((held.size, 2), bool)
    beyond[1:, 0], beyond[:-1, 1] = ~held[:-1], ~held[1:]
    inner = np.where(beyond | ~held[:, None], 0.0, entries)
    matrix = Tridiagonal(inner[1:, 0], np.where(held, diagonal, 1.0), inner[:-1, 1])
    return matrix.solve(np.where(beyond & held[:, None], entries, 0.0))
