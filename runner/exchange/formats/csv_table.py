"""CSV: a row per sample with the time and MuJoCo's qpos; a heading names joint and component.

Columns of `quantities` may follow; they are not read. A name that a spreadsheet would take for a formula is preceded
by '. On import, columns may have units in brackets, such as `left_knee [deg]`.

Commas, semicolons, tabs or spaces separate the cells. Lines that begin with #, % or // are comments. Such a line
directly before the numbers is the heading if it has a name for every column. Empty cells are nan. Every line ends, as a
truncated last number cannot be distinguished from a complete one otherwise.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind

from ...errors import GIVE_FIGURE, GIVE_RATE, UserError, list_names
from ...motion import Sampled
from .. import quantities
from ..array_reader import times
from ..recording import Recording
from ..robot import joint_name

FORMULA = "=+-@\t\r"  # first characters of cells that spreadsheets execute as formulas
QUOTE = "'"
UNITS = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3, "s": 1.0, "ms": 1e-3, "rad": 1.0, "deg": np.pi / 180}
FREE = ("x", "y", "z", "qw", "qx", "qy", "qz")
SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", " ": "spaces"}
MARKS = ("#", "%", "//")


def columns(model: mujoco.MjModel) -> list[str]:
    """Return the heading of qpos (nq,): "root.x" … "root.qz", "left_hip.qw" …, and the plain name of scalar joints."""
    out: list[str] = []
    for joint in range(model.njnt):
        name = joint_name(model, joint)
        match model.jnt_type[joint]:
            case JointKind.FREE:
                out += [f"{name}.{part}" for part in FREE]
            case JointKind.BALL:
                out += [f"{name}.{part}" for part in FREE[3:]]
            case _:
                out.append(name)
    return out


def write(sampled: Sampled, path: Path, groups: Sequence[str] = ()) -> list[str]:
    """Write the table, with groups of further columns; every number has the digits that reproduce it exactly.

    Return notes.
    """
    more, notes = quantities.table(sampled, groups)
    table = np.column_stack([sampled.time, sampled.qpos, *more.values()])
    with path.open("w", newline="", encoding="utf-8") as stream:
        rows = csv.writer(stream)
        rows.writerow([_inert(name) for name in ("time", *columns(sampled.model), *more)])
        rows.writerows(map(repr, row) for row in table.tolist())
    return notes


def recognises(path: Path) -> bool:
    """Return True; raises UserError for a table without a heading, which several formats have."""
    if table(path)[0] is None:
        raise UserError(
            f"{path}: a table without a heading; give --from csv (qpos, quaternions wxyz), --from mjlab-csv (root "
            "position, quaternion xyzw, hinges), format= in Python, or add a heading as an export to csv has it"
        )
    return True


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read a table: with a heading, columns in any order; without one, nq columns, or the time and nq columns."""
    if model is None:
        raise UserError(f"{path}: a table of qpos is for a figure; {GIVE_FIGURE}")
    (headings, numbers), names = table(path), columns(model)
    if headings is None:
        return Recording(*without_heading(path, numbers, model.nq, fps))
    named = _by_name(headings, numbers, {"time", *names}, path)
    missing = [name for name in names if name not in named]
    if missing:
        lacking = list_names((f"'{name}'" for name in missing), 1)
        raise UserError(
            f"{path}: no column {lacking}; the figure's columns: {', '.join(names)}; the file's: {', '.join(headings)}"
        )
    qpos = np.column_stack([named[name] for name in names])
    return Recording(named["time"] if "time" in named else times(len(qpos), rate_of(path, fps)), qpos)


def _by_name(headings: Sequence[str], numbers: Array, wanted: set[str], path: Path) -> dict[str, Array]:
    """Return the columns (T,) of wanted names in metres, radians and seconds.

    Raises UserError for unknown units, and for columns of one name with different numbers.
    """
    out: dict[str, Array] = {}
    for heading, column in zip(map(_name_of, headings), numbers.T, strict=True):
        name, unit = (heading, "") if heading in wanted else _with_unit(heading)
        if name not in wanted:
            continue
        if unit not in UNITS:
            raise UserError(f"{path}: column '{heading}': no unit '{unit}'; units: {', '.join(UNITS)[2:]}")
        values = column * UNITS[unit]
        if not np.array_equal(out.setdefault(name, values), values, equal_nan=True):
            raise UserError(f"{path}: two columns '{name}' with different numbers; remove or rename one of them")
    return out


