"""The Gauss-Newton curvature of E, Σ 2 JᵀJ, from the soft constraints' Jacobians J.

Every penalty is a sum of squares of residuals. Their Jacobians with respect to (y, y', y'') at a sample give one
matrix, never negative: it leaves out the residuals' own second derivatives. It serves the search as its model and the
weak form as its H, never E itself. Residuals that count on one side only, like depths, are kept apart: whether they
count changes within a step.

Jacobian rows that go through the figure's kinematics come from its adjoint sweep on copies of the samples, one a row.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ..array import Array, Index
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .one_sided import OneSidedResiduals

ROWS_AT_ONCE = 400  # copies of samples that an adjoint sweep takes at once: they stay in cache
DIFFERENCE = 1e-6  # of a state's size, between the gradients of a difference


class Curvature:
    """Σ 2 JᵀJ over samples, in factored form until the state's derivatives at the samples are given.

    A direction φ is a scalar function of time by which a frame or a coefficient moves every entry of the state alike:
    y by φ, y' by φ', y'' by φ''. Samples see K such functions, values (S, 3, K).
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self.width = samples.y.shape[1]
        self._rows: list[tuple[Index, Array, tuple[int, ...]]] = []
        self._blocks: list[tuple[Index, Array]] = []
        self._diagonals: list[Array | None] = [None, None, None]

    def add_rows(self, at: Index, scale: Array, jacobian: Array, orders: tuple[int, ...] = (0, 1, 2)) -> None:
        """Residuals at samples `at` (P,), rising, with gradients (P, k, N) in some of y, y', y''; times scale (P,)."""
        if at.size:
            self._rows.append((at, jacobian * np.sqrt(2 * scale)[:, None, None], orders))

    def add_blocks(self, columns: Index, jacobian: Array, scale: Array) -> None:
        """Residuals of n blocks of k columns (n, k), Jacobians (S, n, r, 3, k) at every sample, times scale (S,)."""
        if not columns.size:
            return
        count, n, residuals, _, k = jacobian.shape
        j = (jacobian * np.sqrt(2 * scale)[:, None, None, None, None]).reshape(count, n, residuals, 3 * k)
        squared = np.matmul(j.swapaxes(2, 3), j).reshape(count, n, 3, k, 3, k)
        for there, total in self._blocks:
            if np.array_equal(there, columns):
                total += squared
                return
        self._blocks.append((columns, squared))

    def add_diagonal(self, at: Index, column: Index, order: int, scale: Array) -> None:
        """Residuals that are single entries of y, y' or y'', at samples (P,) in columns (P,), times scale (P,)."""
        width = self.width
        added = np.bincount(at * width + column, 2 * scale, self.samples.count * width).astype(float).reshape(-1, width)
        present = self._diagonals[order]
        self._diagonals[order] = added if present is None else present + added

    def add_one_sided(self, sides: OneSidedResiduals, scale: Array) -> None:
        """One-sided residuals, those of them that count."""
        active = np.flatnonzero(sides.value > 0)
        order, at = np.argsort(sides.at[active], kind="stable"), sides.at[active]
        self.add_rows(at[order], scale[at[order]], sides.select(active)[order, None], (0,))

    def rows_by_y(self) -> list[tuple[Index, Array]]:
        """Residuals that depend on y alone: samples (P,), rising, and rows (P, N)."""
        return [(at, rows[:, 0]) for at, rows, orders in self._rows if orders == (0,)]

    def rows(self, phi: Array, without_y: bool = False) -> list[tuple[Index, Array]]:
        """Residuals by the coefficients of K directions phi (S, 3, K): samples (P,) and rows (P, K N).

        without_y  leaves those out that depend on y alone
        """
        every = [one for one in self._rows if not (without_y and one[2] == (0,))]
        gathered = [(at, np.ascontiguousarray(phi[at][:, orders].swapaxes(1, 2)), rows) for at, rows, orders in every]
        local = [(at, np.matmul(directions, rows)) for at, directions, rows in gathered]
        return [(at, rows.reshape(at.size, -1)) for at, rows in local]

    def squares(self) -> Iterator[tuple[Index, Array]]:
        """2 JᵀJ of blocks of columns (n, k), by order and column: (S, n, 3, k, 3, k)."""
        yield from self._blocks
        for order, diagonal in enumerate(self._diagonals):
            if diagonal is not None:
                used = np.flatnonzero(diagonal.any(axis=0))
                out = np.zeros((len(diagonal), used.size, 3, 1, 3, 1))
                out[:, :, order, 0, order, 0] = diagonal[:, used]
                yield used[:, None], out

    def blocks(self, phi: Array, together: int = 1) -> list[tuple[Index, Array]]:
        """Matrices of n blocks of k columns (n, k) by the coefficients of K directions: (S, n, K, k, K, k).

        Those of every so many neighbouring samples `together` are summed, S is less by as much.
        """
        count, directions = len(phi) // together, phi.shape[2]
        result = []
        pairs = phi[:, :, None, :, None] * phi[:, None, :, None, :]
        pairs = pairs.reshape(count, together * 9, -1).swapaxes(1, 2)
        for columns, blocks in self._blocks:
            n, k = columns.shape
            by_orders = blocks.transpose(0, 2, 4, 1, 3, 5).reshape(count, together * 9, -1)
            local = np.matmul(pairs, by_orders).reshape(count, directions, directions, n, k, k)
            result.append((columns, local.transpose(0, 3, 1, 4, 2, 5)))
        for order, diagonal in enumerate(self._diagonals):
            if diagonal is not None:
                used = np.flatnonzero(diagonal.any(axis=0))
                one = phi[:, order].reshape(count, together, -1)
                pairs = (one[:, :, :, None] * one[:, :, None, :]).reshape(count, together, -1)
                parts = np.matmul(diagonal[:, used].reshape(count, together, -1).swapaxes(1, 2), pairs)
                result.append((used[:, None], parts.reshape(count, used.size, directions, 1, directions, 1)))
        return result

    def quadratic(self, phi: Array, first: int, last: int) -> Array:
        """(N, N): Σ over samples first ... last − 1 in the one direction phi (S, 3)."""
        out = np.zeros((self.width, self.width))
        for at, rows, orders in self._rows:
            begin, end = np.searchsorted(at, [first, last])
            moved = np.einsum("po,pon->pn", phi[at[begin:end]][:, orders], rows[begin:end])
            out += moved.T @ moved
        run = slice(first, last)
        for columns, blocks in self._blocks:
            n, k = columns.shape
            pairs = (phi[run, :, None] * phi[run, None, :]).reshape(-1)
            by_orders = blocks[run].transpose(0, 2, 4, 1, 3, 5).reshape(pairs.size, n * k * k)
            out[columns[:, :, None], columns[:, None, :]] += (pairs @ by_orders).reshape(n, k, k)
        for order, diagonal in enumerate(self._diagonals):
            if diagonal is not None:
                out[np.diag_indices(self.width)] += phi[run, order] ** 2 @ diagonal[run]
        return out

    def acceleration(self) -> Array:
        """(S, N): the diagonal in y''."""
        out = np.zeros((self.samples.count, self.width))
        for at, rows, orders in self._rows:
            if 2 in orders:
                np.add.at(out, at, rows[:, orders.index(2)] ** 2)
        for columns, blocks in self._blocks:
            out[:, columns] += np.einsum("snkk->snk", blocks[:, :, 2, :, 2])
        return out if self._diagonals[2] is None else out + self._diagonals[2]


