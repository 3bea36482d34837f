"""The Gauss-Newton curvature of E, Σ 2 JᵀJ, from the Jacobians J of soft constraints.

A penalty is a sum of squares of residuals. Their Jacobians with respect to (y, y', y'') at a sample define one positive
semidefinite matrix, which omits the residuals' second derivatives. It is the model of the search and the H of the weak
form; E itself does not use it. One-sided residuals are stored separately, because they may become active within a step.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import ENTRIES_AT_ONCE, Array, Index, add_rows_at
from ..figure.kinematics import Samples


class Curvature:
    """Σ 2 JᵀJ over samples, in factored form until the state's derivatives at the samples are known.

    A direction φ is a scalar function of time by which a frame or coefficient moves every entry of the state: y by φ,
    y' by φ', y'' by φ''. The values of K directions at samples are arrays (S, 3, K).

    Attributes:
        samples: The S samples of the motion.
        width: The number N of entries of the state.
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self.width = samples.y.shape[1]
        self._rows: list[
            tuple[Index, Array, Array, tuple[int, ...]]
        ] = []  # samples, roots of weights, Jacobian, orders
        self._blocks: list[tuple[Index, Array]] = []
        self._diagonals: list[Array | None] = [None, None, None]

    def add_rows(self, at: Index, scale: Array, jacobian: Array, orders: tuple[int, ...] = (0, 1, 2)) -> None:
        """Add P residuals with their gradients.

        Args:
            at: The samples, ascending, (P,).
            scale: The weights of the squared residuals, (P,).
            jacobian: The gradients with respect to those of y, y', y'' that `orders` names, (P, k, N).
            orders: Which of y (0), y' (1) and y'' (2), k of them.
        """
        if at.size:
            self._rows.append((at, np.sqrt(2 * scale), jacobian, orders))

    def add_blocks(self, columns: Index, jacobian: Array, scale: Array) -> None:
        """Add residuals of blocks of the state at all samples.

        Args:
            columns: The columns of n blocks of k entries, (n, k).
            jacobian: The gradients of r residuals of each block with respect to y, y' and y'', (S, n, r, 3, k).
            scale: The weights of the squared residuals, (S,).
        """
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
        """Add residuals that are single entries of y, y' or y'', at samples (P,) in columns (P,), times scale (P,)."""
        width = self.width
        added = np.bincount(at * width + column, 2 * scale, self.samples.count * width).astype(float).reshape(-1, width)
        present = self._diagonals[order]
        self._diagonals[order] = added if present is None else present + added

    def add_one_sided(self, sides: OneSidedResiduals, scale: Array) -> None:
        """Add the active ones of one-sided residuals."""
        active = np.flatnonzero(sides.value > 0)
        chosen = sides.select(active[np.argsort(sides.at[active], kind="stable")])
        self.add_rows(chosen.at, scale[chosen.at], chosen.rows[:, None], (0,))

    def rows_by_y(self) -> list[tuple[Index, Array, Array]]:
        """Return the residuals that depend only on y: ascending samples (P,), rows (P, N), and their weights (P,)."""
        return [(at, rows[:, 0], root**2) for at, root, rows, orders in self._rows if orders == (0,)]

    def rows(self, phi: Array, without_y: bool = False) -> list[tuple[Index, Array, Array]]:
        """Return residuals by the coefficients of K directions, as factors of rows (P, K, N).

        Args:
            phi: The directions, (S, 3, K).
            without_y: Whether to omit residuals that depend only on y.

        Returns:
            Ascending samples (P,), factors (P, K, k) and (P, k, N).
        """
        every = [one for one in self._rows if not (without_y and one[3] == (0,))]
        return [(at, phi[at][:, orders].swapaxes(1, 2) * root[:, None, None], rows) for at, root, rows, orders in every]

    def squares(self) -> Iterator[tuple[Index, Array]]:
        """Yield 2 JᵀJ of blocks of columns (n, k), by order and column, (S, n, 3, k, 3, k)."""
        yield from self._blocks
        diagonals = [(order, diagonal) for order, diagonal in enumerate(self._diagonals) if diagonal is not None]
        if diagonals:
            used = np.flatnonzero(np.any([diagonal.any(axis=0) for _, diagonal in diagonals], axis=0))
            out = np.zeros((self.samples.count, used.size, 3, 1, 3, 1))
            for order, diagonal in diagonals:
                out[:, :, order, 0, order, 0] = diagonal[:, used]
            yield used[:, None], out

    @cached_property
    def _by_orders(self) -> list[tuple[Index, Array]]:
        """The columns of blocks (n, k) and their matrices (S, 9, n k²), to be used once all blocks are added."""
        return [
            (columns, blocks.transpose(0, 2, 4, 1, 3, 5).reshape(len(blocks), 9, -1))
            for columns, blocks in self._blocks
        ]

    def quadratic(self, phi: Array, first: int, last: int) -> Array:
        """Return the matrix (N, N) of one direction phi (S, 3), summed over samples first ... last − 1."""
        out = np.zeros((self.width, self.width))
        for at, root, rows, orders in self._rows:
            run = slice(*np.searchsorted(at, [first, last]))
            moved = np.einsum("po,pon->pn", phi[at[run]][:, orders] * root[run, None], rows[run])
            out += moved.T @ moved
        run = slice(first, last)
        pairs = (phi[run, :, None] * phi[run, None, :]).reshape(-1)
        for columns, by_orders in self._by_orders:
            n, k = columns.shape
            total = pairs @ by_orders[run].reshape(pairs.size, n * k * k)
            out[columns[:, :, None], columns[:, None, :]] += total.reshape(n, k, k)
        for order, diagonal in enumerate(self._diagonals):
            if diagonal is not None:
                out[np.diag_indices(self.width)] += phi[run, order] ** 2 @ diagonal[run]
        return out

    def acceleration(self) -> Array:
        """Return the diagonal of y'', (S, N)."""
        out = np.zeros((self.samples.count, self.width))
        for at, root, rows, orders in self._rows:
            if 2 in orders:
                add_rows_at(out, at, (root[:, None] * rows[:, orders.index(2)]) ** 2)
        for columns, blocks in self._blocks:
            out[:, columns] += np.einsum("snkk->snk", blocks[:, :, 2, :, 2])
        return out if self._diagonals[2] is None else out + self._diagonals[2]


