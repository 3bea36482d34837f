"""Tables of numbers as text, with detection of separator, decimal sign, comments and heading.

Commas, semicolons, tabs or spaces separate the cells; decimal commas are possible with all of them except unquoted
commas. Lines that begin with #, % or // are comments. Such a line directly before the numbers is the heading if it has
a name for every column. A line `sep=;` is Excel's. Empty cells are nan.

A table is truncated if its last row has fewer numbers than the others.
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
    lines, comments, heading = _lines(path)
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
    complete = len(rows[-1]) - (numbers[-1][-1] is None)
    is_cut = complete < width and len(rows[-1]) <= width and None not in numbers[-1][:-1]
    whole = numbers[:-1] if is_cut else numbers
    bad = [i + 1 + first for i, row in enumerate(whole) if len(row) != width or None in row]
    if bad:
        do = "complete or delete it" if len(bad) == 1 else f"complete or delete it and {len(bad) - 1} more such"
        raise UserError(
            f"{path}: row {bad[0]} does not hold {width} numbers, separated by {SEPARATORS[dialect.separator]}"
            + (", with decimal commas" if dialect.has_decimal_comma else "")
            + f"; {do}"
        )
    if is_cut:
        notes += (_truncated(path, f"row {len(rows) + first}", f"{complete} of {width} numbers", len(whole)),)
    rates = [float(match[1]) for comment in comments if (match := RATE.search(comment))]
    fps = rates[0] if rates and 0.01 <= rates[0] <= 100_000 else None
    return Table(np.array(whole, float).reshape(-1, width), names, fps, notes)


def _truncated(path: Path, row: str, content: str, count: int) -> str:
    """Return the note on a table with `count` complete rows; raises UserError unless these may be used."""
    cut = f"the file is cut short: {row}, the last, has {content}"
    if count < gaps.FEWEST:
        raise UserError(f"{path}: {cut}; a motion has at least {gaps.FEWEST} complete rows")
    if not gaps.are_allowed():
        raise UserError(f"{path}: {cut}; `dynsplines clean` uses the {count} rows before it")
    return f"{cut}: {count} of {count + 1} rows are used"


def _lines(path: Path) -> tuple[list[str], list[str], str | None]:
    """Return the non-empty lines, the comments, and the comment before the first line."""
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
    return lines, comments, heading


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
