"""A process for a clip, which is ended when it takes too long or too much memory.

It is forked from a server that has imported everything, so that it begins at once and leaves nothing to the next clip.
The server ends with the program that started it, and each of its processes with the server: on Linux the kernel ends
them. Elsewhere an alarm ends a process at the latest when its time is over.
"""

from __future__ import annotations

import ctypes
import os
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from typing import IO, Any

import psutil

from ..errors import UserError, one_line
from ..system.threads import THREADS
from .task import Product

Do = Callable[[Any, Path], Product]

PROGRAM = "import sys; sys.path[:] = {path!r}; from dynsplines.batch.child import serve; serve({handle}, {parent})"
START_SECONDS = 120.0  # [s] that a server may take to import what it needs
WATCH_SECONDS = 0.1  # [s] between looks at the clock and at memory
IDLE_SECONDS = 120.0  # [s] without work, after which a server ends: its program may be on another machine
LATER_SECONDS = 5.0  # [s] after its time, an alarm ends a process that nothing watches
SLACK = 256  # [MB] that a process has asked for and does not use: the kernel counts it
STARTS = 3  # a server may end for want of work just when it gets some
PR_SET_PDEATHSIG = 1  # of Linux's prctl


@dataclass(frozen=True)
class Bounds:
    """Of one clip: seconds by the clock, and MB of resident memory of its process, which needs some 220 to begin with.

    megabytes  None: an equal share of what the machine has, or the Dask worker may use
    """

    seconds: float = 3600.0
    megabytes: float | None = None


@dataclass(frozen=True)
class Outcome:
    """The product of a clip, or why there is none.

    cause  "", "error", "time", "memory" or "lost" (the process ended); bound: the one that was exceeded
    """

    product: Product | None = None
    cause: str = ""
    error: str = ""
    bound: float | None = None
    seconds: float = 0.0
    worker: str = ""


class Crew:
    """Runs clips, each in a process; stop ends all of them."""

    def __init__(self, folder: Path, megabytes: float | None) -> None:
        """Folder for the clips' files, and [MB] of memory for a clip whose bounds specify none."""
        self._folder, self._megabytes = folder, megabytes
        self._idle: list[_Server] = []
        self._over = threading.Event()

    def run(self, do: Do, task: object, bounds: Bounds) -> Outcome:
        """Return the outcome of do(task, an empty folder) in a process; from any thread."""
        if bounds.megabytes is None:
            bounds = replace(bounds, megabytes=self._megabytes)
        try:
            server = self._idle.pop()
        except IndexError:
            server = _Server(self._over)
        try:
            with tempfile.TemporaryDirectory(prefix="clip-", dir=self._folder, ignore_cleanup_errors=True) as place:
                return server.run(pickle.dumps((do, task, place, bounds)), bounds)
        finally:
            self._idle.append(server)
            if self._over.is_set():
                server.stop()

    def stop(self) -> None:
        """End all processes; those at work end within `WATCH_SECONDS`, with an outcome that is lost."""
        self._over.set()
        for server in self._idle:
            server.stop()


