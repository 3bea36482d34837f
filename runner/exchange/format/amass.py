"""NPZ of AMASS, read: motion capture of thousands of people on the SMPL body.

trans (T, 3) [m]        z up, the floor at z = 0
poses (T, 66 or more)   rotation vectors [rad] of SMPL's joints, relative to the parent, the root's in the world:
                        pelvis, left_hip, right_hip, spine1, left_knee, right_knee, spine2, left_ankle, right_ankle,
                        spine3, ...; SMPL-H has 156 numbers, SMPL-X 165, of which the first 22 joints are read
mocap_framerate         [1/s]; mocap_frame_rate in later files

At rest SMPL's body has its arms to the sides, x to its left, y up and z forward. A body of ours has x forward, y to
the left, z up, and its arms hang; so its rotation in the world is that of SMPL's body times a constant one. The three
joints of the spine become one, collar bones go into the shoulders, toes, neck, head and wrists are left out. Source:
N. Mahmood et al., AMASS, ICCV 2019; the joints' order is that of the SMPL model.

The files hold no skeleton, only coefficients of a body model that is not free to pass on. So the limbs are the
figure's own, and the whole motion is lifted or lowered until its lowest sole point, of all samples, touches z = 0.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ..held import held, names_in, times
from ..robot import needs_figure
from ..skeleton.person import Person
from ..take import Recording

NAME = "amass"
PARENT = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)  # of SMPL's joints, by index
JOINT = {
    "spine": 9, "left_hip": 1, "right_hip": 2, "left_knee": 4, "right_knee": 5, "left_ankle": 7, "right_ankle": 8,
    "left_shoulder": 16, "right_shoulder": 17, "left_elbow": 18, "right_elbow": 19,
}  # fmt: skip
ABOVE = {
    "left_shoulder": "spine", "right_shoulder": "spine", "left_elbow": "left_shoulder", "right_elbow": "right_shoulder",
    "left_knee": "left_hip", "right_knee": "right_hip", "left_ankle": "left_knee", "right_ankle": "right_knee",
}  # fmt: skip
AXES = np.array([0.5, -0.5, -0.5, -0.5])  # from our bodies' axes to SMPL's: our x is its z, y its x, z its y
SPREAD = {  # of our arms from hanging to the sides, as SMPL has them at rest
    "left": np.array([np.sqrt(0.5), np.sqrt(0.5), 0, 0]),
    "right": np.array([np.sqrt(0.5), -np.sqrt(0.5), 0, 0]),
}


def recognises(path: Path) -> bool:
    """Whether an .npz is of this kind."""
    return {"poses", "trans"} <= names_in(path)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """The motion of SMPL's body on a person."""
    model = needs_figure(model, path)
    person = Person.of(model, NAME)
    found = held(path)
    position = found.numbers("trans", "samples", 3)
    poses = found.numbers("poses", "samples", "numbers")
    if poses.shape[1] < 3 * len(PARENT):
        found.numbers("poses", "samples", 156)
    rotation = _in_world(quat.from_rotation_vector(poses[:, : 3 * len(PARENT)].reshape(len(poses), -1, 3)))
    bodies = {"root": quat.product(rotation[:, 0], AXES)}
    for name, joint in JOINT.items():
        own = quat.product(rotation[:, joint], AXES)
        arm = name.endswith(("shoulder", "elbow"))
        bodies[name] = quat.product(own, SPREAD[name.split("_")[0]]) if arm else own
    joints = {
        name: quat.product(quat.inverse(bodies[ABOVE.get(name, "root")]), own)
        for name, own in bodies.items()
        if name != "root"
    }
    qpos = person.posed(position, bodies["root"], joints)
    qpos[:, person.root + 2] -= _lowest(model, qpos)
    key = next((name for name in ("mocap_framerate", "mocap_frame_rate") if name in found), None)
    rate = fps if key is None and fps is not None else found.rate(key or "mocap_framerate")
    return Recording(times(len(qpos), rate), qpos, fps=rate)


def _in_world(local: Array) -> Array:
    """Rotations (T, n, 4) in the world, of those relative to the parent."""
    out = local.copy()
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            out[:, joint] = quat.product(out[:, parent], local[:, joint])
    return out


def _lowest(model: mujoco.MjModel, qpos: Array) -> float:
    """The least height [m] that a site of the figure comes to; soles have theirs."""
    if model.nsite == 0:
        return 0.0
    data = mujoco.MjData(model)
    lowest = np.inf
    for row in qpos:
        data.qpos = row
        mujoco.mj_kinematics(model, data)
        lowest = min(lowest, float(data.site_xpos[:, 2].min()))
    return lowest
