"""A captured skeleton in metres, z up, facing x where it stands straight; with its feet and the ground."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import listed
from .. import missing_input
from . import bvh_file
from .bvh_file import Skeleton, placed
from .roles import apply_bone_map, first_hinge, lineage, mapped_roles, roles, unique
from .up_axis import NONE, TO_Z, standing_turn, vertical

REACH = 1.25  # [m] typical distance from an adult's hips along the bones to the fingertips or toes
UNITS = {"metres": 1.0, "centimetres": 0.01, "millimetres": 0.001}
ODD_UNITS = {"inches": 0.0254, "the CMU database's units": 0.0254 / 0.45}
UPRIGHT = 0.8  # least cosine between the vertical and legs and trunk in a pose that counts as standing
LIKELY = (0.55, 3.0)  # [m] plausible reach of a person
STILL = 1e-6  # [1 for quaternions, or the file's unit of length] largest change that counts as no motion
DRIFT = 0.01  # least change of a bone's length that is reported, as a fraction of REACH


@dataclass(frozen=True)
class CapturedSkeleton:
    """Joints, parents first (-1 for the root), at equal time steps.

    offset (J, 3) [m] from the parent in the zero pose, that without rotations; ends {joint: (3,)} [m] of End Sites;
    position (T, J, 3) [m] and rotation (T, J, 4) in the world; notes on what was inferred; bone_map, names by role
    """

    names: list[str]
    parents: list[int]
    offset: Array
    ends: dict[int, Array]
    position: Array
    rotation: Array
    notes: tuple[str, ...] = ()
    bone_map: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        skeleton: Skeleton,
        scale: float | None = None,
        bone_map: Mapping[str, str] | None = None,
    ) -> CapturedSkeleton:
        """Convert from a file's unit and axes; scale [m] its unit, inferred if None; bone_map, names by role."""
        bone_map, notes_of_file = bone_map or {}, skeleton.notes
        skeleton, folded = _from_body_root(skeleton, bone_map)
        place, turn = skeleton.local
        offset = np.where(np.ptp(place, axis=0) > 0, np.median(place, axis=0), place[0])
        ends = {i: joint.end for i, joint in enumerate(skeleton.joints) if joint.end is not None}
        unit, notes = _unit(skeleton.parents, offset, ends, scale)
        notes = (*notes_of_file, *notes, *folded)
        drift = np.abs(place[:, 1:] - offset[1:]).max(axis=(0, 2), initial=0.0)
        stretched = [skeleton.names[1 + i] for i in np.flatnonzero(unit * drift > DRIFT * REACH)]
        if stretched:
            notes += (
                f"bones keep their lengths; what moves in its parent is left out: {listed(stretched, bvh_file.LISTED)}",
            )
        place = place.copy()
        place[:, 1:] = offset[1:]
        offset = np.concatenate([np.zeros((1, 3)), offset[1:]])
        position, rotation = placed(skeleton.parents, place, turn)
        here = cls(
            unique(skeleton.names), skeleton.parents, unit * offset, {i: unit * end for i, end in ends.items()},
            unit * position, rotation, notes, bone_map,
        )  # fmt: skip
        return _placed_upright(here)

    def turned(self, world: Array, rest: Array) -> CapturedSkeleton:
        """Return the skeleton with the world rotated (4,), and the zero pose by another rotation (4,)."""
        back = quat.inverse(rest)
        return replace(
            self,
            offset=quat.rotated(rest, self.offset),
            ends={i: quat.rotated(rest, end) for i, end in self.ends.items()},
            position=quat.rotated(world, self.position),
            rotation=quat.aligned(quat.product(quat.product(world, self.rotation), back)),
        )

    @cached_property
    def roles(self) -> dict[str, int]:
        return mapped_roles(self.names, self.parents, self.bone_map, "recording")

    def start_of(self, role: str) -> int:
        """Return the joint where a part of a limb begins: the first of several for the hinges of a robot's hip."""
        return first_hinge(self.roles[role], self.names, self.parents)

    @cached_property
    def at_zero(self) -> Array:
        """(J, 3) positions of the joints in the zero pose, the root at the origin."""
        place = np.zeros_like(self.offset)
        for i, parent in enumerate(self.parents):
            place[i] = self.offset[i] + (place[parent] if parent >= 0 else 0.0)
        return place

    @cached_property
    def stands(self) -> bool:
        """Whether the zero pose stands upright."""
        place, by_role = self.at_zero, self.roles
        needed = [f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "shin")]
        if any(role not in by_role for role in needed):
            return False
        hips = 0.5 * (place[by_role["left_thigh"]] + place[by_role["right_thigh"]])
        legs = [place[by_role[f"{side}_thigh"]] - place[by_role[f"{side}_shin"]] for side in ("left", "right")]
        top = by_role.get("head", by_role.get("neck"))
        arms = [by_role[f"{side}_upper_arm"] for side in ("left", "right") if f"{side}_upper_arm" in by_role]
        if top is not None or len(arms) == 2:
            legs.append((place[top] if top is not None else place[arms].mean(axis=0)) - hips)
        return min(float(part[2]) / max(float(np.linalg.norm(part)), 1e-12) for part in legs) > UPRIGHT

    def children(self, joint: int) -> list[int]:
        return [i for i, parent in enumerate(self.parents) if parent == joint]

    def tip(self, joint: int) -> tuple[int, Array]:
        """Return the last joint of a limb, along the longest bones from a joint on, and its End Site (3,)."""
        while below := self.children(joint):
            joint = max(below, key=lambda i: float(np.linalg.norm(self.offset[i])))
        return joint, self.ends.get(joint, np.zeros(3))

    def at(self, joint: int, point: Array) -> Array:
        """Return the positions (T, 3) of a joint's point in the world."""
        return self.position[:, joint] + quat.rotated(self.rotation[:, joint], point)

    @cached_property
    def feet(self) -> dict[str, tuple[int, int, Array, int]]:
        """By side: ankle, last joint of the toes, their end (3,) in it, and the sample in which the foot is lowest."""
        out = {}
        for side in ("left", "right"):
            if f"{side}_foot" in self.roles:
                ankle = self.roles[f"{side}_foot"]
                toe, end = self.tip(ankle)
                height = self.position[:, ankle, 2] + self.at(toe, end)[:, 2]
                out[side] = (ankle, toe, end, int(np.argmin(height)))
        return out

    @cached_property
    def ground(self) -> float:
        """The least height [m] of the toes of the lower foot; zero without feet."""
        return min((float(self.at(toe, end)[low, 2]) for _, toe, end, low in self.feet.values()), default=0.0)


