"""Notes on keyframes: unmet goals of poses, ambiguous roots, and whole turns that the motion omits.

Unmet goals are reported with their distance from the nearest pose, the fixed joints and a remedy. Rotations are
quaternions, so from one keyframe to the next a joint takes the shorter arc: a heading of 360 after 0 turns nothing, and
one of 270 after 0 turns back by 90°. Both are reported, with the additional keyframes that produce the turn.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from itertools import pairwise

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import JointRange, joint_ranges
from dynsplines.solver.posing import MET, BodyGoal, Goal, PointGoal, Posed

from ..table import KeyframeTable, RotationTable
from .places import roots_by_name

BESIDE = 0.1  # least reported error of a goal relative to the largest, as smaller ones result from the largest
# [rad, m] distance from the end of a joint's range up to which it is reported
AT_LIMIT = {JointKind.HINGE: np.radians(1), JointKind.BALL: np.radians(1), JointKind.SLIDE: 1e-3}
SAME = 1.0  # [degrees] tolerance of equal turns
STEP = 120.0  # [degrees] largest turn between recommended keyframes


def on_unmet(figure: Figure, key: Frame, row: KeyframeTable, goals: Sequence[Goal], nearest: Posed) -> str:
    """Return a note on the worst unmet goals of a keyframe, the worst first, and what to do.

    Args:
        key: The keyframe before it is posed.
        nearest: The nearest pose found.
    """
    least = max(MET, BESIDE * nearest.worst)
    errors = sorted(zip(nearest.missed.tolist(), goals, strict=True), key=lambda pair: -pair[0])
    worst = [(goal, error) for error, goal in errors if error > least][:3]
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
    names = ", ".join(figure.links[link].name for link in reversed(figure.chain(body)))
    return f"cannot move: every joint on the way to it is given ({names}); leave one of them free"


def _at_limits(figure: Figure, qpos: Array) -> set[int]:
    """Return the links whose joints are at the end of their ranges in a pose (nq,)."""
    limits = JointRange(joint_ranges(figure))
    excess = limits.beyond(Samples.of_qpos(figure, qpos))[:, 0]
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
    if not keys:
        return ""
    # free roots alone would let straight legs sink
    remedy = "omit others" if inherited else f'write {keys[0]} = "free"'
    return f"{' and '.join(causes)}: {remedy}"


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
    links = reversed(figure.chain(body))
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


def on_tables(figure: Figure, rows: Sequence[KeyframeTable], keys: Timeline) -> tuple[str, ...]:
    """Return the notes on a clip's keyframe tables, for its raw timeline."""
    return (*_ambiguities(figure, rows), *_lost_turns(figure, rows, keys), *_longer_turns(figure, rows, keys))


def _ambiguities(figure: Figure, rows: Sequence[KeyframeTable]) -> list[str]:
    """Return a note on a model in which several trees, or several free bodies, could be the figure's root."""
    root = figure.root
    if root is None or not root.rivals:
        return []
    names = {tree.body: name for name, tree in reversed(roots_by_name(figure).items())}
    main, others = names[root.body], ", ".join(f"'{names[body]}'" for body in root.rivals)
    if root.limbs:
        return [f"several figures of one size: the camera and flights are of '{main}', not of {others}"]
    if any(row.root.model_fields_set for row in rows):
        return [f"several free bodies: root is '{main}', the first in the model, not {others}"]
    return []


def _lost_turns(figure: Figure, rows: Sequence[KeyframeTable], keys: Timeline) -> list[str]:
    """Return a note on every rotation of a keyframe that the raw timeline does not reach by the turn specified."""
    names = list(dict.fromkeys(name for row in rows for name in _rotations(figure, row)))
    return [line for name in names for line in _notes(figure, name, rows, keys)]


def _longer_turns(figure: Figure, rows: Sequence[KeyframeTable], keys: Timeline) -> Iterator[str]:
    """Yield a note on every pair of keyframes between which a free body turns the longer way, unless they are written
    with this turn."""
    for i in figure.tables.free_links.tolist():
        columns = quaternion_columns(figure.links[i])
        assert columns is not None
        quaternions = figure.to_qpos(keys.states)[:, columns]
        for first, last in pairwise(np.flatnonzero(keys.fixed[:, columns].all(axis=1)).tolist()):
            cosine = float(quaternions[first] @ quaternions[last])
            if cosine >= 0:
                continue
            written = [
                _notation(table)
                for k in (first, last)
                for link, table in _rotations(figure, rows[k]).values()
                if link == i
            ]
            a, b = written if len(written) == 2 else (None, None)
            is_written = a is not None and b is not None and a[0] == b[0] and np.abs(a[1] - b[1]).max() > 180
            if not is_written:
                angle = np.degrees(2 * np.arccos(max(cosine, -1.0)))
                yield (
                    f"keyframe {last + 1} (t = {keys.times[last]:g} s): '{figure.links[i].name}' turns by {angle:.0f} "
                    f"degrees from keyframe {first + 1}, because this changes its speed less than {360 - angle:.0f} "
                    "degrees the other way; to choose the way, add a keyframe in between"
                )


