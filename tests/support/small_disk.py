"""A limit on the size of files, as a full disk is.

Python up to 3.12 writes compiled modules in part then and takes them for whole later: none are written meanwhile.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

SMALL = "import resource, sys; sys.dont_write_bytecode = True; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"


@contextmanager
def largest_file(size: int) -> Iterator[None]:
    """In here no file of this process grows over so many bytes."""
    resource = pytest.importorskip("resource")
    before, written = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        sys.dont_write_bytecode = written
