"""Named arrays of a file, with checks of types and shapes; .npz files without pickled objects."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from dynsplines.solver.array import Array

from ..errors import UserError
from ..motion import read_entries
from ..system import size_limit
from ..system.quantity import LARGEST
from .gaps import bridge

NUMBER = np.dtype(float).itemsize  # [bytes]
SAMPLES = "samples"  # name of the first axis of arrays with one row per sample


class ArrayReader:
    """A file's entries by name; errors name the file `where`, the missing entry, and the entries present."""

    def __init__(self, where: object, entries: Mapping[str, Any]) -> None:
        self.where, self.entries = where, entries
        self.sizes: dict[str, int] = {}
        self.sampled: dict[str, tuple[int, ...]] = {}  # shapes of the arrays of samples

    def __contains__(self, name: str) -> bool:
        return self.entries.get(name) is not None

    def of(self, name: str) -> Any:
        """Return an entry without conversion; raises UserError if it is missing."""
        if name not in self:
            there = ", ".join(map(str, self.entries)) or "nothing"
            raise UserError(f"{self.where}: no '{name}'; it holds: {there}")
        return self.entries[name]

    def numbers(self, name: str, *shape: int | str) -> Array:
        """Return an array of finite numbers; raises UserError for any other.

        A text in `shape` names a size: arrays with the same name must have the same size there. An array whose first
        axis is SAMPLES must have as many samples as those read before.
        """
        array = self._array(name, len(shape))
        if array.dtype.kind not in "fiu":
            raise UserError(f"{self.where}: '{name}' holds {array.dtype.name}, not numbers")
        wanted = [self.sizes.get(size, size) if isinstance(size, str) else size for size in shape]
        is_sampled = shape[:1] == (SAMPLES,)
        fits = array.ndim == len(shape)
        sizes = list(zip(wanted, array.shape, strict=False))[is_sampled:]
        if not fits or any(isinstance(w, int) and w != n for w, n in sizes):
            expected = ", ".join(map(str, wanted)) + ("," if len(wanted) == 1 else "")
            raise UserError(f"{self.where}: '{name}' has the shape {array.shape}, not ({expected})")
        if is_sampled:
            self.check_samples(name, array.shape)
        self.sizes |= {size: n for size, n in zip(shape, array.shape, strict=True) if isinstance(size, str)}
        array = array.astype(float)
        if not np.all(np.isfinite(array)) and (mended := bridge(array)) is not None:
            array = mended
        if not np.all(np.abs(array) <= LARGEST):
            what = "is too large" if np.all(np.isfinite(array)) else "is not a finite number"
            raise UserError(f"{self.where}: '{name}': an entry {what}")
        return array

    def check_samples(self, name: str, shape: tuple[int, ...]) -> None:
        """Raise UserError if an earlier array has another number of samples."""
        self.sampled[name] = shape
        if shape[0] != self.sizes.get(SAMPLES, shape[0]):
            shapes = ", ".join(f"'{name}' {shape}" for name, shape in self.sampled.items())
            raise UserError(f"{self.where}: its arrays differ in their number of samples, the first axis: {shapes}")

    def quaternions(self, name: str, *shape: int | str, scalar_last: bool = False) -> Array:
        """Return unit quaternions wxyz, from an array in this order or, with `scalar_last`, in the order xyzw."""
        array = unit_quaternions(self.numbers(name, *shape), name, self.where)
        return np.roll(array, 1, -1) if scalar_last else array

    def rate(self, name: str, fps: float | None = None) -> float:
        """Return the sampling rate [1/s], a number or an array of one; `fps` is the default for a missing entry."""
        if fps is not None and name not in self:
            return fps
        return self.number(name, 0.01, 100_000, "a number of samples a second from 0.01 to 100000")

    def number(self, name: str, least: float, most: float, what: str) -> float:
        """Return a number within bounds, stored as a number or an array of one; `what` describes it in errors."""
        array = self._array(name, 1)
        if array.dtype.kind not in "fiub" or array.size != 1 or not least <= float(array.reshape(())) <= most:
            raise UserError(f"{self.where}: '{name}' is not {what}")
        return float(array.reshape(()))

    def texts(self, name: str) -> list[str]:
        array = self._array(name, 1)
        if array.ndim != 1 or array.dtype.kind not in "UO" or not all(isinstance(item, str) for item in array.tolist()):
            raise UserError(f"{self.where}: '{name}' is not a list of names")
        return array.tolist()

    def _array(self, name: str, axes: int) -> Any:
        """Return an entry as an array; raises UserError for lists nested too deeply or of unequal lengths."""
        value = self.of(name)
        size_limit.check(self.where, NUMBER * self._items(name, value, axes), f"'{name}'")
        try:
            return np.asarray(value)
        except ValueError:
            raise UserError(f"{self.where}: '{name}' has rows of different lengths") from None

    def _items(self, name: str, value: object, axes: int) -> int:
        """Count the items of expanded lists: a short pickle may repeat one list a million times."""
        if not isinstance(value, list | tuple):
            return value.size if isinstance(value, np.ndarray) else 1
        if axes == 0:
            raise UserError(f"{self.where}: '{name}' has lists in lists, deeper than it should")
        if axes == 1 and not any(isinstance(item, list | tuple | np.ndarray) for item in value):
            return len(value)
        total, most = 0, size_limit.bound() // NUMBER
        for item in value:
            total += 1 + self._items(name, item, axes - 1)
            if total > most:
                break
        return total


def unit_quaternions(array: Array, name: str, where: object) -> Array:
    """Return quaternions (..., 4) scaled to length 1; raises UserError if one is far from it."""
    length = np.linalg.norm(array, axis=-1, keepdims=True)
    if np.any(np.abs(length - 1) > 0.01):
        raise UserError(f"{where}: '{name}': a quaternion of length {length.flat[np.argmax(abs(length - 1))]:.3g}")
    return array / length


def read_npz(source: Path) -> ArrayReader:
    """Return the arrays of an .npz file.

    Pickles are never loaded: entries that are pickled objects count as missing.
    """
    entries = read_entries(source)
    return ArrayReader(source, {name: entry for name, entry in entries.items() if isinstance(entry, np.ndarray)})


def names_in(source: Path) -> set[str]:
    """Return the names of an .npz file's arrays without reading them; none for other files."""
    try:
        with zipfile.ZipFile(source) as archive:
            return {name.removesuffix(".npy") for name in archive.namelist()}
    except (OSError, zipfile.BadZipFile):
        return set()


def times(count: int, fps: float) -> Array:
    """Return the times (count,) [s] of samples, the first at 0."""
    return np.arange(count) / fps
