"""The compiled kernel, `kernel.c`, if it is built: the same results as NumPy's, faster.

It is built when the package is installed, if there is a C compiler, and left out without one.
"""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np

from .array import Array


def _loaded() -> ModuleType | None:
    if np.dtype(np.intp).itemsize != 8:
        return None
    try:
        return importlib.import_module("dynsplines.solver.kernel")
    except ImportError:
        return None


kernel = _loaded()


def call(name: str, out: Array, *arguments: object) -> None:
    """Calls a function of the kernel, which adds to or sets `out`; numbers, arrays and None for arrays left out."""
    assert kernel is not None, "callers ask first"
    every = (np.ascontiguousarray(one) if isinstance(one, np.ndarray) else one for one in arguments)
    getattr(kernel, name)(out, *every)
