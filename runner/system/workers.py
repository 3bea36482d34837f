"""Worker processes, each of which opens a tool and applies it to one item after another.

No worker outlives the program: a thread in each ends it with its parent. After Ctrl-C, a worker completes its item.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, ExitStack, contextmanager
from functools import cache
from multiprocessing.connection import wait
from typing import Any, TypeVar

from ..errors import UserError
from . import mujoco_warnings

Tool = TypeVar("Tool")
Item = TypeVar("Item")
Result = TypeVar("Result")
Opened = Callable[[], AbstractContextManager[Tool]]
Work = Callable[[Tool, Item], Result]

MOST_WORKERS = 60  # maximum number of processes for which Windows can wait
AHEAD = 2  # tasks per process that are submitted, or wait with their results for an earlier one

_job: tuple[Work[Any, Any, Any], Callable[[], Any]]  # in a worker: its work, and the function that returns its tool


def cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def in_order(
    opened: Opened[Tool], work: Work[Tool, Item, Result], items: Iterable[Item], workers: int = 1
) -> Generator[Result, None, None]:
    """Yield work(tool, item) for every item, in order, computed by this process or by `workers` others.

    Few results are computed ahead, so that a long video is never in memory. Raises the errors of the work, and
    UserError if a process ends. For several workers, tool, work and items must be picklable, and the program importable
    without running (`if __name__ == "__main__"`).
    """
    if workers == 1:
        with opened() as tool:
            for item in items:
                yield work(tool, item)
        return
    pool = ProcessPoolExecutor(workers, multiprocessing.get_context("spawn"), _prepare, (opened, work))
    futures = deque[Future[tuple[Result, list[str]]]]()
    try:
        for item in items:
            futures.append(_submit(pool, item))
            if len(futures) >= AHEAD * workers:
                yield _result(futures.popleft())
        while futures:
            yield _result(futures.popleft())
    except BrokenProcessPool:
        raise UserError("a worker process ended; too little memory? --workers 1 does without") from None
    finally:
        pool.shutdown(cancel_futures=True)


def _submit(pool: ProcessPoolExecutor, item: object) -> Future[Any]:
    """Submit an item; the first one starts the processes."""
    try:
        with ctrl_c_blocked():
            return pool.submit(_apply, item)
    except OSError as error:
        why = error.strerror or error
        raise UserError(f"a worker process cannot be started: {why}; --workers 1 does without") from None


def _result(future: Future[tuple[Result, list[str]]]) -> Result:
    result, warnings = future.result()
    for warning in warnings:
        mujoco_warnings.pass_on(warning)
    return result


def _prepare(opened: Opened[Any], work: Work[Any, Any, Any]) -> None:
    """Let a worker ignore Ctrl-C and end with its parent, and give it its tool, which the first item opens."""
    global _job
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _job = work, cache(lambda: ExitStack().enter_context(opened()))


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    wait([parent.sentinel])
    os._exit(1)


def _apply(item: object) -> tuple[Any, list[str]]:
    """Return the result of an item in a worker, and MuJoCo's warnings."""
    warnings: list[str] = []
    with mujoco_warnings.reported_to(warnings.append):
        work, tool = _job
        return work(tool(), item), warnings


@contextmanager
def ctrl_c_blocked() -> Iterator[None]:
    """Block Ctrl-C until the end of the block, also for processes that start in it; not on Windows."""
    if sys.platform == "win32":
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # if it started in the block, it would unblock Ctrl-C
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