def _rotations(figure: Figure, row: KeyframeTable) -> dict[str, tuple[int | None, RotationTable]]:
    """Return the rotations of a keyframe by key, with the link whose quaternion is set, None for a goal of a pose."""
    named = {link.name: i for i, link in enumerate(figure.links) if i}
    out: dict[str, tuple[int | None, RotationTable]] = {}
    roots = roots_by_name(figure) if row.roots else {}
    placed = [("root", figure.root, row.root)]
    placed += [(f"roots.{name}", roots.get(name), table) for name, table in row.roots.items()]
    for key, root, table in placed:
        if root is not None and isinstance(table.rotation, RotationTable):
            out[f"{key}.rotation"] = root.link, table.rotation
    for name, value in row.joints.items():
        if name in named and isinstance(value, RotationTable):
            out[f"joints.{name}"] = named[name], value
    for name, table in row.bodies.items():
        if _notation(table) is not None:
            out[f"bodies.{name}"] = None, table
    return out


def _notation(table: RotationTable) -> tuple[str, Array] | None:
    """Return the notation of a rotation, and its angles [degrees]; None for a quaternion, which has no whole turns."""
    if table.heading is not None and {"rotvec", "euler", "quat"}.isdisjoint(table.model_fields_set):
        return "heading", np.array([table.heading])
    if table.heading is None and table.rotvec is not None:
        return "rotvec", np.array(table.rotvec)
    if table.euler is not None:
        turned = [] if table.heading is None else [table.heading]
        return f"euler {table.order or 'xyz'}{' heading' * len(turned)}", np.array([*table.euler, *turned])
    return None


def _notes(figure: Figure, name: str, rows: Sequence[KeyframeTable], keys: Timeline) -> Iterator[str]:
    """Yield notes on omitted turns of one rotation, between the keyframes that specify it."""
    last: tuple[int, str | None, Array] | None = None  # no notation at rest, which matches all
    for k, row in enumerate(rows):
        link, table = _rotations(figure, row).get(name, (None, None))
        written = None if table is None else _notation(table)
        if table is None:
            if row.others == "rest":
                last = (k, None, np.zeros(1))
            elif row.model_key is not None:
                last = None
            continue
        if written is not None and last is not None and last[1] in (None, written[0]):
            first = np.broadcast_to(last[2], written[1].shape)
            line = _line(figure, name, link, (last[0], k), first, written[1], keys)
            if line is not None:
                yield line.format(k + 1, row.time, written[0].partition(" ")[0])
        last = None if written is None else (k, *written)


def _line(
    figure: Figure, name: str, link: int | None, pair: tuple[int, int], first: Array, last: Array, keys: Timeline
) -> str | None:
    """Return the note on omitted turns between two keyframes, with placeholders for the second one; None for none."""
    step = last - first
    size = float(np.linalg.norm(step) if name.startswith("joints") and step.size == 3 else np.abs(step).max())
    if size <= 180 + SAME:
        return None
    if link is not None and _is_made(figure, link, pair, size, keys):
        return None
    count = int(np.ceil(size / STEP - 1e-9))
    between = ", ".join(_text(first + step * i / count) for i in range(1, count))
    rest = float(np.abs((size + 180) % 360 - 180))
    comes = "nothing turns" if rest < SAME else f"it takes the shorter way, {rest:g} degrees"
    return (
        f"keyframe {{}} (t = {{:g}} s): {name}: {{}} {_text(last)} is {size:g} degrees from keyframe {pair[0] + 1}, "
        f"but {comes}; to turn {size:g} degrees, add keyframes in between, such as {between}"
    )


def _is_made(figure: Figure, link: int, pair: tuple[int, int], size: float, keys: Timeline) -> bool:
    """Return whether the raw timeline turns a link by an angle [degrees] between two keyframes, as in a spin."""
    columns, (first, last) = quaternion_columns(figure.links[link]), pair
    if columns is None or last >= len(keys.times):
        return False
    quaternions, turned = figure.to_qpos(keys.states[first : last + 1])[:, columns], 0.0
    for a, b in pairwise(quaternions):
        angle = float(np.degrees(np.linalg.norm(quat.rotation_vector(quat.product(quat.inverse(a), b)))))
        turned += angle if a @ b >= 0 else 360 - angle
    return abs(turned - size) < SAME


def _text(angles: Array) -> str:
    """Return angles [degrees] in the notation of clips."""
    listed = ", ".join(f"{angle:g}" for angle in np.round(angles, 3))
    return listed if angles.size == 1 else f"[{listed}]"
