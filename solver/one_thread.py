"""One thread of linear algebra: on matrices as small as a band's blocks, several only wait for each other."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

from threadpoolctl import ThreadpoolController


@contextmanager
def one_thread() -> Iterator[None]:
    """Run this block with one thread of BLAS, then restore the number; without effect if it is one already."""
    libraries = _libraries()
    if all(library.num_threads == 1 for library in libraries.lib_controllers):
        yield
        return
    with libraries.limit(limits=1):
        yield


@cache
def _libraries() -> ThreadpoolController:
    """The BLAS that NumPy and SciPy have loaded; searched once, which takes as long as a small solve."""
    return ThreadpoolController().select(user_api="blas")
