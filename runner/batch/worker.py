"""Executors of clips, and their worker processes. If a clip exceeds a limit, its process is ended and replaced."""

from __future__ import annotations

import ctypes
import gc
import os
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import psutil

from ..errors import UserError, located, one_line
from ..picture.graphics import do_without
from ..system import workers
from ..system.scratch import scratch
from ..system.threads import use_one_thread, without_tools
from ..system.workers import LimitExceeded, WorkerEnded
from .task import Outcome

SolveTask = Callable[[Any, Path], Outcome]

IDLE_SECONDS = 120.0  # [s] without a clip after which a process ends, because its batch may have been killed
CGROUP = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")  # a container's limits


class Pool:
    """Worker processes of clips, with their files in a folder.

    Args:
        folder: A folder for temporary files.
        share: The memory limit of a clip without one [MB].
    """

    def __init__(self, folder: Path, share: float | None = None) -> None:
        self._folder, self._share = folder, share
        self._workers = workers.Pool(partial(_prepared, folder), _outcome, IDLE_SECONDS, folder)

    def run(self, solve_task: SolveTask, task: object, seconds: float, megabytes: float | None = None) -> Outcome:
        """Return the outcome of solve_task(task, empty folder) in a process, within limits [s], [MB]."""
        megabytes = self._share if megabytes is None else megabytes
        with tempfile.TemporaryDirectory(dir=self._folder, ignore_cleanup_errors=True) as place:
            try:
                outcome = self._workers.run((solve_task, task, Path(place)), seconds, megabytes)
            except LimitExceeded as error:
                return Outcome(error.kind, str(error), error.bound)
            except WorkerEnded as error:
                return Outcome("lost", f"its process {error}")
        return replace(outcome, bound=megabytes) if outcome.cause == "memory" else outcome

    def stop(self) -> None:
        """End all processes, at once or within a tenth of a second with the outcome "lost"."""
        self._workers.stop()


@contextmanager
def _prepared(folder: Path) -> Iterator[None]:
    """Prepare a worker process: one thread of linear algebra, no graphics, imports excluded from garbage collection."""
    gc.disable()
    os.chdir(folder)
    use_one_thread()
    do_without()
    without_tools()
    from .. import motion, recordings, solving  # noqa: F401

    gc.freeze()
    gc.enable()
    yield


def _outcome(_: None, clip: tuple[SolveTask, Any, Path]) -> Outcome:
    """Return the outcome of solve_task(task, folder), also if it raises an error, and release its memory."""
    solve_task, task, folder = clip
    begin = time.monotonic()
    try:
        outcome = solve_task(task, folder)
    except MemoryError as error:
        outcome = Outcome("memory", f"it took more memory than there is ({one_line(error)})")
    except UserError as error:
        outcome = Outcome("error", one_line(error))
    except Exception as error:
        outcome = Outcome("error", located(error))
    gc.collect()
    if hasattr(libc := ctypes.CDLL(None), "malloc_trim"):
        libc.malloc_trim(0)  # otherwise glibc retains twice the used memory
    return replace(outcome, seconds=round(time.monotonic() - begin, 3))


class Workers(NamedTuple):
    """An executor of clips: submit(solve_task, task, seconds, megabytes) returns a future outcome.

    `count` returns the number of clips to submit at a time, 0 while there are no workers. It raises UserError if they
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
