"""The process that solves clips, one after another, for the process that started it. It can be ended at any time.

It goes when its parent goes, even while it is deep in a computation that listens to nobody: the kernel sees to that
(Linux), and else that no clip takes longer than it may. It goes by itself when it has had nothing to do for a while.
"""

from __future__ import annotations

import ctypes
import gc
import os
import resource
import shutil
import signal
import sys
import traceback
from collections.abc import Callable
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import UserError, one_line
from .bounded import BEGUN, READY

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .task import Product

    Line = Connection[Any, Any]
    Do = Callable[[Any, Path], Product]

IDLE_SECONDS = 120.0  # [s] without work, after which a worker that lost its driver ends
LATER_SECONDS = 5.0  # the parent's clock comes first
SLACK = 256  # [MB] that a process has asked for and does not use: the kernel counts it
PR_SET_PDEATHSIG = 1


def serve(handle: int, parent: int) -> None:
    """The life of the process: what prepares it, then a clip in, its outcome out, until the line is closed."""
    _go_with(parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    line: Line = Connection(handle)
    with suppress(EOFError, OSError):
        line.recv()()
        line.send(READY)
        while line.poll(IDLE_SECONDS):
            do, task, seconds, megabytes = line.recv()
            line.send(BEGUN)
            line.send(_answer(do, task, seconds, megabytes))


def _answer(do: Do, task: object, seconds: float, megabytes: float | None) -> tuple[str, object]:
    """ "done" and the product, or "error" or "memory" and a line."""
    folder = Path("clip").absolute()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    try:
        with _alarm(seconds + LATER_SECONDS), _room(megabytes):
            answer = "done", do(task, folder)
    except MemoryError as error:
        answer = "memory", one_line(error)
    except UserError as error:
        answer = "error", one_line(error)
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        words = f"{type(error).__name__}: {one_line(error)} ({Path(place.filename).name}:{place.lineno})"
        answer = "error", words
    shutil.rmtree(folder, ignore_errors=True)
    gc.collect()
    _give_back()
    return answer


def _give_back() -> None:
    """Memory that a clip took goes back to the system (glibc), which would otherwise keep twice of what is in use."""
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)


@contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    """The kernel ends this process then, whatever it is at."""
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


@contextmanager
def _room(megabytes: float | None) -> Iterator[None]:
    """What goes far beyond the bound at once is refused (Linux); the parent watches what is used."""
    if megabytes is None:
        yield
        return
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    soft = int((megabytes + SLACK) * 2**20)
    resource.setrlimit(resource.RLIMIT_DATA, (soft if hard == resource.RLIM_INFINITY else min(soft, hard), hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, (hard, hard))


def _go_with(parent: int) -> None:
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        sys.exit("the parent is gone")
