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

ASAP and PHC keep the same by joblib, compressed or not, under the motion's name: root_trans_offset, root_rot, dof, and
pose_aa (T, b, 3), rotation vectors of all bodies, the root's in the world. It is read, too.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError
from .. import layouts
from ..array_reader import ArrayReader, times
from ..pickles import plain_pickle
from ..robot import Robot, configurations, needs_figure
from ..trajectory import Bodies, BodyPoses, Recording, SampledTrajectory
from .mjlab import beside as beside

NAME = "gmr"
ASAP = {"root_trans_offset": "root_pos", "dof": "dof_pos"}  # names of ASAP and PHC, and GMR's


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write in double precision; raises UserError for a figure that is not a robot on a free root."""
    hinged = trajectory.hinged
    robot = Robot.of(hinged.model, NAME)
    bodies = Bodies.of(hinged.model, hinged.qpos, hinged.qvel)
    root = hinged.qpos[:, robot.root : robot.root + 7]
    away = bodies.position[:, robot.bodies] - root[:, None, :3]
    entries = {
        "fps": trajectory.fps,
        "root_pos": np.ascontiguousarray(root[:, :3]),
        "root_rot": np.roll(root[:, 3:], -1, axis=1),
        "dof_pos": hinged.qpos[:, robot.columns],
        "local_body_pos": quat.rotated(quat.inverse(root[:, None, 3:]), away),
        "link_body_list": robot.body_names,
    }
    plain_pickle.dump(entries, path)


def recognises(path: Path) -> bool:
    """Whether a pickle is of this format; every key of its dict occurs in it as text."""
    content = plain_pickle.content(path)
    return b"dof_pos" in content or (b"root_trans_offset" in content and b"dof" in content)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Root and hinges in the figure's order, verified by the bodies where the file has them."""
    model = needs_figure(model, path)
    motion = _motion(plain_pickle.load(path))
    rate = motion.rate("fps", fps)
    position = motion.numbers("root_pos", "samples", 3)
    if "root_rot" not in motion and "pose_aa" in motion:
        rotation = _root_turned(motion)
    else:
        rotation = motion.quaternions("root_rot", "samples", 4, scalar_last=True)
    joints = motion.numbers("dof_pos", "samples", "joints")
    readings: dict[tuple[str, ...], layouts.Reading] = {
        (): partial(configurations, model, NAME, path, position, rotation, joints)
    }
    return layouts.recording(
        model, times(len(joints), rate), readings, scalar_last=True, has_names=False, bodies=_bodies(motion), fps=rate
    )


def _motion(found: ArrayReader) -> ArrayReader:
    """The one motion of a file, under GMR's keys; raises UserError for several, and for one without joints."""
    entries = dict(plain_pickle.one_motion(found).entries)
    for theirs, ours in ASAP.items():
        if theirs in entries and ours not in entries:
            entries[ours] = entries.pop(theirs)
    if "dof_pos" not in entries and "pose_aa" in entries:
        raise UserError(f"{found.where}: a motion of SMPL's body, 'pose_aa' without a robot's 'dof'; give --from amass")
    joints = entries.get("dof_pos")
    if isinstance(joints, np.ndarray) and joints.ndim == 3 and joints.shape[2] == 1:
        entries["dof_pos"] = joints[:, :, 0]
    return ArrayReader(found.where, entries)


def _root_turned(found: ArrayReader) -> Array:
    """The root's rotation (T, 4) as ASAP has it besides: the first of the rotation vectors of all bodies."""
    return quat.aligned(quat.from_rotation_vector(found.numbers("pose_aa", "samples", "bodies and axes", 3)[:, 0]))


def _bodies(found: ArrayReader) -> BodyPoses | None:
    """The bodies about the root, or the root's rotation vector, where the file has them."""
    if "local_body_pos" in found:
        names = tuple(found.texts("link_body_list")) if "link_body_list" in found else None
        return BodyPoses(found.numbers("local_body_pos", "samples", "bodies", 3), names=names, is_local=True)
    if "pose_aa" in found and np.ndim(found.of("pose_aa")) == 3:
        root = found.numbers("root_pos", "samples", 3)
        return BodyPoses(root[:, None], _root_turned(found)[:, None], is_wxyz=True)
    return None
