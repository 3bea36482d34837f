"""The pose that follows a drag of any point of the figure, such as a hand, a foot, the head or the pelvis.

A limb that reaches the target moves alone. Otherwise the whole figure follows, with its soles on the ground and its
centre of mass above the feet.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike
from pydantic import ValidationError

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.model import set_qpos
from dynsplines.solver.penalty.joints.bend import BendLimits
from dynsplines.solver.posing import (
    BodyGoal,
    FloorClearance,
    PointGoal,
    Posed,
    SupportPolygon,
    drag_pose,
)
from dynsplines.solver.surface import static_surfaces
from dynsplines.solver.surface.points import Point
from dynsplines.solver.tolerances import ROUNDING

from ..clip.kinds import posing_limits
from ..clip.parse import options_of
from ..clip.pose import key_of
from ..clip.posing.places import Places, sole_points
from ..clip.table import KeyframeTable, PenaltyTable
from ..clip.table_errors import describe
from ..clip.text import TomlTable, keyframe_tables, tables
from ..errors import UserError, unknown
from .footing import Footing, Spheres

END_RANGE = 0.78  # [1] share of their ranges that ankles and wrists use
LIFTED = 0.02  # [m] distance of a pulled knee from its target beyond which its foot leaves the ground
LEVEL_WEIGHT = 2.0  # [1] weight of a lifted foot's rotation, relative to that of a joint
BALANCED = 0.01  # [m] tolerance of the centre of mass beyond the support polygon, before a drag
BALANCE_KEPT = 0.005  # [m] tolerance of the centre of mass after a drag
LANDINGS = 2  # number of solves while a foot lands
CLEAR = 0.035  # [m] minimum height of a foot in the air
STANDING = 0.03  # [m] height below which a sole is on the ground
SHORT = 0.002  # [m] distance above which a limb does not reach its target
MOVED = 1e-5  # [rad, m] difference above which a joint was moved
PLACES = {"rotvec": 3, "position": 5}  # decimal places of entries: degrees (2e-5 rad) and metres


@dataclass(frozen=True)
class Grip:
    """A grabbed point of a body in a pose.

    Attributes:
        qpos: The pose, (nq,).
        body: MuJoCo's id of the body.
        offset: The point in the body's axes, (3,) [m].
        limb: The entries of its limb, (nq,).
        is_whole_figure: The entries that may move, (nq,).
        standing: The feet on the ground.
        hanging: The feet of the grabbed limb.
        locked: MuJoCo's ids of bodies that stay where they are.
        is_balanced: Whether the centre of mass is above the feet.
        limits: The floor.
    """

    qpos: Array
    body: int
    offset: Array
    limb: Mask
    is_whole_figure: Mask
    standing: tuple[Spheres, ...]
    hanging: tuple[Spheres, ...]
    locked: tuple[int, ...]
    is_balanced: bool
    limits: tuple[FloorClearance, ...]


class Poser:
    """Poses of one figure in its scene; feet are inferred from complete keyframes `full_keyframes` (K, nq)."""

    def __init__(self, figure: Figure, penalties: Sequence[PenaltyTable], full_keyframes: Array) -> None:
        self.figure = figure
        self.bends: BendLimits | None = posing_limits(figure, options_of(penalties, "clip"))
        self.soles: tuple[Point, ...] = sole_points(figure, np.reshape(full_keyframes, (-1, figure.width)))
        self.footing = Footing(figure, self.soles, static_surfaces(figure.model))
        self.data = mujoco.MjData(figure.model)

    @cached_property
    def _range_shares(self) -> dict[int, float]:
        """The shares of their ranges that ankles and wrists may use, by link."""
        knees = set() if self.bends is None else {joint.link for joint in self.bends.joints}
        return dict.fromkeys(self.footing.end_joints - knees, END_RANGE)

    def grip(
        self,
        qpos: Array,
        body: int,
        offset: ArrayLike,
        *,
        plant: bool = True,
        alone: bool = False,
        locked: Collection[int] = (),
    ) -> Grip:
        """Return the grip of a point. Raises UserError for a point of a locked body.

        With `plant`, feet, floor and balance constrain the pose. With `alone`, only the limb of the point may move.
        """
        figure = self.figure
        if body in locked:
            raise UserError(f"'{figure.model.body(body).name}': locked; unlock it to drag it")
        links, root = figure.limb(body), (figure.chain(body)[-1:] or [0])[0]
        limb_mask, whole = np.zeros(figure.width, bool), np.zeros(figure.width, bool)
        for link in links:
            limb_mask[figure.links[link].columns] = figure.links[link].kind is not JointKind.FREE
        for i, link in enumerate(figure.links[1:], 1):
            whole[link.columns] = bool(figure.tables.path[i, root])
        if alone and limb_mask.any():
            whole = limb_mask
        set_qpos(self.figure.model, self.data, qpos)
        standing, hanging = list[Spheres](), list[Spheres]()
        for link in dict.fromkeys(point.link for point in self.soles) if plant else ():
            is_locked = figure.links[link].body in locked
            if limb_mask.any() and figure.tables.path[link, links[-1]] and not is_locked:
                hanging.append(self.footing.spheres[link].lowest(self.footing.rest))
            elif self._stands(link):
                standing.append(self.footing.spheres[link].lowest(self.data))
        floor = self.footing.floor(root, self.data) if plant else None
        grip = Grip(
            np.array(qpos, float), body, np.array(offset, float), limb_mask, whole, tuple(standing),
            tuple(hanging), tuple(locked), False, () if floor is None else (floor,),
        )  # fmt: skip
        support = self._support(grip, hanging)
        can_balance = support is not None and bool(whole[figure.links[root].columns].all())
        return replace(grip, is_balanced=can_balance and support.excess(self.data) < BALANCED)

    def _stands(self, link: int) -> bool:
        """Return whether a sole point of a link is on the ground."""
        points = [point for point in self.soles if point.link == link]
        positions = np.array([PointGoal.of(self.figure, point).places(self.data)[0] for point in points]).reshape(-1, 3)
        radii = np.array([point.radius for point in points])
        return bool((self.footing.heights(positions, radii) < STANDING).any())

    def _support(self, grip: Grip, hanging: Sequence[Spheres]) -> SupportPolygon | None:
        """Return the support polygon of the standing feet in the grip's pose and the limb's feet in the present one."""
        here = self.data.qpos.copy()
        points = [foot.centres(self.data) for foot in hanging]
        set_qpos(self.figure.model, self.data, grip.qpos)
        points += [foot.centres(self.data) for foot in grip.standing]
        set_qpos(self.figure.model, self.data, here)
        root = self.figure.links[(self.figure.chain(grip.body)[-1:] or [0])[0]].body
        return SupportPolygon.of(root, np.concatenate(points)) if points else None

    def pull(self, grip: Grip, position: ArrayLike, begin: Array) -> Posed:
        """Return the pose with the point at a position (3,) [m], or as near as possible, from the last pose (nq,).

        A limb that reaches moves alone. A foot that comes near the ground lands on it. A knee or thigh moves with its
        foot fixed as long as that is possible.
        """
        place = np.array(position, float)
        target = PointGoal("target", grip.body, grip.offset[None], place[None])
        has_foot = bool(grip.hanging) and grip.is_balanced
        if grip.limb.any() and not has_foot and self._is_within_reach(grip, place):
            pose = self._drag(grip, target, np.where(grip.limb, begin, grip.qpos), free=grip.limb)
            if pose.worst <= SHORT and self._keeps_balance(grip, pose):
                return pose
        feet = tuple(foot for foot in grip.hanging if foot.body == grip.body)
        if has_foot and not feet:
            pose = self._drag(grip, target, begin, fixed=grip.hanging)
            if pose.missed[0] <= LIFTED and self._keeps_balance(grip, pose):
                return pose
        if feet and has_foot:
            set_qpos(self.figure.model, self.data, begin)
            by = place - self._point(grip, self.data)
            landing = tuple(foot for foot in feet if self._lands(grip, foot, by))
            return self._drag(grip, target, begin, landing=landing, by=by)
        pose = self._drag(grip, target, begin)
        for _ in range(LANDINGS if grip.hanging else 0):  # the support polygon moves with the sliding foot
            set_qpos(self.figure.model, self.data, pose.qpos)
            low = tuple(foot for foot in grip.hanging if self.footing.clearance(foot, self.data) < STANDING)
            pose = self._drag(grip, target, pose.qpos, landing=low) if low else pose
        return pose

    def _drag(
        self,
        grip: Grip,
        target: PointGoal,
        begin: Array,
        *,
        free: Mask | None = None,
        fixed: Sequence[Spheres] = (),
        landing: Sequence[Spheres] = (),
        by: ArrayLike = (0, 0, 0),
    ) -> Posed:
        """Return the pose of a drag, with feet of the grabbed limb fixed, aloft, or landing after a move (3,) [m]."""
        footing = self.footing
        set_qpos(self.figure.model, self.data, grip.qpos)
        goals = [footing.fix(foot, self.data) for foot in (*grip.standing, *fixed)]
        goals += [footing.lock(body, self.data) for body in grip.locked]
        aloft = [foot for foot in grip.hanging if foot not in fixed and foot not in landing]
        level = [(LEVEL_WEIGHT, BodyGoal("foot", self.data.xquat[foot.body].copy(), foot.body)) for foot in aloft]
        set_qpos(self.figure.model, self.data, begin)
        goals += [footing.land(foot, self.data, by) for foot in landing]
        support = self._support(grip, (*fixed, *landing)) if grip.is_balanced else None
        limits = grip.limits if support is None else (*grip.limits, support)
        if support is not None and any(foot.body == grip.body for foot in aloft):
            limits += tuple(foot.above(floor, CLEAR) for foot in aloft for floor in grip.limits)
        may_restart = free is None and not fixed and not landing
        return drag_pose(
            self.figure, grip.qpos, grip.is_whole_figure if free is None else free, target, self.bends, begin=begin,
            fixed=goals, limits=limits, preferred=level, limb=grip.limb if may_restart else None,
            range_shares=self._range_shares,
        )  # fmt: skip

    def _keeps_balance(self, grip: Grip, pose: Posed) -> bool:
        set_qpos(self.figure.model, self.data, pose.qpos)
        support = self._support(grip, grip.hanging) if grip.is_balanced else None
        return support is None or support.excess(self.data) < BALANCE_KEPT

    def _is_within_reach(self, grip: Grip, position: Array) -> bool:
        """Return whether the straightened limb is long enough for a position (3,) [m]."""
        set_qpos(self.figure.model, self.data, grip.qpos)
        joints = [self.figure.links[link].joint for link in self.figure.limb(grip.body)]
        path = np.array([self._point(grip, self.data), *self.data.xanchor[joints]])
        length = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
        return float(np.linalg.norm(position - path[-1])) < length + SHORT

    def _lands(self, grip: Grip, foot: Spheres, by: Array) -> bool:
        """Return whether a foot, if level, is on or close to the ground after it has moved by (3,) [m]."""
        rest = self.footing.rest
        bottom = float((foot.centres(rest)[:, 2] - foot.radii).min()) - self._point(grip, rest)[2]
        level = float(self.footing.levels(foot, self.data, by).max())
        return self._point(grip, self.data)[2] + by[2] + bottom - level < STANDING

    @staticmethod
    def _point(grip: Grip, data: mujoco.MjData) -> Array:
        return np.array(data.xpos[grip.body] + data.xmat[grip.body].reshape(3, 3) @ grip.offset)

    def keep(self, before: Array, after: Array, locked: Collection[int], *, plant: bool = True) -> Array:
        """Return a pose (nq,) like `after` in which locked bodies are where they were before.

        Joints that differ from `before` remain. Limbs and root move instead. With `plant`, feet that stood on the
        ground stay, too, but move along if the legs cannot reach. Raises UserError if a locked body cannot stay.
        """
        figure, footing = self.figure, self.footing
        set_qpos(figure.model, self.data, before)
        locks = [footing.lock(body, self.data) for body in locked]
        links = [link for link in dict.fromkeys(point.link for point in self.soles) if plant and self._stands(link)]
        feet = [footing.fix(footing.spheres[link].lowest(self.data), self.data) for link in links]
        feet = [foot for foot in feet if foot.index not in locked]
        for goals in ([*locks, *feet], locks):
            free = np.zeros(figure.width, bool)
            for link in {link for goal in goals for link in (*figure.limb(goal.index), *figure.chain(goal.index)[-1:])}:
                columns = figure.links[link].columns
                free[columns] = np.abs(after - before)[columns].max() < MOVED
            if not goals:
                return after
            posed = drag_pose(
                figure, after, free, goals[0], self.bends, begin=after, fixed=goals[1:],
                range_shares=self._range_shares,
            )  # fmt: skip
            if posed.worst <= SHORT:
                return posed.qpos
        names = " and ".join(f"'{figure.model.body(body).name}'" for body in locked)
        raise UserError(f"{names}: locked, and cannot stay in place; unlock it, or change less")

    def with_entries(self, qpos: Array, entries: Mapping[str, Any], where: str = "the keyframe") -> tuple[Array, Mask]:
        """Return a pose (nq,) with the values in entries of a keyframe, and which they are. Raises UserError."""
        try:
            row = KeyframeTable.model_validate({"time": 0.0, **entries})
        except ValidationError as error:
            raise UserError(f"{where}: {describe(error, entries, KeyframeTable)}") from None
        key = key_of(self.figure, row, None, (), where)
        return np.where(key.fixed, key.state, qpos), key.fixed

    def place(self, qpos: Array, home: Array) -> Array:
        """Return a pose (nq,) with the root at the horizontal position and heading of another one (nq,).

        A pose whose feet are inside of what the other one stands on is put on top of it.
        """
        if self.figure.root is None:
            return qpos
        set_qpos(self.figure.model, self.data, home)
        aloft = self.data.xpos[:, 2].copy()
        start, out = self.figure.links[self.figure.root.link].qpos, np.array(qpos)
        turned = slice(start + 3, start + 7)
        before, after = _heading(quat.matrices(np.stack([qpos[turned], home[turned]])))
        turn = quat.from_rotation_vector([0.0, 0.0, after - before])
        out[start : start + 2], out[turned] = home[start : start + 2], quat.product(turn, qpos[turned])
        set_qpos(self.figure.model, self.data, out)
        depths = [0.0]
        for foot in (self.footing.spheres[link] for link in dict.fromkeys(point.link for point in self.soles)):
            rise = max(0.0, aloft[foot.body] - self.data.xpos[foot.body, 2])
            bottom = float((foot.centres(self.data)[:, 2] - foot.radii).min())
            depths.append(float(self.footing.levels(foot, self.data, (0, 0, rise)).max()) - bottom)
        out[start + 2] += max(depths) if max(depths) > STANDING else 0.0
        return out

    def turn(self, qpos: Array, joint: str, turn: ArrayLike) -> Array:
        """Return a pose (nq,) with one joint rotated by a quaternion in the world (4,); a hinge by its component."""
        link = next((link for link in self.figure.links[1:] if link.name == joint), None)
        if link is None:
            raise UserError(unknown("joint", joint, [each.name for each in self.figure.links[1:]]))
        moved = quat.normalise(np.array(turn, float))
        out = np.array(qpos, float)
        set_qpos(self.figure.model, self.data, qpos)
        if link.kind in (JointKind.HINGE, JointKind.SLIDE):
            about = quat.rotation_vector(moved)
            value = out[link.qpos] + float(self.data.xaxis[link.joint] @ about)
            if self.figure.model.jnt_limited[link.joint]:
                value = float(np.clip(value, *self.figure.model.jnt_range[link.joint]))
            out[link.qpos] = value
            return out
        start = link.qpos + (3 if link.kind is JointKind.FREE else 0)
        quaternion = out[start : start + 4]
        base = quat.product(self.data.xquat[link.body], quat.inverse(quaternion))
        there = quat.product(quat.product(quat.inverse(base), moved), quat.product(base, quaternion))
        out[start : start + 4] = quat.normalise(there)
        return out

    def keyframe_entries(self, qpos: Array, home: Array | None = None) -> TomlTable:
        """Return the entries of a keyframe for a pose: of all joints, or of those that differ from `home`.

        The keys are "joints", and "root" and "roots" if there are entries of the root and of other free bodies.
        """
        is_moved = np.ones(self.figure.width, bool)
        if home is not None:
            for link in self.figure.links[1:]:
                is_moved[link.columns] = np.abs(qpos - home)[link.columns].max() >= MOVED
        row = tables(keyframe_tables(self.figure, [Frame.key(0.0, qpos, is_moved)])[0])
        return {"joints": {}} | {key: _round(value) for key, value in row.items() if key != "time"}

    @cached_property
    def root(self) -> str | None:
        """The free joint that is the root of keyframes; None if there is none, or if it is ambiguous."""
        root = self.figure.root
        if root is None or root.is_ambiguous:
            return None
        return self.figure.links[root.link].name

    def select_joints(self, entries: TomlTable, names: Collection[str]) -> TomlTable:
        out: TomlTable = {"joints": {name: value for name, value in entries["joints"].items() if name in names}}
        if self.root in names and "root" in entries:
            out["root"] = entries["root"]
        if roots := {name: body for name, body in entries.get("roots", {}).items() if name in names}:
            out["roots"] = roots
        return out

    def deciding_joints(self, place: str) -> tuple[set[str], set[str]]:
        """Return the joints that determine a point's position: all, and those of its limb; none for unknown points."""
        body = self._places.body(place)
        links_of = ([], []) if body is None else (self.figure.chain(body), self.figure.limb(body))
        whole, limb_names = ({self.figure.links[link].name for link in links} for links in links_of)
        return whole, limb_names

    @cached_property
    def _places(self) -> Places:
        return Places(self.figure, self.soles)

    def limb_names(self, body: int) -> set[str]:
        """Return the names of the sites, soles, bodies and joints of a body's limb."""
        model, links = self.figure.model, set(self.figure.limb(body))
        bodies = {b for b in range(model.nbody) if int(self.figure.body_link[b]) in links}
        names = {str(model.site(i).name) for i in range(model.nsite) if int(model.site_bodyid[i]) in bodies}
        names |= {str(model.body(b).name) for b in bodies} | {self.figure.links[i].name for i in links}
        names |= {str(model.geom(i).name) for i in range(model.ngeom) if int(model.geom_bodyid[i]) in bodies}
        return names | {point.name for point in self.soles if point.link in links}


def _round(value: Any, digits: int = 4) -> Any:
    """Return entries with rounded numbers, by default the angles of hinges [degrees] and slides [m]."""
    if isinstance(value, dict):
        return {key: _round(entry, PLACES.get(key, digits)) for key, entry in value.items()}
    return [_round(entry, digits) for entry in value] if isinstance(value, tuple) else round(value, digits) + 0.0


def _heading(rotation: Array) -> Array:
    """Return the rotation about z in rotation matrices (..., 3, 3), without their shortest tilt, (...) [rad]."""
    sine, cosine = rotation[..., 1, 0] - rotation[..., 0, 1], rotation[..., 0, 0] + rotation[..., 1, 1]
    return np.where(np.hypot(sine, cosine) > ROUNDING, np.arctan2(sine, cosine), 0.0)
