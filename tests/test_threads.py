"""Tests solve as the command does: on one thread, which two workers need not fight over."""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path

import numpy as np
import pytest

from dynsplines.system import threads


def linear_algebra() -> ctypes.CDLL:
    """NumPy's OpenBLAS, as it is loaded."""
    folder = Path(np.__file__).parent.parent / "numpy.libs"
    found = sorted(folder.glob("*openblas*"))
    if not found or sys.platform != "linux":
        pytest.skip("another library does NumPy's linear algebra here")
    return ctypes.CDLL(str(found[0]))


def test_numpys_linear_algebra_has_one_thread_in_the_tests() -> None:
    library = linear_algebra()
    names = ("scipy_openblas_get_num_threads64_", "scipy_openblas_get_num_threads", "openblas_get_num_threads")
    counts = [getattr(library, name)() for name in names if hasattr(library, name)]
    assert counts == [1]


def test_every_library_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in threads.THREADS:
        monkeypatch.setenv(name, "7")
    threads.keep_to_one()
    assert {os.environ[name] for name in threads.THREADS} == {"1"}
