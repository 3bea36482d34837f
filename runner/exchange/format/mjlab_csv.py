"""CSV that mjlab and BeyondMimic convert from, without a heading.

A row an instant: root xyz [m], root quaternion xyzw, hinges [rad].

Source: mjlab, src/mjlab/scripts/csv_to_npz.py, MotionLoader._load_motion; LAFAN1 retargeted by Unitree is kept so.
The rate is not in the file: it is theirs to be given, `--input-fps`, 30 by default. Hinges are in MuJoCo's order; a
ball joint is three of them (`hinged`), and the model that has them is written beside the file.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import mujoco
import numpy as np

from ...errors import UserError
from .. import unsaid
from ..held import Held, times
from ..robot import Robot, configurations, needs_figure
from ..take import Recording, Take
from .mjlab import beside as beside

NAME = "mjlab-csv"


def write(take: Take, path: Path) -> None:
    """Every number with the digits that bring it back exactly."""
    hinged = take.hinged
    robot = Robot.of(hinged.model, NAME)
    root = hinged.qpos[:, robot.root : robot.root + 7]
    rows = np.column_stack([root[:, :3], np.roll(root[:, 3:], -1, axis=1), hinged.qpos[:, robot.columns]])
    with path.open("w", encoding="utf-8") as stream:
        stream.writelines(",".join(map(repr, row)) + "\n" for row in rows.tolist())
    take.notes.append(f"the file does not tell its rate: {take.fps:g} samples a second")


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Raises UserError for rows that do not hold root and hinges of the figure, and without a rate."""
    model = needs_figure(model, path)
    if fps is None:
        raise UserError(f"{path}: the format tells none; {unsaid.RATE}")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an empty file, which is told below
            table = np.loadtxt(path, delimiter=",", ndmin=2)
    except ValueError as error:
        raise UserError(f"{path}: not a table of numbers: {' '.join(str(error).split())}") from None
    if table.shape[0] == 0 or table.shape[1] < 8:
        raise UserError(f"{path}: a table {table.shape}; a row is root xyz, root quaternion xyzw, and hinges")
    found = Held(path, {"root": table[:, :3], "quaternion (columns 4 to 7)": table[:, 3:7], "hinges": table[:, 7:]})
    position, joints = found.numbers("root", "T", 3), found.numbers("hinges", "T", "n")
    rotation = found.quaternions("quaternion (columns 4 to 7)", "T", 4, scalar_last=True)
    qpos = configurations(model, NAME, path, position, rotation, joints)
    return Recording(times(len(table), fps), qpos, fps=fps)
