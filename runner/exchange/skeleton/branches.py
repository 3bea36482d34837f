"""Arms and legs of a figure without meaningful names, by its tree and the positions of its bodies at rest.

Limbs are pairs of chains with equal lengths on one body. Legs are the pair that reaches lowest, arms the one that hangs
highest. A knee or elbow is the joint between the longest segments. A hinge that rotates about the limb's line does not
end a segment: robots have such hinges half-way along upper arms and thighs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.root import subtree

from . import hierarchy
from .roles import SIDES, lineage, split, with_trunk

LEAST = 3  # least number of joints of a limb
ALIKE = 0.03  # largest difference between the limbs of a pair, as a fraction of the limb's length
ALONG = 0.85  # least cosine between a hinge's axis and the limb's line for a hinge along the limb
HANGING = 0.7  # least height of a leg's beginning above its end, as a fraction of its length
PARTS = {"leg": ("thigh", "shin", "foot"), "arm": ("upper_arm", "forearm", "hand")}


@dataclass(frozen=True)
class _Chain:
    """A chain of bodies; places (N, 3) [m] of each at rest and of the limb's tip, in the world."""

    bodies: Sequence[int]
    places: Array

    @property
    def length(self) -> float:
        return float(np.linalg.norm(np.diff(self.places, axis=0), axis=1).sum())


def completed(model: mujoco.MjModel, found: Mapping[str, int], place: Array, turn: Array) -> dict[str, int]:
    """Return bodies by role; the tree gives limbs whose names do not identify upper and lower part.

    found  bodies by role from their names; place (nbody, 3) [m], turn (nbody, 4)  of the bodies at rest
    """
    by_tree = limbs(model, place, turn)
    names, parents = hierarchy.names(model), [-1, *model.body_parentid[1:].tolist()]
    out, changed = dict(found), False
    for parts in PARTS.values():
        needed = [f"{side}_{part}" for side in SIDES for part in parts[:2]]
        if all(role in found for role in needed) or not all(role in by_tree for role in needed):
            continue
        changed = True
        for side in SIDES:
            upper, lower, end = (f"{side}_{part}" for part in parts)
            out |= {upper: by_tree[upper], lower: by_tree[lower]}
            if end in out and by_tree[lower] not in lineage(out[end], parents)[1:]:
                del out[end]
            if end not in out and end in by_tree:
                out[end] = by_tree[end]
    if not changed:
        return out
    trunk = {role: body for role, body in out.items() if role not in ("pelvis", "chest")}
    return {role: body for role, body in with_trunk(trunk, names, parents).items() if body}


def limbs(model: mujoco.MjModel, place: Array, turn: Array) -> dict[str, int]:
    """Return bodies by role, "left_thigh" to "right_hand", of identified limbs; place (nbody, 3), turn (nbody, 4).

    The result is empty for a figure on more than two legs.
    """
    pairs = list(_pairs(model, place, turn))
    legs = min(pairs, key=lambda pair: pair[0].places[-1][2], default=None)
    if legs is None or legs[0].places[0][2] - legs[0].places[-1][2] < HANGING * legs[0].length:
        return {}
    ground, size = legs[0].places[-1][2], legs[0].length
    higher = [pair for pair in pairs if pair is not legs and pair[0].places[0][2] > legs[0].places[0][2] + 0.1 * size]
    arms = max(higher, key=lambda pair: pair[0].places[0][2], default=None)
    others = [pair for pair in pairs if pair is not legs and pair is not arms]
    if any(pair[0].places[-1][2] < ground + 0.1 * size for pair in others):
        return {}
    found = _parts(model, legs, turn, PARTS["leg"])
    return found if arms is None else found | _parts(model, arms, turn, PARTS["arm"])


def _pairs(model: mujoco.MjModel, place: Array, turn: Array) -> Iterator[tuple[_Chain, _Chain]]:
    """Yield pairs of equal limbs that hang on one body, the left one first."""
    for body in range(1, model.nbody):
        below = np.flatnonzero(model.body_parentid[1:] == body) + 1
        chains = [chain for child in below.tolist() if (chain := _chain(model, child, place, turn)) is not None]
        for one, other in combinations(chains, 2):
            if _are_alike(one, other):
                first_is_left = _is_left(model, one, other)
                yield (one, other) if first_is_left else (other, one)


