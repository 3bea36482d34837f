"""UserError: what the user can mend, in one line that names the thing, the place and the alternatives."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class UserError(Exception):
    """Bad input. The command line prints it without a traceback and exits with code 2."""


def one_line(text: object) -> str:
    """Text with everything that does not print written out, so that a message stays one line whatever a file holds."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in str(text))


def unknown(kind: str, name: str, known: Iterable[str]) -> str:
    """ "no joint 'left_kne'; did you mean 'left_knee'? Joints: ..." """
    names = list(known)
    close = difflib.get_close_matches(name, names, n=1)
    guess = f"; did you mean '{close[0]}'?" if close else "."
    several = {"penalty": "Penalties", "criterion": "Criteria", "body": "Bodies"}.get(kind, f"{kind.capitalize()}s")
    return f"no {kind} '{name}'{guess} {several}: {', '.join(names) or 'none'}"
