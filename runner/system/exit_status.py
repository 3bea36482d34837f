"""The end of a command: its exit code, and one line on stderr for every error."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn, cast

import typer

from ..errors import UserError, locate, one_line
from . import signals

INTERNAL = 4  # exit code of an internal error
DEBUG = "DYNSPLINES_DEBUG"
HOW = "what the same command prints as `dynsplines --debug ...`"
UsageError = cast("type[typer.BadParameter]", typer.BadParameter.__mro__[1])  # typer's own, or click's
NO_ROOM = (  # messages without enough memory: of the linker, of MuJoCo, and of Python
    "failed to map segment",
    "annot allocate memory",
    "ould not allocate memory",
    "error return without exception set",
)


def run(command: Callable[[], int | None]) -> NoReturn:
    """Exit with a command's exit code. Invalid input and internal errors are reported in one line."""
    try:
        from . import mujoco_warnings  # imported here so that a lack of memory during the import is reported too
        from .threads import use_one_thread

        use_one_thread()
        fit_terminal()
        with mujoco_warnings.reported_to(mujoco_warnings.print_note):
            code = command()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # avoids an error of Python at exit
        sys.exit(1)
    except SystemExit:
        raise
    except BaseException as error:
        code, line = _ending(error)
        if code == INTERNAL and os.environ.get(DEBUG):
            raise
        _end(code, line)
    if code == signals.STOPPED:  # typer's handling of Ctrl-C
        _end(signals.code(signals.STOPPED), "stopped")
    sys.exit(signals.code(code or 0))


def _ending(error: BaseException) -> tuple[int, str]:
    """Return the exit code for an error, and its message."""
    match error:
        case UserError():
            return 2, one_line(error)
        case UsageError():
            return 2, one_line(_usage(error))
        case typer.Abort():
            return signals.code(signals.STOPPED), "stopped"
        case FileNotFoundError(filename=None) if _is_nowhere():
            return 2, "the folder that the command was started in is gone"
        case OSError():
            return 2, one_line(f"'{error.filename}': {error.strerror}" if error.filename else error.strerror or error)
        case MemoryError():
            return 2, "not enough memory for this"
    if _is_interrupt(error):
        return signals.code(signals.STOPPED), "stopped"
    if any(words in str(error) for words in NO_ROOM):
        return 2, "not enough memory for this, or to load what it needs"
    if isinstance(error, RuntimeError) and "can't start new thread" in str(error):
        return 2, "the system allows no more threads, or no more memory"
    return INTERNAL, f"internal error: {locate(error)}; please report it, with {HOW}"


def _usage(error: typer.BadParameter) -> str:
    """The message of a command line that typer rejects."""
    if type(error) is typer.BadParameter and (parameter := getattr(error, "param", None)) is not None:
        return f"{parameter.opts[0]} {error.message.removeprefix('Value error, ')}"
    path = error.ctx.command_path if error.ctx else "dynsplines"
    return f"{error.format_message()} (see `{path} --help`)"


def _is_nowhere() -> bool:
    """Return whether the current folder has been removed."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return True
    return False


def _is_interrupt(error: BaseException | None) -> bool:
    """Return whether Ctrl-C caused the error. During the import of an extension module it causes an ImportError."""
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__ or error.__context__
    return error is not None


def _end(code: int, line: str) -> NoReturn:
    print(f"dynsplines: {line}", file=sys.stderr)
    sys.exit(code)


def fit_terminal() -> None:
    """Allow any text on both streams, with any encoding: missing letters are printed as their numbers."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")
