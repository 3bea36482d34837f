"""Limit on the memory that a file may need: a small untrusted file can request all of the memory."""

from __future__ import annotations

import os

from ..errors import UserError

VARIABLE = "DYNSPLINES_LARGEST"
USUAL = 1000  # [MB] default limit; ten minutes of a hundred joints at 120 Hz need 60 MB per array
MEGABYTE = 1_000_000


def bound() -> int:
    """Return the limit in bytes, by default or from the environment. Raises UserError if that is not a number of MB."""
    setting = os.environ.get(VARIABLE, "").strip()
    if not setting:
        return USUAL * MEGABYTE
    if not (setting.isascii() and setting.isdigit() and 0 < len(setting) <= 9 and int(setting)):
        raise UserError(f"{VARIABLE}={setting}: give a number of MB, such as {4 * USUAL}")
    return int(setting) * MEGABYTE


def check(where: object, size: float, what: str) -> None:
    """Raise UserError if `what` would need more bytes than the limit."""
    most = bound()
    if size > most:
        raise UserError(
            f"{where}: {what} comes to {size / MEGABYTE:,.0f} MB in memory, over {most // MEGABYTE:,} MB; "
            f"if you trust it, set {VARIABLE} to more MB"
        )
