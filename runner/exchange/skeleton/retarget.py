"""A captured skeleton's motion on another figure: parts rotate alike; hands and feet have the same scaled positions.

Every body with a counterpart of the same role rotates with it: R_body(t) = R_joint(t) A with constant A. Feet without
toes follow the line from the ankle to the end of the skeleton's toes. If the skeleton's zero pose, that without
rotations, stands upright, such as a T-pose, A takes the figure's bones at rest to the skeleton's there by the shortest
rotation. Otherwise (LAFAN1's bones all lie along x) A follows from two directions: the bone's, and the axis about which
knee and elbow bend in the motion; hips and shoulders give those of pelvis and chest. Robots rest with bent elbows, so
limbs are straightened before A is computed. Arms and legs are then bent until hands and feet have the skeleton's
positions relative to shoulder and hip, scaled to the figure. Limb directions alone do not give these positions if the
figure's limbs have other proportions: a robot's leg begins with a bracket that offsets it from the hip. Every pose is
found by inverse kinematics, from the one before it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.contacts.ground_alignment import LOWEST
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.model import boxes
from dynsplines.solver.figure.root import Root, roots_of, subtree
from dynsplines.solver.posing import STARTS, PoseSearch, Residuals, join
from dynsplines.solver.tolerances import NEGLIGIBLE, TINY

from ...errors import GIVE_MAP, UserError, list_names
from ...scene.configuration import kinematics_of
from ...scene.roles import NEEDED, ONWARD, SIDES, lineage, mapped_roles
from . import hierarchy, maps
from .captured_skeleton import CapturedSkeleton, standing_turn, unit

NEXT = {**ONWARD, "foot": "toe", "clavicle": "upper_arm"}
BENT = 0.15  # least mean sine of an elbow's or knee's bend that determines its axis
LEG, ARM = ("thigh", "shin", "foot"), ("upper_arm", "forearm", "hand")
ENDS = ("foot", "hand")
HANGS_ON = {"forearm": "upper_arm", "shin": "thigh"}
PLACE = 0.01  # [m] position error of a hand or foot that counts as a residual of 1
TURN, TURN_OF_END, TURN_OF_TRUNK = np.radians((15, 4, 1))  # [rad] errors of a limb's parts, its end, and other bodies
RANGE = 1e3  # [1/rad] weight of joint ranges
STEPS, LONGEST = 30, 0.3  # most iterations of least squares; [rad] largest change of a joint in one
FAR = 4.0  # [1] increase of the cost between two samples after which the rest pose is another start


@dataclass(frozen=True)
class _Standing:
    """The figure at rest, rotated to be upright and facing x: at_zero (nbody, 3), turn (nbody, 4), bodies by role."""

    model: mujoco.MjModel
    at_zero: Array
    turn: Array
    roles: dict[str, int]
    notes: tuple[str, ...] = ()

    @classmethod
    def of(cls, model: mujoco.MjModel, bone_map: Mapping[str, str]) -> _Standing:
        rest, names = hierarchy.rest(model), hierarchy.names(model)[1:]
        parents = [int(p) - 1 for p in model.body_parentid[1:]]
        bodies = {role: 1 + body for role, body in mapped_roles(names, parents, bone_map, "figure").items()}
        stand, notes = standing_turn(rest.position[0], bodies)
        place, turn = quat.rotate(stand, rest.position[0]), quat.product(stand, rest.rotation[0])
        return cls(model, place, turn, bodies, notes)

    def straighten(self, role: str) -> Array:
        """Return the rotation (4,) of a forearm or shin into the line of the upper arm or thigh."""
        above = f"{role.partition('_')[0]}_{HANGS_ON.get(role.partition('_')[2], '')}"
        if above not in self.roles:
            return np.array([1.0, 0, 0, 0])
        return quat.swing(self.bone(role), self.bone(above), np.array([0.0, 1, 0]))

    @cached_property
    def bracketed(self) -> list[str]:
        """The sides on which the hip's first hinge is off the thigh's line, and the foot cannot roll: it is flat only
        under a leg that is vertical below this offset."""
        return [side for side in SIDES if not self._rolls(side) and np.any(_bracket(self, side))]

    def _rolls(self, side: str) -> bool:
        """Return whether a foot has several joints below the shin."""
        foot = self.roles.get(f"{side}_foot")
        chain = [] if foot is None else hierarchy.above(self.model, foot, itself=True)
        return len(hierarchy.joints(self.model, [body for body in chain if body > self.roles[f"{side}_shin"]])) > 1

    def start_of(self, role: str) -> int:
        """Return the first body of a part of a limb: of several for the hinges of a robot's hip."""
        body, others = self.roles[role], {0, *self.roles.values()}
        while int(self.model.body_parentid[body]) not in others:
            body = int(self.model.body_parentid[body])
        return body

    @cached_property
    def feet(self) -> Index:
        """The geoms of the feet: the colliding ones, if there are any."""
        tops = [self.roles[role] for role in ("left_foot", "right_foot") if role in self.roles]
        bodies = [body for top in tops for body in np.flatnonzero(subtree(self.model, top))]
        geoms = np.flatnonzero(np.isin(self.model.geom_bodyid, bodies))
        touching = geoms[(self.model.geom_contype[geoms] | self.model.geom_conaffinity[geoms]) > 0]
        return touching if touching.size else geoms

    def bone(self, role: str) -> Array:
        """Return the vector (3,) from a body to the next part of its limb, or to its farthest site or geom."""
        body, (side, _, part) = self.roles[role], role.partition("_")
        onward = self.roles.get(f"{side}_{NEXT.get(part, '')}")
        if onward is not None:
            return self.at_zero[onward] - self.at_zero[body]
        return quat.rotate(self.turn[body], hierarchy.end(self.model, body))


