"""The command `dynsplines`, run in the process of the tests."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from dataclasses import dataclass

import pytest

from dynsplines import cli
from dynsplines.system.signals import HANDLED


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
