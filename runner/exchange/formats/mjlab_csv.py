"""CSV from which mjlab and BeyondMimic convert, without a heading.

A row per sample: root xyz [m], root quaternion xyzw, hinges [rad].

Source: mjlab, src/mjlab/scripts/csv_to_npz.py, MotionLoader._load_motion; LAFAN1 retargeted by Unitree has this format.
The file does not contain the rate: mjlab takes it from `--input-fps`, 30 by default. Hinges are in MuJoCo's order.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from ...errors import GIVE_RATE, UserError
from ...motion import Sampled
from ..array_reader import ArrayReader
from ..recording import Recording
from ..robot import Robot, configurations, needs_figure, refuse_balls, robot_joints
from .csv_table import table, without_heading

NAME = "mjlab-csv"


def write(sampled: Sampled, path: Path) -> list[str]:
    """Write the table; every number has the digits that reproduce it exactly. Return notes."""
    robot = Robot.of(sampled.model, NAME)
    root = sampled.qpos[:, robot.root : robot.root + 7]
    rows = np.column_stack([root[:, :3], np.roll(root[:, 3:], -1, axis=1), sampled.qpos[:, robot.columns]])
    with path.open("w", encoding="utf-8") as stream:
        stream.writelines(",".join(map(repr, row)) + "\n" for row in rows.tolist())
    return [f"the file contains no rate: {sampled.fps:g} samples a second", *robot.notes]


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read root and hinges, after an optional column of times; raises UserError for rows of another length."""
    model = needs_figure(model, path)
    names, numbers = table(path)
    if names is not None:
        raise UserError(f"{path}: a table with a heading; the format has none; give --from csv")
    figure_joints = robot_joints(model)
    refuse_balls(model, figure_joints, NAME)
    width = 7 + len(figure_joints)
    if numbers.shape[1] != width + 1 and fps is None:
        raise UserError(f"{path}: the format contains no rate; {GIVE_RATE}")
    if numbers.shape[1] not in (width, width + 1):
        shape = numbers.shape
        raise UserError(
            f"{path}: a table {shape}; a row is root xyz, root quaternion xyzw, and hinges: {width} columns"
        )
    time, rows = without_heading(path, numbers, width, fps)
    parts = {"root": rows[:, :3], "quaternion (columns 4 to 7)": rows[:, 3:7], "hinges": rows[:, 7:]}
    arrays = ArrayReader(path, parts)
    position, joints = arrays.numbers("root", "T", 3), arrays.numbers("hinges", "T", "n")
    rotation = arrays.quaternions("quaternion (columns 4 to 7)", "T", 4, scalar_last=True)
    rate = fps if numbers.shape[1] == width else None
    qpos = configurations(model, NAME, path, position, rotation, joints)
    return Recording(time, qpos, fps=rate)
