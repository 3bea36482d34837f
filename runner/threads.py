"""One thread: on the solver's small matrices more of them only wait for each other."""

from __future__ import annotations

import os

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def keep_to_one() -> None:
    """For this process, before it imports NumPy, unless its environment says otherwise."""
    for name in THREADS:
        os.environ.setdefault(name, "1")