def _unit(
    parents: list[int],
    offset: Array,
    ends: dict[int, Array],
    scale: float | None,
) -> tuple[float, tuple[str, ...]]:
    """Return the file's unit [m], by the length of its longest limb from the root, and notes."""
    reach = np.zeros(len(parents))
    for i, parent in enumerate(parents):
        if parent >= 0:
            reach[i] = reach[parent] + np.linalg.norm(offset[i])
    longest = max([*reach, *(reach[i] + np.linalg.norm(end) for i, end in ends.items())])
    if scale is not None:
        return scale, ()
    if longest <= 0:
        return 0.01, (f"a skeleton without size: taken for centimetres; {missing_input.UNIT}",)
    for units in (UNITS, ODD_UNITS):
        likely = {name: unit for name, unit in units.items() if LIKELY[0] <= longest * unit <= LIKELY[1]}
        if likely:
            name = min(likely, key=lambda each: abs(np.log(longest * likely[each] / REACH)))
            length = f"the longest limb reaches {longest * likely[name]:.2f} m"
            return likely[name], (f"taken for {name}: {length}; if not, {missing_input.UNIT}",)
    unit = REACH / longest
    return unit, (f"of no unit that fits a person: made {REACH:g} m from hips to toes; {missing_input.UNIT}",)


def _placed_upright(captured: CapturedSkeleton) -> CapturedSkeleton:
    """Return a skeleton in the file's axes converted to z up, both in the world and in the zero pose."""
    up, note = vertical(captured.position, captured.roles)
    world = TO_Z[up]
    captured = captured.turned(world, world)
    rest, _ = standing_turn(captured.at_zero, captured.roles)
    stood = captured.turned(NONE, rest)
    if stood.stands and not captured.stands:
        captured = stood
    return replace(captured, notes=captured.notes + note)


def _from_body_root(skeleton: Skeleton, bone_map: Mapping[str, str]) -> tuple[Skeleton, tuple[str, ...]]:
    """Return the skeleton from the root of its body on, which moves as in the world, and a note on the joints left out.

    Many programs have parents above the pelvis, which are static or carry the body along: Reference, Armature, world.
    The skeleton is unchanged without such parents, and also if the body's root does not translate in its parent and
    other branches move.
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
        note += f"; other branches are left out: {listed((skeleton.names[i] for i in beside), bvh_file.LISTED)}"
    return bvh_file.skeleton(joints, place[:, subtree], turn[:, subtree], skeleton.fps), (note,)


def _body_root(skeleton: Skeleton, bone_map: Mapping[str, str]) -> int:
    """Return the joint that carries all parts of the body known by name. Without such names it is the first joint from
    the top that carries several joints, one without position channels, or that moves while the one below does not
    translate in it, as in the chain of an arm."""
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
        if _spread(skeleton.local[0][:, below[0]]) <= STILL < max(_spread(part[:, root]) for part in skeleton.world):
            return root
        root = below[0]


def _spread(values: Array) -> float:
    """Return the largest change of an entry of values (T, n) in time."""
    return float(np.ptp(values, axis=0).max())


def _at_zero(skeleton: Skeleton, carried: Array, root: int) -> Array:
    """Return the rotation (4,) of the zero pose by static parents that make it upright, as in files made z up."""
    if np.abs(carried - carried[0]).max() > STILL:
        return NONE
    by_role = roles(skeleton.names, skeleton.parents)
    feet = [by_role[role] for role in ("left_foot", "right_foot", "left_shin", "right_shin") if role in by_role]
    if not feet:
        return NONE
    place, zero = skeleton.world[0], skeleton.at_zero
    stands = np.median(place[:, root] - place[:, feet].mean(axis=1), axis=0)
    rest = zero[root] - zero[feet].mean(axis=0)
    return carried[0] if stands @ quat.rotated(carried[0], rest) > stands @ rest + STILL else NONE
