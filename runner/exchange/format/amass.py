"""NPZ of AMASS and other recordings on the SMPL body, only read: motion capture of thousands of people.

trans (T, 3) [m]        z up, the floor at z = 0
poses (T, n)            rotation vectors [rad] of SMPL's joints, relative to the parent, the root's in the world:
                        pelvis, left_hip, right_hip, spine1, left_knee, right_knee, spine2, left_ankle, right_ankle,
                        spine3, ...; n is 66, 72 (SMPL), 156 (SMPL-H) or 165 (SMPL-X); 22 joints are read
mocap_framerate         [1/s]; mocap_frame_rate in later files

Other names of the same arrays are those of `POSES`, `ROOTS`, `BODIES`, `PLACES` and `RATES`; poses may also have the
shape (T, joints, 3). Files with y up, or positions in centimetres or millimetres, are recognised and converted.
Positions of AIST++ are divided by `smpl_scaling`.

At rest SMPL's body has its arms to the sides, x to its left, y up and z forward. Source: N. Mahmood et al., AMASS, ICCV
2019. The files contain no skeleton, only coefficients of a body model that may not be redistributed. So a file is read
in one of two ways:

- A figure like the shipped human, with SMPL's joints as ball joints, gets their angles. It has x forward, y to the
  left and z up, and its arms hang, so its orientation is that of SMPL's body times a constant rotation. The three
  joints of the spine become one, and collar bones become part of the shoulders; toes, neck, head and wrists are
  omitted. The figure keeps its limb lengths. The motion is shifted vertically until the lowest sole point of all
  samples touches z = 0.
- Any other figure gets the motion of SMPL's mean shape (`smpl`) by retargeting. Without a figure, the mean shape is
  the figure.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.forward import kinematics

from ...errors import UserError
from ...motion import FARTHEST
from ...scene.configuration import posed
from .. import missing_input, plain_pickle
from ..array_reader import SAMPLES, ArrayReader, names_in, read_npz, times
from ..skeleton import hierarchy, smpl
from ..skeleton.roles import SIDES, lineage
from ..trajectory import Recording
from . import bvh

POSES = ("poses", "smpl_poses", "pose_aa", "fullpose", "full_pose")
ROOTS = ("root_orient", "global_orient", "poses_root")
BODIES = ("pose_body", "body_pose", "poses_body")
PLACES = ("trans", "transl", "smpl_trans", "translation", "trans_orig", "root_trans_offset")
RATES = ("mocap_framerate", "mocap_frame_rate", "mocap_fps", "framerate", "frame_rate", "fps")
SCALE = "smpl_scaling"
ROBOT = "dof"  # array that only files of robots have, among SMPL's names
BODY = 3 * len(smpl.NAMES)
COUNTS = (22, 24, 52, 55)  # joints of SMPL's body, SMPL, SMPL-H and SMPL-X
JOINT = {  # of SMPL, by ball joint of the figure
    "spine": smpl.NAMES.index("spine3"),
    **{
        f"{side}_{part}": smpl.NAMES.index(f"{side}_{part}")
        for side in SIDES
        for part in ("shoulder", "elbow", "hip", "knee", "ankle")
    },
}
SPREAD = {  # rotation of hanging arms to the sides, as at rest in SMPL
    "left": np.array([np.sqrt(0.5), np.sqrt(0.5), 0, 0]),
    "right": np.array([np.sqrt(0.5), -np.sqrt(0.5), 0, 0]),
}


def recognises(path: Path) -> bool:
    """Return whether an .npz or a pickle is of this format."""
    if path.suffix.lower() == ".npz":
        return _is_smpl(names_in(path))
    text = plain_pickle.content(path)
    return _is_smpl([name for name in (*POSES, *ROOTS, *BODIES, *PLACES, ROBOT) if name.encode() in text])


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the motion of SMPL's body on a figure, or as a new figure."""
    is_npz = path.suffix.lower() == ".npz"
    arrays = read_npz(path) if is_npz else plain_pickle.one_motion(plain_pickle.load(path))
    position, poses = _motion(arrays)
    name = _first(arrays, RATES)
    if name is None and fps is None:
        raise UserError(f"{path}: it has no '{RATES[0]}'; {missing_input.RATE}")
    rate = fps if name is None and fps is not None else arrays.rate(name or RATES[0])
    local = quat.from_rotation_vector(poses)
    position, local, turned = smpl.z_up(position, local)
    position, scaled = (position, ()) if SCALE in arrays else smpl.in_metres(position, local)
    notes = turned + scaled
    columns = None if model is None else _columns(model)
    if model is None or columns is None:
        notes += _on_shape(arrays)
        return bvh.of_captured(smpl.captured(position, local), rate, path, model, notes)
    qpos = _on_person(model, columns, position, local)
    return Recording(times(len(qpos), rate), qpos, fps=rate, notes=notes)


