"""A captured skeleton in metres, z up, facing x where it stands straight; with its feet and the ground.

The rest pose of a model built with y up lies down in MuJoCo's world. A recording has the conventional vertical axis if
the person is upright along it in enough samples. Otherwise it is an axis along which the person is upright in most
samples, and the feet are not as level along the conventional axis as on a floor.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.surface.surface import UPRIGHT
from dynsplines.solver.tolerances import SINGLE, TINY

from ...errors import GIVE_UNIT, list_names
from ...scene.roles import apply_bone_map, first_hinge, lineage, mapped_roles, roles, unique
from . import bvh_file, hierarchy
from .bvh_file import Skeleton, to_world

REACH = 1.25  # [m] typical distance from an adult's hips along the bones to the fingertips or toes
UNITS = {"metres": 1.0, "centimetres": 0.01, "millimetres": 0.001}
ODD_UNITS = {"inches": 0.0254, "the CMU database's units": 0.0254 / 0.45}
STANDING = 0.8  # least cosine between the vertical and legs and trunk in a pose that counts as standing
LIKELY = (0.55, 3.0)  # [m] plausible reach of a person
DRIFT = 0.01  # least change of a bone's length that is reported, as a fraction of REACH
CLEARLY = 0.3  # least gain in the sum of the cosines of up and left for which a rest pose is rotated
AXES, USUAL = "xyz", "y"  # and the vertical axis of BVH files
NONE = np.array([1.0, 0, 0, 0])
TO_Z = {  # rotation of an axis to z; that of y is for figures facing z, as in animation
    "z": NONE, "y": np.array([0.5, 0.5, 0.5, 0.5]), "x": np.array([0.5, -0.5, -0.5, -0.5]),
    "-z": np.array([0.0, 1, 0, 0]), "-y": np.array([0.5, -0.5, 0.5, -0.5]), "-x": np.array([0.5, -0.5, 0.5, 0.5]),
}  # fmt: skip
SOME, MOST = 0.2, 0.5  # fractions of the samples that count as enough and as most
LEVEL = 0.25  # ratio of standard deviations of the lowest joint's height below which an axis indicates a floor


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
        bone_map = bone_map or {}
        skeleton, folded = _from_body_root(skeleton, bone_map)
        place, turn = skeleton.local
        offset = np.where(np.ptp(place, axis=0) > 0, np.median(place, axis=0), place[0])
        ends = {i: joint.end for i, joint in enumerate(skeleton.joints) if joint.end is not None}
        unit, notes = _unit(skeleton.parents, offset, ends, scale)
        notes += folded
        drift = np.abs(place[:, 1:] - offset[1:]).max(axis=(0, 2), initial=0.0)
        stretched = [skeleton.names[1 + i] for i in np.flatnonzero(unit * drift > DRIFT * REACH)]
        if stretched:
            names = list_names(stretched, hierarchy.LISTED)
            notes += (f"bones keep their lengths; what moves in its parent is left out: {names}",)
        place = place.copy()
        place[:, 1:] = offset[1:]
        offset = np.concatenate([np.zeros((1, 3)), offset[1:]])
        position, rotation = to_world(skeleton.parents, place, turn)
        here = cls(
            unique(skeleton.names), skeleton.parents, unit * offset, {i: unit * end for i, end in ends.items()},
            unit * position, rotation, notes, bone_map,
        )  # fmt: skip
        return _placed_upright(here)

    def turn(self, world: Array, rest: Array) -> CapturedSkeleton:
        """Return the skeleton with the world rotated (4,), and the zero pose by another rotation (4,)."""
        back = quat.inverse(rest)
        return replace(
            self,
            offset=quat.rotate(rest, self.offset),
            ends={i: quat.rotate(rest, end) for i, end in self.ends.items()},
            position=quat.rotate(world, self.position),
            rotation=quat.align_signs(quat.product(quat.product(world, self.rotation), back)),
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
        return min(float(part[2]) / max(float(np.linalg.norm(part)), TINY) for part in legs) > STANDING

    def children(self, joint: int) -> list[int]:
        return [i for i, parent in enumerate(self.parents) if parent == joint]

    def tip(self, joint: int) -> tuple[int, Array]:
        """Return the last joint of a limb, along the longest bones from a joint on, and its End Site (3,)."""
        while below := self.children(joint):
            joint = max(below, key=lambda i: float(np.linalg.norm(self.offset[i])))
        return joint, self.ends.get(joint, np.zeros(3))

    def at(self, joint: int, point: Array) -> Array:
        """Return the positions (T, 3) of a joint's point in the world."""
        return self.position[:, joint] + quat.rotate(self.rotation[:, joint], point)

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
    """Return the file's unit [m], by the length of its longest limb from the root, and a note."""
    if scale is not None:
        return scale, ()
    reach = np.zeros(len(parents))
    for i, parent in enumerate(parents):
        reach[i] = reach[parent] + np.linalg.norm(offset[i]) if parent >= 0 else 0.0
    longest = max([*reach, *(reach[i] + np.linalg.norm(end) for i, end in ends.items())])
    for units in (UNITS, ODD_UNITS):
        likely = {name: unit for name, unit in units.items() if LIKELY[0] <= longest * unit <= LIKELY[1]}
        if likely:
            name = min(likely, key=lambda each: abs(np.log(longest * likely[each] / REACH)))
            length = f"the longest limb reaches {longest * likely[name]:.2f} m"
            return likely[name], (f"taken for {name}: {length}; if not, {GIVE_UNIT}",)
    return 0.01, (f"of no unit that fits a person: taken for centimetres; {GIVE_UNIT}",)