Pose = _Standing | CapturedSkeleton  # in the figure's rest pose, or in the skeleton's zero pose


def onto(captured: CapturedSkeleton, model: mujoco.MjModel, where: str) -> tuple[Array, tuple[str, ...]]:
    """Return qpos (T, nq) of the figure, and notes; where is the label of the file in errors."""
    chosen, applied = maps.current()
    standing, names = _Standing.of(model, chosen.figure), hierarchy.names(model)
    captured = replace(captured, bone_map=chosen.recording)
    applied.append(where)
    for what, by_role in (("the figure's bodies", standing.roles), ("the file's joints", captured.roles)):
        missing = [role for role in NEEDED if role not in by_role]
        if missing:
            every = captured.names if by_role is captured.roles else names[1:]
            repeated = [name for name in every if f"{name}_2" in every]
            twice = (
                f"; twice there is {list_names(repeated, hierarchy.LISTED)}: add left and right to the names"
                if repeated
                else ""
            )
            raise UserError(
                f"{where}: among {what} none is a {' or '.join(missing).replace('_', ' ')} by its name: "
                f"{list_names(every, hierarchy.LISTED)}{twice}; {GIVE_MAP}"
            )
    chain = hierarchy.above(model, standing.roles.get("pelvis", standing.roles["left_thigh"]), itself=True)
    root = next((root for root in roots_of(model) if root.body in chain), None)
    if root is None:
        top = names[model.body_rootid[standing.roles.get("pelvis", standing.roles["left_thigh"])]]
        floating = "in URDF a joint of type 'floating' from a link 'world'"
        raise UserError(f"{where}: the figure's root, '{top}', needs a free joint; {floating}")
    shared = [role for role in standing.roles if role in captured.roles]
    upright = captured.stands
    alignment = _upright(captured, standing, shared) if upright else _by_bends(captured, standing, shared)
    bent = [side for side in SIDES if f"{side}_toe" not in standing.roles and _has_toes(captured, side)]
    for side in bent:
        captured = _toes_in_foot(captured, side, at_zero=upright)
    turns = {
        standing.roles[role]: quat.product(
            quat.product(captured.rotation[:, captured.roles[role]], alignment[role]),
            standing.turn[standing.roles[role]],
        )
        for role in shared
    }
    leg = _leg({role: _line_of(captured, role, standing.bracketed) for role in shared})
    if not leg > 0:
        raise UserError(f"{where}: its legs have no length, so its size is unknown")
    scale = _leg({role: _line_of(standing, role, standing.bracketed) for role in shared}) / leg
    qpos, columns = _at_root(standing, root, turns)
    qpos = follow(model, qpos, RecordedPoses(turns, list(_limbs(captured, standing, turns, scale))), columns)
    qpos = _place(captured, standing, root, qpos, scale)
    qpos, lift = _on_ground(standing, root, qpos)
    notes = [*standing.notes, f"scaled by {scale:.3f}, the ratio of the legs"]
    notes += notes_on_lift(lift)
    toes_of_feet = [role for role in ("left_toe", "right_toe") if role in captured.roles]
    joints_of_roles = {
        joint for role in (*shared, *toes_of_feet) for joint in lineage(captured.roles[role], captured.parents)
    }
    lost = [name for i, name in enumerate(captured.names) if i not in joints_of_roles]
    moved = {above for body in turns for above in hierarchy.above(model, body, itself=True)}
    still = [names[body] for body in range(1, model.nbody) if model.body_jntnum[body] and body not in moved]
    toes = " and ".join(captured.names[captured.roles[f"{side}_toe"]] for side in bent)
    notes += [f"the figure has no toes: what {toes} bend turns its feet"] if bent else []
    notes += [f"without a counterpart in the figure: {list_names(lost, hierarchy.LISTED)}"] if lost else []
    notes += (
        [f"without a counterpart in the file, kept at rest: {list_names(still, hierarchy.LISTED)}"] if still else []
    )
    return qpos, tuple(notes)