def _with_unit(heading: str) -> tuple[str, str]:
    """Return name and unit of a heading such as `knee [deg]`."""
    match = re.fullmatch(r"(.*?)\s*[\[(]\s*(.*?)\s*[\])]", heading)
    return (match[1], match[2]) if match else (heading, "")


def without_heading(path: Path, numbers: Array, width: int, fps: float | None) -> tuple[Array, Array]:
    """Return times (T,) and numbers (T, width) of a table, which may begin with a column of times."""
    if numbers.shape[1] not in (width, width + 1):
        raise UserError(f"{path}: {numbers.shape[1]} columns without a heading; the figure's qpos has {width}")
    values = numbers[:, numbers.shape[1] - width :]
    if numbers.shape[1] == width:
        return times(len(values), rate_of(path, fps)), values
    time = numbers[:, 0]
    if len(time) > 1 and np.all(np.diff(time) == 1):  # a counter of samples
        return times(len(values), rate_of(path, fps)), values
    return time, values


def rate_of(path: Path, fps: float | None) -> float:
    """Return the rate [1/s]; raises UserError if it is None."""
    if fps is None:
        raise UserError(f"{path}: it has no column of times; {GIVE_RATE}")
    return fps


def _inert(name: str) -> str:
    """Return a heading that spreadsheets read as text: joint names are untrusted input from the model."""
    return QUOTE + name if name.startswith(tuple(FORMULA + QUOTE)) else name


def _name_of(cell: str) -> str:
    """Return the name in a heading of `_inert`."""
    return cell[1:] if cell.startswith(QUOTE) and cell[1:].startswith(tuple(FORMULA + QUOTE)) else cell


def table(path: Path) -> tuple[list[str] | None, Array]:
    """Return the names (n,) of the columns, None without a heading, and the numbers (T, n) of a file.

    Raises UserError, with line and separator, for an invalid or truncated one.
    """
    lines, comment = _lines(path)
    separator = _separator([line for _, line in lines])
    names = None if _is_numeric(lines[0][1], separator) else _cells(lines[0][1], separator)
    rows = [(number, _cells(line, separator)) for number, line in lines[names is not None :]]
    if not rows or not _is_numeric(lines[names is not None][1], separator):
        raise UserError(
            f"{path}: no table of numbers, with one heading, separated by commas, semicolons, tabs or spaces, "
            "and with decimal points"
        )
    width, separated = len(rows[0][1]), f"separated by {SEPARATORS[separator]}"
    if names is None and comment is not None and not _is_numeric(comment, separator):
        names = _cells(comment, separator) if len(_cells(comment, separator)) == width > 1 else None
    if names is not None and len(names) != width:
        raise UserError(f"{path}: {len(names)} names for {width} columns, {separated}")
    numbers = [[_number(cell) for cell in row] for _, row in rows]
    bad = [number for (number, row), values in zip(rows, numbers, strict=True) if len(row) != width or None in values]
    if bad:
        more = f" and {len(bad) - 1} more such" if len(bad) > 1 else ""
        raise UserError(
            f"{path}: line {bad[0]} does not hold {width} numbers, {separated}; complete or delete it{more}"
        )
    return names, np.array(numbers, float)


def _cells(line: str, separator: str) -> list[str]:
    """Return the cells of a line without surrounding spaces; a separator at its end is ignored."""
    if separator == " ":
        return line.split()
    row = [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]
    return row[:-1] if len(row) > 1 and not row[-1] else row


def _number(cell: str) -> float | None:
    """Return a cell's number, nan if it is empty, None if it contains anything else."""
    try:
        return float(cell) if cell else np.nan
    except ValueError:
        return None


def _is_numeric(line: str, separator: str) -> bool:
    cells = _cells(line, separator)
    return any(cells) and None not in [_number(cell) for cell in cells]


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


def _separator(lines: Sequence[str]) -> str:
    """Return the separator for which most lines are equally many numbers, of several the one with the most columns."""

    def fits(separator: str) -> tuple[int, int]:
        try:
            widths = [len(_cells(line, separator)) for line in lines[:50] if _is_numeric(line, separator)]
        except csv.Error:
            return 0, 0
        usual = max(set(widths), key=widths.count, default=0)
        return widths.count(usual), usual

    return max(SEPARATORS, key=fits)
