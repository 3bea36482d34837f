"""Second stage of loading: keyframe tables become keyframes of a figure, posed where they leave joints free."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind, Link, quaternion_columns
from dynsplines.solver.figure.root import Root, sliding_joints
from dynsplines.solver.penalty import couplings
from dynsplines.solver.penalty.joints.equality import Coupling, in_order
from dynsplines.solver.posing import Goal, rest_rotation
from dynsplines.solver.surface.points import Point
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError, unknown
from .parse import Parsed
from .posing import notes
from .posing.placement import goals_of, released_links, with_pose
from .posing.places import Places, roots_by_name, sole_points
from .posing.standing_feet import Stander
from .table import ROTATION, ClipTable, KeyframeTable, RootTable, RotationTable, SceneTable

FREE = RootTable(position="free", rotation="free")


def pose(source: Parsed, figure: Figure, base: Callable[[float], Array] | None = None) -> tuple[list[Frame], list[str]]:
    """Return the keyframes of a clip, and a line for each keyframe with unreachable positions, whose pose is as near as
    possible.

    Args:
        base: Returns qpos (nq,) at a time [s], for unspecified degrees of freedom of keyframes that edit a recording.

    Raises:
        UserError: For tables that do not fit the figure.
    """
    rows = _with_objects(source.table)
    places = [f"{source.where}: {label}" for label in source.labels]
    goals_by_key = _goals(figure, rows, places)
    loose = [released_links(figure, row, goals) for goals, row in zip(goals_by_key, rows, strict=True)]
    keys: list[Frame] = []
    for row, here, free in zip(rows, places, loose, strict=True):
        if row.others == "previous" and not keys:
            raise UserError(f"{here}: others = 'previous' has no keyframe before it")
        keys.append(_base_on(key_of(figure, row, keys[-1] if keys else None, free, here), base))
    stander, missed = Stander.of(source, figure), list[str]()
    if any(goals_by_key):
        for k, (row, goals, here) in enumerate(zip(rows, goals_by_key, places, strict=True)):
            before = keys[k - 1] if k else None  # "previous" uses posed keyframes
            partial = key_of(figure, row, before, loose[k], here)
            keys[k] = _base_on(partial, base)
            if goals:
                among, index = (keys, k) if base is None else ([_later(keys[k], base, by) for by in (-1, 0, 1)], 1)
                unposed = among[index]
                keys[k], nearest, goals = with_pose(stander, among, index, goals, soles_of(figure, among), here)
                if not nearest.is_met:
                    missed.append(f"{source.labels[k]}: {notes.on_unmet(figure, unposed, row, goals, nearest)}")
                keys[k] = _base_on(keys[k], base)
    return keys if base is not None else stander.pose_feet(keys), missed


def _base_on(key: Frame, base: Callable[[float], Array] | None) -> Frame:
    """Return a keyframe with its unspecified degrees of freedom as in the recording that it edits."""
    if base is None:
        return key
    return Frame(key.time, np.where(key.fixed, key.state, base(key.time)), key.fixed, ~key.fixed)


def _later(key: Frame, base: Callable[[float], Array], by: int) -> Frame:
    """Return a keyframe with its specified degrees of freedom only, or the pose of the recording `by` seconds later."""
    return Frame.key(key.time + by, base(key.time)) if by else Frame(key.time, key.state, key.fixed)


def _goals(figure: Figure, rows: Sequence[KeyframeTable], where: Sequence[str]) -> list[list[Goal]]:
    """Return the goals of the pose of each keyframe. Feet are inferred from complete keyframes."""
    places = Places(figure)
    if any(row.sites or row.bodies for row in rows):
        keys: list[Frame] = []
        for row, here in zip(rows, where, strict=True):
            keys.append(key_of(figure, row, keys[-1] if keys else None, (), here))
        places = Places(figure, soles_of(figure, keys))
    return [goals_of(places, row, here) for row, here in zip(rows, where, strict=True)]


def soles_of(figure: Figure, keys: Sequence[Frame]) -> tuple[Point, ...]:
    """Return the sole points of a figure in its complete keyframes of qpos (nq,)."""
    whole = [key.state for key in keys if key.is_key]
    return sole_points(figure, np.reshape(whole, (-1, figure.width)))


def key_of(figure: Figure, row: KeyframeTable, before: Frame | None, loose: Sequence[int], where: str) -> Frame:
    """Return the qpos and mask of a keyframe; unspecified degrees of freedom are free, at rest, or as in `before`. The
    joints of the links `loose` are free whatever `others` is."""
    qpos = np.array(figure.model.qpos0)
    fixed = np.full(figure.width, row.others == "rest" or row.model_key is not None)
    if row.model_key is not None:
        qpos = figure.to_qpos(figure.to_state(figure.model.key(row.model_key).qpos))  # unit quaternions
    if row.others == "previous" and before is not None:
        qpos, fixed = np.array(before.state), np.array(before.fixed)
    for i in loose:
        fixed[figure.links[i].columns] = False
    named = {link.name: link for link in figure.links[1:]}
    for name, value in row.joints.items():
        if name not in named:
            raise UserError(f"{where}: {unknown('joint', name, named)}")
        if value == "free":
            fixed[quaternion_columns(named[name]) or named[name].qpos] = False
        else:
            _set_joint(qpos, fixed, named[name], value, f"{where}: joints.{name}")
    _set_roots(figure, qpos, fixed, row, where)
    follow(figure, qpos, fixed, lambda name: name in row.joints)
    return Frame.key(row.time, qpos, fixed)


def _set_roots(figure: Figure, qpos: Array, fixed: Mask, row: KeyframeTable, where: str) -> None:
    """Set qpos (nq,) and mask (nq,) to a keyframe's `root` and `roots`, in place."""
    if row.root.model_fields_set:
        _set_root(figure, _main_root(figure, where), qpos, fixed, row.root)
    if not row.roots:
        return
    named = roots_by_name(figure)
    for name, table in row.roots.items():
        if name not in named:
            free = [link.name for link in figure.links[1:] if link.kind is JointKind.FREE]
            raise UserError(f"{where}: roots: {unknown('free joint', name, free)}")
        _set_root(figure, named[name], qpos, fixed, table)