def _limbs(
    captured: CapturedSkeleton, standing: _Standing, turns: Mapping[int, Array], scale: float
) -> Iterator[tuple[list[int], Array]]:
    """Yield bodies of arms and legs with the target positions (T, 3) of hands and feet; scale: of legs."""
    for side, parts in product(SIDES, (LEG, ARM)):
        chain = [f"{side}_{part}" for part in parts]
        if not all(role in standing.roles and role in captured.roles for role in chain):
            continue
        first, last = standing.start_of(chain[0]), standing.roles[chain[-1]]
        bodies = [body for body in hierarchy.above(standing.model, last, itself=True) if body >= first]
        theirs, mine = ([_line_of(pose, role, standing.bracketed) for role in chain] for pose in (captured, standing))
        size = scale if parts is LEG else _length(mine) / max(_length(theirs), TINY)
        about = captured.position[:, captured.roles[chain[-1]]] - captured.position[:, captured.start_of(chain[0])]
        pelvis = standing.roles.get("pelvis", -1)
        if parts is LEG and pelvis in turns and side in standing.bracketed:
            about = about - quat.rotate(captured.rotation[:, captured.roles["pelvis"]], _bracket(captured, side))
            in_pelvis = quat.rotate(quat.conjugate(standing.turn[pelvis]), _bracket(standing, side))
            about = about + quat.rotate(turns[pelvis], in_pelvis) / size
        yield bodies, size * about


def _line_of(pose: Pose, role: str, bracketed: Sequence[str]) -> Array:
    """Return where a limb's line begins and bends (3,), or for hand and foot the origin of their body."""
    if role.endswith(ENDS):
        return pose.at_zero[pose.roles[role]]
    start, (side, _, part) = pose.at_zero[pose.start_of(role)], role.partition("_")
    return start + _bracket(pose, side) if part == "thigh" and side in bracketed else start


def _bracket(pose: Pose, side: str) -> Array:
    """Return the offset (3,) [m] of the thigh from the hip's first hinge, across the leg."""
    thigh, shin = (pose.at_zero[pose.roles[f"{side}_{part}"]] for part in ("thigh", "shin"))
    return _across(thigh - pose.at_zero[pose.start_of(f"{side}_thigh")], shin - thigh)


