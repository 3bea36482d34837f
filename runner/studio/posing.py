"""The pose that follows a drag: of a hand, a foot, the head, the pelvis, or any other point of the figure.

A limb that reaches goes alone. One that does not takes the whole figure along, but for the soles that stand.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.penalty.joints.bend import BendLimits
from dynsplines.solver.posing import Goal, PointGoal, Posed, chain, entries, limb, pulled
from dynsplines.solver.surface import Surface, static_surfaces
from dynsplines.solver.surface.points import Point

from ..clip.constraints import chosen, posing_bends
from ..clip.posing.feet import sole_points
from ..clip.posing.places import Places
from ..clip.table import PenaltyTable
from ..clip.text import rotation
from ..errors import UserError, unknown

STANDS = 0.03  # [m] over what it may stand on from which on a sole does not stand
SHORT = 0.002  # [m] by which a limb that does not reach misses
MOVED = 1e-5  # [rad, m] by which a joint differs that was moved
DIGITS = 3  # after the point, of degrees: 2e-5 rad; places have two more


@dataclass(frozen=True)
class Grip:
    """What has been taken hold of: a point of a body, offset (3,) [m] in its axes, in a pose qpos (nq,)."""

    qpos: Array
    body: int
    offset: Array
    limb: Mask
    whole: Mask
    planted: tuple[Goal, ...]


class Poser:
    """Poses of one figure in its scene.

    whole  (K, nq) keyframes that say every joint, by which feet are found
    """

    def __init__(self, figure: Figure, penalties: Sequence[PenaltyTable], whole: Array) -> None:
        self.figure = figure
        self.bends: BendLimits | None = posing_bends(figure, chosen(penalties, "clip"))
        self.soles: tuple[Point, ...] = sole_points(figure, np.reshape(whole, (-1, figure.width)))
        self.surfaces: tuple[Surface, ...] = static_surfaces(figure.model)
        self.data = mujoco.MjData(figure.model)

    @cached_property
    def _sole_goals(self) -> list[PointGoal]:
        return [PointGoal.of(self.figure, point) for point in self.soles]

    def gripped(self, qpos: Array, body: int, offset: ArrayLike, *, plant: bool = True, alone: bool = False) -> Grip:
        """A point taken hold of; plant: whether soles that stand stay where they are; alone: its limb and no more."""
        figure, width = self.figure, self.figure.width
        own_limb = np.zeros(width, bool)
        links = limb(figure, body)
        for link in links:
            own_limb[entries(figure, link)] = figure.links[link].kind is not JointKind.FREE
        own, whole = set(links), np.zeros(width, bool)
        root = chain(figure, body)[-1:] or [0]
        for link in range(1, len(figure.links)):
            if figure.tables.path[link, root[0]]:
                whole[entries(figure, link)] = True
        if alone and own_limb.any():
            whole = own_limb
        self._place(qpos)
        planted: list[Goal] = []
        for point, goal in zip(self.soles, self._sole_goals, strict=True):
            place = goal.place(self.data)
            stands = self._height(place) - point.radius < STANDS
            if plant and stands and point.link not in own:
                planted.append(PointGoal(goal.name, goal.index, goal.offset, place))
        return Grip(np.array(qpos, float), body, np.array(offset, float), own_limb, whole, tuple(planted))

    def pulled(self, grip: Grip, position: ArrayLike, begin: Array) -> Posed:
        """The pose with the point at a place (3,) [m], or as near to it as it comes; begin (nq,), the last one."""
        goal = PointGoal("hand", grip.body, grip.offset, np.array(position, float))
        found: Posed | None = None
        if grip.limb.any():
            alone = np.where(grip.limb, begin, grip.qpos)
            found = pulled(self.figure, grip.qpos, grip.limb, [goal], self.bends, begin=alone)
            if found.worst <= SHORT:
                return found
        return pulled(self.figure, grip.qpos, grip.whole, [goal, *grip.planted], self.bends, begin=begin)

    def turned(self, qpos: Array, joint: str, turn: ArrayLike) -> Array:
        """(nq,) a pose with one joint turned on by a rotation in the world (4,) wxyz; a hinge by its share of it."""
        link = next((link for link in self.figure.links[1:] if link.name == joint), None)
        if link is None:
            raise UserError(unknown("joint", joint, [each.name for each in self.figure.links[1:]]))
        moved = quat.normalised(np.array(turn, float))
        out = np.array(qpos, float)
        self._place(qpos)
        if link.kind in (JointKind.HINGE, JointKind.SLIDE):
            about = quat.rotation_vector(moved)
            mujoco.mj_comPos(self.figure.model, self.data)
            value = out[link.qpos] + float(self.data.xaxis[link.joint] @ about)
            if self.figure.model.jnt_limited[link.joint]:
                value = float(np.clip(value, *self.figure.model.jnt_range[link.joint]))
            out[link.qpos] = value
            return out
        start = link.qpos + (3 if link.kind is JointKind.FREE else 0)
        own = out[start : start + 4]
        base = quat.product(self.data.xquat[link.body], quat.inverse(own))
        there = quat.product(quat.product(quat.inverse(base), moved), quat.product(base, own))
        out[start : start + 4] = quat.normalised(there)
        return out

    def said(self, qpos: Array, home: Array | None = None) -> dict[str, Any]:
        """What a keyframe has to say for a pose: of all joints, or of those not as at home.

        {"joints"}, and {"root"} and {"roots"} where there is something to say of the first free body and of others
        """
        joints: dict[str, Any] = {}
        root: dict[str, Any] = {}
        roots: dict[str, Any] = {}
        for index, link in enumerate(self.figure.links[1:], start=1):
            own = entries(self.figure, index)
            if home is not None and np.abs(qpos[own] - home[own]).max() < MOVED:
                continue
            if link.kind is JointKind.FREE:
                place = [round(float(x), DIGITS + 2) for x in qpos[own][:3]]
                told = {"position": place, "rotation": _short(qpos[own][3:])}
                if link.name == self.root:
                    root = told
                else:
                    roots[link.name] = told
            elif link.kind is JointKind.BALL:
                joints[link.name] = _short(qpos[own])
            else:
                value = float(qpos[link.qpos])
                joints[link.name] = round(np.degrees(value) if link.kind is JointKind.HINGE else value, DIGITS + 1)
        return {"joints": joints, **({"root": root} if root else {}), **({"roots": roots} if roots else {})}

    @cached_property
    def root(self) -> str | None:
        """The free joint that keyframes call the root; None if there is none, or if it is ambiguous."""
        root = self.figure.root
        if root is None or not root.is_free or root.is_ambiguous:
            return None
        return self.figure.links[root.link].name

    def among(self, said: dict[str, Any], names: Collection[str]) -> dict[str, Any]:
        """What is said of some joints, by name, those of free bodies among them."""
        kept = {group: {k: v for k, v in said.get(group, {}).items() if k in names} for group in ("joints", "roots")}
        root = {"root": said["root"]} if self.root in names and "root" in said else {}
        return {"joints": kept["joints"], **root, **({"roots": kept["roots"]} if kept["roots"] else {})}

    def ways(self, place: str) -> tuple[set[str], set[str]]:
        """The joints that decide where a place is, of all and of its own limb; none of one that is not known."""
        body = self._places.body(place)
        found = ([], []) if body is None else (chain(self.figure, body), limb(self.figure, body))
        whole, own = ({self.figure.links[link].name for link in links} for links in found)
        return whole, own

    @cached_property
    def _places(self) -> Places:
        return Places(self.figure, self.soles)

    def limb_names(self, body: int) -> set[str]:
        """Names of all that lies on the limb of a body: sites, soles, bodies, joints."""
        model, links = self.figure.model, set(limb(self.figure, body))
        bodies = {b for b in range(model.nbody) if int(self.figure.body_link[b]) in links}
        names = {str(model.site(i).name) for i in range(model.nsite) if int(model.site_bodyid[i]) in bodies}
        names |= {str(model.body(b).name) for b in bodies} | {self.figure.links[i].name for i in links}
        names |= {str(model.geom(i).name) for i in range(model.ngeom) if int(model.geom_bodyid[i]) in bodies}
        return names | {point.name for point in self.soles if point.link in links}

    def _place(self, qpos: Array) -> None:
        self.data.qpos[:] = qpos
        mujoco.mj_kinematics(self.figure.model, self.data)

    def _height(self, place: Array) -> float:
        """[m] of a place over what lies under it."""
        heights = [float(np.ravel(surface.height(place.reshape(3, 1)))[0]) for surface in self.surfaces]
        return min(heights, default=np.inf)


def _short(quaternion: Array) -> dict[str, list[float]]:
    return {"rotvec": [round(x, DIGITS) + 0.0 for x in rotation(quaternion).rotvec or ()]}
