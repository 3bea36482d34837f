"""Notes on goals that no pose meets: how far they are from the nearest pose, which joints are fixed, and a remedy."""

from __future__ import annotations

from collections.abc import Container, Sequence

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import JointRange, joint_ranges
from dynsplines.solver.posing import MET, BodyGoal, Goal, PointGoal, Posed, chain

from ..table import KeyframeTable

BESIDE = 0.1  # least reported error of a goal relative to the largest, as smaller ones result from the largest
CLOSE = 2e-3  # [m or rad] errors up to which goals are not reported beside one with a larger error
# [rad, m] distance from the end of a joint's range up to which it is reported
AT_LIMIT = {JointKind.HINGE: np.radians(1), JointKind.BALL: np.radians(1), JointKind.SLIDE: 1e-3}
MOST = 3  # most goals of a keyframe that are reported


def describe(figure: Figure, key: Frame, row: KeyframeTable, goals: Sequence[Goal], nearest: Posed) -> str:
    """Return a note on the worst unmet goals of a keyframe, the worst first, and what to do.

    Args:
        key: The keyframe before it is posed.
        nearest: The nearest pose found.
    """
    least = max(MET, BESIDE * nearest.worst, min(CLOSE, 0.5 * nearest.worst))
    errors = sorted(zip(nearest.missed.tolist(), goals, strict=True), key=lambda pair: -pair[0])
    worst = [(goal, error) for error, goal in errors if error > least][:MOST]
    stopped = _at_limits(figure, nearest.qpos)
    notes = [_note(figure, key, goal, error, stopped, goals) for goal, error in worst]
    if not all(can_move(figure, key, goal.bodies(figure.model)[0]) for goal, _ in worst):
        return "; ".join(notes)
    move = "move the target" if len(worst) == 1 else "move one of the targets"
    remedies = filter(None, (_remedy(figure, key, row, goal) for goal, _ in worst))
    return "; ".join([*notes, next((f"{remedy}, or {move}" for remedy in remedies), move)])


def can_move(figure: Figure, key: Frame, body: int) -> bool:
    """Return whether a joint that a keyframe leaves free moves a body."""
    return bool(_joints(figure, key, body, is_fixed=False))


def immovable(figure: Figure, body: int) -> str:
    """Return the complaint on a body of which a keyframe fixes every joint, and what to do."""
    names = ", ".join(figure.links[link].name for link in reversed(chain(figure, body)))
    return f"cannot move: every joint on the way to it is given ({names}); leave one of them free"


def _at_limits(figure: Figure, qpos: Array) -> set[int]:
    """Return the links whose joints are at the end of their ranges in a pose (nq,)."""
    limits = JointRange(joint_ranges(figure))
    excess = limits.beyond(Samples.still(figure, figure.to_state(qpos[None])))[:, 0]
    return {joint.link for joint, over in zip(limits.joints, excess, strict=True) if over > -AT_LIMIT[joint.kind]}


def _note(figure: Figure, key: Frame, goal: Goal, error: float, stopped: Container[int], goals: Sequence[Goal]) -> str:
    body = goal.bodies(figure.model)[0]
    kind = _kind(figure, goal)
    if not can_move(figure, key, body):
        return f"{kind} '{goal.name}' {immovable(figure, body)}"
    joints = ", ".join(
        figure.links[link].name + (" (at the end of its range)" if link in stopped else "")
        for link in _joints(figure, key, body, is_fixed=False)
    )
    nearest = f"off in the nearest pose, with {joints} free"
    if not isinstance(goal, PointGoal):
        return f"no pose found that turns body '{goal.name}' so: {np.degrees(error):.3g} degrees {nearest}"
    where = ", ".join("free" if np.isnan(axis) else f"{axis:g}" for axis in goal.spots[0])
    is_turned = any(isinstance(other, BodyGoal) and other.bodies(figure.model)[0] == body for other in goals)
    turned = f" and body '{figure.model.body(body).name}' turned as specified" if is_turned else ""
    return f"no pose found that puts {kind} '{goal.name}' at ({where}): {_metres(error)} {nearest}{turned}"


def _remedy(figure: Figure, key: Frame, row: KeyframeTable, goal: Goal) -> str:
    """Return which joints on the way to a goal's body are fixed, by what, and how to free one; "" if none is."""
    keys: list[str] = []
    named: list[str] = []
    inherited: list[str] = []
    for link in _joints(figure, key, goal.bodies(figure.model)[0], is_fixed=True):
        is_whole = bool(key.fixed[figure.links[link].columns].all())
        entry, is_named = _entry(figure, key, row, link, goal)
        name = figure.links[link].name if is_whole else entry
        if is_named or row.others != "free":  # otherwise an equality constraint determines it
            keys.append(entry)
            (named if is_named else inherited).append(name)
    causes = [f"the keyframe fixes {', '.join(named)}"] if named else []
    causes += [f'others = "{row.others}" fixes {", ".join(inherited)}'] if inherited else []
    return f'{" and ".join(causes)}: write {keys[0]} = "free"' if keys else ""


def _entry(figure: Figure, key: Frame, row: KeyframeTable, link: int, goal: Goal) -> tuple[str, bool]:
    """Return the entry of a keyframe that frees a joint for a goal, and whether the keyframe names it."""
    root, joint = figure.root, figure.links[link]
    if joint.kind is not JointKind.FREE:
        return f"joints.{joint.name}", joint.name in row.joints
    is_root = root is not None and not root.is_ambiguous and root.link == link
    table = row.root if is_root else row.roots.get(joint.name)
    is_placed = bool(key.fixed[joint.qpos : joint.qpos + 3].any())
    part = "position" if is_placed and isinstance(goal, PointGoal) else "rotation"
    part = part if key.fixed[joint.qpos + 3 : joint.qpos + 7].any() else "position"
    return (
        f"{'root' if is_root else f'roots.{joint.name}'}.{part}",
        table is not None and part in table.model_fields_set,
    )


def _joints(figure: Figure, key: Frame, body: int, *, is_fixed: bool) -> list[int]:
    """Return the links from the root to a body of which a keyframe fixes an entry, or leaves one free."""
    links = reversed(chain(figure, body))
    masks = [(link, key.fixed[figure.links[link].columns]) for link in links]
    return [link for link, mask in masks if (mask.any() if is_fixed else not mask.all())]


def _kind(figure: Figure, goal: Goal) -> str:
    model, named = figure.model, mujoco.mjtObj
    if isinstance(goal, BodyGoal):
        return "body"
    if mujoco.mj_name2id(model, int(named.mjOBJ_SITE), goal.name) >= 0:
        return "site"
    return "body" if mujoco.mj_name2id(model, int(named.mjOBJ_BODY), goal.name) >= 0 else "point"


def _metres(length: float) -> str:
    return f"{length:.3g} m" if length >= 0.01 else f"{1000 * length:.2g} mm"
