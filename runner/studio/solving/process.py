"""Where the process that solves begins: nothing is imported before it is known not to be the server."""

from __future__ import annotations

from typing import Any


def entry(line: Any, outside: bool) -> None:
    """The process's whole life; outside: whether models may refer to files anywhere."""
    from ...picture.graphics import do_without
    from ...system.threads import keep_to_one, without_tools

    keep_to_one()
    do_without()
    without_tools()
    from .work import serve

    serve(line, outside)
