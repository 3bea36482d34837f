"""Residual blocks of soft constraints, with value, gradient and curvature.

    f = Σ weight r², or Σ weight max(0, r)² for one-sided residuals

The derivative of a residual r has one of three forms: wrenches, if r depends on links (see `figure.wrenches`); single
entries of y, y' or y''; or a function for the product with a vector (`Dense`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..array import Array, Index, add_rows_at
from ..figure.adjoint import OF_THE_STATE, Cotangent
from ..figure.kinematics import Samples
from ..figure.wrenches import Wrenches
from .curvature import Curvature, OneSidedResiduals


@dataclass(frozen=True, eq=False)
class Entries:
    """Derivatives of P residuals, each with respect to a single entry of y, y' or y''.

    Attributes:
        at: Indices of the samples, (P,).
        order: 0, 1 or 2, for an entry of y, y' or y''.
        column: Columns of the entries, (P,).
        slope: Derivatives with respect to the entries, (P,).
    """

    at: Index
    order: int
    column: Index
    slope: Array | float = 1.0

    def select(self, indices: Index) -> Entries:
        """Return the derivatives of the residuals with these indices."""
        slope = self.slope if isinstance(self.slope, float) else self.slope[indices]
        return replace(self, at=self.at[indices], column=self.column[indices], slope=slope)

    @property
    def orders(self) -> int:
        """The number of gradients in `rows`: 1 for y, 2 for y and y', 3 for y, y' and y''."""
        return self.order + 1

    def rows(self, samples: Samples) -> Array:
        """Return the gradients, (P, order + 1, N)."""
        out = np.zeros((self.at.size, self.order + 1, samples.y.shape[1]))
        out[np.arange(self.at.size), self.order, self.column] = self.slope
        return out

    def pull_back(self, into: Cotangent, bar: Array) -> None:
        """Add the gradient of Σ_p bar[p] · r[p] to `into`, bar (P,)."""
        buffer = into.buffer(OF_THE_STATE[self.order][0])
        flat = self.at * buffer.shape[1] + self.column
        buffer += np.bincount(flat, bar * self.slope, buffer.size).reshape(buffer.shape)


Change = Wrenches | Entries


@dataclass(frozen=True, eq=False)
class Block:
    """P residuals with their derivatives.

    Attributes:
        at: Indices of the residuals' samples, (P,).
        value: Residuals, (P,).
        changes: The derivatives of the residuals: the sum of the parts in this tuple. `Wrenches` contains derivatives
            with respect to the motion of links, `Entries` with respect to entries of the state. Each part has one item
            per residual, in the same order, unless `of` is given.
        weight: Weights of the squared residuals, (P,).
        one_sided: Whether only positive residuals count.
        curved: curved(curvature, scale) adds the matrices of Σ_s scale_s f(s), scale (S,), to `curvature`, for a model
            that differs from that of Gauss and Newton. None: the Gauss-Newton matrices.
        of: If residuals have several wrenches each: for each of the Q wrenches, the index of its residual, (Q,).
            Otherwise None.
    """

    at: Index
    value: Array
    changes: tuple[Change, ...]
    weight: Array | float = 1.0
    one_sided: bool = False
    of: Index | None = None
    curved: Callable[[Curvature, Array], None] | None = None

    @classmethod
    def join(cls, parts: Sequence[Block]) -> Block:
        """Concatenate blocks of one-sided residuals with one wrench each. Without parts, the block is empty."""
        none = np.zeros(0, np.intp)
        if not parts:
            return cls(none, np.zeros(0), (Wrenches(none, none, np.zeros((3, 0))),), one_sided=True)
        at, value = (np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "value"))
        changes = zip(*(part.changes for part in parts), strict=True)
        return cls(at, value, tuple(Wrenches.join(parts_of_kind) for parts_of_kind in changes), one_sided=True)

    @cached_property
    def counted(self) -> Array:
        """The residuals, (P,), zero for inactive one-sided ones."""
        return np.maximum(self.value, 0) if self.one_sided else self.value

    def values(self, count: int) -> Array:
        """Return the penalty f at every sample, (S,): the weighted sum of the sample's squared residuals."""
        return np.bincount(self.at, self.weight * self.counted * self.counted, count).astype(float)

    def pull_back(self, into: Cotangent, scale: Array) -> None:
        """Add the gradient of Σ_s scale_s f(s) to `into`, scale (S,)."""
        bar = 2 * scale[self.at] * self.weight * self.counted
        bar = bar if self.of is None else bar[self.of]
        nonzero = np.flatnonzero(bar)
        if not nonzero.size:
            return
        for change in self.changes:
            part = change if nonzero.size == bar.size else change.select(nonzero)
            if isinstance(part, Wrenches):
                into.add_wrenches(part.scale(bar[nonzero]))
            else:
                part.pull_back(into, bar[nonzero])

    def add_to(self, curvature: Curvature, scale: Array) -> None:
        """Add the Gauss-Newton matrices of Σ_s scale_s f(s) to `curvature`. One-sided residuals add nothing."""
        if self.curved is not None:
            self.curved(curvature, scale)
            return
        if self.one_sided or not self.at.size:
            return
        factor = scale[self.at] * self.weight
        only = self.changes[0]
        if isinstance(only, Entries) and len(self.changes) == 1:
            curvature.add_diagonal(only.at, only.column, only.order, factor * only.slope**2)
            return
        rows, at, order = self.rows(curvature.samples), self.at, _rising(self.at)
        if order is not None:
            rows, at, factor = rows[order], at[order], factor[order]
        curvature.add_rows(at, factor, rows, tuple(range(rows.shape[1])))

    def rows(self, samples: Samples) -> Array:
        """Return the gradients with respect to y, y', ... up to the highest order used, (P, 1 to 3, N)."""
        if self.of is None and len(self.changes) == 1:
            return self.changes[0].rows(samples)
        total = np.zeros((self.at.size, max(change.orders for change in self.changes), samples.y.shape[1]))
        for change in self.changes:
            rows = change.rows(samples)
            if self.of is None:
                total[:, : rows.shape[1]] += rows
            else:
                add_rows_at(total[:, : rows.shape[1]], self.of, rows)
        return total

    def one_sided_residuals(self, samples: Samples) -> OneSidedResiduals:
        """Return the residuals, each times the square root of its weight, with their gradients with respect to y.

        Derivatives with respect to y' and y'' are ignored. The quadratic model of E uses these residuals.
        """
        root = np.sqrt(self.weight)
        return OneSidedResiduals(self.at, root * self.value, np.reshape(root, (-1, 1)) * self.rows(samples)[:, 0])


