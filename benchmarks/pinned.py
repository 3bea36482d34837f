"""One thread for every linear algebra library: to be imported before NumPy."""

from __future__ import annotations

import os
import sys

THREADS = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "BLIS_NUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
)

if "numpy" in sys.modules and any(os.environ.get(name) != "1" for name in THREADS[:2]):
    raise RuntimeError("numpy was imported before its threads were pinned; import `pinned` first")
for _name in THREADS:
    os.environ[_name] = "1"
