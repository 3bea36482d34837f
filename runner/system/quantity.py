"""Lengths as people write them: "2cm", "20 mm", "0.02 m"; from Python also a number, of metres."""

from __future__ import annotations

import math
import re

from ..errors import UserError

LARGEST = 1e6  # of any number of a configuration

METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001}


def length(given: str | float, what: str) -> float:
    """Metres; raises UserError for what is no length above 0, or text without a unit. `what` is how errors call it."""
    found = re.fullmatch(r"\s*([0-9.eE+-]+?)\s*(m|cm|mm|)\s*", str(given))
    try:
        number = float(found[1]) if found else math.nan
    except ValueError:
        number = math.nan
    if not (math.isfinite(number) and number > 0):
        raise UserError(f"{what} {given}: give a length above 0, such as 2cm, 20mm or 0.02m")
    unit = found[2] if found else ""
    if isinstance(given, str) and not unit:
        raise UserError(f"{what} {given}: of what? give {number:g}cm, {number:g}mm or {number:g}m")
    return number * METRES[unit or "m"]
