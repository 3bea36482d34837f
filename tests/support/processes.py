"""What processes of tests do: workers, the command `dynsplines`, faults, full disks, progress."""

import asyncio
import io
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache

import pytest
from rich.console import Console
from typer.main import get_command

from dynsplines import cli
from dynsplines.studio.loop import SolverLoop
from dynsplines.studio.session import Session
from dynsplines.system.progress import Progress
from dynsplines.system.signals import HANDLED

# A limit on the size of files, as a full disk is.
#
# Python up to 3.12 writes compiled modules in part then and takes them for whole later: none are written meanwhile.

SMALL = "import resource, sys; sys.dont_write_bytecode = True; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"


@contextmanager
def largest_file(size: int) -> Iterator[None]:
    """In here no file of this process grows over so many bytes."""
    resource = pytest.importorskip("resource")
    before, written = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        sys.dont_write_bytecode = written


# The command `dynsplines`, run in the process of the tests.


@dataclass(frozen=True)
class Done:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def last(self) -> str:
        """The last line of what it says beside its output."""
        return (self.err.splitlines() or [""])[-1]


Command = Callable[..., Done]
PARSER = cache(get_command)  # built once, which takes as long as many a command


def refusal(done: Done) -> str:
    """The one line of a command that ends with code 2 and prints nothing else, without the name of the program."""
    assert (done.code, done.out) == (2, "")
    (line,) = done.err.splitlines()
    assert "Traceback" not in line
    assert line.startswith("dynsplines: ")
    return line.removeprefix("dynsplines: ")


def commanded(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], main: Callable[[], None] = cli.main
) -> Command:
    """What runs it, in the present folder."""
    monkeypatch.setattr("typer.main.get_command", PARSER)

    def run(*words: object) -> Done:
        monkeypatch.setattr(sys, "argv", ["dynsplines", *map(str, words)])
        handlers = {number: signal.getsignal(number) for number in map(signal.Signals.__getitem__, HANDLED)}
        try:
            with pytest.raises(SystemExit) as ended:
                main()
        finally:  # a command that ends ignores signals, and so would all processes that later tests start
            for number, handler in handlers.items():
                signal.signal(number, handler)
        code = ended.value.code
        assert code is None or isinstance(code, int)
        said = capsys.readouterr()
        return Done(code or 0, str(said.out), str(said.err))

    return run


# Progress that nobody reads.


def quiet() -> Progress:
    return Progress(Console(file=io.StringIO()))


# The solver loop without a process, and a session without a solver.


class Recorded(SolverLoop):
    """A solver loop that records its messages. `is_interrupted` makes a message wait from the next check on."""

    def __init__(self):
        self.sent, self.is_interrupted = [], False
        super().__init__(self.sent.append, lambda: self.is_interrupted)

    def taken(self):
        messages, self.sent[:] = list(self.sent), []
        return messages

    def asked(self, do, **arguments):
        self.do({"do": do, **arguments})
        return self.taken()

    def loaded(self, folder, text, revision=0, *, go=True):
        place = {"name": "tiny", "place": "tiny.toml", "folder": str(folder)}
        return self.asked("load", text=text, **place, revision=revision, go=go, id=7)


def session_without_solver(document, monkeypatch):
    """A session whose solver accepts every text."""
    session = Session(document)

    def send(message):
        if message["do"] == "load":
            loaded = {"is": "loaded", "id": message.get("id"), "revision": message["revision"]}
            asyncio.get_running_loop().call_soon(session.solver.answer, {**loaded, "outline": {}, "timeline": b""})

    monkeypatch.setattr(session.solver, "send", send)
    return session
