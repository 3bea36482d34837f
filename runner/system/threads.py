"""One thread: on the solver's small matrices more of them only wait for each other, and round another way."""

from __future__ import annotations

import os

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def keep_to_one() -> None:
    """For this process, before it imports NumPy, whatever its environment says: the same bytes come out."""
    for name in THREADS:
        os.environ[name] = "1"
