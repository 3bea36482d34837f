"""MuJoCo's warnings as notes. MuJoCo itself prints them and appends them to MUJOCO_LOG.TXT in the current folder.

A command and its worker processes report them before anything else is imported; the Python API collects the warnings of
each call and issues them as Python warnings. mujoco is imported here only once a renderer has been chosen.
"""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from ..errors import one_line

Sink = Callable[[str], None]

TIME = re.compile(r" Time = [\d.]+\.$")  # of a simulation, which there is none of

_sinks: list[Sink] = []


def print_note(text: str) -> None:
    """Print a warning as a note of the command."""
    print(f"note: {text}", file=sys.stderr, flush=True)


@contextmanager
def reported_to(sink: Sink) -> Iterator[None]:
    """Pass every MuJoCo warning of the block to `sink`, each kind once."""
    before = _mujoco().get_mju_user_warning() if "mujoco" in sys.modules else None
    _sinks.append(_once(sink))
    install()
    try:
        yield
    finally:
        _sinks.pop()
        if "mujoco" in sys.modules:
            _mujoco().set_mju_user_warning(before)


def install() -> None:
    """Replace MuJoCo's handler if warnings are reported in this process; called again once mujoco is imported."""
    if _sinks and "mujoco" in sys.modules:
        _mujoco().set_mju_user_warning(_receive)


@contextmanager
def intercepted() -> Iterator[None]:
    """Pass MuJoCo's warnings of the block to where they are reported, or drop them if they are not."""
    before = _mujoco().get_mju_user_warning()
    _mujoco().set_mju_user_warning(_receive)
    try:
        yield
    finally:
        _mujoco().set_mju_user_warning(before)


@contextmanager
def as_python_warnings() -> Iterator[None]:
    """Issue MuJoCo's warnings in the function that this decorates as Python warnings, at its caller's line."""
    if _sinks:  # of a call inside another, or of a command
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


def _once(sink: Sink) -> Sink:
    """A sink that passes on the first of the texts that differ in numbers only."""
    kinds: set[str] = set()

    def first(text: str) -> None:
        kind = re.sub(r"[-+.\d]+", "#", text)
        if kind not in kinds:
            kinds.add(kind)
            sink(text)

    return first


def _mujoco() -> Any:
    """The module, which reads MUJOCO_GL while it is imported."""
    import mujoco

    return mujoco
