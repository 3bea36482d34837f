"""Numerics of a process: one thread, and no more of NumPy than required.

On the solver's small matrices more threads only wait for each other, and round another way.
"""

from __future__ import annotations

import os

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def keep_to_one() -> None:
    """Set one thread for this process, before it imports NumPy, whatever its environment: results are reproducible."""
    for name in THREADS:
        os.environ[name] = "1"


def without_tools() -> None:
    """Before SciPy is imported: it copies every name of NumPy, and so would import NumPy's tests and Fortran compiler,
    which take as long as NumPy itself. They remain available to other importers."""
    import numpy

    tools = {"f2py", "testing", "test"}
    getattr(numpy, "__numpy_submodules__", set()).difference_update(tools)
    numpy.__all__[:] = [name for name in numpy.__all__ if name not in tools]