def _ahead(pose: Pose, role: str) -> Array:
    """Return the offset (3,) [m] of the thigh from the hip's first hinge, in the sagittal plane."""
    return _across(pose.at_zero[pose.roles[role]] - pose.at_zero[pose.start_of(role)], _to_left(pose))


def _to_left(pose: Pose) -> Array:
    return pose.at_zero[pose.roles["left_thigh"]] - pose.at_zero[pose.roles["right_thigh"]]


def _across(vector: Array, axis: Array) -> Array:
    """Return the part of a vector (3,) orthogonal to an axis."""
    return vector - unit(axis) * (unit(axis) @ vector)


def _length(places: Sequence[Array] | Array) -> float:
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())


def _has_toes(captured: CapturedSkeleton, side: str) -> bool:
    """Return whether a foot has a joint of toes between ankle and tip, with an extent that it rotates."""
    toes = captured.roles.get(f"{side}_toe")
    if toes is None or side not in captured.feet:
        return False
    _, tip, end, _ = captured.feet[side]
    return toes in lineage(tip, captured.parents) and (toes != tip or bool(np.any(end)))


def _toes_in_foot(captured: CapturedSkeleton, side: str, *, at_zero: bool) -> CapturedSkeleton:
    """Rotate an ankle so that a foot with stiff toes ends where the foot with bending toes does.

    at_zero  whether toes are straight in the zero pose; otherwise they are in the sample in which the foot is lowest
    """
    ankle, toe, end, low = captured.feet[side]
    turn, along = captured.rotation[:, ankle], captured.at(toe, end) - captured.position[:, ankle]
    if at_zero:
        straight = captured.at_zero[toe] + end - captured.at_zero[ankle]
    else:
        straight = quat.rotate(quat.conjugate(turn[low]), along[low])
    start, stop = quat.rotate(turn, straight), along
    sizes = np.linalg.norm(start, axis=1) * np.linalg.norm(stop, axis=1)
    swung = np.concatenate([(sizes + np.sum(start * stop, axis=1))[:, None], np.cross(start, stop)], axis=1)
    swung[swung[:, 0] <= 1e-6 * sizes] = [1, 0, 0, 0]  # toes turned back by 180°, or without length
    rotation = captured.rotation.copy()
    rotation[:, ankle] = quat.product(quat.normalise(swung), turn)
    return replace(captured, rotation=rotation)


def _leg(place: Mapping[str, Array]) -> float:
    """Return the mean length [m] of both legs, to the ankle if there is one, from positions of the joints."""
    total = 0.0
    for side in SIDES:
        chain = [place[f"{side}_{part}"] for part in ("thigh", "shin", "foot") if f"{side}_{part}" in place]
        total += 0.5 * _length(chain)
    return total


def _frame(first: Array, second: Array) -> Array:
    """Return a frame (3, 3) with columns: the first direction, the orthogonalised second, and their cross product."""
    x = unit(first)
    y = unit(_across(second, x))
    return np.stack([x, y, np.cross(x, y)], axis=-1)


def _heading(left: Array) -> Array:
    """Return the rotation (4,) about the vertical that takes y, a figure's left, to a direction."""
    return quat.from_rotation_vector(np.array([0, 0, np.arctan2(-left[0], left[1])]))


def _upright(captured: CapturedSkeleton, standing: _Standing, shared: list[str]) -> dict[str, Array]:
    """Return A by role, from an upright zero pose."""
    facing = quat.product(_heading(_to_left(captured)), quat.conjugate(_heading(_to_left(standing))))
    out = {}
    for role in shared:
        part = role.partition("_")[2]
        out[role] = facing
        if part not in NEXT:
            continue
        straight = quat.product(facing, standing.straighten(role))
        mine, theirs = standing.bone(role), _bone(captured, role)
        if part == "thigh":
            mine, theirs = mine + _ahead(standing, role), theirs + _ahead(captured, role)
        mine = quat.rotate(straight, mine)
        if part == "foot":  # soles are level in both; only their headings may differ
            mine, theirs = mine * [1, 1, 0], theirs * [1, 1, 0]
        if min(np.linalg.norm(mine), np.linalg.norm(theirs)) > 1e-3:
            out[role] = quat.product(quat.swing(mine, theirs, quat.rotate(facing, np.array([1.0, 0, 0]))), straight)
    for side in SIDES:  # in line with the forearm in both
        if {f"{side}_hand", f"{side}_forearm"} <= out.keys():
            out[f"{side}_hand"] = out[f"{side}_forearm"]
    return out


