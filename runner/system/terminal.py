"""Text for terminals with limited encodings: missing letters are replaced by available ones."""

from __future__ import annotations

import codecs
import sys
import unicodedata

NAME = "dynsplines"
SPELLED = {"°": " deg", "×": "x", "·": "*", "–": "-", "−": "-", "…": "...", "→": "->", "┃": "|", "│": "|", "━": "-"}


def _spelled(error: UnicodeError) -> tuple[str, int]:
    """Return letters without accents, or signs in words, or else the character's number."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_letter, error.object[error.start : error.end])), error.end


def _letter(letter: str) -> str:
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    return SPELLED.get(letter) or plain or letter.encode("unicode_escape").decode()


def fit() -> None:
    """Allow any text on both streams, with any encoding."""
    codecs.register_error(NAME, _spelled)
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors=NAME)
