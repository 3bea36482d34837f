"""The process that solves, seen from the server: begun, spoken to, heard; begun again when it is lost."""

from __future__ import annotations

import asyncio
import multiprocessing
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from ..errors import UserError
from ..scene.outside import is_allowed
from ..system.workers import ctrl_c_blocked
from .solving.process import entry

Message = dict[str, Any]
SHORT = 0.2  # [s] for one that has nothing to do
PATIENCE = 5.0  # [s] that a process may take to end by itself
MOST_LOSSES = 5  # in a row, without one answer: then it is not begun again


class Solver:
    """A process and the line to it.

    heard  gets every message of its, in the server's own thread
    lost   is called when the process has ended without having been asked to, and another one has been begun
    """

    def __init__(self, heard: Callable[[Message], None], lost: Callable[[str], None]) -> None:
        self.heard, self.lost = heard, lost
        self._line: Any = None
        self._process: Any = None
        self._losses = 0
        self._is_closed = False
        self._loop: asyncio.AbstractEventLoop | None = None

    @property
    def is_started(self) -> bool:
        """Whether there is a process."""
        return self._process is not None

    def start(self, *, is_seen: bool = False) -> None:
        """Starts the process; what it needs is imported over there, at leisure if something is seen already."""
        spawn = multiprocessing.get_context("spawn")
        self._line, theirs = spawn.Pipe()
        self._process = spawn.Process(target=entry, args=(theirs, is_allowed(), is_seen), daemon=True, name="solver")
        try:
            with ctrl_c_blocked():
                self._process.start()
        except OSError as error:
            raise UserError(f"the process that solves cannot be started: {error.strerror or error}") from None
        theirs.close()

    def listen(self) -> None:
        """From now on messages go to the running event loop."""
        self._loop = asyncio.get_running_loop()
        threading.Thread(target=self._listen, args=(self._line, self._process), daemon=True).start()

    def send(self, message: Message) -> None:
        """A message to the process; if it is gone, it is told that it is lost soon."""
        with suppress(OSError, ValueError):
            self._line.send(message)

    def close(self) -> None:
        """Ends the process."""
        self._is_closed = True
        with suppress(OSError, AttributeError):
            self._line.close()
        if self._process is None:
            return
        self._process.join(SHORT)
        if self._process.is_alive():
            self._process.terminate()
            self._process.join(PATIENCE)

    def begin_anew(self) -> None:
        """Ends the process where it is; another one goes on from the last path."""
        if self._process is not None:
            self._process.kill()

    def _listen(self, line: Any, process: Any) -> None:
        """In a thread of its own: what comes, until the line ends."""
        with suppress(EOFError, OSError, TypeError):  # the last of a line that is closed here meanwhile
            while True:
                message = line.recv()
                self._losses = 0
                self._tell(self.heard, message)
        if not self._is_closed:
            process.join(PATIENCE)
            self._tell(self._begin_again, process.exitcode)

    def _tell(self, to: Callable[[Any], None], what: Any) -> None:
        with suppress(RuntimeError):  # the server has ended meanwhile
            assert self._loop is not None
            self._loop.call_soon_threadsafe(to, what)

    def _begin_again(self, code: int | None) -> None:
        if self._is_closed:
            return
        self._losses += 1
        how = f"was ended by signal {-code}" if code is not None and code < 0 else f"ended with code {code}"
        if self._losses > MOST_LOSSES:
            self.heard({"is": "gone", "words": f"the process that solves {how}, again and again; too little memory?"})
            return
        self.start()
        self.listen()
        self.lost(f"the process that solves {how}; another one goes on from the last path")