def _is_smpl(names: Iterable[str]) -> bool:
    """Return whether these are the names of arrays of a motion on SMPL's body."""
    there = set(names)
    turned = there.intersection(POSES) or (there.intersection(ROOTS) and there.intersection(BODIES))
    return bool(turned and there.intersection(PLACES)) and ROBOT not in there


def _first(reader: ArrayReader, names: tuple[str, ...]) -> str | None:
    return next((name for name in names if name in reader), None)


def _motion(reader: ArrayReader) -> tuple[Array, Array]:
    """Return positions (T, 3) and rotation vectors (T, 22, 3); raises UserError for other shapes."""
    place, poses = _first(reader, PLACES) or PLACES[0], _first(reader, POSES)
    root, body = _first(reader, ROOTS), _first(reader, BODIES)
    if poses is None and root is not None and body is not None:
        arrays = {root: _rows(reader, root, (1,)), body: _rows(reader, body, [count - 1 for count in COUNTS])}
    else:
        poses = poses or POSES[0]
        arrays = {poses: _rows(reader, poses, COUNTS)}
    arrays[place] = reader.numbers(place, SAMPLES, 3)
    count = len(arrays[place])
    if not count:
        raise UserError(f"{reader.where}: it has no samples")
    position = arrays.pop(place)
    if SCALE in reader:
        position = position / reader.number(SCALE, 1e-9, FARTHEST, "a positive number")
    turns = np.concatenate(list(arrays.values()), axis=1)
    return position, turns[:, :BODY].reshape(count, -1, 3)


def _rows(reader: ArrayReader, name: str, counts: Sequence[int]) -> Array:
    """Return rotation vectors (T, 3 joints) of an array (T, 3 joints) or (T, joints, 3); counts: of joints."""
    nested = isinstance(reader.of(name), np.ndarray) and reader.of(name).ndim == 3
    shape = (SAMPLES, f"joints of {name}", 3) if nested else (SAMPLES, f"numbers of {name}")
    array = reader.numbers(name, *shape)
    array = array.reshape(len(array), int(np.prod(array.shape[1:])))
    widths = [3 * count for count in counts]
    if array.shape[1] not in widths:
        raise UserError(
            f"{reader.where}: '{name}' has {array.shape[1]} numbers a sample; rotation vectors of SMPL's joints are "
            f"{', '.join(map(str, widths))} numbers"
        )
    return array


def _on_shape(reader: ArrayReader) -> tuple[str, ...]:
    """Return a note if a file has the shape of the person."""
    betas = reader.of("betas") if "betas" in reader else None
    has_shape = isinstance(betas, np.ndarray) and betas.dtype.kind in "fiu" and bool(np.any(betas))
    return ("bones are those of SMPL's mean shape: the file's 'betas' are not used",) if has_shape else ()


def _columns(model: mujoco.MjModel) -> dict[str, int] | None:
    """Return the first columns in qpos of the root and of the ball joints of a figure like the shipped human.

    None for a figure that lacks some of them, or has bodies that are not parallel to the world at rest.
    """
    roots = np.flatnonzero(model.jnt_type == JointKind.FREE)
    joints = {model.joint(joint).name: joint for joint in np.flatnonzero(model.jnt_type == JointKind.BALL)}
    if len(roots) != 1 or not joints.keys() >= JOINT.keys():
        return None
    chosen = [roots[0], *(joints[name] for name in JOINT)]
    if np.abs(kinematics(model).xquat[model.jnt_bodyid[chosen[1:]], 0]).min() < 1 - 1e-6:
        return None
    return dict(zip(("root", *JOINT), model.jnt_qposadr[chosen].tolist(), strict=True))


def _on_person(model: mujoco.MjModel, columns: dict[str, int], position: Array, local: Array) -> Array:
    """Return qpos (T, nq) with the joints' angles, on the floor."""
    _, rotation = smpl.in_world(local)
    bodies = {"root": quat.product(rotation[:, 0], hierarchy.Y_UP)}
    for name, joint in JOINT.items():
        world = quat.product(rotation[:, joint], hierarchy.Y_UP)
        arm = name.endswith(("shoulder", "elbow"))
        bodies[name] = quat.product(world, SPREAD[name.split("_")[0]]) if arm else world
    qpos, root = np.tile(model.qpos0, (len(position), 1)), columns["root"]
    qpos[:, root : root + 3] = position
    qpos[:, root + 3 : root + 7] = quat.aligned(bodies["root"])
    names = {joint: name for name, joint in JOINT.items()}
    for name, joint in JOINT.items():
        above = next((names[i] for i in lineage(joint, smpl.PARENT)[1:] if i in names), "root")
        turn = quat.product(quat.inverse(bodies[above]), bodies[name])
        qpos[:, columns[name] : columns[name] + 4] = quat.aligned(turn)
    qpos[:, root + 2] -= _lowest(model, qpos)
    return qpos


def _lowest(model: mujoco.MjModel, qpos: Array) -> float:
    """Return the least height [m] of the figure's sites, which include those at the soles."""
    if model.nsite == 0:
        return 0.0
    return min(float(data.site_xpos[:, 2].min()) for data in posed(model, qpos))
