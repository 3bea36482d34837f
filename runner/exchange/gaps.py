"""Samples without numbers and truncated files: errors where every sample counts, tolerated in recordings to be cleaned.

Readers get the sample before in place of one without numbers, so that they need no code for it; those samples are
removed at the end. A file whose arrays differ in their number of samples is read again, up to the fewest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace

import numpy as np

from dynsplines.solver.array import Array, Mask

from ..errors import UserError
from .layouts import noted
from .trajectory import Recording

FEWEST = 2  # samples of a motion


class UnequalSamples(UserError):
    """Files whose arrays differ in their number of samples.

    shapes   of its arrays, by name, the samples first
    """

    def __init__(self, where: object, shapes: Mapping[str, tuple[int, ...]]) -> None:
        self.count = min(shape[0] for shape in shapes.values())
        self.counts = ", ".join(f"'{name}' {shape[0]}" for name, shape in shapes.items())
        called = ", ".join(f"'{name}' {shape}" for name, shape in shapes.items())
        remedy = f"`dynsplines clean` uses the first {self.count}"
        if self.count < FEWEST:
            remedy = f"a motion has at least {FEWEST}"
        super().__init__(f"{where}: its arrays differ in their number of samples, the first axis: {called}; {remedy}")


@dataclass
class Gaps:
    """The defects of the file that is read.

    missing  the samples that hold no numbers, (T,) for all its arrays together
    most     the number of samples that all its arrays have; None as long as none is known to be shorter
    """

    missing: Mask | None = field(default=None)
    most: int | None = None

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
            raise UserError(f"{where}: some of its numbers are not finite, and no single samples can be removed")
        count, first = int(self.missing.sum()), float(found.time[self.missing][0])
        many = "samples hold" if count > 1 else "sample holds"
        note = f"{count} {many} no numbers, first at {first:.3f} s: left out"
        is_present = ~self.missing
        return replace(found, time=found.time[is_present], qpos=found.qpos[is_present], notes=(*found.notes, note))


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
    """Whether recordings with gaps, or truncated ones, are read as far as possible."""
    return _now.get() is not None


def bridged(array: Array) -> Array | None:
    """As `Gaps.bridged` in a block that allows gaps; else None."""
    gaps = _now.get()
    return None if gaps is None or array.ndim == 0 or not len(array) else gaps.bridged(array)


def left_out(found: Recording, where: object) -> Recording:
    """As `Gaps.left_out` in a block that allows gaps."""
    gaps = _now.get()
    return found if gaps is None else gaps.left_out(found, where)


def samples_used(count: int) -> int:
    """Return the number of used samples of an array: those that all arrays of the file have, as far as is known."""
    gaps = _now.get()
    return count if gaps is None or gaps.most is None else min(count, gaps.most)


def as_far_as_it_goes(read: Callable[[], Recording]) -> Recording:
    """Return the recording that a reader returns; with a note if its arrays differ in their number of samples.

    Raises UnequalSamples for such a file unless gaps are allowed.
    """
    gaps, unequal = _now.get(), None
    if gaps is not None:
        gaps.most = None
    while True:
        try:
            result = read()
        except UnequalSamples as error:
            if gaps is None or error.count < FEWEST:
                raise
            gaps.most, gaps.missing, unequal = error.count, None, error
        else:
            break
    if unequal is None:
        return result
    note = f"the file is cut short, samples of its arrays: {unequal.counts}; the first {unequal.count} are used"
    return noted(result, (note,))
