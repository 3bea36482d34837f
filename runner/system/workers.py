"""Items worked on by several processes at once, the results in order.

Every process opens its own tool, such as a stage to take pictures on, and keeps it. Few items are under way at a time,
so a long film is never in memory. However the loop over the results ends, no process is left: they do not listen to
Ctrl-C themselves but are told to stop, and a process whose parent is gone goes too.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import traceback
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from functools import partial
from multiprocessing.connection import Connection, wait
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from ..errors import UserError
from . import mujoco_warnings

if TYPE_CHECKING:
    Line = Connection[Any, Any]

Tool = TypeVar("Tool")
Item = TypeVar("Item")
Result = TypeVar("Result")
Opened = Callable[[], AbstractContextManager[Tool]]
Work = Callable[[Tool, Item], Result]

MOST_WORKERS = 60  # Windows waits for no more at a time
GRACE_SECONDS = 5.0
AHEAD = 2  # results for each process that may wait for an earlier one


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
    left = enumerate(items)
    results: dict[int, Result] = {}
    shown = 0
    crew: list[_Worker[Result]] = []
    try:
        with ctrl_c_blocked():
            for _ in range(workers):
                crew.append(_Worker(opened, work))
        while True:
            for worker in crew:
                if worker.number is None and len(results) < AHEAD * workers:
                    worker.give(*next(left, (None, None)))
            busy = {worker.line: worker for worker in crew if worker.number is not None}
            if not busy and not results:
                return
            for line in wait(list(busy), 0 if shown in results else None) if busy else ():
                number, result = busy[cast("Line", line)].result()
                results[number] = result
            if shown in results:
                yield results.pop(shown)
                shown += 1
    finally:
        for worker in crew:
            worker.line.close()
        for worker in crew:
            worker.stop()


class _Worker(Generic[Result]):
    """A process and the line to it. It works on the item of this number, or on none."""

    def __init__(self, opened: Callable[[], object], work: Callable[..., Result]) -> None:
        spawn = multiprocessing.get_context("spawn")
        self.line, theirs = spawn.Pipe()
        self.number: int | None = None
        self._process = spawn.Process(target=_serve, args=(theirs, opened, work), daemon=True)
        try:
            self._process.start()
        except OSError as error:
            why = error.strerror or error
            raise UserError(f"a worker process cannot be started: {why}; --workers 1 does without") from None
        theirs.close()

    def give(self, number: int | None, item: object) -> None:
        """One at a time: a process that is sending a result does not listen."""
        self.number = number
        if number is not None:
            with suppress(OSError):  # `result` tells what became of it
                self.line.send(item)

    def result(self) -> tuple[int, Result]:
        try:
            error, result, notes = self.line.recv()
        except (EOFError, OSError):
            raise self._lost() from None
        for note in notes:
            mujoco_warnings.pass_on(note)
        if error is not None:
            raise error
        number, self.number = cast(int, self.number), None
        return number, result

    def stop(self) -> None:
        """Its line is closed: it ends by itself if it has nothing to do."""
        if self.number is None:
            self._process.join(GRACE_SECONDS)
        self._process.terminate()
        self._process.join()

    def _lost(self) -> UserError:
        self._process.join(GRACE_SECONDS)
        code = self._process.exitcode or 0
        how = f"ended with code {code}"
        if code < 0:
            memory = "; too little memory?" if -code == 9 else ""
            how = f"was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'}{memory})"
        return UserError(f"a worker process {how}; --workers 1 does without")


@contextmanager
def ctrl_c_blocked() -> Iterator[None]:
    """Ctrl-C waits for the end of the block; processes started in it never get one. (Windows knows no such thing.)"""
    if sys.platform == "win32":
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # it would let Ctrl-C through again if it were started in the block
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(line: Line, opened: Callable[[], AbstractContextManager[Tool]], work: Callable[[Tool, Any], object]) -> None:
    """The life of a worker process: items in, results and notes out, until the line is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    notes: list[str] = []
    with mujoco_warnings.reported_to(notes.append), ExitStack() as stack, suppress(EOFError, OSError):
        do: Callable[[Any], object] | None = None
        while True:
            item = line.recv()
            try:
                do = do or partial(work, stack.enter_context(opened()))
                answer = (None, do(item), notes)
            except Exception as error:
                answer = (_portable(error), None, notes)
            line.send(answer)
            notes.clear()


def _portable(error: Exception) -> Exception:
    """The error, or its words if it does not survive the way to another process."""
    try:
        error.add_note(f"In a worker process:\n{traceback.format_exc()}")
        return pickle.loads(pickle.dumps(error))
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")
