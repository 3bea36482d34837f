"""MuJoCo's warnings as notes. MuJoCo itself prints them and appends them to MUJOCO_LOG.TXT in the current folder.

A command and its worker processes report them before any other import. The Python API collects the warnings of each
call and issues them as Python warnings. mujoco is imported here only after a renderer has been selected.
"""

from __future__ import annotations

import io
import re
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stdout
from typing import Any

from ..errors import one_line

Sink = Callable[[str], None]

TIME = re.compile(r" Time = [\d.]+\.$")  # simulation time, which is meaningless here

_sinks: list[Sink] = []


def print_note(text: str) -> None:
    """Print a warning as a note of the command."""
    print(f"note: {text}", file=sys.stderr, flush=True)


@contextmanager
def reported_to(sink: Sink) -> Iterator[None]:
    """Pass every MuJoCo warning of the block to `sink`, each kind once."""
    before = _mujoco().get_mju_user_warning() if "mujoco" in sys.modules else None
    _sinks.append(_first_of_each(sink))
    install()
    try:
        yield
    finally:
        _sinks.pop()
        if "mujoco" in sys.modules:
            _mujoco().set_mju_user_warning(before)


def install() -> None:
    """Replace MuJoCo's handler if warnings are reported in this process; called again after the import of mujoco."""
    if _sinks and "mujoco" in sys.modules:
        _mujoco().set_mju_user_warning(_receive)


@contextmanager
def quietly() -> Iterator[None]:
    """Pass MuJoCo's warnings on, or drop them if this process does not report warnings.

    Suppress other output and warnings of MuJoCo's Python module.
    """
    sink = _sinks[-1] if _sinks else lambda text: None
    with reported_to(sink), redirect_stdout(io.StringIO()), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # deprecation warnings of MuJoCo
        yield


@contextmanager
def as_python_warnings() -> Iterator[None]:
    """Issue MuJoCo's warnings in the decorated function as Python warnings, at its caller's line."""
    if _sinks:  # a nested call, or a command
        yield
        return
    texts: list[str] = []
    with reported_to(texts.append):
        yield
    for text in texts:
        warnings.warn(text, stacklevel=4)


def pass_on(text: str) -> None:
    """Report a warning that another process has received."""
    if _sinks:
        _sinks[-1](text)


def _receive(text: str) -> None:
    pass_on(f"MuJoCo: {one_line(TIME.sub('', text.strip()))}")


def _first_of_each(sink: Sink) -> Sink:
    """Return a sink that passes on only the first of texts that differ in numbers."""
    kinds: set[str] = set()

    def first(text: str) -> None:
        kind = re.sub(r"[-+.\d]+", "#", text)
        if kind not in kinds:
            kinds.add(kind)
            sink(text)

    return first


def _mujoco() -> Any:
    """Return mujoco, which reads MUJOCO_GL during its import."""
    import mujoco

    return mujoco
