"""Worker processes, each of which opens a tool and applies it to one item after another.

No worker outlives the program: workers ignore Ctrl-C and end with their connection, and a thread in each ends it with
its parent, even during an item.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import IO, Any, Generic, TypeVar

from ..errors import UserError
from . import mujoco_warnings

Tool = TypeVar("Tool")
Item = TypeVar("Item")
Result = TypeVar("Result")
Opened = Callable[[], AbstractContextManager[Tool]]
Work = Callable[[Tool, Item], Result]

MOST_WORKERS = 60  # maximum number of processes for which Windows can wait
GRACE_SECONDS = 5.0  # [s] time in which a process should end
AHEAD = 2  # results per process that may wait for an earlier one


def cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def in_order(
    opened: Opened[Tool], work: Work[Tool, Item, Result], items: Iterable[Item], workers: int = 1
) -> Generator[Result, None, None]:
    """Yield work(tool, item) for every item, in order, computed by this process or by `workers` others.

    Few results are computed ahead, so that a long video is never in memory. Raises the errors of the work, and
    UserError if a process ends. For several workers see `Worker`.
    """
    if workers > 1:
        yield from _by_several(opened, work, items, workers)
        return
    with opened() as tool:
        for item in items:
            yield work(tool, item)


def _by_several(
    opened: Opened[Tool], work: Work[Tool, Item, Result], items: Iterable[Item], count: int
) -> Generator[Result, None, None]:
    remaining = enumerate(items)
    results: dict[int, Result] = {}
    shown = 0
    idle: list[Worker[Tool, Item, Result]] = []
    busy: dict[Any, tuple[int, Worker[Tool, Item, Result]]] = {}
    try:
        for _ in range(count):
            idle.append(Worker(opened, work))
        while True:
            while idle and len(results) < AHEAD * count and (following := next(remaining, None)) is not None:
                number, item = following
                worker = idle.pop(0)
                busy[worker.line] = number, worker
                worker.give(item)
            if not busy and not results:
                return
            for line in wait(list(busy), 0 if shown in results else None) if busy else ():
                number, worker = busy[line]
                results[number] = worker.result()
                del busy[line]
                idle.append(worker)
            if shown in results:
                yield results.pop(shown)
                shown += 1
    except WorkerEnded as error:
        raise UserError(f"a worker process {error}; --workers 1 does without") from None
    finally:
        for worker in idle:
            worker.line.close()
        for worker in idle:
            worker.stop(GRACE_SECONDS)  # the process closes its tool
        for _, worker in busy.values():
            worker.stop()


class WorkerEnded(Exception):
    """A worker process has ended; the text describes how."""


class Worker(Generic[Tool, Item, Result]):
    """A process with a tool, and the connection to it.

    Tool, work and items must be picklable, and the program importable without running (`if __name__ == "__main__"`).

    Args:
        opened: Opens the tool, before the first item.
        work: (tool, item) -> result.
        idle: The time without an item after which the process ends [s]; None: never.
        errors: A temporary file for its standard error, closed with it.

    Raises:
        UserError: No more processes can be started.
    """

    def __init__(
        self,
        opened: Opened[Tool],
        work: Work[Tool, Item, Result],
        idle: float | None = None,
        errors: IO[bytes] | None = None,
    ) -> None:
        spawn = multiprocessing.get_context("spawn")
        self.line, theirs = spawn.Pipe()
        args = (theirs, opened, work, idle, None if errors is None else errors.name)
        self.process = spawn.Process(target=_serve, args=args, daemon=True)
        self._errors = errors
        try:
            with ctrl_c_blocked():
                self.process.start()
        except OSError as error:
            why = error.strerror or error
            raise UserError(f"a worker process cannot be started: {why}; --workers 1 does without") from None
        finally:
            theirs.close()

    def give(self, item: Item) -> None:
        """Send an item. Wait for its result before the next one."""
        with suppress(OSError):  # `result` reports the end of the process
            self.line.send(item)

    def result(self) -> Result:
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
        if self._errors is not None:
            self._errors.close()

    def _ending(self) -> str:
        """Return how the process ended, with the last line of its standard error."""
        self.process.join(GRACE_SECONDS)
        code = self.process.exitcode
        text = "did not answer" if code is None else f"ended with code {code}"
        if code is not None and code < 0:
            memory = "; too little memory?" if -code == 9 else ""
            text = f"was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'}{memory})"
        lines = self._errors.read()[-4000:].decode(errors="replace").splitlines() if self._errors else []
        return next((f"{text}: {line.strip()}" for line in reversed(lines) if line.strip()), text)


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


def _serve(
    line: Connection[Any, Any],
    opened: Opened[Tool],
    work: Work[Tool, Any, object],
    idle: float | None,
    errors: str | None,
) -> None:
    """Receive items and send results with their notes, until the connection closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    if errors is not None:
        with Path(errors).open("wb") as stream:
            os.dup2(stream.fileno(), 2)
    notes: list[str] = []
    with mujoco_warnings.reported_to(notes.append), ExitStack() as stack, suppress(EOFError, OSError):
        tools: list[Tool] = []
        while line.poll(idle):
            item = line.recv()
            try:
                if not tools:
                    tools.append(stack.enter_context(opened()))
                answer = (None, work(tools[0], item), notes)
            except Exception as error:
                answer = (_portable(error), None, notes)
            line.send(answer)
            notes.clear()


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
