"""Lengths as people write them: "2cm", "20 mm", "0.02"."""

from __future__ import annotations

import math
import re

from .errors import UserError

METRES = {"": 1.0, "m": 1.0, "cm": 0.01, "mm": 0.001}


def length(text: str | float, what: str) -> float:
    """Metres; raises UserError for what is no length above 0. `what` is how the error calls it."""
    found = re.fullmatch(r"\s*([0-9.eE+-]+?)\s*(m|cm|mm|)\s*", str(text))
    try:
        value = float(found[1]) * METRES[found[2]] if found else math.nan
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0):
        raise UserError(f"{what} {text}: give a length above 0, such as 2cm, 20mm or 0.02m")
    return value