@dataclass(frozen=True, eq=False)
class Dense:
    """R residuals at each of S samples, with a function for their gradients. f(s) is Σ_i r[i, s]² + `more`[s].

    Attributes:
        value: Residuals, (R, S).
        pulled_back: pulled_back(cotangent, bar) adds the gradient of Σ bar[i, s] · r[i, s] to `cotangent`. The shape of
            `bar` is (R, S).
        curved: curved(curvature, scale) adds the Gauss-Newton matrices of Σ_s scale_s f(s) to `curvature`. The shape
            of `scale` is (S,). If None, they come from R adjoint sweeps of the kinematics.
        more: Summand of f in addition to the squares, (S,). Its gradient is not computed: the gradient of f is
            taken to be that of the squares. This is correct if f was minimised over auxiliary variables, and the
            gradient of r is computed with these held constant (envelope theorem).
    """

    value: Array
    pulled_back: Callable[[Cotangent, Array], None]
    curved: Callable[[Curvature, Array], None] | None = None
    more: Array | float = 0.0

    def values(self, count: int) -> Array:
        """Return f at every sample, (S,)."""
        return np.einsum("rs,rs->s", self.value, self.value) + self.more

    def pull_back(self, into: Cotangent, scale: Array) -> None:
        """Add the gradient of Σ_s scale_s f(s) to `into`."""
        self.pulled_back(into, 2 * scale * self.value)

    def add_to(self, curvature: Curvature, scale: Array) -> None:
        """Add the Gauss-Newton matrices of Σ_s scale_s f(s) to `curvature`."""
        if self.curved is not None:
            self.curved(curvature, scale)
            return
        every = np.arange(scale.size)
        for unit in np.eye(len(self.value)):
            cotangent = Cotangent(curvature.samples)
            self.pulled_back(cotangent, np.repeat(unit[:, None], scale.size, axis=1))
            curvature.add_rows(every, scale, np.stack(cotangent.gradients(), axis=1))


def sum_of_blocks(
    blocks: Iterable[Block | Dense], samples: Samples, into: Cotangent | None, scale: Array | float
) -> Array:
    """Return f at every sample, (S,). If `into` is given, add the gradient of Σ_s scale_s f(s) to `into`."""
    values, scale = np.zeros(samples.count), scale + np.zeros(samples.count)
    for block in blocks:
        values += block.values(samples.count)
        if into is not None:
            block.pull_back(into, scale)
    return values


def one_sided_residuals(blocks: Iterable[Block | Dense], samples: Samples) -> OneSidedResiduals | None:
    """Return the one-sided residuals among blocks; None if there are none."""
    chosen = [block for block in blocks if isinstance(block, Block) and block.one_sided]
    return OneSidedResiduals.join([block.one_sided_residuals(samples) for block in chosen]) if chosen else None


def every(
    samples: Samples, columns: Index, order: int, value: Array | None = None, weight: Array | float = 1.0
) -> Block:
    """Return residuals of single entries of y, y' or y'' at every sample.

    Args:
        columns: The columns of the entries, (C,).
        order: 0, 1 or 2, for entries of y, y' or y''.
        value: The residuals (S, C), with a derivative of 1 with respect to the entries; None: the entries.
        weight: The weights of the squared residuals, (S, C).
    """
    value = (samples.y, samples.y_d, samples.y_dd)[order][:, columns] if value is None else value
    at = np.repeat(np.arange(samples.count), columns.size)
    weight = weight if isinstance(weight, float) else np.ravel(weight)
    return Block(at, value.ravel(), (Entries(at, order, np.tile(columns, samples.count)),), weight)


def _rising(at: Index) -> Index | None:
    """Return the permutation that sorts the samples in ascending order; None if they are sorted."""
    return np.argsort(at, kind="stable") if np.any(at[1:] < at[:-1]) else None
