"""One thread of linear algebra, because on matrices as small as a band's blocks several threads mostly wait."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

from threadpoolctl import ThreadpoolController


@contextmanager
def one_thread() -> Iterator[None]:
    """Run a block with one thread of BLAS, then restore the number of threads."""
    libraries = _libraries()
    if all(library.num_threads == 1 for library in libraries.lib_controllers):
        yield
        return
    with libraries.limit(limits=1):
        yield


@cache
def _libraries() -> ThreadpoolController:
    """Return the BLAS libraries of NumPy and SciPy, cached because the search takes as long as a small solve."""
    return ThreadpoolController().select(user_api="blas")
