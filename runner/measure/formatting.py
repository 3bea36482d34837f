"""Lines of a report for the terminal: each has the label of a quantity, and its values before and after solving.

The unit is part of a name. Entries whose name ends in ", m", and the entries that they contain, are shown in
millimetres.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

Line = tuple[str, str, str]  # label, before, after
HIDDEN = ("geoms", "unit")  # entries without lines: too many, or shown with their quantity
FEW = 4  # most numbers of a quantity that are shown in one line
SPAN = ("from, s", "to, s")
MOST_SHOWN = 6  # most swings of a foot whose heights a table lists one by one


def rows(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Yield the lines for the quantities of two columns. In a report of an older version, `before` may lack entries."""
    for name, value in after.items():
        yield from _rows(name, before.get(name), value)


def _rows(name: str, before: Any, after: Any, unit: str = "") -> Iterator[Line]:
    label, unit = _label_and_unit(name, unit)
    if isinstance(after, list) and label.startswith("swings"):
        yield label, swing_text(before or []), swing_text(after)
    elif any(isinstance(entry, dict) for side in (before, after) if isinstance(side, list) for entry in side):
        for one, two in zip(before or [], after, strict=False):
            texts = " on ".join(value for value in two.values() if isinstance(value, str))
            place = f"{label}: {texts} {two['from, s']:.2f} - {two['to, s']:.2f} s"
            numbers = {key: value for key, value in two.items() if not isinstance(value, str) and key not in SPAN}
            yield from _rows(place, one, numbers, unit)
    elif isinstance(after, dict):
        unit, before = after.get("unit", unit), before or {}
        single = [key for key, value in after.items() if not isinstance(value, dict | list) and key not in HIDDEN]
        if len(single) > FEW:
            for key in single:
                yield from _rows(f"{label}: {key}", before.get(key), after[key], unit)
        elif single:
            one, two = (" / ".join(_value(key, side.get(key), unit) for key in single) for side in (before, after))
            yield f"{label}: {' / '.join(_label_and_unit(key, unit)[0] for key in single)}", one, two
        for key in (key for key in after if key not in single and key not in HIDDEN):
            yield from _rows(f"{label}, {key}", before.get(key), after[key], unit)
    else:
        yield label, _value(name, before, unit), _value(name, after, unit)


def swing_text(foot_swings: list[dict[str, float]]) -> str:
    """Return a foot's swings for a table, by their heights."""
    high = [1000 * swing["height, m"] for swing in foot_swings]
    if not high:
        return "never"
    if len(high) > MOST_SHOWN:
        return f"{len(high)} times, {min(high):.0f} to {max(high):.0f} mm"
    return ", ".join(f"{height:.0f}" for height in high) + " mm"


def _label_and_unit(name: str, unit: str) -> tuple[str, str]:
    """Return a name without its unit, and the unit, by default that of the containing entry."""
    label, comma, own_unit = name.rpartition(", ")
    return (label, own_unit) if comma and own_unit in UNITS else (name, unit)


UNITS = {
    "m": lambda value: f"{1000 * value:.1f} mm",
    "degrees": lambda value: f"{value:.1f}°",
    "s": lambda value: f"{value:.2f} s",
    "m/s": lambda value: f"{value:.3f} m/s",
    "rad/s²": lambda value: f"{value:.0f} rad/s²",
    "N m": lambda value: f"{value:.0f} N m",
    "N": lambda value: f"{value:.0f} N",
}


def _value(name: str, value: Any, unit: str) -> str:
    if value is None:
        return ""
    if isinstance(value, str | bool):
        return str(value)
    if isinstance(value, list):
        return ", ".join(_value(name, item, unit) for item in value)
    return UNITS.get(_label_and_unit(name, unit)[1], lambda number: f"{number:.4g}")(value)
