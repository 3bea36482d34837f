"""CSV: a row per sample with the time and MuJoCo's qpos; a heading names joint and component.

Columns of `quantities` may follow; they are not read. A name that a spreadsheet would take for a formula is preceded
by '. `tables` reads tables of other programs, and resolves their column names in `headings`.
"""

from __future__ import annotations

import csv
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind

from ...errors import UserError
from .. import missing_input, quantities
from ..array_reader import times
from ..tables import headings, table_text
from ..trajectory import Recording, SampledTrajectory

FORMULA = "=+-@\t\r"  # first characters of cells that spreadsheets execute as formulas
QUOTE = "'"
FREE = ("x", "y", "z", "qw", "qx", "qy", "qz")


def columns(model: mujoco.MjModel) -> list[str]:
    """Return the heading of qpos (nq,): "root.x" … "root.qz", "left_hip.qw" …, and the plain name of scalar joints."""
    out: list[str] = []
    for joint in range(model.njnt):
        name = model.joint(joint).name or f"joint{joint}"
        match model.jnt_type[joint]:
            case JointKind.FREE:
                out += [f"{name}.{part}" for part in FREE]
            case JointKind.BALL:
                out += [f"{name}.{part}" for part in FREE[3:]]
            case _:
                out.append(name)
    return out


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write the table; every number has the digits that reproduce it exactly."""
    more = quantities.table(trajectory, trajectory.options.columns)
    table = np.column_stack([trajectory.time, trajectory.qpos, *more.values()])
    with path.open("w", newline="", encoding="utf-8") as stream:
        rows = csv.writer(stream)
        rows.writerow([_inert(name) for name in ("time", *columns(trajectory.model), *more)])
        rows.writerows(map(repr, row) for row in table.tolist())


def recognises(path: Path) -> bool:
    """Return whether a text is a table; raises UserError for one without a heading."""
    if table_text.table(path).names is None:
        raise UserError(
            f"{path}: a table without a heading; add one with the names of the columns (an export to csv shows them), "
            f"or {missing_input.FORMAT}: csv reads time and qpos (quaternions wxyz), mjlab-csv root position, "
            "quaternion xyzw and hinges"
        )
    return True


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read a table: with a heading, columns in any order; without one, nq columns, or the time and nq columns."""
    if model is None:
        raise UserError(f"{path}: a table of qpos is for a figure; {missing_input.FIGURE}")
    source = table_text.table(path)
    notes: tuple[str, ...] = ()
    if source.names is None:
        time, qpos = without_heading(path, source.numbers, model.nq, fps or source.fps)
    else:
        names = list(map(_named, source.names))
        qpos, time, _, notes = headings.resolve(model, columns(model), names, source.numbers, path)
        if time is None:
            time = times(len(qpos), rate_of(path, fps or source.fps))
    return Recording(time, qpos, notes=(*source.notes, *notes))


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
        raise UserError(f"{path}: it has no column of times; {missing_input.RATE}")
    return fps


def _inert(name: str) -> str:
    """Return a heading that spreadsheets read as text: joint names are untrusted input from the model."""
    return QUOTE + name if name.startswith(tuple(FORMULA + QUOTE)) else name


def _named(cell: str) -> str:
    """Return the name in a heading of `_inert`."""
    return cell[1:] if cell.startswith(QUOTE) and cell[1:].startswith(tuple(FORMULA + QUOTE)) else cell
