"""CSV: a row an instant, the time and MuJoCo's qpos, under a heading that names joint and component.

More columns, of `quantities`, may follow; those are not read. A name that a spreadsheet would take for a formula has
a ' before it.
"""

from __future__ import annotations

import csv
from pathlib import Path

import mujoco
import numpy as np

from ...errors import UserError
from .. import quantities, unsaid
from ..take import Recording, Take

FORMULA = "=+-@\t\r"  # what a spreadsheet takes for the begin of one, and runs
QUOTE = "'"
FREE = ("x", "y", "z", "qw", "qx", "qy", "qz")


def columns(model: mujoco.MjModel) -> list[str]:
    """The heading of qpos (nq,): "root.x" … "root.qz", "left_hip.qw" …, and a hinge's or slide's name alone."""
    out: list[str] = []
    for joint in range(model.njnt):
        name = model.joint(joint).name or f"joint{joint}"
        match model.jnt_type[joint]:
            case mujoco.mjtJoint.mjJNT_FREE:
                out += [f"{name}.{part}" for part in FREE]
            case mujoco.mjtJoint.mjJNT_BALL:
                out += [f"{name}.{part}" for part in FREE[3:]]
            case _:
                out.append(name)
    return out


def write(take: Take, path: Path) -> None:
    """Every number with the digits that bring it back exactly."""
    more = quantities.table(take, take.wishes.columns)
    table = np.column_stack([take.time, take.qpos, *more.values()])
    with path.open("w", newline="", encoding="utf-8") as stream:
        rows = csv.writer(stream)
        rows.writerow([_inert(name) for name in ("time", *columns(take.model), *more)])
        rows.writerows(map(repr, row) for row in table.tolist())


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """With our heading, columns in any order; without one nq columns, or the time and nq columns."""
    if model is None:
        raise UserError(f"{path}: a table of qpos is for a figure; {unsaid.FIGURE}")
    try:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            rows = [row for row in csv.reader(stream) if any(cell.strip() for cell in row)]
    except (UnicodeDecodeError, csv.Error) as error:
        raise UserError(f"{path}: not a table of text: {error}") from None
    if not rows:
        raise UserError(f"{path}: the file is empty")
    heading = None if _is_number(rows[0][0]) else [_named(cell.strip()) for cell in rows[0]]
    body = rows if heading is None else rows[1:]
    width = len(rows[0])
    try:
        table = np.array([[float(cell) for cell in row] for row in body]).reshape(-1, width)
    except ValueError:
        bad = next(i for i, row in enumerate(body) if len(row) != width or not all(map(_is_number, row)))
        line = bad + 1 + (heading is not None)
        raise UserError(f"{path}: row {line} does not hold {width} numbers") from None
    if heading is not None:
        wanted = columns(model)
        missing = [name for name in wanted if name not in heading]
        if missing:
            raise UserError(f"{path}: no column '{missing[0]}'; the figure's columns: {', '.join(wanted)}")
        qpos = table[:, [heading.index(name) for name in wanted]]
        time = table[:, heading.index("time")] if "time" in heading else None
    elif width in (model.nq, model.nq + 1):
        qpos, time = table[:, width - model.nq :], table[:, 0] if width > model.nq else None
    else:
        raise UserError(f"{path}: {width} columns without a heading; the figure's qpos has {model.nq}")
    if time is None:
        if fps is None:
            raise UserError(f"{path}: it has no column of times; {unsaid.RATE}")
        time = np.arange(len(qpos)) / fps
    return Recording(time, qpos)


def _inert(name: str) -> str:
    """A heading that is text to every spreadsheet: names of joints come from whoever made the model."""
    return QUOTE + name if name.startswith(tuple(FORMULA + QUOTE)) else name


def _named(cell: str) -> str:
    """The name in such a heading."""
    return cell[1:] if cell.startswith(QUOTE) and cell[1:].startswith(tuple(FORMULA + QUOTE)) else cell


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True
