"""UserError: an error that the user can correct, in one line with the place, the problem and the alternatives."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from pathlib import Path

LONGEST_WORD = 300  # maximum number of letters in a word of an error; paths are rarely longer
LONGEST = 4000  # maximum number of letters of an error; the names of a humanoid's joints have 700
CUT = "…"
# What to supply when a file lacks it
GIVE_FIGURE = "name the figure: --figure, or figure= in Python"
GIVE_RATE = "give the rate: --fps, or fps= in Python"
GIVE_UNIT = "give the unit: --scale, or scale= in Python"
GIVE_MAP = "name them in a bone map, --map FILE"
GIVE_FORMAT = "give --from, or format= in Python"
EXPORT_SKELETON = "to transfer it to another figure, export a skeleton with its own figure (.bvh), and retarget that"


class UserError(Exception):
    """Invalid input. The command line prints it without a traceback and exits with code 2.

    Very long words and names in the message are shortened in the middle.
    """

    def __init__(self, text: object = "") -> None:
        super().__init__(shorten(str(text)))


def shorten(text: str) -> str:
    """Return a text with very long words shortened."""
    if len(text) <= LONGEST_WORD:
        return text
    text = re.sub(rf"\S{{{LONGEST_WORD + 1},}}", lambda word: _middle_out(word[0], LONGEST_WORD), text)
    return text if len(text) <= LONGEST else _middle_out(text, LONGEST)


def _middle_out(text: str, most: int) -> str:
    return f"{text[: 2 * most // 3]}{CUT}{text[-(most // 3) :]}"


def missing_package(what: str, package: str | None, extra: str) -> UserError:
    """Return the error of a feature whose optional package is not installed."""
    return UserError(f"{what} needs '{package}'; install it: pip install 'dynamic-splines[{extra}]'")


def import_first(source: object) -> str:
    """Return what to do with a recording of another program where a clip or a motion is needed."""
    return f"import a recording first: `dynsplines import {source} -o motion.npz`, or import_motion in Python"


def words_of(error: Exception) -> str:
    """Return the message of an error of several lines in one line."""
    return " ".join(str(error).split())


def locate(error: BaseException) -> str:
    """Return an internal error with its type, and the line of the program that raised it."""
    import traceback  # imported here because internal errors are rare

    calls = traceback.extract_tb(error.__traceback__)
    place = f" ({Path(calls[-1].filename).name}:{calls[-1].lineno})" if calls else ""
    return f"{type(error).__name__}: {one_line(error)}{place}"


def one_line(text: object) -> str:
    """Return a text with unprintable characters escaped, so that a message is one line for any file content."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in shorten(str(text)))


def unknown(kind: str, name: str, choices: Iterable[str]) -> str:
    """ "no joint 'left_kne'; did you mean 'left_knee'? Joints: ..." """
    names = list(choices)
    close = difflib.get_close_matches(name, names, n=1) if len(name) <= LONGEST_WORD else []
    guess = f"; did you mean '{close[0]}'?" if close else "."
    several = {"penalty": "Penalties", "criterion": "Criteria", "body": "Bodies"}.get(kind, f"{kind.capitalize()}s")
    return f"no {kind} '{name}'{guess} {several}: {', '.join(names) or 'none'}"


def list_names(names: Iterable[str], most: int = 3) -> str:
    """Return the first names of a list: "a, b and 3 more"."""
    first = list(names)
    more = f" and {len(first) - most} more" if len(first) > most else ""
    return ", ".join(first[:most]) + more
