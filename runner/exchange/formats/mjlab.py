"""NPZ of mjlab and BeyondMimic (whole_body_tracking): a robot's hinges, and its bodies in the world.

fps (1,)                             [1/s]
joint_pos, joint_vel (T, n)          [rad, rad/s] hinges in MuJoCo's order
body_pos_w (T, b, 3) [m]             origins of the robot's bodies, depth first, the root first, without the world
body_quat_w (T, b, 4)                wxyz
body_lin_vel_w (T, b, 3) [m/s]       of the origins
body_ang_vel_w (T, b, 3) [rad/s]     all of them in the world's axes, z up
joint_names (n,), body_names (b,)    an addition of this program, which other readers ignore

Source: mjlab, src/mjlab/scripts/csv_to_npz.py, which records body_link_pos_w and related arrays.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.figure.root import root_of

from ...motion import Bodies, Sampled, write_arrays
from .. import layouts
from ..array_reader import names_in, read_npz, times
from ..recording import Recording
from ..robot import Robot, configurations, needs_figure

NAME = "mjlab"


def write(sampled: Sampled, path: Path) -> list[str]:
    """Write in double precision, and return notes; raises UserError for a figure that is not a robot on a free root."""
    robot = Robot.of(sampled.model, NAME)
    bodies = Bodies.of(sampled.model, sampled.qpos, sampled.qvel)
    arrays = {
        "fps": np.array([sampled.fps]),
        "joint_pos": sampled.qpos[:, robot.columns],
        "joint_vel": sampled.qvel[:, robot.dofs],
        "body_pos_w": bodies.position[:, robot.bodies],
        "body_quat_w": bodies.rotation[:, robot.bodies],
        "body_lin_vel_w": bodies.velocity[:, robot.bodies],
        "body_ang_vel_w": bodies.spin[:, robot.bodies],
        "joint_names": np.array(robot.joint_names),
        "body_names": np.array(robot.body_names),
    }
    write_arrays(path, arrays)
    return robot.notes


def recognises(path: Path) -> bool:
    """Return whether an .npz is of this format."""
    return {"joint_pos", "body_pos_w"} <= names_in(path)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read root and hinges, verified by the bodies; in the figure's order if the file has no names."""
    model = needs_figure(model, path)
    arrays = read_npz(path)
    rate = arrays.rate("fps", fps)
    joints = arrays.numbers("joint_pos", "samples", "joints")
    position = arrays.numbers("body_pos_w", "samples", "bodies", 3)
    rotation = arrays.quaternions("body_quat_w", "samples", "bodies", 4)
    names = arrays.texts("joint_names") if "joint_names" in arrays else None
    body_names = arrays.texts("body_names") if "body_names" in arrays else []
    figure_root = root_of(model)
    root_name = "" if figure_root is None else model.body(figure_root.body).name
    root = body_names.index(root_name) if root_name in body_names else 0
    qpos = configurations(model, NAME, path, position[:, root], rotation[:, root], joints, names)
    poses = layouts.BodyPoses(position, rotation, tuple(body_names) or None)
    return layouts.recording(model, path, times(len(joints), rate), qpos, poses, scalar_last=False, fps=rate)
