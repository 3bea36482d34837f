"""NPZ of LocoMuJoCo: a Trajectory as its `save` writes it, with every array.

qpos (T, nq), qvel (T, nv)                     MuJoCo's; free joints and hinges only
xpos, xquat, cvel, subtree_com (T, nbody, ...) of mjData at every sample, the world first
site_xpos (T, nsite, 3), site_xmat (T, nsite, 9)
split_points (2,)                              first sample of every motion, and the end of the last: 0, T
joint_names, body_names, site_names, frequency [1/s]
njnt, jnt_type, nbody, body_rootid, body_weldid, body_mocapid, body_pos, body_quat, body_ipos, body_iquat,
nsite, site_bodyid, site_pos, site_quat        of mjModel

Source: LocoMuJoCo 1.0, loco_mujoco/trajectory/dataclasses.py; its `load` rejects unknown names and ball joints.
`metadata` is omitted, as None would be a pickled object. Files from before version 1.0, with an array for every joint,
are not read.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind

from ...errors import UserError
from ...motion import Sampled, write_arrays
from .. import layouts
from ..array_reader import ArrayReader, names_in, read_npz, times, unit_quaternions
from ..recording import Recording
from ..robot import Robot, body_name, configurations, joint_name, needs_figure

NAME = "locomujoco"
OF_MODEL = (
    "jnt_type", "body_rootid", "body_weldid", "body_mocapid", "body_pos", "body_quat", "body_ipos", "body_iquat",
    "site_bodyid", "site_pos", "site_quat",
)  # fmt: skip
OF_DATA = ("xpos", "xquat", "cvel", "subtree_com", "site_xpos", "site_xmat")


def write(sampled: Sampled, path: Path) -> None:
    """Write in double precision; raises UserError for a figure that is not a robot on a free root, or with objects."""
    robot, model = Robot.of(sampled.model, NAME), sampled.model
    if robot.objects:
        raise UserError(
            f"the format '{NAME}' is for one figure, not for '{robot.objects[0]}'; export mjlab, which omits it, and "
            "import that file with the figure alone"
        )
    arrays = {
        "qpos": sampled.qpos,
        "qvel": sampled.qvel,
        "split_points": np.array([0, len(sampled.qpos)]),
        "joint_names": np.array([joint_name(model, i) for i in range(model.njnt)]),
        "body_names": np.array([body_name(model, i) for i in range(model.nbody)]),
        "site_names": np.array([model.site(i).name or f"site{i}" for i in range(model.nsite)], dtype=np.str_),
        "frequency": np.array(sampled.fps),
        **{name: np.array(getattr(model, name)) for name in ("njnt", "nbody", "nsite", *OF_MODEL)},
        **_of_data(model, sampled.qpos, sampled.qvel),
    }
    write_arrays(path, arrays)


def _of_data(model: mujoco.MjModel, qpos: Array, qvel: Array) -> dict[str, Array]:
    """Return MuJoCo's derived quantities at every sample, by name."""
    data = mujoco.MjData(model)
    out = {name: np.zeros((len(qpos), *getattr(data, name).shape)) for name in OF_DATA}
    for t in range(len(qpos)):
        data.qpos, data.qvel = qpos[t], qvel[t]
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        for name, array in out.items():
            array[t] = getattr(data, name)
    return out


def recognises(path: Path) -> bool:
    """Return whether an .npz is of this format."""
    return {"qpos", "split_points"} <= names_in(path)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the joints by name, verified by body poses if the file has them.

    Raises UserError for files of several motions, and for joints other than the figure's.
    """
    model = needs_figure(model, path)
    arrays = read_npz(path)
    declared = _count(arrays, path)
    names, kinds = arrays.texts("joint_names"), arrays.numbers("jnt_type", "joints").astype(int).tolist()
    fits = set(kinds) <= {JointKind.FREE, JointKind.SLIDE, JointKind.HINGE} and kinds.count(JointKind.FREE) == 1
    if len(kinds) != len(names) or not fits:
        raise UserError(f"{path}: 'jnt_type' must list one free joint and one hinge for each of 'joint_names'")
    starts = np.cumsum([0, *(JointKind(kind).width for kind in kinds)]).tolist()
    qpos = arrays.numbers("qpos", "samples", starts[-1])
    if declared > len(qpos):
        arrays.check_samples("split_points", (declared,))
    root = starts[kinds.index(JointKind.FREE)]
    hinges = [i for i, kind in enumerate(kinds) if kind != JointKind.FREE]
    turned = unit_quaternions(qpos[:, root + 3 : root + 7], "qpos (the root's quaternion)", path)
    joints, called = qpos[:, [starts[i] for i in hinges]], [names[i] for i in hinges]
    rate = arrays.rate("frequency", fps)
    time, bodies = times(len(qpos), rate), layouts.body_poses(arrays)
    qpos = configurations(model, NAME, path, qpos[:, root : root + 3], turned, joints, called)
    return layouts.recording(model, path, time, qpos, bodies, scalar_last=False, fps=rate)


def _count(reader: ArrayReader, path: Path) -> int:
    """Return the number of samples that the file declares; raises UserError for several motions."""
    splits = reader.numbers("split_points", "splits")
    if len(splits) > 2:
        raise UserError(f"{path}: it holds {len(splits) - 1} motions one after another; cut them apart first")
    return int(splits[-1] - splits[0]) if splits.size == 2 else 0
