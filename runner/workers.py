"""Items worked on by several processes at once, the results in order.

Every process opens its own tool, such as a stage to take pictures on, and keeps it. Few items are under way at a time,
so a long film is never in memory. However the loop over the results ends, no process is left: they are told to stop,
they do not listen to Ctrl-C themselves, and each goes when it finds itself without a parent.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from itertools import islice
from multiprocessing.connection import wait
from multiprocessing.process import BaseProcess
from typing import Any, TypeVar

from .errors import UserError

Tool = TypeVar("Tool")
Item = TypeVar("Item")
Result = TypeVar("Result")
Opened = Callable[[], AbstractContextManager[Tool]]
Work = Callable[[Tool, Item], Result]

AHEAD = 2  # items under way or waiting for each process, so that none is idle


def cores() -> int:
    """Cores this process may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def in_order(
    opened: Opened[Tool], work: Work[Tool, Item, Result], items: Iterable[Item], workers: int = 1
) -> Generator[Result, None, None]:
    """work(tool, item) for every item, in order, by this process or by `workers` others; an error of theirs is ours.

    opened  gives the tool; it, `work` and the items must be picklable if there are several workers, and the program
            must be importable without running (`if __name__ == "__main__"`)
    """
    if workers > 1:
        yield from _by_several(opened, work, items, workers)
        return
    with opened() as tool:
        for item in items:
            yield work(tool, item)


def _by_several(
    opened: Opened[Tool], work: Work[Tool, Item, Result], items: Iterable[Item], workers: int
) -> Generator[Result, None, None]:
    left = iter(items)
    pool = ProcessPoolExecutor(
        workers, multiprocessing.get_context("spawn"), initializer=_begin, initargs=(opened, work)
    )
    others = set(multiprocessing.active_children())
    crew: list[BaseProcess] = []
    waiting: deque[Future[Result]] = deque()
    try:
        with _ctrl_c_blocked():  # the processes, which the first item starts, inherit that
            waiting.extend(pool.submit(_work, item) for item in islice(left, 1))
            crew += [child for child in multiprocessing.active_children() if child not in others]
        waiting.extend(pool.submit(_work, item) for item in islice(left, AHEAD * workers - 1))
        while waiting:
            done = waiting.popleft().result()
            waiting.extend(pool.submit(_work, item) for item in islice(left, 1))
            yield done
    except BrokenProcessPool:
        pool.shutdown()
        raise UserError(f"a process that worked for this one {_end(crew)}; --workers 1 does without") from None
    except BaseException:
        for process in crew:
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def _ctrl_c_blocked() -> Iterator[None]:
    """Ctrl-C waits for the end of the block; processes started in it never get one, where the system can do that."""
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _end(crew: Sequence[BaseProcess]) -> str:
    """How the one of them ended that was not told to."""
    codes = [process.exitcode for process in crew if process.exitcode not in (None, 0, -signal.SIGTERM)]
    if not codes:
        return "was stopped"
    code = codes[0] or 0
    if code > 0:
        return f"ended with code {code}"
    words = signal.strsignal(-code) or "unknown"
    return f"was ended by signal {-code} ({words.lower()}{'; too little memory?' if -code == 9 else ''})"


# What follows runs in the worker processes.

_task: list[Any] = []  # how to open the tool, the work, and once it is open the tool


def _begin(opened: Callable[[], object], work: Callable[..., object]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_leave_with_the_parent, daemon=True).start()
    _task[:] = [opened, work]


def _leave_with_the_parent() -> None:
    """A parent that was killed cannot tell its workers to stop."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


def _work(item: Any) -> Any:
    """One item; the first one opens the tool here and not in `_begin`, whose errors nobody would hear."""
    if len(_task) == 2:
        _task.append(_task[0]().__enter__())
    return _task[1](_task[2], item)
