"""Tables of numbers as text, with detection of separator, decimal sign and heading.

Commas, semicolons, tabs or spaces separate the cells; decimal commas are possible with all of them except unquoted
commas. Lines that begin with #, % or // are comments. Such a line directly before the numbers is the heading if it has
a name for every column. Empty cells are nan. Every line ends, as a truncated last number cannot be told from a complete
one otherwise.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dynsplines.solver.array import Array

from ..errors import UserError

SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", " ": "spaces"}
MARKS = ("#", "%", "//")


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


def table(path: Path) -> tuple[list[str] | None, Array]:
    """Return the names (n,) of the columns, None without a heading, and the numbers (T, n) of a file.

    Raises UserError, with line and separator, for an invalid or truncated one.
    """
    lines, comment = _lines(path)
    dialect = _dialect([line for _, line in lines])
    names = None if dialect.is_numeric(lines[0][1]) else dialect.cells(lines[0][1])
    rows = [(number, dialect.cells(line)) for number, line in lines[names is not None :]]
    if not rows or not dialect.is_numeric(lines[names is not None][1]):
        raise UserError(
            f"{path}: no table of numbers, with one heading, separated by commas, semicolons, tabs or spaces"
        )
    width, separator = len(rows[0][1]), SEPARATORS[dialect.separator]
    if names is None and comment is not None and not dialect.is_numeric(comment):
        names = dialect.cells(comment) if len(dialect.cells(comment)) == width > 1 else None
    if names is not None and len(names) != width:
        raise UserError(f"{path}: {len(names)} names for {width} columns, separated by {separator}")
    numbers = [[dialect.number(cell) for cell in row] for _, row in rows]
    bad = [number for (number, row), values in zip(rows, numbers, strict=True) if len(row) != width or None in values]
    if bad:
        decimals = ", with decimal commas" if dialect.has_decimal_comma else ""
        more = f" and {len(bad) - 1} more such" if len(bad) > 1 else ""
        raise UserError(
            f"{path}: line {bad[0]} does not hold {width} numbers, separated by {separator}{decimals}; "
            f"complete or delete it{more}"
        )
    return names, np.array(numbers, float)


def _lines(path: Path) -> tuple[list[tuple[int, str]], str | None]:
    """Return the lines that are neither empty nor comments, with their numbers, and the last comment before them."""
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{path}: not a table of text: {error}") from None
    if "\0" in text:
        raise UserError(f"{path}: not a table of text: it contains zero bytes")
    lines: list[tuple[int, str]] = []
    heading = None
    for number, line in enumerate(map(str.strip, text.splitlines()), 1):
        mark = next((mark for mark in MARKS if line.startswith(mark)), None)
        if mark is None and line.strip(",;\t "):
            lines.append((number, line))
        elif mark is not None and not lines:
            heading = line[len(mark) :].strip()
    if not lines:
        raise UserError(f"{path}: the file is empty")
    if not text.endswith(("\n", "\r")) and lines[-1][0] == number:
        raise UserError(f"{path}: line {number}, the last, has no end: the file may be cut short; if not, end the line")
    return lines, heading


def _dialect(lines: Sequence[str]) -> Dialect:
    """Return the notation for which most lines are equally many numbers, of several the one with the most columns."""

    def fits(dialect: Dialect) -> tuple[int, int]:
        try:
            widths = [len(dialect.cells(line)) for line in lines[:50] if dialect.is_numeric(line)]
        except csv.Error:
            return 0, 0
        usual = max(set(widths), key=widths.count, default=0)
        return widths.count(usual), usual

    return max(DIALECTS, key=fits)
