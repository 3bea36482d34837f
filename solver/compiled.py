"""The compiled kernel `kernel.c`. Its results are those of the NumPy code, and it is faster.

Installation builds it if there is a C compiler. Without it, `kernel` is None and NumPy is used.
"""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np

from .array import Array


def _load() -> ModuleType | None:
    if np.dtype(np.intp).itemsize != 8:
        return None
    try:
        return importlib.import_module("dynsplines.solver.kernel")
    except ImportError:
        return None


kernel = _load()


def call(name: str, out: Array, *arguments: object) -> None:
    """Call a function of the kernel, which adds to `out` or sets it.

    Args:
        arguments: Numbers, arrays, and None for omitted arrays.
    """
    assert kernel is not None, "callers ask first"
    every = (np.ascontiguousarray(one) if isinstance(one, np.ndarray) else one for one in arguments)
    getattr(kernel, name)(out, *every)