def _bone(captured: CapturedSkeleton, role: str) -> Array:
    """Return the vector (3,) from a joint to the next part of its limb, in the joint's axes."""
    joint, (side, _, part) = captured.roles[role], role.partition("_")
    onward = captured.roles.get(f"{side}_{NEXT.get(part, '')}")
    if onward is not None and joint in lineage(onward, captured.parents):
        return captured.at_zero[onward] - captured.at_zero[joint]
    tip, end = captured.tip(joint)
    return captured.at_zero[tip] + end - captured.at_zero[joint]


def _local(captured: CapturedSkeleton, role: str, vector: Array) -> Array:
    """Return the mean (3,) of world directions (T, 3) in a joint's axes."""
    return quat.rotate(quat.conjugate(captured.rotation[:, captured.roles[role]]), vector).mean(axis=0)


def _by_bends(captured: CapturedSkeleton, standing: _Standing, shared: list[str]) -> dict[str, Array]:
    """Return A by role from two directions of every bone, for any zero pose."""
    out: dict[str, Array] = {}
    lateral: dict[str, Array] = {}
    for role, limb, top in (("pelvis", "thigh", "chest"), ("chest", "upper_arm", "neck")):
        ends = [captured.roles[f"{side}_{limb}"] for side in SIDES if f"{side}_{limb}" in captured.roles]
        if role not in shared or len(ends) < 2:
            continue
        place = captured.position
        across = place[:, ends[0]] - place[:, ends[1]]
        above, middle = captured.roles.get(top, captured.roles.get("head")), place[:, ends].mean(axis=1)
        if role == "chest":  # its bone leads to the neck, or to the midpoint of the shoulders
            up = (place[:, above] if above is not None else middle) - place[:, captured.roles[role]]
        else:
            up = place[:, above] - middle if above is not None else np.tile([0.0, 0, 1], (len(place), 1))
        theirs = _frame(_local(captured, role, across), _local(captured, role, up))
        mine = _frame(np.array([0.0, 1, 0]), np.array([0.0, 0, 1]))
        out[role], lateral[limb] = quat.from_matrix(theirs @ mine.T), across
    for side in SIDES:
        for upper, lower, sign in (("thigh", "shin", 1.0), ("upper_arm", "forearm", -1.0)):
            pair = [f"{side}_{upper}", f"{side}_{lower}"]
            if not all(role in shared for role in pair):
                continue
            along = [
                quat.rotate(captured.rotation[:, captured.roles[role]], unit(_bone(captured, role))) for role in pair
            ]
            bend = sign * np.cross(along[0], along[1])
            is_bent = float(np.linalg.norm(bend, axis=1).mean()) > BENT
            axis = bend if is_bent else lateral.get(upper)
            if axis is None:
                continue
            for role in pair:
                theirs = _frame(_bone(captured, role), _local(captured, role, axis))
                out[role] = quat.from_matrix(theirs @ _frame(standing.bone(role), np.array([0.0, 1, 0])).T)
        if f"{side}_foot" in shared and side in captured.feet:
            out[f"{side}_foot"] = _flat(captured, standing, side)
    for role in shared:
        if role not in out:  # as for its parent
            out[role] = _like_parent(captured, role, out)
    return out


