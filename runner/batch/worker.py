"""Executors of clips, and their worker processes. If a clip exceeds a limit, its process is ended and replaced."""

from __future__ import annotations

import ctypes
import gc
import os
import tempfile
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import psutil

from ..errors import UserError, one_line
from ..system.scratch import scratch
from ..system.threads import THREADS
from ..system.workers import Worker, WorkerEnded
from .task import Limits, Outcome

SolveTask = Callable[[Any, Path], Outcome]
Process = Worker[None, tuple[SolveTask, object, Path], Outcome]

READY = Outcome()
START = Limits(120.0)  # limits of a process while it imports its modules
WATCH_SECONDS = 0.1  # [s] interval of checks of time and memory
IDLE_SECONDS = 120.0  # [s] without a clip after which a process ends, because its batch may have been killed
CGROUP = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")  # a container's limits


class Pool:
    """Worker processes, one for every thread that calls `run` at the same time. Each serves one clip after another.

    Attributes:
        megabytes: The memory limit of a clip whose limits specify none [MB].
    """

    def __init__(self, folder: Path, megabytes: float | None = None) -> None:
        self._folder, self._megabytes = folder, megabytes
        self._idle: list[Process] = []
        self._stopped = threading.Event()

    def run(self, solve_task: SolveTask, task: object, limits: Limits) -> Outcome:
        """Return the outcome of do(task, empty folder) in a process."""
        if limits.megabytes is None:
            limits = replace(limits, megabytes=self._megabytes)
        with tempfile.TemporaryDirectory(dir=self._folder, ignore_cleanup_errors=True) as place:
            outcome, process = READY, self._idle_process()
            if process is None:
                errors = tempfile.NamedTemporaryFile(dir=self._folder)  # noqa: SIM115, `stop` closes it
                process = Worker(partial(_prepared, self._folder), _outcome, IDLE_SECONDS, errors)
                outcome = self._received(process, START, (_ready, None, Path(place)))
            begin = time.monotonic()
            if outcome == READY:
                outcome = self._received(process, limits, (solve_task, task, Path(place)))
        if outcome.cause in ("", "error") and not self._stopped.is_set():
            self._idle.append(process)
        else:
            process.stop()
        return replace(outcome, seconds=round(time.monotonic() - begin, 3))

    def stop(self) -> None:
        """End all processes: idle ones now, the others within WATCH_SECONDS with the outcome "lost"."""
        self._stopped.set()
        while process := self._idle_process():
            process.stop()

    def _idle_process(self) -> Process | None:
        with suppress(IndexError):
            while not (process := self._idle.pop()).process.is_alive():
                process.stop()
            return process
        return None

    def _received(self, process: Process, limits: Limits, clip: tuple[SolveTask, object, Path]) -> Outcome:
        """Return the outcome of a clip, or the limit that it exceeds."""
        process.give(clip)
        end, megabytes = time.monotonic() + limits.seconds, limits.megabytes
        while not process.line.poll(max(0.0, min(WATCH_SECONDS, end - time.monotonic()))):
            if self._stopped.is_set():
                return Outcome("lost", "the batch is over")
            if time.monotonic() >= end:
                return Outcome("time", f"it took longer than {limits.seconds:g} s", limits.seconds)
            with suppress(psutil.Error):
                if megabytes is not None and psutil.Process(process.process.pid).memory_info().rss > megabytes * 2**20:
                    return Outcome("memory", f"it took more memory than {megabytes:g} MB", megabytes)
        try:
            outcome = process.result()
        except WorkerEnded as error:
            return Outcome("lost", f"its process {error}")
        return replace(outcome, bound=megabytes) if outcome.cause == "memory" else outcome


@contextmanager
def _prepared(folder: Path) -> Iterator[None]:
    """Prepare a worker process: one thread of linear algebra, no graphics, imports excluded from garbage collection."""
    os.chdir(folder)
    os.environ.update({**dict.fromkeys(THREADS, "1"), "MUJOCO_GL": "disable"})
    from .. import motion, recordings, solving  # noqa: F401

    gc.freeze()
    yield


def _ready(task: object, folder: Path) -> Outcome:
    return READY


def _outcome(_: None, clip: tuple[SolveTask, Any, Path]) -> Outcome:
    """Return the outcome of do(task, folder), also if it raises an error, and release its memory."""
    do, task, folder = clip
    try:
        outcome = do(task, folder)
    except MemoryError as error:
        outcome = Outcome("memory", f"it took more memory than there is ({one_line(error)})")
    except UserError as error:
        outcome = Outcome("error", one_line(error))
    except Exception as error:
        at = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(at.filename).name}:{at.lineno}"
        outcome = Outcome("error", f"{type(error).__name__}: {one_line(error)} ({place})")
    gc.collect()
    if hasattr(libc := ctypes.CDLL(None), "malloc_trim"):
        libc.malloc_trim(0)  # otherwise glibc retains twice the used memory
    return outcome


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
