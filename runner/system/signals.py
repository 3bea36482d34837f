"""Signals that end a command: hangup, SIGTERM and a limit of processor time act like Ctrl-C, with separate exit codes.

The best result of a search is then written. The exit code still reports the signal, 129, 143 or 152, so that the sender
can detect the interruption. This module imports almost nothing, because the handlers are set before any slow import.
"""

from __future__ import annotations

import os
import signal
from types import FrameType

FIRST = 128  # offset of the exit code to the signal's number
STOPPED = FIRST + signal.SIGINT  # exit code of Ctrl-C
HANDLED = ("SIGINT", "SIGTERM", "SIGHUP", "SIGXCPU")  # Windows lacks the last two
TERMINALS = 1, 2  # stdout and stderr, which cannot be written to after a hangup of their terminal

_received: int | None = None
_terminals: list[int] = []


def install_handlers() -> None:
    """Set the handlers, except for signals that this process was started to ignore."""
    global _received
    _received = None
    _terminals[:] = filter(os.isatty, TERMINALS)
    for number in _signals():
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _stop)


def ignore() -> None:
    """Ignore signals: the command is about to end."""
    for number in _signals():
        signal.signal(number, signal.SIG_IGN)


def was_received() -> bool:
    """Return whether a signal was received."""
    return _received is not None


def code(otherwise: int) -> int:
    """Return the exit code of the received signal, except Ctrl-C, or else `otherwise`."""
    return otherwise if _received in (None, signal.SIGINT) else FIRST + int(_received)


def _signals() -> list[signal.Signals]:
    return [getattr(signal, name) for name in HANDLED if hasattr(signal, name)]


def _stop(number: int, frame: FrameType | None) -> None:
    """Handle a signal like Ctrl-C: call its handler, or else raise KeyboardInterrupt."""
    global _received
    _received = number
    if number == getattr(signal, "SIGXCPU", None):
        signal.signal(number, signal.SIG_IGN)  # it is sent again every second
    if number == getattr(signal, "SIGHUP", None):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        for stream in _terminals:
            os.dup2(nowhere, stream)
    handler = signal.getsignal(signal.SIGINT)
    if callable(handler) and handler is not _stop:
        handler(number, frame)
        return
    raise KeyboardInterrupt
