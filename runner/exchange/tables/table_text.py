"""Tables of numbers as text, with detection of separator, decimal sign, comments and heading.

Commas, semicolons, tabs or spaces separate the cells; decimal commas are possible with all of them except unquoted
commas. Lines that begin with #, % or // are comments. Such a line directly before the numbers is the heading if it has
a name for every column. A line `sep=;` is Excel's. Empty cells are nan.

A table is truncated if its last row has fewer cells than the others, or if the file ends within the last number. The
latter is inferred if no end of line follows the number, and it is shorter than those above it or far from them.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dynsplines.solver.array import Array

from ...errors import UserError
from .. import gaps

SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", " ": "spaces"}
MARKS = ("#", "%", "//")
RATE = re.compile(
    r"\b(?:fps|frame[ _]?rate|frequency|sampl\w*[ _]rate|hz)\b\W{0,3}([0-9]+(?:\.[0-9]+)?)", re.IGNORECASE
)
ENCODINGS = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16", b"\xef\xbb\xbf": "utf-8-sig"}
BEGINNING = re.compile(r"[+-]?([0-9]*[.,]?[0-9]*(e[+-]?)?|na?|inf?|infin?i?t?)", re.IGNORECASE)  # of a number
NUMBER = re.compile(r"[+-]?[0-9]*(?:[.,](?P<decimals>[0-9]*))?(?:e[+-]?(?P<exponent>[0-9]+))?", re.IGNORECASE)
PRECISE = 9  # decimals with which even a truncated number has an error of at most 1e-9
FAR, NEAR = 3, 1e-6  # multiple of a column's largest step, and margin, beyond which a number lacks its exponent
Rows = list[list[str]]


@dataclass(frozen=True)
class Table:
    """numbers (T, n); names (n,) of the columns, or None; fps [1/s] from a comment; notes on what was inferred"""

    numbers: Array
    names: list[str] | None = None
    fps: float | None = None
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Dialect:
    """The notation of a table."""

    separator: str
    has_decimal_comma: bool = False

    def cells(self, line: str) -> list[str]:
        """Return the cells of a line without surrounding spaces; a separator at its end is ignored."""
        if self.separator == " ":
            return line.split()
        row = [cell.strip() for cell in next(csv.reader([line], delimiter=self.separator, skipinitialspace=True))]
        return row[:-1] if len(row) > 1 and not row[-1] else row

    def number(self, cell: str) -> float | None:
        """Return a cell's number, nan if it is empty, None if it contains anything else."""
        text = cell.replace(",", ".") if self.has_decimal_comma else cell
        try:
            return float(text) if text else np.nan
        except ValueError:
            return None

    def is_numeric(self, line: str) -> bool:
        cells = self.cells(line)
        return any(cells) and all(self.number(cell) is not None for cell in cells)


DIALECTS = [Dialect(separator, comma) for comma in (False, True) for separator in SEPARATORS]


def table(path: Path) -> Table:
    """Return the table in a file; raises UserError, with row and separator, for an invalid one."""
    lines, comments, heading, is_ended = _lines(path)
    if not lines:
        raise UserError(f"{path}: the file is empty")
    dialect = _dialect(lines)
    first = next((i for i, line in enumerate(lines) if dialect.is_numeric(line)), len(lines))
    if first > 2 or first == len(lines):
        what = "no numbers" if first == len(lines) else f"{first} lines before its numbers; it may have names and units"
        raise UserError(f"{path}: a table with {what}, whose cells commas, semicolons, tabs or spaces separate")
    rows = [dialect.cells(line) for line in lines[first:]]
    width = len(rows[0])
    names = _names(lines[:first], heading, dialect, width)
    if names is not None and len(names) != width:
        raise UserError(f"{path}: {len(names)} names for {width} columns, separated by {SEPARATORS[dialect.separator]}")
    numbers = [[dialect.number(cell) for cell in row] for row in rows]
    notes: tuple[str, ...] = ("decimal commas are read as points",) if dialect.has_decimal_comma else ()
    cut = _cut(rows, numbers, is_ended=is_ended)
    whole = numbers if cut is None else numbers[:-1]
    bad = [i + 1 + first for i, row in enumerate(whole) if len(row) != width or None in row]
    if bad:
        do = "complete or delete it" if len(bad) == 1 else f"complete or delete it and {len(bad) - 1} more such"
        raise UserError(
            f"{path}: row {bad[0]} does not hold {width} numbers, separated by {SEPARATORS[dialect.separator]}"
            + (", with decimal commas" if dialect.has_decimal_comma else "")
            + f"; {do}"
        )
    if cut is not None:
        notes += (_truncated(path, f"row {len(rows) + first}, the last, {cut}", len(whole), len(rows[-1]) == width),)
    rates = [float(match[1]) for comment in comments if (match := RATE.search(comment))]
    fps = rates[0] if rates and 0.01 <= rates[0] <= 100_000 else None
    return Table(np.array(whole, float).reshape(-1, width), names, fps, notes)


