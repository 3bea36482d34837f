"""UserError: an error the user can correct, in one line with the place, the problem and the alternatives.

Former names of public attributes and arguments raise errors, too, that give the present ones.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, ClassVar, ParamSpec, TypeVar

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")

LONGEST_WORD = 300  # letters; a path is hardly longer
LONGEST = 4000  # letters of an error; a person's joints are 700
CUT = "…"


class UserError(Exception):
    """Bad input. The command line prints it without a traceback and exits with code 2.

    Words and names from files can be of any length; of very long ones the message keeps the begin and the end.
    """

    def __init__(self, text: object = "") -> None:
        super().__init__(shortened(str(text)))


def shortened(text: str) -> str:
    """Readable text, for any quoted content."""
    if len(text) <= LONGEST_WORD:
        return text
    text = re.sub(rf"\S{{{LONGEST_WORD + 1},}}", lambda word: _middle_out(word[0], LONGEST_WORD), text)
    return text if len(text) <= LONGEST else _middle_out(text, LONGEST)


def _middle_out(text: str, most: int) -> str:
    return f"{text[: 2 * most // 3]}{CUT}{text[-(most // 3) :]}"


def one_line(text: object) -> str:
    """Text with unprintable characters escaped, so that a message is one line for any file content."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in shortened(str(text)))


def unknown(kind: str, name: str, known: Iterable[str]) -> str:
    """ "no joint 'left_kne'; did you mean 'left_knee'? Joints: ..." """
    names = list(known)
    close = difflib.get_close_matches(name, names, n=1) if len(name) <= LONGEST_WORD else []
    guess = f"; did you mean '{close[0]}'?" if close else "."
    several = {"penalty": "Penalties", "criterion": "Criteria", "body": "Bodies"}.get(kind, f"{kind.capitalize()}s")
    return f"no {kind} '{name}'{guess} {several}: {', '.join(names) or 'none'}"


class Renames:
    """Base of public classes: reading a renamed attribute raises an AttributeError that gives its present name."""

    RENAMED: ClassVar[Mapping[str, str]] = {}

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            if name in self.RENAMED:
                raise AttributeError(
                    f"{type(self).__name__} has no attribute '{name}'; it is named '{self.RENAMED[name]}'"
                )
            return object.__getattribute__(self, name)  # raises the usual error


def renamed_arguments(**successors: str) -> Callable[[Callable[Arguments, Result]], Callable[Arguments, Result]]:
    """Return a decorator of public functions: a renamed argument raises a TypeError that gives its present name."""

    def decorated(function: Callable[Arguments, Result]) -> Callable[Arguments, Result]:
        @wraps(function)
        def checked(*args: Arguments.args, **kwargs: Arguments.kwargs) -> Result:
            for name in successors.keys() & kwargs.keys():
                raise TypeError(f"{function.__name__} has no argument '{name}'; it is named '{successors[name]}'")
            return function(*args, **kwargs)

        return checked

    return decorated