def _chain(model: mujoco.MjModel, body: int, place: Array, turn: Array) -> _Chain | None:
    """Return the jointed bodies from one on to the first branching, such as at fingers; None for too few."""
    bodies = list[int]()
    while True:
        if model.body_jntnum[body]:
            bodies.append(body)
        children = np.flatnonzero(model.body_parentid == body).tolist()
        below = [child for child in children if model.body_jntnum[subtree(model, child)].any()]
        if len(below) != 1:
            break
        body = below[0]
    if len(hierarchy.joints(model, bodies)) < LEAST or len(bodies) < 2:
        return None
    end = bodies[-1]
    geoms = np.flatnonzero(model.geom_bodyid == end)
    middle = model.geom_pos[geoms].mean(axis=0) if geoms.size else np.zeros(3)
    tip = place[end] + quat.rotated(turn[end], middle)
    return _Chain(bodies, np.concatenate([place[bodies], tip[None]]))


def _are_alike(one: _Chain, other: _Chain) -> bool:
    """Return whether two limbs have equal lengths, and begin and end at equal heights."""
    if len(one.bodies) != len(other.bodies) or not one.length > 0:
        return False
    gaps = [np.linalg.norm(np.diff(chain.places, axis=0), axis=1) for chain in (one, other)]
    near = ALIKE * one.length
    level = np.abs(one.places[[0, -1], 2] - other.places[[0, -1], 2]).max()
    apart = np.linalg.norm(one.places[0] - other.places[0])
    return bool(np.abs(gaps[0] - gaps[1]).max() < near and level < near and apart > near)


def _is_left(model: mujoco.MjModel, one: _Chain, other: _Chain) -> bool:
    """Return whether the first limb is the left one of a pair, by names of bodies and joints, else by position."""
    for chain, side in ((one, "left"), (other, "right"), (one, "right"), (other, "left")):
        names = [model.body(body).name for body in chain.bodies]
        names += [model.joint(joint).name for joint in hierarchy.joints(model, chain.bodies)]
        if side in {split(name)[0] for name in names}:
            return side == ("left" if chain is one else "right")
    return bool(one.places[0][1] > other.places[0][1])


def _parts(
    model: mujoco.MjModel, pair: tuple[_Chain, _Chain], turn: Array, parts: tuple[str, str, str]
) -> dict[str, int]:
    """Return upper part, lower part and end of two limbs; the end only if a joint follows the lower part's."""
    out = dict[str, int]()
    for side, chain in zip(SIDES, pair, strict=True):
        middle = _middle(model, chain, turn)
        if middle is None:
            return {}
        above, at, last = chain.bodies[middle - 1], chain.bodies[middle], chain.bodies[-1]
        out |= {f"{side}_{parts[0]}": above, f"{side}_{parts[1]}": at}
        if last != at:
            out[f"{side}_{parts[2]}"] = last
    return out


def _middle(model: mujoco.MjModel, chain: _Chain, turn: Array) -> int | None:
    """Return the index in a chain of the knee or elbow, where the longest segments meet."""
    ends = [0]  # of stretches
    for i in range(1, len(chain.bodies)):
        line = chain.places[i] - chain.places[ends[-1]]
        if not _turns_about(model, chain.bodies[i], turn, line):
            ends.append(i)
    ends.append(len(chain.places) - 1)
    sizes = np.linalg.norm(np.diff(chain.places[ends], axis=0), axis=1)
    if sizes.size < 2:
        return None
    return ends[1 + int(np.minimum(sizes[:-1], sizes[1:]).argmax())]


def _turns_about(model: mujoco.MjModel, body: int, turn: Array, line: Array) -> bool:
    joints = hierarchy.joints(model, [body])
    if len(joints) != 1 or model.jnt_type[joints[0]] != JointKind.HINGE:
        return False
    axis = quat.rotated(turn[body], model.jnt_axis[joints[0]])
    return bool(abs(axis @ line) > ALONG * max(float(np.linalg.norm(line)), 1e-9))
