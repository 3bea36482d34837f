"""Samples that hold no numbers: an error where every sample counts, left out where a recording is to be mended.

Readers see the sample before in their place, so that they need not know; what was made of it is taken out at the end.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace

import numpy as np

from dynsplines.solver.array import Array, Mask

from ..errors import UserError
from .take import Recording


@dataclass
class Gaps:
    """Which samples of the file that is read hold no numbers, (T,) for all its arrays together."""

    missing: Mask | None = field(default=None)

    def bridged(self, array: Array) -> Array | None:
        """An array, its samples along the first axis, with those of no numbers as the one before, which is noted.

        None for one that has no good sample, or is of another count of samples than the arrays before.
        """
        bad = np.asarray(~np.isfinite(array.reshape(len(array), -1)).all(axis=1))
        if bad.all() or (self.missing is not None and self.missing.size != bad.size):
            return None
        self.missing = bad if self.missing is None else np.asarray(self.missing | bad)
        good = np.flatnonzero(~bad)
        return array[good[np.maximum(np.searchsorted(good, np.arange(bad.size), side="right") - 1, 0)]]

    def left_out(self, found: Recording, where: object) -> Recording:
        """A recording without the samples that were noted."""
        if self.missing is None or not self.missing.any():
            return found
        if self.missing.size != found.time.size:
            raise UserError(f"{where}: some of its numbers are not finite, and they are of no samples")
        count, first = int(self.missing.sum()), float(found.time[self.missing][0])
        many = "samples hold" if count > 1 else "sample holds"
        note = f"{count} {many} no numbers, first at {first:.3f} s: left out"
        kept = ~self.missing
        return replace(found, time=found.time[kept], qpos=found.qpos[kept], notes=(*found.notes, note))


_now: ContextVar[Gaps | None] = ContextVar("gaps", default=None)


@contextmanager
def allowed() -> Iterator[None]:
    """Files may have samples without numbers while it lasts."""
    before = _now.set(Gaps())
    try:
        yield
    finally:
        _now.reset(before)


def are_allowed() -> bool:
    """Whether recordings with gaps, or cut short, are read as far as they go."""
    return _now.get() is not None


def bridged(array: Array) -> Array | None:
    """As `Gaps.bridged` where gaps are allowed; else None."""
    gaps = _now.get()
    return None if gaps is None or array.ndim == 0 or not len(array) else gaps.bridged(array)


def left_out(found: Recording, where: object) -> Recording:
    """As `Gaps.left_out` where gaps are allowed."""
    gaps = _now.get()
    return found if gaps is None else gaps.left_out(found, where)