def _main_root(figure: Figure, where: str) -> Root:
    """Return the root that `root` places; raises UserError if the figure has none, or several."""
    root = figure.root
    if root is None:
        joints = [figure.links[joint + 1].name for joint in sliding_joints(figure.model)]
        listed = ", ".join(f"joints.{name}" for name in joints) or "its joints, by joints.NAME"
        raise UserError(f"{where}: root: the figure has no free joint, so no root to place; specify {listed}")
    names = {tree.body: name for name, tree in reversed(roots_by_name(figure).items())}
    if root.is_ambiguous:
        several = ", ".join(f"roots.{names[body]}" for body in (root.body, *root.rivals))
        raise UserError(f"{where}: root: the model has several figures; specify which: {several}")
    called = next((link for link in figure.links[1:] if link.kind is JointKind.FREE and link.name == "root"), None)
    if called is not None and called.body != root.body:
        raise UserError(
            f"{where}: root: the joint 'root' carries '{figure.model.body(called.body).name}', the figure's root "
            f"carries '{figure.model.body(root.body).name}'; specify roots.root or roots.{names[root.body]}"
        )
    return root


def _set_root(figure: Figure, root: Root, qpos: Array, fixed: Mask, table: RootTable) -> None:
    """Set a free joint's position, axis by axis, and its rotation from a table."""
    start = figure.links[root.link].qpos
    if "position" in table.model_fields_set:
        axes = ("free",) * 3 if table.position == "free" else table.position
        for i, value in enumerate(axes):
            fixed[start + i] = value != "free"
            if value != "free":
                qpos[start + i] = float(value)
    if "rotation" in table.model_fields_set:
        fixed[start + 3 : start + 7] = table.rotation != "free"
        if table.rotation != "free":
            qpos[start + 3 : start + 7] = table.rotation.quaternion(rest_rotation(figure.model, root.body))


