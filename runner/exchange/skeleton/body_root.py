"""A skeleton from the root of its body on: the motion of the parents above the pelvis becomes part of the root's.

Many programs have such parents, which are static or carry the body along: Reference, Armature, world, a trajectory on
the ground. The root of the result moves in the world as the pelvis did.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from . import bvh_file
from .bvh_file import Skeleton
from .roles import apply_bone_map, lineage, roles, unique

STILL = 1e-6  # [1 for quaternions, or the file's unit of length] largest change that counts as no motion
MOST_NAMES = 8  # most names in a note


def from_body_root(skeleton: Skeleton, bone_map: Mapping[str, str]) -> tuple[Skeleton, tuple[str, ...]]:
    """Return the skeleton from the root of its body on, and a note on the joints left out.

    bone_map: the recording's names by role

    The skeleton is unchanged if its root is that of the body, and also if the body's root does not translate in its
    parent and other branches move.
    """
    root = _body_root(skeleton, bone_map)
    if root == 0:
        return skeleton, ()
    above = lineage(root, skeleton.parents)[1:]
    subtree = [i for i in range(root, len(skeleton.joints)) if root in lineage(i, skeleton.parents)]
    beside = [i for i in range(len(skeleton.joints)) if i not in subtree and i not in above]
    beside = [i for i in beside if any(np.ptp(part[:, i], axis=0).max() > STILL for part in skeleton.world)]
    if beside and np.ptp(skeleton.local[0][:, root], axis=0).max() <= STILL:
        return skeleton, ()
    place, turn = (part.copy() for part in skeleton.local)
    world_place, world_turn = skeleton.world
    zero = _at_zero(skeleton, world_turn[:, above[0]], root)
    place[:, root], turn[:, root] = world_place[:, root], quat.product(world_turn[:, root], quat.inverse(zero))
    joints = []
    for i in subtree:
        joint = skeleton.joints[i]
        parent = subtree.index(joint.parent) if i != root else -1
        end = None if joint.end is None else quat.rotated(zero, joint.end)
        joints.append(replace(joint, parent=parent, offset=quat.rotated(zero, joint.offset), end=end))
        if i != root:
            place[:, i] = quat.rotated(zero, place[:, i])
            turn[:, i] = quat.product(quat.product(zero, turn[:, i]), quat.inverse(zero))
    names = ", ".join(skeleton.names[i] for i in reversed(above))
    note = f"'{skeleton.names[root]}' is the root; its parents are folded into it: {names}"
    if beside:
        note += f"; other branches are left out: {', '.join(skeleton.names[i] for i in beside[:MOST_NAMES])}"
    return bvh_file.skeleton(joints, place[:, subtree], turn[:, subtree], skeleton.frame_time), (note,)


def _body_root(skeleton: Skeleton, bone_map: Mapping[str, str]) -> int:
    """Return the joint that carries all parts of the body known by name. Without such names it is the first joint from
    the top that carries several joints, or one without position channels."""
    parents, names = skeleton.parents, unique(skeleton.names)
    parts = set(apply_bone_map(roles(names, parents), bone_map, names, "recording").values())
    if len(parts) > 1:
        shared = set.intersection(*(set(lineage(i, parents)) for i in parts))
        return max(shared, default=0)
    root = 0
    while True:
        below = [i for i, parent in enumerate(parents) if parent == root]
        if len(below) != 1 or not any(channel.endswith("position") for channel in skeleton.joints[below[0]].channels):
            return root
        root = below[0]


def _at_zero(skeleton: Skeleton, carried: Array, root: int) -> Array:
    """Return the rotation (4,) of the zero pose by static parents that make it upright, as in files made z up."""
    none = np.array([1.0, 0, 0, 0])
    if np.abs(carried - carried[0]).max() > STILL:
        return none
    by_role = roles(skeleton.names, skeleton.parents)
    feet = [by_role[role] for role in ("left_foot", "right_foot", "left_shin", "right_shin") if role in by_role]
    if not feet:
        return none
    place, zero = skeleton.world[0], skeleton.at_zero
    stands = np.median(place[:, root] - place[:, feet].mean(axis=1), axis=0)
    rest = zero[root] - zero[feet].mean(axis=0)
    return carried[0] if stands @ quat.rotated(carried[0], rest) > stands @ rest + STILL else none