def _flat(captured: CapturedSkeleton, standing: _Standing, side: str) -> Array:
    """Return A of a foot that, in the sample in which it is lowest, is level and has the heading of the skeleton's."""
    ankle, toe, end, low = captured.feet[side]
    up = np.array([0.0, 0, 1])
    ahead = (captured.at(toe, end)[low] - captured.position[low, ankle]) * [1, 1, 0]
    mine = standing.bone(f"{side}_foot") * [1, 1, 0]
    mine = mine if np.linalg.norm(mine) > 1e-3 else np.array([1.0, 0, 0])
    turn = quat.from_matrix(_frame(ahead, up) @ _frame(mine, up).T)
    return quat.product(quat.conjugate(captured.rotation[low, ankle]), turn)


def _like_parent(captured: CapturedSkeleton, role: str, out: dict[str, Array]) -> Array:
    """Return A with which a part has the mean orientation relative to its nearest ancestor with an A."""
    joint = captured.roles[role]
    role_of = {captured.roles[other]: other for other in out}
    above = next((i for i in lineage(joint, captured.parents)[1:] if i in role_of), None)
    if above is None:
        return np.array([1.0, 0, 0, 0])
    relative = quat.product(quat.conjugate(captured.rotation[:, joint]), captured.rotation[:, above])
    return quat.product(quat.normalise(quat.align_signs(relative).mean(axis=0)), out[role_of[above]])


def _at_root(standing: _Standing, root: Root, turns: Mapping[int, Array]) -> tuple[Array, slice]:
    """Return qpos (T, nq) at rest, with the root rotated as the first recorded body on it, and its columns."""
    start = int(standing.model.jnt_qposadr[root.joint])
    first = next(body for body in sorted(turns) if root.body in hierarchy.above(standing.model, body, itself=True))
    relative = quat.product(quat.conjugate(standing.turn[first]), standing.turn[root.body])
    qpos = np.tile(standing.model.qpos0, (len(turns[first]), 1))
    qpos[:, start + 3 : start + 7] = quat.align_signs(quat.normalise(quat.product(turns[first], relative)))
    return qpos, slice(start, start + 7)


def _place(captured: CapturedSkeleton, standing: _Standing, root: Root, qpos: Array, scale: float) -> Array:
    """Return qpos with the middle of the hips at the captured one's, scaled about the world's origin."""
    model = standing.model
    hips = captured.position[:, [captured.start_of(f"{side}_thigh") for side in SIDES]].mean(axis=1)
    middle = standing.at_zero[[standing.start_of(f"{side}_thigh") for side in SIDES]].mean(axis=0)
    pelvis = standing.roles["pelvis"]
    offset = quat.rotate(quat.conjugate(standing.turn[pelvis]), middle - standing.at_zero[pelvis])

    places = [data.xpos[pelvis] + quat.rotate(data.xquat[pelvis], offset) for data in kinematics_of(model, qpos)]
    return _shift(model, root, qpos, scale * hips - np.array(places))


def _on_ground(standing: _Standing, root: Root, qpos: Array) -> tuple[Array, float]:
    """Shift the motion vertically so that the soles are nearly never below the ground; return also the shift [m]. Soles
    are sites with heel or toe in their name, or else the bounding boxes of the feet's geoms."""
    model, feet = standing.model, standing.feet
    soles = [i for i in range(model.nsite) if any(word in model.site(i).name.lower() for word in ("heel", "toe"))]
    if not soles and not feet.size:
        return qpos, 0.0
    lowest = []
    for data in kinematics_of(model, qpos):
        centre, reach = boxes(model, data, feet)
        lowest.append((data.site_xpos[soles] if soles else centre - reach)[:, 2].min())
    lift = -float(np.percentile(lowest, LOWEST))
    return _shift(model, root, qpos, np.tile([0, 0, lift], (len(qpos), 1))), lift


def notes_on_lift(lift: float) -> tuple[str, ...]:
    """Return a note on a vertical shift [m] of a motion, if it is large enough."""
    direction = "raised" if lift > 0 else "lowered"
    return (f"{direction} by {abs(lift):.3f} m, so that feet meet the ground",) if abs(lift) > NEGLIGIBLE else ()


