"""A process that solves clips within bounds: it is ended when one takes too long or too much memory."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import Pipe
from pathlib import Path
from typing import TYPE_CHECKING, Any

import psutil

from ..system.threads import THREADS

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.connection import Connection

    from .task import Product

    Line = Connection[Any, Any]
    Do = Callable[[Any, Path], Product]

PROGRAM = "import sys; sys.path[:] = {path!r}; from dynsplines.batch.child import serve; serve({handle}, {parent})"
READY, BEGUN = "ready", "begun"
START_SECONDS = 120.0  # [s] that a worker may take to import what it needs
WATCH_SECONDS = 0.1  # [s] between looks at the clock and at memory
STARTS = 3  # a process may have gone for want of work just when it gets some


@dataclass(frozen=True)
class Bounds:
    """Of one clip: seconds by the clock, and MB of resident memory of its process, which needs some 220 to begin with.

    megabytes  None: an equal share of what the Dask worker may use
    """

    seconds: float = 3600.0
    megabytes: float | None = None


@dataclass(frozen=True)
class Outcome:
    """What became of a clip: what was made of it, or why nothing was.

    seconds  that it took; cause "", "error", "time", "memory" or "lost"; bound: the one that it came up against
    """

    seconds: float
    product: Product | None = None
    cause: str = ""
    error: str = ""
    bound: float | None = None

    @property
    def data(self) -> bytes | None:
        """The bytes of its output, if there are any."""
        return None if self.product is None else self.product.data


class _Gone(Exception):
    """The process has ended."""


class Bounded:
    """Works on one clip at a time, by a process that is started when there is none and kept for the next clip.

    folder   where the process keeps its files; prepare is called in it once, off the clock
    """

    def __init__(self, folder: Path, prepare: Callable[[], None]) -> None:
        self._folder, self._prepare = folder, prepare
        self._process: subprocess.Popen[bytes] | None = None
        self._place: tempfile.TemporaryDirectory[str] | None = None
        self._line: Line | None = None
        self._interrupted = False

    @property
    def process(self) -> int | None:
        """The number of the process, if there is one."""
        return None if self._process is None else self._process.pid

    def run(self, do: Do, task: object, bounds: Bounds) -> Outcome:
        """do(task, an empty folder) in the process. Does not raise: whatever happens is an outcome."""
        line, words = None, ""
        for _ in range(STARTS):
            try:
                line = self._line or self._started()
                line.send((do, task, bounds.seconds, bounds.megabytes))
                if line.poll(START_SECONDS) and line.recv() == BEGUN:
                    break
            except (_Gone, EOFError, OSError):
                line = None
            words = self._end()
            if self._interrupted:
                break
        else:
            return Outcome(0.0, cause="lost", error=words)
        if line is None or self._interrupted:  # perhaps before there was a process to end
            self.interrupt()
            return Outcome(0.0, cause="lost", error=self._end())
        outcome = self._watched(line, bounds, time.monotonic())
        if outcome.cause not in ("", "error"):
            self._end()
        return outcome

    def stop(self) -> None:
        """Ends the process; not while another thread waits for it in `run`."""
        self._end()

    def interrupt(self) -> None:
        """Ends the process from another thread, for good: `run` then finds that it has gone, and starts no other."""
        self._interrupted = True
        if self._process is not None:
            self._process.kill()

    def _watched(self, line: Line, bounds: Bounds, begin: float) -> Outcome:
        assert self._process is not None
        watched = psutil.Process(self._process.pid)
        while True:
            left = begin + bounds.seconds - time.monotonic()
            spent = time.monotonic() - begin
            try:
                if line.poll(max(0.0, min(WATCH_SECONDS, left))):
                    kind, what = line.recv()
                    spent = time.monotonic() - begin
                    if kind == "done":
                        return Outcome(spent, product=what)
                    if kind == "memory":
                        return Outcome(spent, None, kind, _too_much(bounds.megabytes, what), bounds.megabytes)
                    return Outcome(spent, None, kind, what)
            except (EOFError, OSError):
                return Outcome(spent, None, "lost", self._end())
            if left <= 0:
                return Outcome(spent, None, "time", f"it took longer than {bounds.seconds:g} s", bounds.seconds)
            if bounds.megabytes is not None:
                with suppress(psutil.Error):
                    if watched.memory_info().rss > bounds.megabytes * 2**20:
                        return Outcome(spent, None, "memory", _too_much(bounds.megabytes), bounds.megabytes)

    def _started(self) -> Line:
        """A process that is ready; raises _Gone or OSError."""
        self._place = tempfile.TemporaryDirectory(prefix="clip-", dir=self._folder, ignore_cleanup_errors=True)
        self._line, theirs = Pipe()
        path = [str(Path(entry).absolute()) for entry in sys.path]
        program = PROGRAM.format(path=path, handle=theirs.fileno(), parent=os.getpid())
        with theirs, (Path(self._place.name) / "said").open("wb") as said:
            self._process = subprocess.Popen(
                [sys.executable, "-c", program],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=said,
                pass_fds=(theirs.fileno(),),
                cwd=self._place.name,
                env={**os.environ, **dict.fromkeys(THREADS, "1"), "MUJOCO_GL": "disable"},
            )
        self._line.send(self._prepare)
        if not self._line.poll(START_SECONDS) or self._line.recv() != READY:
            raise _Gone
        return self._line

    def _end(self) -> str:
        """Ends the process and says how it ended, had it not been for us."""
        words = "its process could not be started"
        if self._line is not None:
            self._line.close()
            self._line = None
        if self._process is not None:
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(WATCH_SECONDS)
            words = _ending(self._process.returncode)
            self._process.kill()
            self._process.wait()
            self._process = None
        if self._place is not None:
            last = _last_line(Path(self._place.name) / "said")
            words += f": {last}" if last else ""
            self._place.cleanup()
            self._place = None
        return words


def _too_much(megabytes: float | None, more: str = "") -> str:
    bound = "there is" if megabytes is None else f"{megabytes:g} MB"
    return f"it took more memory than {bound}{more and f' ({more})'}"


def _ending(code: int | None) -> str:
    if code is None:
        return "its process did not answer"
    if code >= 0:
        return f"its process ended with code {code}"
    memory = "; too little memory?" if -code == signal.SIGKILL else ""
    return f"its process was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'}{memory})"


def _last_line(path: Path) -> str:
    with suppress(OSError):
        lines = path.read_bytes()[-4000:].decode(errors="replace").splitlines()
        return next((line.strip() for line in reversed(lines) if line.strip()), "")
    return ""
