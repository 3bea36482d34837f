"""A motion of ours as other makers' skeletons would have it: other names, other zero poses, other axes and units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from dynsplines.exchange.skeleton.bvh_file import Joint, Skeleton
from dynsplines.exchange.skeleton.hierarchy import euler_angles
from dynsplines.exchange.trajectory import SampledTrajectory
from dynsplines.solver import quaternion as quat

MIXAMO = {
    "pelvis": "mixamorig:Hips", "chest": "mixamorig:Spine2", "left_upper_arm": "mixamorig:LeftArm",
    "left_forearm": "mixamorig:LeftForeArm", "right_upper_arm": "mixamorig:RightArm",
    "right_forearm": "mixamorig:RightForeArm", "left_thigh": "mixamorig:LeftUpLeg", "left_shin": "mixamorig:LeftLeg",
    "left_foot": "mixamorig:LeftFoot", "right_thigh": "mixamorig:RightUpLeg", "right_shin": "mixamorig:RightLeg",
    "right_foot": "mixamorig:RightFoot",
}  # fmt: skip
PLACES = ("Xposition", "Yposition", "Zposition")


def t_pose() -> dict[str, np.ndarray]:
    """How a T-pose turns the arms out of ours, in which they hang."""
    out = {}
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for part in ("upper_arm", "forearm"):
            out[f"{side}_{part}"] = quat.from_rotation_vector(np.array([sign * np.pi / 2, 0, 0]))
    return out


def disguised(
    take: SampledTrajectory,
    *,
    names: Mapping[str, str] = MIXAMO,
    zero: Mapping[str, np.ndarray] | None = None,
    unit: float = 0.01,
    orders: Sequence[str] = ("ZXY", "YXZ", "XYZ", "ZYX", "YZX", "XZY"),
    z_up: bool = False,
    every_place: bool = False,
    larger: float = 1.0,
) -> Skeleton:
    """The human's motion; zero: by body, its rotation (4,) in the pose where all angles are nought, from our rest.

    unit [m]; orders, in turn; every_place: positions for all joints, not just the root; larger: all but the angles
    """
    model, zero = take.model, zero or {}

    def theirs(vector):
        return vector if z_up else np.roll(vector, -1, axis=-1)

    def turned(q):
        return np.concatenate([q[..., :1], theirs(q[..., 1:])], axis=-1)

    bodies = [b for b in range(1, model.nbody) if model.body_weldid[b]]
    zeros = {b: zero.get(model.body(b).name, np.array([1.0, 0, 0, 0])) for b in bodies}
    world = {b: quat.product(take.bodies.rotation[:, b], quat.conjugate(zeros[b])) for b in bodies}
    joints, columns = [], []
    for i, body in enumerate(bodies):
        order, parent = orders[i % len(orders)], int(model.body_parentid[body])
        offset = (
            larger / unit * theirs(quat.rotated(zeros.get(parent, zeros[body]), model.body_pos[body]))
            if i
            else np.zeros(3)
        )
        sites = np.flatnonzero(model.site_bodyid == body)
        leaf = body not in model.body_parentid[bodies]
        end = larger / unit * theirs(quat.rotated(zeros[body], model.site_pos[sites[-1]])) if leaf else None
        places = PLACES if i == 0 or every_place else ()
        name = names.get(model.body(body).name, model.body(body).name)
        joints.append(
            Joint(
                name, bodies.index(parent) if i else -1, offset, (*places, *(f"{axis}rotation" for axis in order)), end
            )
        )
        local = quat.product(quat.conjugate(world[parent]), world[body]) if i else world[body]
        if places:
            root = larger / unit * theirs(take.bodies.position[:, body])
            columns.append(root if i == 0 else np.tile(offset, (len(root), 1)))
        columns.append(np.degrees(euler_angles(turned(local)[:, None], order.lower())[:, 0]))
    return Skeleton(tuple(joints), take.fps, np.concatenate(columns, axis=1))
