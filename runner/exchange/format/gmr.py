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

Files of ASAP and PHC are read, too. They are written by joblib, compressed or not, as a dict under the motion's name:
root_trans_offset, root_rot, dof, and pose_aa (T, b, 3), rotation vectors of all bodies, the root's in the world.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from .. import layouts, plain_pickle
from ..array_reader import ArrayReader, times
from ..robot import Robot, configurations, needs_figure
from ..trajectory import Bodies, Recording, SampledTrajectory

NAME = "gmr"
ASAP = {"root_trans_offset": "root_pos", "dof": "dof_pos"}  # GMR's names by those of ASAP and PHC


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write in double precision; raises UserError for a figure that is not a robot on a free root."""
    robot = Robot.of(trajectory.model, NAME)
    bodies = Bodies.of(trajectory.model, trajectory.qpos, trajectory.qvel)
    root = trajectory.qpos[:, robot.root : robot.root + 7]
    away = bodies.position[:, robot.bodies] - root[:, None, :3]
    entries = {
        "fps": trajectory.fps,
        "root_pos": np.ascontiguousarray(root[:, :3]),
        "root_rot": np.roll(root[:, 3:], -1, axis=1),
        "dof_pos": trajectory.qpos[:, robot.columns],
        "local_body_pos": quat.rotated(quat.inverse(root[:, None, 3:]), away),
        "link_body_list": robot.body_names,
    }
    plain_pickle.dump(entries, path)


def recognises(path: Path) -> bool:
    """Return whether a pickle is of this format: the keys of its dict occur in it as text."""
    content = plain_pickle.content(path)
    return b"dof_pos" in content or (b"root_trans_offset" in content and b"dof" in content)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read root and hinges in the figure's order, verified by body positions if the file has them."""
    model = needs_figure(model, path)
    motion = _motion(plain_pickle.load(path))
    rate = motion.rate("fps", fps)
    position = motion.numbers("root_pos", "samples", 3)
    if "root_rot" not in motion and "pose_aa" in motion:
        rotation = _root_turned(motion)
    else:
        rotation = motion.quaternions("root_rot", "samples", 4, scalar_last=True)
    joints = motion.numbers("dof_pos", "samples", "joints")
    qpos = configurations(model, NAME, path, position, rotation, joints)
    return layouts.recording(model, path, times(len(joints), rate), qpos, _bodies(motion), scalar_last=True, fps=rate)


def _motion(reader: ArrayReader) -> ArrayReader:
    """Return the one motion of a file under GMR's keys; raises UserError for several."""
    entries = dict(plain_pickle.one_motion(reader).entries)
    for theirs, ours in ASAP.items():
        if theirs in entries and ours not in entries:
            entries[ours] = entries.pop(theirs)
    joints = entries.get("dof_pos")
    if isinstance(joints, np.ndarray) and joints.ndim == 3 and joints.shape[2] == 1:
        entries["dof_pos"] = joints[:, :, 0]
    return ArrayReader(reader.where, entries)


def _root_turned(reader: ArrayReader) -> Array:
    """Return the root's rotation (T, 4) in ASAP's redundant form: the first of the bodies' rotation vectors."""
    return quat.aligned(quat.from_rotation_vector(reader.numbers("pose_aa", "samples", "bodies and axes", 3)[:, 0]))


def _bodies(reader: ArrayReader) -> layouts.BodyPoses | None:
    """Return body positions relative to the root, or the root's pose from its rotation vector, if the file has them."""
    if "local_body_pos" in reader:
        names = tuple(reader.texts("link_body_list")) if "link_body_list" in reader else None
        return layouts.BodyPoses(reader.numbers("local_body_pos", "samples", "bodies", 3), names=names, is_local=True)
    if "pose_aa" in reader and np.ndim(reader.of("pose_aa")) == 3:
        root = reader.numbers("root_pos", "samples", 3)
        return layouts.BodyPoses(root[:, None], _root_turned(reader)[:, None])
    return None
