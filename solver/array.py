"""Array types of the solver, read-only copies, runs of masks, intervals of times, and sums of rows."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]

ENTRIES_AT_ONCE = 500_000  # largest number of entries of an array that is made in parts, 4 MB
IN_CACHE = 2000  # number of vectors that are processed at once, so that they stay in the processor's cache
SAMPLES_AT_ONCE = 1000  # largest number of samples of a figure that are evaluated at once, which bounds the memory


def freeze(values: ArrayLike) -> Array:
    """A read-only float copy."""
    array = np.array(values, float)
    array.setflags(write=False)
    return array


def frozen_mask(values: ArrayLike) -> Mask:
    """A read-only boolean copy."""
    array = np.array(values, bool)
    array.setflags(write=False)
    return array


def runs(mask: Mask) -> list[tuple[int, int]]:
    """Return the intervals (first, one past the last) in which a mask (T,) is true."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def count_off(lengths: Index) -> tuple[Index, Index]:
    """Return the index of the run and the position in it, for every item of runs of these lengths (n,)."""
    run = np.repeat(np.arange(lengths.size), lengths)
    return run, np.arange(run.size) - (np.cumsum(lengths) - lengths)[run]


def segments_at(times: Array, t: Array) -> Index:
    """Return for each of the times t (T,) the segment between `times` (K,) that contains it, 0 to K − 2.

    A time before or after all segments belongs to the first or last one.
    """
    return np.clip(np.searchsorted(times, t, side="right") - 1, 0, times.size - 2)


def pairs_within(t: Array, first: Array, last: Array) -> tuple[Index, Index]:
    """Return the pairs of an interval and a time in it: two index arrays (p,), for times t (S,).

    Args:
        t: The times, (S,) [s], in any order.
        first: The first times of the intervals, (n,) [s].
        last: The last times of the intervals, (n,) [s], inclusive.
    """
    order = np.argsort(t, kind="stable")
    rising = t[order]
    begin, end = np.searchsorted(rising, first, "left"), np.searchsorted(rising, last, "right")
    interval, place = count_off(np.maximum(end - begin, 0))
    return interval, order[begin[interval] + place]


def add_rows_at(into: Array, at: Index, rows: Array) -> None:
    """Add rows (P, ...) to the rows `at` (P,) of `into`. Rows of one index are summed, as by the slower np.add.at."""
    if np.any(at[1:] < at[:-1]):
        order = np.argsort(at, kind="stable")
        at, rows = at[order], rows[order]
    first = np.flatnonzero(np.diff(at, prepend=-1))
    into[at[first]] += np.add.reduceat(rows, first)
