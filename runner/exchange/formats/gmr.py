"""Pickle of GMR (General Motion Retargeting) and of programs that train on it, such as TWIST: a dict of a robot's
motion.

fps                       [1/s]
root_pos (T, 3) [m]       z up
root_rot (T, 4)           xyzw, in contrast to MuJoCo's wxyz
dof_pos (T, n) [rad]      hinges in MuJoCo's order
local_body_pos (T, b, 3)  origins of bodies relative to an unrotated root at the origin; None in some files
link_body_list            names of the bodies, depth first, the root first; None together with the former

Source: GMR, scripts/smplx_to_robot_dataset.py and general_motion_retargeting/data_loader.py. `plain_pickle` reads
pickles without executing them.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat

from ...motion import Bodies, Sampled
from .. import layouts, plain_pickle
from ..array_reader import times
from ..recording import Recording
from ..robot import Robot, configurations, needs_figure

NAME = "gmr"


def write(sampled: Sampled, path: Path) -> list[str]:
    """Write in double precision, and return notes; raises UserError for a figure that is not a robot on a free root."""
    robot = Robot.of(sampled.model, NAME)
    bodies = Bodies.of(sampled.model, sampled.qpos, sampled.qvel)
    root = sampled.qpos[:, robot.root : robot.root + 7]
    away = bodies.position[:, robot.bodies] - root[:, None, :3]
    entries = {
        "fps": sampled.fps,
        "root_pos": np.ascontiguousarray(root[:, :3]),
        "root_rot": np.roll(root[:, 3:], -1, axis=1),
        "dof_pos": sampled.qpos[:, robot.columns],
        "local_body_pos": quat.rotate(quat.inverse(root[:, None, 3:]), away),
        "link_body_list": robot.body_names,
    }
    plain_pickle.dump(entries, path)
    return robot.notes


def recognises(path: Path) -> bool:
    """Return whether a pickle is of this format: a key of its dict occurs in it as text."""
    return b"dof_pos" in path.read_bytes()


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read root and hinges in the figure's order, verified by body positions if the file has them."""
    model = needs_figure(model, path)
    motion = plain_pickle.load(path)
    rate = motion.rate("fps", fps)
    position = motion.numbers("root_pos", "samples", 3)
    rotation = motion.quaternions("root_rot", "samples", 4, scalar_last=True)
    joints = motion.numbers("dof_pos", "samples", "joints")
    bodies = None
    if "local_body_pos" in motion:
        names = tuple(motion.texts("link_body_list")) if "link_body_list" in motion else None
        places = motion.numbers("local_body_pos", "samples", "bodies", 3)
        bodies = layouts.BodyPoses(places, names=names, is_local=True)
    qpos = configurations(model, NAME, path, position, rotation, joints)
    return layouts.recording(model, path, times(len(joints), rate), qpos, bodies, scalar_last=True, fps=rate)
