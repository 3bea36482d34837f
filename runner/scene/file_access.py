"""Whether a model may refer to files outside its folder: an untrusted model could name any file of the user.

It may not by default. Exceptions are `with allowed():` around code that reads models, `--allow-outside` on the command
line, and `allow_outside=True` in Python.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from ..errors import UserError

_allowed: ContextVar[bool] = ContextVar("allowed", default=False)


@contextmanager
def allowed(yes: bool = True) -> Iterator[None]:
    """Allow models to refer to files anywhere, within this block; yes=False restores the default."""
    before = _allowed.set(yes or _allowed.get())
    try:
        yield
    finally:
        _allowed.reset(before)


def is_allowed() -> bool:
    """Return whether models may refer to files outside their folders now."""
    return _allowed.get()


def check(place: Path, folder: Path, name: str) -> None:
    """Raise UserError for a file outside the model's folder, after resolving links.

    Args:
        place: The path of the file.
        folder: The model's folder.
        name: The file's name in the model.
    """
    if not is_allowed() and not lies_in(place, folder):
        home = os.path.realpath(folder)
        real = os.path.realpath(place)
        resolved = "" if name == real else f" ('{real}')"
        raise UserError(
            f"the model refers to '{name}'{resolved}, outside its folder '{home}'; if it may read that file, "
            "--allow-outside lets it (allow_outside=True in Python)"
        )


def lies_in(place: Path, folder: Path) -> bool:
    """Return whether a file is in a folder or below it, after resolving links."""
    return Path(os.path.realpath(place)).is_relative_to(os.path.realpath(folder))