def _cut(rows: Rows, numbers: list[list[float | None]], *, is_ended: bool) -> str | None:
    """Return how a last row is incomplete; None if it is complete, or damaged otherwise."""
    last, values, width = rows[-1], numbers[-1], len(rows[0])
    if len(last) > width or None in values[:-1] or (values[-1] is None and not BEGINNING.fullmatch(last[-1])):
        return None
    if len(last) < width or values[-1] is None:
        return f"has {len(last) - (values[-1] is None)} of {width} numbers"
    above = [(row[-1], values[-1]) for row, values in zip(rows[:-1], numbers[:-1], strict=True) if len(row) == width]
    if is_ended or not (len(rows) == 1 or is_cut(last[-1], values[-1], above)):
        return None
    return f"has no end after the number {last[-1]}" + (", which differs from those above it" if above else "")


def _truncated(path: Path, cut: str, count: int, is_wide: bool) -> str:
    """Return the note on a table with `count` complete rows; raises UserError unless these may be used."""
    cut = f"the file is cut short: {cut}"
    if count < gaps.FEWEST:
        raise UserError(f"{path}: {cut}; a motion has at least {gaps.FEWEST} complete rows")
    if not gaps.are_allowed():
        end = "; if it is complete, end its line" if is_wide else ""
        raise UserError(f"{path}: {cut}; `dynsplines clean` uses the {count} rows before it{end}")
    return f"{cut}: {count} of {count + 1} rows are used"


def is_cut(cell: str, number: float, above: Sequence[tuple[str, float | None]]) -> bool:
    """Return whether a number is truncated: it has fewer digits than all above it, or is far from them."""
    matches = [match for text, _ in above if (match := NUMBER.fullmatch(text))]
    match = NUMBER.fullmatch(cell)
    if match is None or not matches:
        return False
    if match["exponent"]:
        return len(match["exponent"]) < min((len(row["exponent"]) for row in matches if row["exponent"]), default=2)
    decimals = len(match["decimals"] or "")
    least = min((len(row["decimals"] or "") for row in matches if not row["exponent"]), default=None)
    if least is None or decimals < min(least, PRECISE):
        return True
    values = np.array([value for _, value in above if value is not None and np.isfinite(value)])
    return values.size > 1 and bool(abs(number - values[-1]) > FAR * np.abs(np.diff(values)).max() + NEAR)


def _lines(path: Path) -> tuple[list[str], list[str], str | None, bool]:
    """Return the non-empty lines, the comments, the comment before the first line, and whether the last line ends."""
    content = path.read_bytes()
    encoding = next((name for mark, name in ENCODINGS.items() if content.startswith(mark)), "utf-8")
    try:
        text = content.decode(encoding)
    except UnicodeDecodeError as error:
        raise UserError(f"{path}: not a table of text: {error}") from None
    if "\0" in text:
        raise UserError(f"{path}: not a table of text: it contains zero bytes")
    lines: list[str] = []
    comments: list[str] = []
    heading = None
    for line in map(str.strip, text.splitlines()):
        if not line.strip(",;\t ") or line.lower().startswith("sep="):
            continue
        mark = next((mark for mark in MARKS if line.startswith(mark)), None)
        if mark is not None:
            comments.append(line[len(mark) :].strip())
            heading = comments[-1] if not lines else heading
        else:
            lines.append(line)
    is_ended = text.endswith(("\n", "\r")) or not lines or text.splitlines()[-1].strip() != lines[-1]
    return lines, comments, heading, is_ended


def _dialect(lines: Sequence[str]) -> Dialect:
    """Return the notation for which most lines are equally many numbers, of several the one with the most columns."""
    look = list(lines[:50])

    def fits(dialect: Dialect) -> tuple[int, int]:
        try:
            widths = [len(dialect.cells(line)) for line in look if dialect.is_numeric(line)]
        except csv.Error:
            return 0, 0
        usual = max(set(widths), key=widths.count, default=0)
        return widths.count(usual), usual

    return max(DIALECTS, key=fits)


def _names(lines: Sequence[str], comment: str | None, dialect: Dialect, width: int) -> list[str] | None:
    """Return the names of the columns, from the heading or else the comment before the numbers."""
    if lines:
        names, *units = map(dialect.cells, lines)
        return (
            [f"{name} [{unit.strip('[]()')}]" for name, unit in zip(names, units[0], strict=False)] if units else names
        )
    for other_dialect in DIALECTS if comment else ():
        names = other_dialect.cells(str(comment))
        if width > 1 and len(names) == width and all(other_dialect.number(name) is None for name in names):
            return names
    return None