def _set_joint(qpos: Array, fixed: Mask, link: Link, value: RotationTable | float, where: str) -> None:
    columns = quaternion_columns(link)
    if columns is None:
        if isinstance(value, RotationTable):
            unit = "degrees" if link.kind is JointKind.HINGE else "metres"
            raise UserError(f"{where}: a {link.kind.name.lower()} joint takes a number ({unit}), not a rotation")
        qpos[link.qpos] = np.radians(value) if link.kind is JointKind.HINGE else value
        fixed[link.qpos] = True
        return
    if link.kind is JointKind.FREE:
        raise UserError(f"{where}: a free joint is placed by root.position and root.rotation, or by roots.{link.name}")
    if not isinstance(value, RotationTable):
        raise UserError(f"{where}: a ball joint takes a rotation, {ROTATION}, not a number")
    if value.heading is not None:
        raise UserError(f"{where}: a heading is of the root, of bodies and of obstacles; a joint turns in its parent")
    qpos[columns] = value.quaternion()
    fixed[columns] = True


def follow(figure: Figure, qpos: Array, fixed: Mask, is_named: Callable[[str], bool]) -> None:
    """Set the followers of coupled joints in a keyframe, qpos and mask, in place.

    A joint that the keyframe names is unchanged. If it names the follower and not the driver, the driver is set.
    """
    names = {link.qpos: link.name for link in figure.links[1:]}
    for coupling in in_order(couplings(figure)):
        driver = coupling.driver
        if not is_named(names[coupling.follower]):
            if driver < 0 or fixed[driver]:
                qpos[coupling.follower] = coupling.follow(qpos[driver] if driver >= 0 else np.zeros(()))
                fixed[coupling.follower] = True
        elif driver >= 0 and not is_named(names[driver]) and fixed[coupling.follower]:
            back = _driver(coupling, float(qpos[coupling.follower]))
            if back is not None:
                qpos[driver], fixed[driver] = back, True


def _driver(coupling: Coupling, follower: float) -> float | None:
    """Return the driver's value for a follower's value; None unless the relation is linear."""
    a = coupling.coefficients
    if a[1] == 0 or np.any(a[2:]):
        return None
    return coupling.rest[1] + (follower - coupling.rest[0] - float(a[0])) / float(a[1])


def _objects(scene: SceneTable) -> tuple[str, ...]:
    """Return the names of the bodies that a scene's tables define."""
    parts = (*scene.box, *scene.sphere, *scene.capsule, *scene.cylinder)
    return tuple(dict.fromkeys(part.body for part in parts if part.body is not None))


def _with_objects(table: ClipTable) -> list[KeyframeTable]:
    """Return a clip's keyframes with the positions of objects that nothing has moved since the previous keyframe.

    The keyframes before the first specified position have this position. An object that a [[grasp]] moves in between is
    free, independent of `others`. In a clip that follows a recording, the recording places them.
    """
    rows = list(table.keyframe)
    for name in _objects(table.scene) if table.recording is None else ():
        time, place = rows[0].time, _first(table, name)
        for k, row in enumerate(rows):
            if name in row.roots:
                place = row.roots[name]
            else:
                place = FREE if _is_carried(table, name, time, row.time) else place
                rows[k] = row.model_copy(update={"roots": row.roots | {name: place}})
            time = row.time
    return rows


def _first(table: ClipTable, name: str) -> RootTable:
    """Return the initial position of an object: that of the first keyframe that places it, unless it is held before."""
    row = next((row for row in table.keyframe if name in row.roots), None)
    if row is None or _is_carried(table, name, table.keyframe[0].time, row.time):
        return FREE
    return row.roots[name]


def _is_carried(table: ClipTable, name: str, first: float, last: float) -> bool:
    """Return whether an object is held at any time of an interval."""
    grasps = (grasp for grasp in table.grasp if grasp.body == name)
    return any(max(grasp.start, first) < min(grasp.end, last) - ROUNDING for grasp in grasps)