def _shift(model: mujoco.MjModel, root: Root, qpos: Array, by: Array) -> Array:
    """Return qpos (T, nq) with the root translated by vectors (T, 3) [m] in world axes."""
    out, start = qpos.copy(), int(model.jnt_qposadr[root.joint])
    out[:, start : start + 3] += by
    return out


@dataclass
class RecordedPoses:
    """Targets in every sample, as one goal of inverse kinematics for the current sample.

    turns  target orientations in the world {body: (T, 4)}
    limbs  bodies from the first one of a limb to hand or foot, and the target (T, 3) [m] of the last one relative to
           the first
    """

    turns: Mapping[int, Array]
    limbs: Sequence[tuple[Sequence[int], Array]]
    sample: int = 0
    name: str = "recording"
    inverse: Array = field(init=False)  # (T, b, 4) inverse rotations of the targets
    spread: Array = field(init=False)  # (b, 1) [rad]

    def __post_init__(self) -> None:
        of_limb = {body: TURN for bodies, _ in self.limbs for body in bodies}
        of_limb |= {bodies[-1]: TURN_OF_END for bodies, _ in self.limbs}
        self.inverse = quat.inverse(np.stack(list(self.turns.values()), axis=1))
        self.spread = np.array([[of_limb.get(body, TURN_OF_TRUNK)] for body in self.turns])

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [*self.turns, *(body for bodies, _ in self.limbs for body in bodies)]

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        away = quat.rotation_vector(quat.product(data.xquat[list(self.turns)], self.inverse[self.sample]))
        off = [data.xpos[b[-1]] - data.xpos[b[0]] - about[self.sample] for b, about in self.limbs]
        return np.concatenate([(away / self.spread).ravel(), *(part / PLACE for part in off)])

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> tuple[Array, Array]:
        turned, moved = np.zeros((len(self.turns), 3, model.nv)), np.zeros((len(self.limbs), 2, 3, model.nv))
        for row, body in zip(turned, self.turns, strict=True):
            mujoco.mj_jacBody(model, data, None, row, body)
        for pair, (bodies, _) in zip(moved, self.limbs, strict=True):
            for row, body in zip(pair, (bodies[-1], bodies[0]), strict=True):
                mujoco.mj_jacBody(model, data, row, None, body)
        by_end = (moved[:, 0] - moved[:, 1]) / PLACE
        rows = np.concatenate([turned / self.spread[:, :, None], by_end]).reshape(-1, model.nv)
        return self.residual(model, data), rows


def follow(model: mujoco.MjModel, qpos: Array, poses: RecordedPoses, root: slice) -> Array:
    """Return qpos (T, nq) that follow the targets, with hinges and slides in their ranges; root: the columns that stay.

    Ball joints are those of people, who exceed their ranges a little.
    """
    figure, out = Figure(model), np.array(qpos)
    free = np.ones(figure.width, bool)
    free[root] = False
    search = PoseSearch(figure, model.qpos0, free, (poses,), None)
    balls = len(search.ranges.balls)  # their rows are the first ones

    def residuals(pose: Array) -> Residuals:
        _, (off, by_off), (over, by_over) = search.linearise(pose)
        over, by_over = over[balls:], by_over[balls:]
        return Residuals(*join([(off, by_off), (RANGE * over, RANGE * by_over)]), off.size)

    def minimise(start: Array) -> tuple[Array, float]:
        return search.minimise(residuals, start, STEPS, longest=LONGEST, smallest=NEGLIGIBLE)

    last = 0.0
    for i, row in enumerate(out if search.dofs.size else ()):
        poses.sample = i
        starts = [search.clip(row), *search.starts_around(STARTS)] if i == 0 else [np.where(free, out[i - 1], row)]
        found = [minimise(np.where(free, start, row)) for start in starts]
        if i and found[0][1] > FAR * max(last, 1.0):
            found.append(minimise(search.clip(row)))
        pose, last = min(found, key=lambda each: each[1])
        out[i] = search.clip(pose)
    return out
