"""The processes of this machine that solve clips, as `concurrent.futures`; or those of a Dask cluster, likewise."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import psutil

from ..system.progress import Progress
from ..system.scratch import scratch
from .child import Crew, Outcome

LIMIT = Path("/sys/fs/cgroup/memory.max")  # of a container, "max" where there is none


@dataclass(frozen=True)
class Workers:
    """What solves clips.

    submit  starts one: (do, task, bounds) -> its outcome
    count   how many to start at a time
    check   raises UserError if no worker will ever answer
    """

    submit: Callable[..., Future[Outcome]]
    count: Callable[[], int]
    check: Callable[[], None] = lambda: None


@contextmanager
def opened(workers: int, scheduler: str | None, batch: str, progress: Progress) -> Iterator[Workers]:
    """So many on this machine, or those of the scheduler at an address; their processes end with the block."""
    if scheduler is not None:
        from .cluster import connected  # only here: Dask takes a while, and need not be installed

        with connected(scheduler, batch, progress) as there:
            yield there
        return
    with scratch() as folder, ThreadPoolExecutor(workers) as pool:
        crew = Crew(folder, _memory() / workers)
        try:
            yield Workers(partial(pool.submit, crew.run), lambda: workers)
        finally:
            crew.stop()
            pool.shutdown(cancel_futures=True)


def _memory() -> float:
    """[MB] of this machine, or of the container that this is."""
    there = float(psutil.virtual_memory().total)
    with suppress(OSError, ValueError):
        there = min(there, float(LIMIT.read_text(encoding="ascii")))
    return there / 2**20
