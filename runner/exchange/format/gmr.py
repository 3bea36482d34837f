"""Pickle of GMR (General Motion Retargeting) and what is trained on it, such as TWIST: a dict of a robot's motion.

fps                       [1/s]
root_pos (T, 3) [m]       z up
root_rot (T, 4)           xyzw, where MuJoCo has wxyz
dof_pos (T, n) [rad]      hinges, MuJoCo's order
local_body_pos (T, b, 3)  bodies' origins as if the root lay unturned at the origin; None in some of their files
link_body_list            names of the bodies, depth first, the root first; None with the former

Source: GMR, scripts/smplx_to_robot_dataset.py and general_motion_retargeting/data_loader.py. A ball joint is three
hinges (`hinged`); the model that has them is written beside the file. Pickles are read by `plain_pickle`, which runs
nothing.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat

from .. import layouts
from ..held import Held, times
from ..pickles import plain_pickle
from ..robot import Robot, configurations, needs_figure
from ..take import Bodies, BodyPoses, Recording, Take
from .mjlab import beside as beside

NAME = "gmr"


def write(take: Take, path: Path) -> None:
    """In double precision; raises UserError for a figure that is no robot on a free root."""
    hinged = take.hinged
    robot = Robot.of(hinged.model, NAME)
    bodies = Bodies.of(hinged.model, hinged.qpos, hinged.qvel)
    root = hinged.qpos[:, robot.root : robot.root + 7]
    away = bodies.position[:, robot.bodies] - root[:, None, :3]
    entries = {
        "fps": take.fps,
        "root_pos": np.ascontiguousarray(root[:, :3]),
        "root_rot": np.roll(root[:, 3:], -1, axis=1),
        "dof_pos": hinged.qpos[:, robot.columns],
        "local_body_pos": quat.rotated(quat.inverse(root[:, None, 3:]), away),
        "link_body_list": robot.body_names,
    }
    plain_pickle.dump(entries, path)


def recognises(path: Path) -> bool:
    """Whether a pickle is of this kind; every key of a dict of theirs stands in it as text."""
    return b"dof_pos" in path.read_bytes()


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Root and hinges in the figure's order, verified by the bodies where the file has them."""
    model = needs_figure(model, path)
    found = plain_pickle.load(path)
    rate = found.rate("fps") if "fps" in found or fps is None else fps
    position = found.numbers("root_pos", "samples", 3)
    rotation = found.quaternions("root_rot", "samples", 4, scalar_last=True)
    joints = found.numbers("dof_pos", "samples", "joints")
    readings: dict[tuple[str, ...], layouts.Reading] = {
        (): partial(configurations, model, NAME, path, position, rotation, joints)
    }
    return layouts.recording(
        model, times(len(joints), rate), readings, scalar_last=True, has_names=False, bodies=_bodies(found), fps=rate
    )


def _bodies(found: Held) -> BodyPoses | None:
    """The bodies about the root, where the file has them."""
    if "local_body_pos" not in found:
        return None
    names = tuple(found.texts("link_body_list")) if "link_body_list" in found else None
    return BodyPoses(found.numbers("local_body_pos", "samples", "bodies", 3), names=names, is_local=True)
