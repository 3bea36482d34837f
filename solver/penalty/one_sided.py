"""One-sided residuals, such as depths. In a model of E each adds max(0, value + row · δy)² for a step δy of y."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, add_rows_at

ENTRIES_AT_ONCE = 500_000  # [1] largest number of array entries that are copied at once, 4 MB


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
    def joined(cls, parts: Sequence[OneSidedResiduals]) -> OneSidedResiduals:
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "value", "rows")))

    def shifted(self, first: int) -> OneSidedResiduals:
        return OneSidedResiduals(self.at + first, self.value, self.rows)

    def select(self, indices: Index) -> OneSidedResiduals:
        return OneSidedResiduals(self.at[indices], self.value[indices], self.rows[indices])

    def moved(self, change: Array) -> Array:
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
