"""Executors of clips: threads of this machine with a process each, or the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import psutil

from ..system.scratch import scratch
from .task import Outcome
from .worker import Pool

CGROUP = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")  # a container's limits


@dataclass(frozen=True)
class Workers:
    """An executor of clips.

    Attributes:
        submit: (do, task, limits) -> future outcome.
        count: Returns the number of clips to submit at a time, 0 while there are no workers. Raises UserError if they
            are lost.
    """

    submit: Callable[..., Future[Outcome]]
    count: Callable[[], int]


@contextmanager
def local(count: int) -> Iterator[Workers]:
    """Start `count` processes on this machine, which end with the block."""
    with scratch() as folder, ThreadPoolExecutor(count) as threads:
        pool = Pool(folder, _memory() / count)
        try:
            yield Workers(partial(threads.submit, pool.run), lambda: count)
        finally:
            pool.stop()
            threads.shutdown(cancel_futures=True)


def _memory() -> float:
    """Return the memory of this machine, or of the container [MB]."""
    size = psutil.virtual_memory().total
    for path in CGROUP:
        with suppress(OSError, ValueError):  # "max" without a limit
            size = min(size, int(Path(path).read_text(encoding="ascii")))
    return size / 2**20
