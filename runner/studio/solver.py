"""The solver process, as seen from the server: start, messages, and restart after a crash."""

from __future__ import annotations

import asyncio
import ctypes
import itertools
import multiprocessing
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from ..errors import UserError
from ..scene.file_access import is_allowed
from ..system.workers import ctrl_c_blocked

Message = dict[str, Any]  # JSON between pages, server and solver: "do" names a request, "is" an answer
ANSWER_TIMEOUT = 60.0  # [s] time limit for an answer
MOST_LOSSES = 5  # consecutive crashes without an answer after which it is not restarted


class Solver:
    """The solver process and its connection.

    Args:
        receive: Receives every message that answers no request of `ask`, in the server's thread.
        resume: Called when the process has ended unexpectedly and a new one has been started.
    """

    def __init__(self, receive: Callable[[Message], None], resume: Callable[[str], None]) -> None:
        self.receive, self.resume = receive, resume
        self._line: Any = None
        self._process: Any = None
        self._losses = 0
        self._numbers = itertools.count(1)
        self._answers: dict[int, asyncio.Future[Message]] = {}  # of requests without an answer yet, by their ids
        self._is_closed = False
        self._loop: asyncio.AbstractEventLoop | None = None

    @property
    def is_started(self) -> bool:
        return self._process is not None

    def start(self) -> None:
        """Start the process, which imports in the background."""
        spawn = multiprocessing.get_context("spawn")
        self._line, theirs = spawn.Pipe()
        self._process = spawn.Process(target=entry, args=(theirs, is_allowed()), daemon=True, name="solver")
        try:
            with ctrl_c_blocked():
                self._process.start()
        except OSError as error:
            raise UserError(f"the solver process cannot be started: {error.strerror or error}") from None
        theirs.close()

    def listen(self) -> None:
        """Deliver messages to the running event loop from now on."""
        self._loop = asyncio.get_running_loop()
        threading.Thread(target=self._listen, args=(self._line, self._process), daemon=True).start()

    def send(self, message: Message) -> None:
        """Send a message to the process. If the process has ended, `resume` is called soon afterwards."""
        with suppress(OSError, ValueError):
            self._line.send(message)

    async def ask(self, message: Message) -> Message:
        """Return the answer to a request. Raises UserError for a refusal, after a crash, and after a time limit."""
        number = next(self._numbers)
        answer = self._answers[number] = asyncio.get_running_loop().create_future()
        self.send({**message, "id": number})
        try:
            received: Message = await asyncio.wait_for(answer, ANSWER_TIMEOUT)
        except TimeoutError:
            self.restart()  # otherwise it would finish this request first
            raise UserError(f"the solver process took longer than {ANSWER_TIMEOUT:g} s") from None
        finally:
            del self._answers[number]
        if received["is"] == "refused":
            raise UserError(received["words"])
        return received

    def close(self) -> None:
        self._is_closed = True
        with suppress(OSError, AttributeError):
            self._line.close()
        if self._process is None:
            return
        self._process.join(0.2)  # [s]; an idle process ends with its connection
        if self._process.is_alive():
            self._process.terminate()
            self._process.join(5)

    def restart(self) -> None:
        """End the process at once. A new one starts."""
        if self._process is not None:
            self._process.kill()

    def _listen(self, line: Any, process: Any) -> None:
        """Receive messages in a separate thread, until the connection closes."""
        with suppress(EOFError, OSError, TypeError):  # the connection is being closed
            while True:
                message = line.recv()
                self._losses = 0
                self._deliver(self.answer, message)
        if not self._is_closed:
            process.join(5)  # [s]
            self._deliver(self._recover, process.exitcode)

    def answer(self, message: Message) -> None:
        """Pass a message to the request that it answers, or else to `receive`."""
        number = message.pop("id", None)
        if number is None:
            self.receive(message)
        elif number in self._answers and not self._answers[number].done():
            self._answers[number].set_result(message)

    def _deliver(self, to: Callable[[Any], None], what: Any) -> None:
        with suppress(RuntimeError):  # the server has ended
            assert self._loop is not None
            self._loop.call_soon_threadsafe(to, what)

    def _recover(self, code: int | None) -> None:
        if self._is_closed:
            return
        self._losses += 1
        how = f"was ended by signal {-code}" if code is not None and code < 0 else f"ended with code {code}"
        words = f"the solver process {how}; a new one solves the clip again"
        if self._losses > MOST_LOSSES:
            words = f"the solver process {how} repeatedly; free memory, then start the studio again"
        for number in self._answers:
            self.answer({"is": "refused", "id": number, "words": words})
        if self._losses > MOST_LOSSES:
            self.receive({"is": "gone", "words": words})
            return
        self.start()
        self.listen()
        self.resume(words)


def release_memory() -> None:
    """Return freed memory to the system; where glibc keeps it, a process grows with every edit."""
    with suppress(OSError, AttributeError, TypeError):  # other C libraries
        ctypes.CDLL(None).malloc_trim(0)


def entry(line: Any, outside: bool) -> None:
    """Run the solver process. With `outside`, models may refer to files anywhere.

    Numerical libraries are imported here, because the server does without them.
    """
    from ..picture.graphics import do_without
    from ..system import mujoco_warnings
    from ..system.threads import use_one_thread, without_tools

    use_one_thread()
    do_without()
    without_tools()
    from .loop import serve

    with mujoco_warnings.reported_to(mujoco_warnings.print_note):
        serve(line, outside)
