"""Where the process that solves begins: nothing is imported before it is known not to be the server."""

from __future__ import annotations

from typing import Any


def entry(line: Any, outside: bool) -> None:
    """The process's whole life; outside: whether models may refer to files anywhere."""
    from ..picture.graphics import do_without
    from ..system.threads import keep_to_one

    keep_to_one()
    do_without()
    from .solving import serve

    serve(line, outside)
