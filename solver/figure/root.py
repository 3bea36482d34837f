"""The root of a figure: the joints by which its articulated tree moves in the world, wherever a model lists it.

A tree moves on a free joint, or on slides and hinges in any order (`rootx`, `rootz`, `rooty`; `pelvis_tx` ...), of one
body or of several light ones in series. If there are several such trees, the root carries the one with legs: limbs of
at least two joints that end lowest. Other objects, such as a box or a cart, have no legs. Among several trees with
legs, the root carries the one with clearly the most joints. If there is none, the root is ambiguous, and `rivals` lists
the others.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from ..array import Array, Index, Mask
from .forward import boxes, kinematics

FREE, SLIDE = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_SLIDE)
LIGHT = 0.05  # [1] maximum mass of a body between the world and the root's body, relative to the tree's mass
EVIDENT = 2.0  # [1] ratio of joint counts above which a tree has clearly the most joints
LEG = 2  # minimum number of joints in a leg
LOW = 0.15  # [1] maximum height of a leg's end above the tree's lowest point, relative to the tree's height


@dataclass(frozen=True)
class Root:
    """The joints that carry one tree of bodies.

    Attributes:
        joints: MuJoCo's ids from the world on: a free joint alone, or slides, hinges and balls.
        body: MuJoCo's id of the body that they move.
        is_free: Whether it is a free joint.
        limbs: The number of other joints of the tree; 0 for a rigid object.
        rivals: Root bodies of other trees that are equally plausible. The root is then the first in the model.
    """

    joints: tuple[int, ...]
    body: int
    is_free: bool
    limbs: int = 0
    rivals: tuple[int, ...] = ()

    @property
    def is_ambiguous(self) -> bool:
        """Whether other articulated trees are equally plausible; among rigid objects the first is the root."""
        return bool(self.rivals and self.limbs)

    @property
    def links(self) -> tuple[int, ...]:
        """The indices of the joints' links in a `Figure`, from the world on."""
        return tuple(joint + 1 for joint in self.joints)

    @property
    def link(self) -> int:
        return self.joints[-1] + 1


def root_of(model: mujoco.MjModel) -> Root | None:
    """Return the root of a model's articulated tree; None if no tree moves in the world."""
    moving = _moving(model)
    best = [tree for tree in moving if tree.limbs.size] or [tree for tree in moving if tree.root.is_free] or moving
    if not best:
        return None
    if len(best) > 1:
        best = _evident([tree for tree in best if tree.has_legs] or best)
    return replace(best[0].root, rivals=tuple(tree.root.body for tree in best[1:]))


def roots_of(model: mujoco.MjModel) -> list[Root]:
    """Return the roots of all trees that move in the world, in the model's order."""
    return [tree.root for tree in _moving(model)]


def has_fixed_base(model: mujoco.MjModel) -> bool:
    """Return whether only rigid objects move about, and other bodies turn on a fixed base, like an arm."""
    roots = roots_of(model)
    return not any(root.limbs for root in roots) and sum(len(root.joints) for root in roots) < model.njnt


def _moving(model: mujoco.MjModel) -> list[_Tree]:
    """Return the mobile trees, without rigid objects on slides (a drawer) if there are articulated trees."""
    trees = [_Tree(model, joint) for joint in _first_joints(model)]
    has_limbs = any(tree.limbs.size for tree in trees)
    return [tree for tree in trees if tree.moves_about and (tree.root.is_free or tree.limbs.size or not has_limbs)]


def _evident(trees: list[_Tree]) -> list[_Tree]:
    """Return the tree with clearly the most joints, or else all trees with nearly as many."""
    counts = np.array([tree.limbs.size for tree in trees])
    near = (counts * EVIDENT > counts.max()) | (counts == counts.max())
    return [trees[i] for i in np.flatnonzero(near)]


def _first_joints(model: mujoco.MjModel) -> Iterator[int]:
    for body in range(1, model.nbody):
        above = int(model.body_parentid[body])
        if model.body_jntnum[body] and model.body_weldid[above] == 0:
            yield int(model.body_jntadr[body])


class _Tree:
    """The bodies below one joint of the world."""

    def __init__(self, model: mujoco.MjModel, joint: int) -> None:
        self.model = model
        top = int(model.jnt_bodyid[joint])
        self.bodies: Mask = subtree(model, top)
        root = self._root(top)
        is_limb = self.bodies[model.jnt_bodyid]
        is_limb[list(root.joints)] = False
        self.limbs: Index = np.flatnonzero(is_limb)
        self.root = replace(root, limbs=self.limbs.size)

    @property
    def moves_about(self) -> bool:
        """Whether its root translates it. A door, or an arm on a base, only turns in place."""
        return bool(np.isin(self.model.jnt_type[list(self.root.joints)], (FREE, SLIDE)).any())

    def _root(self, top: int) -> Root:
        model, joints, body = self.model, list[int](), top
        while True:
            first = int(model.body_jntadr[body])
            joints += range(first, first + int(model.body_jntnum[body]))
            if model.jnt_type[first] == FREE:
                return Root(tuple(joints), body, True)
            onward = self._onward(body)
            if onward is None:
                return Root(tuple(joints), body, False)
            body = onward

    def _onward(self, body: int) -> int | None:
        """Return the only child of a light body without collision geoms; None for any other body."""
        model = self.model
        rigid = np.flatnonzero(model.body_weldid == body)
        hanging = [
            child for child in np.flatnonzero(np.isin(model.body_parentid, rigid)).tolist() if model.body_jntnum[child]
        ]
        solid = (model.geom_contype | model.geom_conaffinity) > 0
        is_light = model.body_mass[rigid].sum() <= LIGHT * model.body_mass[self.bodies].sum()
        if len(hanging) != 1 or not is_light or np.isin(model.geom_bodyid[solid], rigid).any():
            return None
        return int(hanging[0])

    @property
    def has_legs(self) -> bool:
        """Whether limbs of two joints or more end lowest in the default pose, below the body that carries them."""
        model = self.model
        low, high = _heights(model)
        bottoms = low[self.bodies]
        height = float(high[self.bodies].max() - bottoms.min())
        if not np.isfinite(height):
            return False
        ground = float(bottoms.min()) + LOW * height
        if low[model.body_weldid == self.root.body].min() <= ground:
            return False
        return any(low[end] <= ground and self._joints_to(end) >= LEG for end in np.flatnonzero(self.bodies).tolist())

    def _joints_to(self, body: int) -> int:
        """The number of limb joints between the root and a body."""
        count, model = 0, self.model
        while body:
            first = int(model.body_jntadr[body])
            count += int(np.isin(self.limbs, range(first, first + int(model.body_jntnum[body]))).sum())
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
