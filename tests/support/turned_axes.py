"""A skeleton's motion in other axes of the world, and with another pose in which nothing is turned."""

from __future__ import annotations

from dataclasses import replace

from scipy.spatial.transform import Rotation

from dynsplines.exchange.skeleton import bvh_file
from dynsplines.exchange.skeleton.bvh_file import Skeleton
from dynsplines.solver import quaternion as quat


def turned(skeleton: Skeleton, world: Rotation, rest: Rotation) -> Skeleton:
    """The same motion; offsets and joints' axes are turned by `rest`, places in the world by `world`."""
    w, r = (turn.as_quat(scalar_first=True) for turn in (world, rest))
    place, turn = (part.copy() for part in skeleton.local)
    root = quat.rotated(w, place[:, 0]), quat.product(quat.product(w, turn[:, 0]), quat.conjugate(r))
    place, turn = quat.rotated(r, place), quat.product(quat.product(r, turn), quat.conjugate(r))
    place[:, 0], turn[:, 0] = root
    joints = [
        replace(
            joint,
            offset=quat.rotated(r, joint.offset),
            end=None if joint.end is None else quat.rotated(r, joint.end),
        )
        for joint in skeleton.joints
    ]
    return bvh_file.skeleton(joints, place, turn, skeleton.fps)
