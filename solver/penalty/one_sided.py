"""One-sided residuals, such as depths. In a model of E each adds max(0, value + row · δy)² for a step δy of the state.

The gradients of many points on one link are stored as linear combinations of the rows of the link's Jacobian.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..array import Array, Index, add_rows_at

ENTRIES_AT_ONCE = 500_000  # [1] largest number of array entries that are copied at once, 4 MB
FAINT = 1e-13  # [1] share of a matrix's trace added to its diagonal, so that its Cholesky factor exists
TINY = 1e-300  # [1] summand that makes zero matrices positive definite


@dataclass(frozen=True, eq=False)
class Rows:
    """Gradients of P residuals with respect to y: row p is shares_p · basis_r, r = of_p.

    Attributes:
        of: The index of the basis of each residual, (P,).
        shares: The coefficients of the linear combinations, (P, k).
        at: The sample of each basis, (R,).
        basis: The basis vectors, (R, k, N).
    """

    of: Index
    shares: Array
    at: Index
    basis: Array

    @classmethod
    def plain(cls, at: Index, rows: Array) -> Rows:
        """Return gradients (P, N) at samples (P,), each stored with a separate basis."""
        return cls(np.arange(at.size), np.ones((at.size, 1)), at, rows[:, None])

    @property
    def is_plain(self) -> bool:
        """Whether every gradient is stored with a separate basis of one vector."""
        return self.shares.shape[1] == 1

    def select(self, indices: Index) -> Array:
        """Return the gradients with given indices (A,), (A, N)."""
        if self.is_plain:
            return self.basis[indices, 0]
        return np.einsum("ak,akn->an", self.shares[indices], self.basis[self.of[indices]])

    def moved(self, change: Array) -> Array:
        """Return the changes (P,) of the residuals for a change (S, N) of y."""
        changes = np.empty(self.basis.shape[:2])
        few = max(1, ENTRIES_AT_ONCE // self.basis.shape[2])
        for first in range(0, len(changes), few):
            run = slice(first, first + few)
            np.einsum("rkn,rn->rk", self.basis[run], change[self.at[run]], out=changes[run])
        return changes[:, 0] if self.is_plain else np.einsum("pk,pk->p", self.shares, changes[self.of])

    def pull_back(self, forces: Array, into: Array) -> None:
        """Add the gradient of forces · residuals, for forces (P,), to `into` (S, N)."""
        nonzero = np.flatnonzero(forces)
        if not nonzero.size:
            return
        if self.is_plain:
            felt, rows = nonzero, forces[nonzero, None] * self.basis[nonzero, 0]
        else:
            total = np.zeros((len(self.basis), self.shares.shape[1]))
            for k, share in enumerate(self.shares[nonzero].T):
                total[:, k] = np.bincount(self.of[nonzero], forces[nonzero] * share, len(self.basis))
            felt = np.unique(self.of[nonzero])
            rows = np.einsum("rk,rkn->rn", total[felt], self.basis[felt])
        add_rows_at(into, self.at[felt], rows)

    def squared(self, indices: Index, factor: Array) -> tuple[Index, Array]:
        """Return samples (A,) and rows (A, N) with Σ rowᵀrow at every sample of some rows, each with a factor."""
        if self.is_plain:
            return self.at[indices], factor[:, None] * self.basis[indices, 0]
        k = self.shares.shape[1]
        of, shares = self.of[indices], factor[:, None] * self.shares[indices]
        many = np.bincount(of, minlength=len(self.basis)) > k
        is_alone = ~many[of]
        at, rows = self.at[of[is_alone]], np.einsum("ak,akn->an", shares[is_alone], self.basis[of[is_alone]])
        if not many.any():
            return at, rows
        together = np.flatnonzero(~is_alone)
        together = together[np.argsort(of[together], kind="stable")]
        first = np.flatnonzero(np.diff(of[together], prepend=-1))
        shares, which = shares[together], of[together[first]]
        square = np.add.reduceat(shares[:, :, None] * shares[:, None, :], first)
        square += FAINT * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(k) + TINY * np.eye(k)
        half = np.linalg.cholesky(square).swapaxes(1, 2) @ self.basis[which]
        return np.append(at, np.repeat(self.at[which], k)), np.concatenate([rows, half.reshape(-1, half.shape[2])])


@dataclass(frozen=True, eq=False)
class OneSidedResiduals:
    """One-sided residuals.

    Attributes:
        at: The sample of each residual, (P,).
        value: The signed excess over the bound, negative within it, (P,).
    """

    at: Index
    value: Array
    gradients: tuple[Rows, ...]

    @classmethod
    def joined(cls, parts: Sequence[OneSidedResiduals]) -> OneSidedResiduals:
        at, value = (np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "value"))
        return cls(at, value, tuple(rows for part in parts for rows in part.gradients))

    def shifted(self, first: int) -> OneSidedResiduals:
        gradients = tuple(replace(rows, at=rows.at + first) for rows in self.gradients)
        return OneSidedResiduals(self.at + first, self.value, gradients)

    @property
    def rows(self) -> Array:
        """All gradients, (P, N)."""
        return self.select(np.arange(self.at.size))

    def parts(self) -> Iterator[tuple[slice, Rows]]:
        """Yield the residuals by kind of gradient."""
        first = 0
        for rows in self.gradients:
            yield slice(first, first + rows.of.size), rows
            first += rows.of.size

    def sorted(self) -> tuple[OneSidedResiduals, Index]:
        """Return the residuals with the plain ones first, as one part sorted by sample; and their permutation (P,)."""
        plain = [(run, rows) for run, rows in self.parts() if rows.is_plain]
        others = [(run, rows) for run, rows in self.parts() if not rows.is_plain]
        if not plain:
            return self, np.arange(self.at.size)
        place = np.concatenate([np.arange(run.start, run.stop) for run, _ in plain])
        by_sample = np.argsort(self.at[place], kind="stable")
        basis = np.concatenate([rows.basis[:, 0] for _, rows in plain])[by_sample]
        order = np.concatenate([place[by_sample], *(np.arange(run.start, run.stop) for run, _ in others)])
        rows = Rows.plain(self.at[place[by_sample]], basis), *(rows for _, rows in others)
        return OneSidedResiduals(self.at[order], self.value[order], rows), order

    def select(self, ascending: Index) -> Array:
        """Return the gradients (A, N) of ascending indices."""
        gradients = []
        for run, rows in self.parts():
            indices = (
                ascending[np.searchsorted(ascending, run.start) : np.searchsorted(ascending, run.stop)] - run.start
            )
            if indices.size:
                gradients.append(rows.select(indices))
        return np.concatenate(gradients) if gradients else np.zeros((0, 0))
