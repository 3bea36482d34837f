"""Numerics of a process: one thread, and no more of NumPy than required.

On the solver's small matrices, several threads mostly wait for each other, and rounding depends on their number.
"""

from __future__ import annotations

import os

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def use_one_thread() -> None:
    """Set one thread for this process before it imports NumPy, so that results are reproducible."""
    for name in THREADS:
        os.environ[name] = "1"


def without_tools() -> None:
    """Exclude NumPy's tests and Fortran compiler from imports, before SciPy is imported.

    SciPy copies every name of NumPy, and would thus import these, which takes as long as NumPy itself. Other code can
    still import them.
    """
    import numpy

    tools = {"f2py", "testing", "test"}
    getattr(numpy, "__numpy_submodules__", set()).difference_update(tools)
    numpy.__all__[:] = [name for name in numpy.__all__ if name not in tools]
