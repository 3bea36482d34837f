"""NPZ of mjlab and BeyondMimic (whole_body_tracking): a robot's hinges, and its bodies in the world.

fps (1,)                             [1/s]
joint_pos, joint_vel (T, n)          [rad, rad/s] hinges, MuJoCo's order
body_pos_w (T, b, 3) [m]             origins of the robot's bodies, depth first, the root first, without the world
body_quat_w (T, b, 4)                wxyz
body_lin_vel_w (T, b, 3) [m/s]       of the origins
body_ang_vel_w (T, b, 3) [rad/s]     all of them in the world's axes, z up
joint_names (n,), body_names (b,)    ours: theirs have no names, and their readers do not mind

Source: mjlab, src/mjlab/scripts/csv_to_npz.py, which logs body_link_pos_w and its kin. A ball joint is three hinges
(`hinged`); the model that has them is written beside the file.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from ...motion import write_arrays
from ..held import held, names_in, times
from ..robot import Robot, configurations, needs_figure
from ..take import Bodies, Recording, Take

NAME = "mjlab"


def write(take: Take, path: Path) -> None:
    """In double precision; raises UserError for a figure that is no robot on a free root."""
    hinged = take.hinged
    robot = Robot.of(hinged.model, NAME)
    bodies = Bodies.of(hinged.model, hinged.qpos, hinged.qvel)
    arrays = {
        "fps": np.array([take.fps]),
        "joint_pos": hinged.qpos[:, robot.columns],
        "joint_vel": hinged.qvel[:, robot.dofs],
        "body_pos_w": bodies.position[:, robot.bodies],
        "body_quat_w": bodies.rotation[:, robot.bodies],
        "body_lin_vel_w": bodies.velocity[:, robot.bodies],
        "body_ang_vel_w": bodies.spin[:, robot.bodies],
        "joint_names": np.array(robot.joint_names),
        "body_names": np.array(robot.body_names),
    }
    write_arrays(path, arrays)


def beside(take: Take) -> dict[str, str | bytes]:
    """The model of hinges that the motion is for, if it is not the figure itself, and the files it refers to."""
    return {".hinges.xml": take.hinged.mjcf, **take.saved.scene.assets} if take.hinged.is_other else {}


def recognises(path: Path) -> bool:
    """Whether an .npz is of this kind."""
    return {"joint_pos", "body_pos_w"} <= names_in(path)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """The root's body and the hinges; by name where the file has names, else in the figure's order."""
    model = needs_figure(model, path)
    found = held(path)
    rate = found.rate("fps") if "fps" in found or fps is None else fps
    joints = found.numbers("joint_pos", "samples", "joints")
    position = found.numbers("body_pos_w", "samples", "bodies", 3)[:, 0]
    rotation = found.quaternions("body_quat_w", "samples", "bodies", 4)[:, 0]
    names = found.texts("joint_names") if "joint_names" in found else None
    qpos = configurations(model, NAME, path, position, rotation, joints, names)
    return Recording(times(len(joints), rate), qpos, fps=rate)
