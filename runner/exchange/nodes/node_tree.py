"""A skeleton from nodes placed in the world, as in glTF and USD.

Joints of BVH have rotations relative to a pose without rotations, whereas nodes are rotated at rest, too. So a joint's
rotation is that of its node relative to the rest pose, which becomes the skeleton's zero pose.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ..skeleton import bvh_file
from ..skeleton.bvh_file import Joint, Skeleton, fps_of


@dataclass(frozen=True)
class Nodes:
    """Nodes of one tree, parents first.

    names     J names
    parents   J indices, -1 for the top
    rest      (J, 4, 4) matrices to the world in the pose to which the mesh is bound
    moving    (T, J, 4, 4) matrices to the world, at equal time steps
    fps       [1/s]
    notes     on what was chosen in the file
    """

    names: Sequence[str]
    parents: Sequence[int]
    rest: Array
    moving: Array
    fps: float
    notes: tuple[str, ...] = ()

    def skeleton(self) -> Skeleton:
        """Return the nodes as joints of a BVH file, with channels of positions and of rotations from the rest pose."""
        turn = quat.product(rotations(self.moving), quat.conjugate(rotations(self.rest)))
        place, offset = self.moving[..., :3, 3].copy(), self.rest[:, :3, 3].copy()
        relative = turn.copy()
        for i, parent in enumerate(self.parents):
            if parent >= 0:
                above = quat.conjugate(turn[:, parent])
                place[:, i] = quat.rotated(above, place[:, i] - self.moving[:, parent, :3, 3])
                relative[:, i] = quat.product(above, turn[:, i])
                offset[i] -= self.rest[parent, :3, 3]
        joints = [Joint(*row) for row in zip(self.names, self.parents, offset, strict=True)]
        return replace(bvh_file.skeleton(joints, place, relative, self.fps), notes=self.notes)


def rotations(matrices: Array) -> Array:
    """Return quaternions wxyz (..., 4) of matrices (..., 4, 4) of any scale, sign-continuous along the first axis."""
    turns = matrices[..., :3, :3]
    turns = turns / np.maximum(np.linalg.norm(turns, axis=-2, keepdims=True), np.finfo(float).tiny)
    turns = turns * np.sign(np.linalg.det(turns))[..., None, None]  # undoes a mirroring scale
    q = Rotation.from_matrix(turns.reshape(-1, 3, 3)).as_quat(scalar_first=True).reshape(*matrices.shape[:-2], 4)
    return quat.aligned(q) if q.ndim == 3 else q


def float32_step(times: Array) -> float:
    """Return the resolution [s] of times that were stored as float32, at the largest of them."""
    return float(np.spacing(np.float32(np.abs(times).max())))


def rate_of(times: Array) -> float:
    """Return the rate [1/s] of rising times [s], by their median step, or by their mean step if the two differ only by
    the rounding of float32."""
    if times.size < 2:
        return 30.0
    median, mean = float(np.median(np.diff(times))), float(times[-1] - times[0]) / (times.size - 1)
    return fps_of(mean if abs(mean - median) <= float32_step(times) else median, 6)


def moving_tree(parents: Sequence[int], is_animated: Iterable[bool]) -> tuple[list[int], list[int]]:
    """Return the nodes of the tree with the most animated ones, parents first, without branches in which nothing moves.

    Nodes below an animated one are included, such as a toe or fingertip; a static branch such as a floor is not. Also
    return the parents among these nodes, -1 for the top.
    """
    animated, count = list(is_animated), len(parents)
    top = list[int]()
    for i, parent in enumerate(parents):
        top.append(i if parent < 0 else top[parent])
    votes = [sum(animated[i] for i in range(count) if top[i] == t) for t in range(count)]
    chosen = int(np.argmax(votes)) if count else -1
    carried, carries = list(animated), list(animated)
    for i in range(count):
        carried[i] = carried[i] or (parents[i] >= 0 and carried[parents[i]])
    for i in reversed(range(count)):
        if carries[i] and parents[i] >= 0:
            carries[parents[i]] = True
    nodes = [i for i in range(count) if top[i] == chosen and (carried[i] or carries[i])]
    place = {node: k for k, node in enumerate(nodes)}
    return nodes, [place.get(parents[node], -1) for node in nodes]
