"""The root of a figure: the free joint by which its articulated tree moves in the world, wherever a model lists it.

If there are several such trees, the root carries the one with legs: limbs of at least two joints that end lowest. Other
objects, such as a box or a cart, have no legs. Among several trees with legs, the root carries the one with clearly the
most joints. If there is none, the root is ambiguous, and `rivals` lists the others. Slides and hinges are no root.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import mujoco
import numpy as np

from ..array import Array, Index, Mask
from .model import boxes, kinematics

FREE, SLIDE = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_SLIDE)
EVIDENT = 2.0  # [1] ratio of joint counts above which a tree has clearly the most joints
LEG = 2  # minimum number of joints in a leg
LOW = 0.15  # [1] maximum height of a leg's end above the tree's lowest point, relative to the tree's height


@dataclass(frozen=True)
class Root:
    """The free joint that carries one tree of bodies.

    Attributes:
        joint: MuJoCo's id of the joint.
        body: MuJoCo's id of the body that it moves.
        limbs: The number of other joints of the tree; 0 for a rigid object.
        rivals: Root bodies of other trees that are equally plausible. The root is then the first in the model.
    """

    joint: int
    body: int
    limbs: int
    rivals: tuple[int, ...] = ()

    @property
    def is_ambiguous(self) -> bool:
        """Whether other articulated trees are equally plausible; among rigid objects the first is the root."""
        return bool(self.rivals and self.limbs)

    @property
    def link(self) -> int:
        """The index of the joint's link in a `Figure`."""
        return self.joint + 1


def root_of(model: mujoco.MjModel) -> Root | None:
    """Return the root of a model's articulated tree; None if it moves on slides, or if no tree has a free joint."""
    roots = roots_of(model)
    articulated = [root for root in roots if root.limbs]
    if not roots or (not articulated and sliding_joints(model)):
        return None
    best = articulated or roots
    if len(best) > 1:
        best = _evident([root for root in best if _has_legs(model, root)] or best)
    return replace(best[0], rivals=tuple(root.body for root in best[1:]))


def roots_of(model: mujoco.MjModel) -> list[Root]:
    """Return the roots of all trees with a free joint, in the model's order."""
    roots = []
    for joint in np.flatnonzero(model.jnt_type == FREE).tolist():
        body = int(model.jnt_bodyid[joint])
        roots.append(Root(joint, body, _joints_of(model, body).size - 1))
    return roots


def sliding_joints(model: mujoco.MjModel) -> list[int]:
    """Return MuJoCo's ids of the joints of the bodies by which articulated trees move on slides, such as `rootx`."""
    out: list[int] = []
    for top in _tops(model):
        joints = np.flatnonzero(model.jnt_bodyid == top)
        if (model.jnt_type[joints] == SLIDE).any() and _joints_of(model, top).size > joints.size:
            out += joints.tolist()
    return out


def has_fixed_base(model: mujoco.MjModel) -> bool:
    """Return whether only rigid objects move about, and other bodies turn on a fixed base, like an arm."""
    moves = [bool(np.isin(model.jnt_type[model.jnt_bodyid == top], (FREE, SLIDE)).any()) for top in _tops(model)]
    return not any(root.limbs for root in roots_of(model)) and not sliding_joints(model) and not all(moves)


def _tops(model: mujoco.MjModel) -> list[int]:
    """Return the bodies with joints that are children of the world, or of bodies fixed to it."""
    is_child = model.body_weldid[model.body_parentid] == 0
    return np.flatnonzero((model.body_jntnum > 0) & is_child).tolist()


def _joints_of(model: mujoco.MjModel, top: int) -> Index:
    """Return the joints of a body and of its descendants."""
    return np.flatnonzero(subtree(model, top)[model.jnt_bodyid])


def _evident(roots: list[Root]) -> list[Root]:
    """Return the root of the tree with clearly the most joints, or else of all trees with nearly as many."""
    most = max(root.limbs for root in roots)
    return [root for root in roots if root.limbs * EVIDENT > most or root.limbs == most]


def _has_legs(model: mujoco.MjModel, root: Root) -> bool:
    """Return whether limbs of two joints or more end lowest in the default pose, below the body that carries them."""
    low, high = _heights(model)
    bodies = subtree(model, root.body)
    bottom = float(low[bodies].min())
    height = float(high[bodies].max()) - bottom
    if not np.isfinite(height):
        return False
    ground = bottom + LOW * height
    if low[model.body_weldid == root.body].min() <= ground:
        return False
    ends = np.flatnonzero(bodies & (low <= ground)).tolist()
    return any(_joints_above(model, end) - 1 >= LEG for end in ends)


def _joints_above(model: mujoco.MjModel, body: int) -> int:
    """Return the number of joints of a body and of its ancestors."""
    count = 0
    while body:
        count += int(model.body_jntnum[body])
        body = int(model.body_parentid[body])
    return count


def subtree(model: mujoco.MjModel, top: int) -> Mask:
    """Return which bodies are `top` or its descendants, (nbody,)."""
    out = np.zeros(model.nbody, bool)
    out[top] = True
    for body in range(top + 1, model.nbody):
        out[body] = out[model.body_parentid[body]]
    return out


def _heights(model: mujoco.MjModel) -> tuple[Array, Array]:
    """Return the lowest and highest z of the bounding boxes of every body's geoms in the default pose, (nbody,) [m]."""
    centre, reach = boxes(model, kinematics(model), np.arange(model.ngeom))
    low, high = np.full(model.nbody, np.inf), np.full(model.nbody, -np.inf)
    np.minimum.at(low, model.geom_bodyid, (centre - reach)[:, 2])
    np.maximum.at(high, model.geom_bodyid, (centre + reach)[:, 2])
    return low, high
