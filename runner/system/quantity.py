"""Lengths and speeds with units: "2cm", "20 mm", "1200deg/s"; from Python also numbers in m and rad/s; rates."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from numbers import Real

from ..errors import UserError

LARGEST = 1e6  # maximum number in a configuration

METRES = {"cm": 0.01, "mm": 0.001, "m": 1.0}
RADIANS_A_SECOND = {"rad/s": 1.0, "deg/s": math.pi / 180}


def length(value: str | float, what: str) -> float:
    """Return a length in metres. Raises UserError unless it is above 0 with a unit; `what` is the label in errors."""
    return _quantity(value, what, METRES, "a length above 0, such as 2cm, 20mm or 0.02m")


def speed(value: str | float, what: str) -> float:
    """Return a speed in radians per second. Raises UserError as for `length`."""
    return _quantity(value, what, RADIANS_A_SECOND, "a speed above 0, such as 20rad/s or 1200deg/s")


def positive(value: float, what: str) -> float:
    """Return a number. Raises UserError unless it is finite and above 0; `what` is the label in errors."""
    if not (isinstance(value, Real) and 0 < value < math.inf):
        raise UserError(f"{what} {value}: give a finite number above 0")
    return float(value)


def _quantity(value: str | float, what: str, units: Mapping[str, float], example: str) -> float:
    match = re.fullmatch(rf"\s*([0-9.eE+-]+?)\s*({'|'.join(units)}|)\s*", str(value))
    try:
        number = float(match[1]) if match else math.nan
    except ValueError:
        number = math.nan
    if not (math.isfinite(number) and number > 0):
        raise UserError(f"{what} {value}: give {example}")
    unit = match[2] if match else ""
    if isinstance(value, str) and not unit:
        *examples, last = (f"{number:g}{unit_name}" for unit_name in units)
        raise UserError(f"{what} {value}: the unit is missing; give {', '.join(examples)} or {last}")
    return number * (units[unit] if unit else 1.0)