def jacobian(samples: Samples, at: Index, seeded: Callable[[Samples, Cotangent, Index], None]) -> Array:
    """(P, 3, N): the gradients of P residuals at samples `at` (P,) with respect to y, y', y''.

    seeded(copies, cotangent, rows) adds each row's seed, rows (R,), to the cotangent of the copied samples (R).
    """
    out = np.empty((at.size, 3, samples.y.shape[1]))
    for first in range(0, at.size, ROWS_AT_ONCE):
        rows = np.arange(first, min(first + ROWS_AT_ONCE, at.size))
        copies = samples.select(at[rows])
        cotangent = Cotangent(copies)
        seeded(copies, cotangent, rows)
        out[rows] = np.stack(cotangent.gradients(), axis=1)
    return out


def add_differences(
    evaluate: Callable[[Samples, Cotangent, Array], Array], samples: Samples, into: Curvature, scale: Array
) -> None:
    """The second derivatives of any penalty from differences of its gradients, negative curvature made positive."""
    count, width = samples.y.shape
    base = np.hstack([samples.y, samples.y_d, samples.y_dd])

    def gradients(moved: Array, copies: int) -> Array:
        shifted = Samples(samples.figure, *np.split(moved, 3, axis=1), t=np.tile(samples.t, copies))
        cotangent = Cotangent(shifted)
        evaluate(shifted, cotangent, np.tile(scale, copies))
        return np.hstack(cotangent.gradients()).reshape(copies, count, -1)

    here = gradients(base, 1)[0]
    hessian = np.empty((count, 3 * width, 3 * width))
    together = max(1, ROWS_AT_ONCE // count)
    size = DIFFERENCE * np.maximum(np.sqrt(np.mean(base.reshape(count, 3, width) ** 2, axis=(0, 2))), 1.0)
    for first in range(0, 3 * width, together):
        columns = np.arange(first, min(first + together, 3 * width))
        h = size[columns // width]
        moved = np.tile(base, (columns.size, 1)).reshape(columns.size, count, -1)
        moved[np.arange(columns.size), :, columns] += h[:, None]
        there = gradients(moved.reshape(-1, 3 * width), columns.size)
        hessian[:, columns] = ((there - here) / h[:, None, None]).transpose(1, 0, 2)
    eigenvalues, vectors = np.linalg.eigh((hessian + hessian.transpose(0, 2, 1)) / 2)
    rows = (vectors * np.sqrt(np.abs(eigenvalues))[:, None, :]).transpose(0, 2, 1)
    at = np.repeat(np.arange(count), 3 * width)
    into.add_rows(at, np.full(at.size, 0.5), rows.reshape(-1, 3, width))
