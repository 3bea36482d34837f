"""The Gauss-Newton curvature of E: what the soft constraints' Jacobians J say of its second derivatives, Σ 2 JᵀJ.

Every penalty is a sum of squares of residuals. Their Jacobians with respect to (y, y', y'') at a sample make one
symmetric matrix, never negative: it leaves out the residuals' own second derivatives. It serves the search as its
model and the weak form as its H, never E itself. Residuals that count on one side only, like depths, are kept apart:
whether they count changes within a step.

Jacobian rows that go through the figure's kinematics come from its adjoint sweep on copies of the samples, one a row.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from .kinematics import Cotangent, Samples
from .quaternion import Array, Index

ROWS_AT_ONCE = 400
DIFFERENCE = 1e-6


class Curvature:
    """Σ 2 JᵀJ at every sample: matrix (S, 3, N, 3, N) over the entries of y, y' and y''."""

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        count, width = samples.y.shape
        self.matrix = np.zeros((count, 3, width, 3, width))

    @property
    def flat(self) -> Array:
        """(S, 3 N, 3 N), the same memory."""
        count, width = self.samples.y.shape
        return self.matrix.reshape(count, 3 * width, 3 * width)

    def add_rows(self, at: Index, scale: Array, jacobian: Array, order: int | None = None) -> None:
        """Residuals at samples `at` (P,) with rows (P, N) in one of y, y', y'', or (P, 3 N) in all, times scale (P,)."""
        block = self.flat if order is None else self.matrix[:, order, :, order]
        ranked = np.argsort(at, kind="stable")
        at, weighted = at[ranked], jacobian[ranked] * np.sqrt(2 * scale[ranked])[:, None]
        edges = np.flatnonzero(np.diff(at)) + 1
        for first, last in zip(np.append(0, edges), np.append(edges, at.size), strict=True):
            if first < last:
                rows = weighted[first:last]
                block[at[first]] += rows.T @ rows

    def add_blocks(self, columns: Index, jacobian: Array, scale: Array) -> None:
        """Residuals of one block of k columns (k,), Jacobians (S, r, 3, k) at every sample, times scale (S,)."""
        count, width = self.samples.y.shape
        j = (jacobian * np.sqrt(2 * scale)[:, None, None, None]).reshape(count, jacobian.shape[1], -1)
        where = (width * np.arange(3)[:, None] + columns).ravel()
        self.flat[:, where[:, None], where] += np.matmul(j.transpose(0, 2, 1), j)

    def add_squares(self, columns: Index, order: int, scale: Array) -> None:
        """Residuals that are entries of y, y' or y'' themselves, times scale (S,)."""
        self.matrix[:, order, columns, order, columns] += 2 * scale[:, None]


@dataclass(frozen=True)
class Sides:
    """Residuals that count on one side only: each adds max(0, value + row · δy)² when the state moves by δy.

    at     (P,) sample of each
    value  (P,) how far it is over its bound, negative below
    rows   (P, N) its gradient with respect to y
    """

    at: Index
    value: Array
    rows: Array

    @classmethod
    def joined(cls, parts: Sequence[Sides]) -> Sides:
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "value", "rows")))


def jacobian(samples: Samples, at: Index, seeded: Callable[[Samples, Cotangent, Index], None]) -> Array:
    """(P, 3 N): the gradients of P residuals at samples `at` (P,) with respect to y, y', y''.

    seeded(copies, cotangent, rows) adds each row's seed, rows (R,), to the cotangent of the copied samples (R).
    """
    out = np.empty((at.size, 3 * samples.y.shape[1]))
    for first in range(0, at.size, ROWS_AT_ONCE):
        rows = np.arange(first, min(first + ROWS_AT_ONCE, at.size))
        copies = samples.taken(at[rows])
        cotangent = Cotangent(copies)
        seeded(copies, cotangent, rows)
        out[rows] = np.hstack(cotangent.gradients())
    return out


def add_differences(
    evaluate: Callable[[Samples, Cotangent, Array], Array], samples: Samples, into: Curvature, scale: Array
) -> None:
    """The second derivatives of any penalty from differences of its gradients, negative curvature made positive."""
    count, width = samples.y.shape
    base = np.hstack([samples.y, samples.y_d, samples.y_dd])

    def gradients(moved: Array, copies: int) -> Array:
        seen = Samples(samples.figure, *np.split(moved, 3, axis=1), t=np.tile(samples.t, copies))
        cotangent = Cotangent(seen)
        evaluate(seen, cotangent, np.tile(scale, copies))
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
    into.flat[:] += (vectors * np.abs(eigenvalues)[:, None, :]) @ vectors.transpose(0, 2, 1)