@dataclass(frozen=True, eq=False)
class OneSidedResiduals:
    """One-sided residuals.

    Attributes:
        at: The sample of each residual, (P,).
        value: The signed excess over the bound, negative within it, (P,).
        rows: The gradients with respect to y, (P, N).
    """

    at: Index
    value: Array
    rows: Array

    @classmethod
    def join(cls, parts: Sequence[OneSidedResiduals]) -> OneSidedResiduals:
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "value", "rows")))

    def shift(self, first: int) -> OneSidedResiduals:
        return OneSidedResiduals(self.at + first, self.value, self.rows)

    def select(self, indices: Index) -> OneSidedResiduals:
        return OneSidedResiduals(self.at[indices], self.value[indices], self.rows[indices])

    def changes(self, change: Array) -> Array:
        """Return the changes (P,) of the residuals for a change (S, N) of y."""
        changes = np.empty(self.at.size)
        few = max(1, ENTRIES_AT_ONCE // self.rows.shape[1])
        for first in range(0, changes.size, few):
            run = slice(first, first + few)
            np.einsum("pn,pn->p", self.rows[run], change[self.at[run]], out=changes[run])
        return changes

    def pull_back(self, forces: Array, into: Array) -> None:
        """Add the gradient of forces · residuals, for forces (P,), to `into` (S, N)."""
        nonzero = np.flatnonzero(forces)
        if nonzero.size:
            add_rows_at(into, self.at[nonzero], forces[nonzero, None] * self.rows[nonzero])