def _placed_upright(captured: CapturedSkeleton) -> CapturedSkeleton:
    """Return a skeleton in the file's axes converted to z up, both in the world and in the zero pose."""
    up, note = vertical(captured.position, captured.roles)
    world = TO_Z[up]
    captured = captured.turn(world, world)
    rest, _ = standing_turn(captured.at_zero, captured.roles)
    stood = captured.turn(NONE, rest)
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
    beside = [i for i in beside if any(np.ptp(part[:, i], axis=0).max() > SINGLE for part in skeleton.world)]
    if beside and np.ptp(skeleton.local[0][:, root], axis=0).max() <= SINGLE:
        return skeleton, ()
    place, turn = (
        np.concatenate([world[:, [root]], local[:, subtree[1:]]], axis=1)
        for world, local in zip(skeleton.world, skeleton.local, strict=True)
    )
    joints = [
        replace(skeleton.joints[i], parent=subtree.index(skeleton.parents[i]) if i != root else -1) for i in subtree
    ]
    names = ", ".join(skeleton.names[i] for i in reversed(above))
    note = f"'{skeleton.names[root]}' is the root; its parents are folded into it: {names}"
    if beside:
        note += f"; other branches are left out: {list_names((skeleton.names[i] for i in beside), hierarchy.LISTED)}"
    return bvh_file.skeleton(joints, place, turn, skeleton.fps), (note,)


def _body_root(skeleton: Skeleton, bone_map: Mapping[str, str]) -> int:
    """Return the joint that carries all parts of the body known by name. Without such names it is the last joint that
    translates in its parent, of those from the top down to the first that carries several joints."""
    parents, names = skeleton.parents, unique(skeleton.names)
    parts = set(apply_bone_map(roles(names, parents), bone_map, names, "recording").values())
    if len(parts) > 1:
        return max(set.intersection(*(set(lineage(i, parents)) for i in parts)))
    root, joint = 0, 0
    while parents.count(joint) == 1:
        joint = parents.index(joint)
        if np.ptp(skeleton.local[0][:, joint], axis=0).max() > SINGLE:
            root = joint
    return root


def vertical(position: Array, roles: Mapping[str, int]) -> tuple[str, tuple[str, ...]]:
    """Return the vertical axis of a recording, of "x", "-x", ..., and a note if it is not the usual one.

    position (T, J, 3) of joints; roles: joints by part of the body
    """
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles][:1]
    tops = tops or [roles[role] for role in ("pelvis",) if role in roles]
    feet = [roles[role] for role in ("left_foot", "right_foot") if role in roles]
    feet = feet or [roles[role] for role in ("left_shin", "right_shin") if role in roles]
    if not tops or not feet:
        return USUAL, ()
    along = position[:, tops].mean(axis=1) - position[:, feet].mean(axis=1)
    cosine = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), TINY)
    share, drift = {}, {}
    for i, name in enumerate(AXES):
        for sign, axis in ((1.0, name), (-1.0, f"-{name}")):
            share[axis] = float(np.mean(sign * cosine[:, i] > UPRIGHT))
            drift[axis] = float(np.std(np.min(sign * position[:, :, i], axis=1)))
    upright = max(share, key=lambda axis: share[axis])
    if share[USUAL] >= SOME or upright == USUAL:
        return USUAL, ()
    if share[upright] > MOST and drift[USUAL] > LEVEL * drift[upright]:
        return upright, (
            f"{upright} is up in the file: along it the person is upright at {share[upright]:.0%} of the samples",
        )
    return USUAL, (f"the person is upright along no axis of the file; {USUAL} is taken as up, the usual axis",)


def standing_turn(place: Array, roles: Mapping[str, int]) -> tuple[Array, tuple[str, ...]]:
    """Return the rotation (4,) by multiples of 90° with which a rest pose stands upright and faces x, and a note.

    place (nbody, 3) [m] of bodies at rest; roles: bodies by part. Upright, the head is above the hips, these are above
    the feet, and the left hip is to the left. A figure without identified legs is taken to stand.
    """
    thighs, ends = ([roles.get(f"{side}_{part}") for side in ("left", "right")] for part in ("thigh", "foot"))
    ends = [
        end if end is not None else roles.get(f"{side}_shin") for end, side in zip(ends, ("left", "right"), strict=True)
    ]
    tops = [roles[role] for role in ("head", "neck", "left_upper_arm", "right_upper_arm", "chest") if role in roles]
    if None in thighs or None in ends:
        return NONE, ()
    hips, feet = (place[np.array(bodies, int)].mean(axis=0) for bodies in (thighs, ends))
    up = unit(hips - feet) + (unit(place[tops].mean(axis=0) - hips) if tops else 0.0)
    leftward = unit(place[thighs[0]] - place[thighs[1]])
    turns = Rotation.create_group("O")
    score = turns.apply(unit(up))[:, 2] + turns.apply(leftward)[:, 1]
    best = int(np.argmax(score))
    if score[best] - (unit(up)[2] + leftward[1]) < CLEARLY:
        return NONE, ()
    turn = turns[best]
    was_up = turn.inv().apply([0, 0, 1])
    axis = int(np.argmax(np.abs(was_up)))
    name = ("-" if was_up[axis] < 0 else "") + AXES[axis]
    notes = (
        () if name == "z" else (f"the figure's rest pose has {name} up, and lies down in the model's world: stood up",)
    )
    return turn.as_quat(scalar_first=True), notes


def unit(vector: Array) -> Array:
    """Return a vector (3,) scaled to length 1; zero stays zero."""
    return vector / max(float(np.linalg.norm(vector)), TINY)
