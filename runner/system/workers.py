"""Worker processes, each of which opens a tool and applies it to one item after another.

No worker outlives the program: workers ignore Ctrl-C and end with their connection, and a thread in each ends it with
its parent, even during an item.
"""

from __future__ import annotations

import gc
import math
import multiprocessing
import os
import pickle
import signal
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import wait as wait_for
from contextlib import AbstractContextManager, contextmanager, suppress
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

from ..errors import UserError
from . import mujoco_warnings

Tool = TypeVar("Tool")
Item = TypeVar("Item")
Result = TypeVar("Result")
Opened = Callable[[], AbstractContextManager[Tool]]
Work = Callable[[Tool, Item], Result]

MOST_WORKERS = 60  # maximum number of processes for which Windows can wait
GRACE_SECONDS = 5.0  # [s] time in which a process should end
START_SECONDS = 120.0  # [s] time in which a process should start and open its tool
WATCH_SECONDS = 0.1  # [s] interval of checks whether results are still needed
AHEAD = 2  # results per process that may wait for an earlier one


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
    pool, futures = _Pool(opened, work), deque[Future[Result]]()
    with ThreadPoolExecutor(workers) as threads:
        try:
            for item in items:
                futures.append(threads.submit(pool.run, item))
                if len(futures) >= AHEAD * workers:
                    yield _result(futures.popleft())
            while futures:
                yield _result(futures.popleft())
        except WorkerEnded as error:
            raise UserError(f"a worker process {error}; --workers 1 does without") from None
        finally:
            pool.stop()
            threads.shutdown(cancel_futures=True)


def _result(future: Future[Result]) -> Result:
    """Return a future result. On Windows, Ctrl-C interrupts only waits with a timeout."""
    while not wait_for([future], WATCH_SECONDS).done:
        pass
    return future.result()


class _Pool:
    """Worker processes, one for every thread that calls `run` at the same time."""

    def __init__(self, opened: Opened[Any], work: Work[Any, Any, Any]) -> None:
        self._start = (opened, work)
        self._idle: list[_Worker] = []
        self._stopped = threading.Event()

    def run(self, item: object) -> Any:
        """Return work(tool, item). Raises UserError if no more processes can be started.

        Any error ends the process.
        """
        worker = self._idle_worker()
        is_new = worker is None
        if worker is None:
            worker = _Worker(*self._start)
        try:
            if is_new:
                self._wait(worker, START_SECONDS)
            worker.give(item)
            result = self._wait(worker)
        except BaseException:
            worker.stop()
            raise
        self._idle.append(worker)
        if self._stopped.is_set():
            self.stop()
        return result

    def stop(self) -> None:
        """End all processes: idle ones close their tools, the others end within WATCH_SECONDS."""
        self._stopped.set()
        idle = list(iter(self._idle_worker, None))
        for worker in idle:
            worker.line.close()
        for worker in idle:
            worker.stop(GRACE_SECONDS)

    def _idle_worker(self) -> _Worker | None:
        with suppress(IndexError):
            return self._idle.pop()
        return None

    def _wait(self, worker: _Worker, seconds: float = math.inf) -> Any:
        """Return the next answer of a process."""
        end = time.monotonic() + seconds
        while not worker.line.poll(WATCH_SECONDS):
            if self._stopped.is_set():
                raise WorkerEnded("was stopped")
            if time.monotonic() >= end:
                raise WorkerEnded(f"did not start within {seconds:g} s")
        return worker.result()


class WorkerEnded(Exception):
    """A worker process has ended; the text describes how."""


class _Worker:
    """A process with a tool, and the connection to it. Its first answer is None."""

    def __init__(self, opened: Opened[Any], work: Work[Any, Any, Any]) -> None:
        spawn = multiprocessing.get_context("spawn")
        self.line, theirs = spawn.Pipe()
        self.process = spawn.Process(target=_serve, args=(theirs, opened, work), daemon=True)
        try:
            with ctrl_c_blocked():
                self.process.start()
        except OSError as error:
            why = error.strerror or error
            raise UserError(f"a worker process cannot be started: {why}; --workers 1 does without") from None
        finally:
            theirs.close()

    def give(self, item: object) -> None:
        """Send an item. Wait for its result before the next one."""
        with suppress(OSError):  # `result` reports the end of the process
            self.line.send(item)

    def result(self) -> Any:
        """Return the result of the item. Raises the error of the work, and WorkerEnded."""
        try:
            error, result, notes = self.line.recv()
        except (EOFError, OSError):
            raise WorkerEnded(self._ending()) from None
        for note in notes:
            mujoco_warnings.pass_on(note)
        if error is not None:
            raise error
        return result

    def stop(self, patience: float = 0.0) -> None:
        """End the process, by force after a timeout [s]."""
        self.line.close()
        if patience:
            self.process.join(patience)
        self.process.kill()
        self.process.join()

    def _ending(self) -> str:
        """Return how the process ended."""
        self.process.join(GRACE_SECONDS)
        code = self.process.exitcode
        if code is None:
            return "did not answer"
        if code >= 0:
            return f"ended with code {code}"
        memory = "; too little memory?" if code == -9 else ""
        return f"was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'}{memory})"


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


def _serve(line: Connection[Any, Any], opened: Opened[Any], work: Work[Any, Any, Any]) -> None:
    """Open the tool, then receive items and send results with their notes, until the connection closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    notes: list[str] = []
    with mujoco_warnings.reported_to(notes.append), suppress(EOFError, OSError):
        try:
            with opened() as tool:
                line.send((None, None, notes))
                while True:
                    item = line.recv()
                    notes.clear()
                    line.send((None, work(tool, item), notes))
        except Exception as error:
            line.send((_portable(error), None, notes))
    gc.freeze()  # without a garbage collection, the process ends sooner


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    wait([parent.sentinel])
    os._exit(1)


def _portable(error: Exception) -> Exception:
    """Return the error, or its text if it cannot be sent to another process."""
    try:
        error.add_note(f"In a worker process:\n{traceback.format_exc()}")
        return pickle.loads(pickle.dumps(error))
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")