class _Server:
    """A process that forks one for each clip; it is started when there is a clip and none."""

    def __init__(self, over: threading.Event) -> None:
        self._over = over
        self._said: IO[bytes] | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._line: Connection | None = None

    def run(self, message: bytes, bounds: Bounds) -> Outcome:
        words = "the batch is over"
        for _ in range(STARTS):
            if self._over.is_set():
                break
            try:
                line = self._line or self._start()
                line.send_bytes(message)
                if line.poll(START_SECONDS):
                    return self._watch(line, line.recv(), bounds)
                words = "its process did not answer"
            except (EOFError, OSError):
                words = _ending(self._process.wait() if self._process else None)
            words += self._last_line()
            self.stop()
        return Outcome(cause="lost", error=words)

    def _start(self) -> Connection:
        self._line, theirs = Pipe()
        self._said = tempfile.TemporaryFile("a+b")  # noqa: SIM115, closed by `stop`
        path = [str(Path(entry).absolute()) for entry in sys.path]
        program = PROGRAM.format(path=path, handle=theirs.fileno(), parent=os.getpid())
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-c", program],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=self._said,
                pass_fds=(theirs.fileno(),),
                env={**os.environ, **dict.fromkeys(THREADS, "1"), "MUJOCO_GL": "disable"},
            )
        return self._line

    def _watch(self, line: Connection, child: int, bounds: Bounds) -> Outcome:
        """The outcome of a process that has begun, once it has ended."""
        begin, outcome, spent = time.monotonic(), None, 0.0
        try:
            while True:
                spent = time.monotonic() - begin
                if line.poll(max(0.0, min(WATCH_SECONDS, bounds.seconds - spent)) if outcome is None else None):
                    answer = line.recv()
                    spent = time.monotonic() - begin
                    if isinstance(answer, int):
                        outcome = outcome or Outcome(cause="lost", error=_ending(answer) + self._last_line())
                        return replace(outcome, seconds=outcome.seconds or spent)
                    outcome = replace(answer, seconds=spent)
                    self._last_line()
                elif outcome is None and (exceeded := self._exceeded(child, spent, bounds)):
                    outcome = replace(exceeded, seconds=spent)
                    with suppress(ProcessLookupError):
                        os.kill(child, signal.SIGKILL)
        except (EOFError, OSError):
            words = _ending(self._process.wait() if self._process else None) + self._last_line()
            self.stop()
            return Outcome(cause="lost", error=words, seconds=spent)

    def _exceeded(self, child: int, spent: float, bounds: Bounds) -> Outcome | None:
        """The outcome that a bound, or the end of the batch, forces on a process."""
        if self._over.is_set():
            return Outcome(cause="lost", error="the batch is over")
        if spent >= bounds.seconds:
            return Outcome(cause="time", error=f"it took longer than {bounds.seconds:g} s", bound=bounds.seconds)
        with suppress(psutil.Error):
            if bounds.megabytes is not None and psutil.Process(child).memory_info().rss > bounds.megabytes * 2**20:
                return _too_much(bounds.megabytes)
        return None

    def stop(self) -> None:
        """End the server."""
        if self._line is not None:
            self._line.close()
            self._line = None
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None
        if self._said is not None:
            self._said.close()
            self._said = None

    def _last_line(self) -> str:
        """The last line that the process has printed, and no clip before it."""
        if self._said is None:
            return ""
        self._said.seek(0)
        lines = [line.strip() for line in self._said.read()[-4000:].decode(errors="replace").splitlines()]
        self._said.truncate(0)
        return next((f": {line}" for line in reversed(lines) if line), "")


def _too_much(megabytes: float | None, more: str = "") -> Outcome:
    bound = "there is" if megabytes is None else f"{megabytes:g} MB"
    return Outcome(None, "memory", f"it took more memory than {bound}{more and f' ({more})'}", megabytes)


def _ending(code: int | None) -> str:
    if code is None:
        return "its process could not be started"
    if code >= 0:
        return f"its process ended with code {code}"
    memory = "; too little memory?" if -code == signal.SIGKILL else ""
    return f"its process was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'}{memory})"


def serve(handle: int, parent: int) -> None:
    """The server's program: for every task a process, its number first, its outcome, and how it ended."""
    _end_with(parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    from .. import motion, work  # noqa: F401, for all processes, and off the clock

    line, server = Connection(handle), os.getpid()
    with suppress(EOFError, OSError):
        while line.poll(IDLE_SECONDS):
            message = line.recv_bytes()
            child = os.fork()
            if not child:
                try:
                    _end_with(server)
                    line.send(os.getpid())
                    line.send(_outcome(*pickle.loads(message)))
                finally:
                    os._exit(0)
            _, status = os.waitpid(child, 0)
            line.send(os.waitstatus_to_exitcode(status))


def _outcome(do: Do, task: object, place: str, bounds: Bounds) -> Outcome:
    """Of do, in this process, which is for nothing else."""
    os.chdir(place)
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_REAL, bounds.seconds + LATER_SECONDS)
    if bounds.megabytes is not None:
        hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
        soft = int((bounds.megabytes + SLACK) * 2**20)
        resource.setrlimit(resource.RLIMIT_DATA, (soft if hard == resource.RLIM_INFINITY else min(soft, hard), hard))
    try:
        return Outcome(do(task, Path(place)))
    except MemoryError as error:
        return _too_much(bounds.megabytes, one_line(error))
    except UserError as error:
        return Outcome(cause="error", error=one_line(error))
    except Exception as error:
        at = traceback.extract_tb(error.__traceback__)[-1]
        words = f"{type(error).__name__}: {one_line(error)} ({Path(at.filename).name}:{at.lineno})"
        return Outcome(cause="error", error=words)


def _end_with(parent: int) -> None:
    """End when the parent ends (Linux)."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
