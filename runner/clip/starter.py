"""A starting clip for any model: its keyframes, or one or two poses, and every available name in comments."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, FigureError, JointKind, Link, quaternion_columns
from dynsplines.solver.figure.forward import boxes, kinematics
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import closures, couplings
from dynsplines.solver.surface.points import Point, body_points, bottoms_of, places_of
from dynsplines.solver.surface.touch import TOUCHING, counts_all, movers
from dynsplines.solver.surface.touch import solids as solids_of

from ..errors import UserError, words_of
from ..scene.compose import compose, figure_spec
from ..scene.configuration import first_wrong, posed
from ..scene.model_notes import vertical_notes
from ..scene.urdf import fixed_base
from ..system.mujoco_warnings import quietly
from .load import compiled_keys
from .pose import follow
from .posing.equalities import Equalities, in_words
from .posing.places import Places, posable_sites, rest_within_ranges, sole_points
from .posing.pose_report import floor_height, lifts, lowest_point, violations
from .table import KEY, KeyframeTable, RotationTable
from .text import keyframe_tables, rotation, tables, written

APART = 0.5  # [s] distance of keyframes if the model's times do not rise
STRAIGHT = 0.99  # [1] component of a slide's direction from which a comment names the axis
REPORTED = 5e-4  # [m] displacement above which a raised pose is reported
MOVED = np.radians(40)  # [rad] rotation of the one joint that moves
ROOM = 0.6  # [1] maximum motion of a joint, relative to the distance to its bound
FLEXED = 0.35  # [1] maximum motion of a slide, relative to the figure's size
DIGITS = 6  # decimal places of degrees and metres
WIDE = 110  # characters per line of comments
AT_REST = "Positions in the first keyframe, in metres. Such a line in a keyframe is a target position:"
ALL_COUNT = "Nothing of this model collides (contype, conaffinity), so all of its geoms are checked for collisions."
NO_FEET = "none were found; add sites with names such as left_heel and left_toe"

PENALTIES = """\
# Soft constraints: those that fit the figure are enabled. Each can have another weight; weight = 0 disables it.
#
# [[penalty]]
# kind = "collision"                # keeps the figure out of the ground and obstacles
# points = ["a_site", "another"]    # other sole points
# margin = 0.01                     # distance to keep, in metres
#
# [[penalty]]
# kind = "limits"                   # keeps joints within their ranges
# weight = {range = 10}
#
# [[penalty]]
# kind = "torque"                   # keeps joint torques small
# weight = 0.1
#
# [scene]
# step = {x = 1.0, height = 0.2}    # or [[scene.box]], [[scene.sphere]], [[scene.capsule]], [[scene.cylinder]]
"""


def starter(source: str, target: Path, report: Callable[[str], None] = lambda _: None) -> str:
    """Return the TOML text of a clip for a shipped figure or an MJCF file.

    Args:
        source: The name or path of the figure.
        target: The path to which the text will be written.
        report: Receives a note for each violation of the keyframes, and for each change. The text contains them too.

    Raises:
        UserError: The figure cannot be loaded.
    """
    with quietly():
        spec = figure_spec(source)
    times, poses = _model_keys(spec, Path(source).name)
    names, model_poses = [key.name for key in spec.keys], poses
    scene = compose(spec)
    try:
        figure = Figure(scene.model())
    except (FigureError, ValueError) as error:
        raise UserError(f"{Path(source).name}: {words_of(error)}") from None
    soles = sole_points(figure, poses)
    has_keys = bool(len(poses))
    equalities = Equalities(figure)
    notes = [*([line] if (line := fixed_base(source, figure.model)) else []), *vertical_notes(figure.model)]
    if not has_keys:
        times, poses = np.zeros(1), rest_within_ranges(figure)[None]
    given_poses, poses = poses, np.array([_settled(figure, qpos) for qpos in poses])
    for k, qpos in enumerate(poses):
        poses[k], lines = _closed(figure, qpos, equalities)
        notes += [f"keyframe {k + 1}: {line}" for line in lines]
    settled = poses
    lifted = [_on_floor(figure, qpos, lowers=bool(soles) and not has_keys) for qpos in poses]
    poses = np.array(
        [  # bodies attached to the world or a mocap body are not lifted off it
            qpos if equalities.open(up) and not equalities.open(qpos) else up
            for qpos, up in zip(poses, lifted, strict=True)
        ]
    )
    for k, qpos in enumerate(poses):
        notes += [f"keyframe {k + 1}: {line}" for line in violations(figure, qpos, equalities)]
    for note in notes:
        report(note)
    frames = [Frame.key(t, q) for t, q in zip(times, poses, strict=True)]
    rows = [_without_followers(figure, row) for row in keyframe_tables(figure, frames)]
    for k in range(len(model_poses)):
        if names[k] and np.array_equal(poses[k], model_poses[k]):
            rows[k] = KeyframeTable.unchecked(time=rows[k].time, others=KEY + names[k])
    if len(poses) == 1:
        rows += _moved(figure, poses[0], float(times[0]))
    head = {"figure": source if source in models.figures() else _path(source, target), "fps": 30}
    blocks = [
        _head(
            source,
            has_keys,
            len(poses),
            float(max((poses - settled).flat, key=abs)),
            float(np.abs(settled - given_poses).max()),
        ),
        written(head).rstrip("\n"),
        *([_comment(notes)] if notes else []),
        _named(figure, poses[0], soles),
        PENALTIES.rstrip("\n"),
        "\n\n".join(written({"keyframe": [_rounded(tables(row))]}).strip("\n") for row in rows),
    ]
    return "\n\n".join(blocks) + "\n"


def _model_keys(spec: mujoco.MjSpec, where: str) -> tuple[Array, Array]:
    """Return times (K,) [s] and qpos (K, nq) of a model's keys. If the times do not rise, they are half a second
    apart."""
    model, times, poses = compiled_keys(spec, where)
    if not model.njnt:
        raise UserError(f"{where}: the model has no joints: nothing can move")
    if wrong := first_wrong(model, times, poses):
        raise UserError(f"{where}: keyframe {wrong[0] + 1}: {wrong[1]}")
    if times.size and not np.all(np.diff(times) >= 1e-3):
        times = np.array([APART * k for k in range(times.size)])
    return times, poses


def _path(source: str, target: Path) -> str:
    """Return a model's path relative to the clip's folder."""
    return Path(os.path.relpath(Path(source).resolve(), target.resolve().parent)).as_posix()


def _closed(figure: Figure, qpos: Array, equalities: Equalities) -> tuple[Array, list[str]]:
    """Return a pose (nq,) moved onto the model's equality constraints if possible, with notes."""
    gaps = equalities.open(qpos)
    if not gaps:
        return qpos, []
    closed = equalities.closed(qpos)
    if closed is None:
        return qpos, ["no pose within the joints' ranges was found that meets the model's equality constraints"]
    away = np.zeros(figure.model.nv)
    mujoco.mj_differentiatePos(figure.model, away, 1.0, qpos, closed)
    link = max(figure.links[1:], key=lambda candidate: float(np.abs(away[candidate.dofs]).max()))
    most = float(np.linalg.norm(away[link.dofs]))
    size = in_words(most, "m") if link.kind is JointKind.SLIDE else in_words(np.degrees(most), "degrees")
    was = str(gaps[0]).replace("open by", "was open by")
    return closed, [f"moved onto the model's equality constraints, '{link.name}' by {size}: {was}"]


def _settled(figure: Figure, qpos: Array) -> Array:
    """Return a pose (nq,) with coupled joints at the values that their drivers determine."""
    out = np.array(qpos)
    follow(figure, out, np.ones(figure.width, bool), lambda _: False)
    return out


def _without_followers(figure: Figure, row: KeyframeTable) -> KeyframeTable:
    """Return a keyframe without coupled joints, so that they stay consistent when it is edited."""
    names = {coupling.name for coupling in couplings(figure)}
    return row.changed(joints={name: value for name, value in row.joints.items() if name not in names})


def _on_floor(figure: Figure, qpos: Array, *, lowers: bool) -> Array:
    """Return a pose (nq,) with free parts raised out of the floor, or with `lowers` also lowered onto it, and on top
    of their pedestal."""
    out, floor = np.array(qpos), floor_height(figure.model)
    for root, column, up in lifts(figure):
        low = lowest_point(figure, out, root)
        if low is None:
            continue
        if floor is not None:
            out[column] += up * (floor - low if lowers else max(floor - low, 0.0))
        if root in figure.tables.free_links:
            _mount(figure, out, root)
    return out


def _mount(figure: Figure, qpos: Array, root: int) -> None:
    """Raise a link's subtree to the top of the obstacle that it overlaps: its pedestal."""
    model = figure.model
    endless = (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD))
    solids = [geom for geom in solids_of(model) if model.geom_type[geom] not in endless]
    geoms = [geom for geom in movers(model) if figure.tables.path[figure.body_link[model.geom_bodyid[geom]], root]]
    for _ in solids:
        data = kinematics(model, qpos)
        under = [s for s in solids if any(_depth(model, data, geom, s) > TOUCHING for geom in geoms)]
        low = lowest_point(figure, qpos, root)
        if not under or low is None:
            return
        centre, reach = boxes(model, data, np.array(under))
        qpos[figure.links[root].qpos + 2] += (centre + reach)[:, 2].max() - low


def _depth(model: mujoco.MjModel, data: mujoco.MjData, geom: int, solid: int) -> float:
    """Return the penetration depth of one geom in another [m]."""
    return -mujoco.mj_geomDistance(model, data, geom, solid, TOUCHING, None)


def _moved(figure: Figure, qpos: Array, start: float) -> list[KeyframeTable]:
    """Return two more keyframes: one joint moved, and moved back."""
    link, value = _example_joint(figure, qpos)
    back = _joint(link, qpos)
    if isinstance(back, RotationTable):
        there: RotationTable | float = RotationTable(rotvec=(0.0, float(_short(float(np.degrees(value)))), 0.0))
    else:
        there = float(np.degrees(value)) if link.kind is JointKind.HINGE else value
        rounded = round(there, 0 if link.kind is JointKind.HINGE else 3)
        there = rounded if min(back, there) < rounded < max(back, there) else there
    loops = [figure.links[i] for i in sorted(_loops(figure))]
    loops = loops if any(loop is link for loop in loops) else []  # the search closes the loops again
    free = {loop.name: "free" for loop in loops if loop is not link}
    closed = {loop.name: _joint(loop, qpos) for loop in loops}
    return [
        KeyframeTable.unchecked(time=start + APART, joints={link.name: there, **free}, others="previous"),
        KeyframeTable.unchecked(time=start + 2 * APART, joints={link.name: back, **closed}, others="previous"),
    ]


def _joint(link: Link, qpos: Array) -> RotationTable | float:
    columns = quaternion_columns(link)
    if columns is not None:
        return rotation(qpos[columns])
    return float(np.degrees(qpos[link.qpos])) if link.kind is JointKind.HINGE else float(qpos[link.qpos])


def _loops(figure: Figure) -> set[int]:
    path, links = figure.tables.path > 0, set()
    for closure in closures(figure):
        links |= set(np.flatnonzero(path[closure.point.link] != path[closure.link]).tolist())
    return {i for i in links if figure.links[i].kind is not JointKind.FREE}


def _example_joint(figure: Figure, qpos: Array) -> tuple[Link, float]:
    """Return the joint whose motion is most visible, except those that carry half the figure, and its target value."""
    model = figure.model
    after = {coupling.follower for coupling in couplings(figure)}
    loops = _loops(figure)
    size = _size(figure, qpos)
    choices: list[tuple[int, float]] = []
    poses = [qpos]
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind is JointKind.FREE or link.qpos in after:
            continue
        for value in _goals(figure, link, qpos, size):
            moved = np.array(qpos)
            columns = quaternion_columns(link)
            if columns is None:
                moved[link.qpos] = value
            else:
                moved[columns] = [np.cos(value / 2), 0, np.sin(value / 2), 0]
            choices.append((i, value))
            poses.append(moved)
    if not choices:
        name = figure.links[1].name
        raise UserError(
            f"'{name}' is the only moving body: a free body needs its own keyframes, "
            "as in `dynsplines clips --show tumble`"
        )
    samples = Samples.still(figure, figure.to_state(np.array(poses)))
    lowest = bottoms_of(body_points(figure), samples).min(axis=0, initial=np.inf)
    worth = []
    for (i, _), pose, low in zip(choices, poses[1:], lowest[1:], strict=True):
        heavy, sunk = figure.tables.path[:, i].mean() > 0.5, low < lowest[0] - 1e-3
        share = (0.1 if heavy else 1.0) * (0.2 if sunk else 1.0) * (0.1 if i in loops else 1.0)
        worth.append(share * _shift(model, qpos, pose))
    i, value = choices[int(np.argmax(np.array(worth) > 0.999 * max(worth)))]
    return figure.links[i], value


def _goals(figure: Figure, link: Link, qpos: Array, size: float) -> list[float]:
    """Return possible values of a joint [rad or m], in either direction."""
    if link.kind is JointKind.BALL:
        high = float(figure.model.jnt_range[link.joint].max()) if figure.model.jnt_limited[link.joint] else np.pi
        return [min(MOVED, ROOM * high), -min(MOVED, ROOM * high)]
    here, most = float(qpos[link.qpos]), MOVED if link.kind is JointKind.HINGE else FLEXED * size
    low, high = (here - most / ROOM, here + most / ROOM)
    if figure.model.jnt_limited[link.joint]:
        low, high = (float(bound) for bound in figure.model.jnt_range[link.joint])
    steps = [min(most, ROOM * max(high - here, 0.0)), -min(most, ROOM * max(here - low, 0.0))]
    return [here + step for step in steps if step != 0]


def _shift(model: mujoco.MjModel, before: Array, after: Array) -> float:
    """Return the largest displacement of a geom between two poses [m]."""
    places = [np.concatenate([data.geom_xpos, data.xipos]) for data in posed(model, np.stack([before, after]))]
    return float(np.linalg.norm(places[1] - places[0], axis=1).max())


def _size(figure: Figure, qpos: Array) -> float:
    """Return the extent of a figure [m]."""
    data = kinematics(figure.model, qpos)
    moving = figure.body_link > 0
    return float(np.linalg.norm(np.ptp(data.xipos[moving], axis=0))) or 0.1


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: (entry if key == "rotvec" else _rounded(entry)) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_rounded(entry) for entry in value]
    return _short(value) if isinstance(value, float) else value


def _short(value: float) -> float | int:
    number = round(value, DIGITS) + 0.0
    return int(number) if number == int(number) else number


def _head(source: str, has_keyframes: bool, count: int, raised: float, settled: float) -> str:
    name = Path(source).name
    content = f"its {count} keyframe{'s' * (count > 1)}" if has_keyframes else "its rest pose"
    more = "" if count > 1 else ", and one joint moved"
    up = "\n"
    if abs(raised) >= REPORTED:
        verb = "Raised" if raised > 0 else "Lowered"
        where = "out of" if raised > 0 else "onto"
        up = f" {verb} by up to {1000 * abs(raised):.1f} mm, {where} the floor or an obstacle.\n"
    off = "# Joints that follow others have the values that these determine, not those of the model's keyframes.\n"
    return (
        f"# A clip for {name}: {content}{more}.{up}{off if has_keyframes and settled >= REPORTED else ''}"
        "# Units are degrees, metres and seconds. The solver chooses joints that a keyframe does not name. To specify\n"
        '# them, add others = "previous" (as in the previous keyframe), "rest" or "key:NAME" (a <key> of the model).\n'
        "# To see the motion: dynsplines render THIS_FILE"
    )


def _comment(notes: Sequence[str]) -> str:
    return "\n".join(f"# {line}" for note in notes for line in textwrap.wrap(f"NOTE: {note}", WIDE))


def _named(figure: Figure, qpos: Array, soles: Sequence[Point]) -> str:
    model = figure.model
    lines = ["# Joints, by their keys in keyframes:"]
    for link in figure.links[1:]:
        lines.append(f"#   {_joint_line(figure, link)}")
    if figure.root is not None and not figure.root.is_free:
        joints = ", ".join(figure.links[i].name for i in figure.root.links)
        lines.append(
            f"#   {'root.position, .rotation':40} of '{model.body(figure.root.body).name}', which sets {joints}"
        )
    bodies = [model.body(i).name for i in range(1, model.nbody) if model.body(i).name]
    lines += _list("Bodies, for bodies.NAME = {flat = true}, a rotation or {position = [x, y, z]}", bodies)
    ground = "Sole points"
    lines += _list(ground, list(dict.fromkeys(point.name for point in soles))) or [f"# {ground}: {NO_FEET}"]
    lines += _list(
        "Joints that follow others (equality constraints), so that keyframes need not name them",
        [c.name for c in couplings(figure)],
    )
    lines += [f"# {ALL_COUNT}"] if counts_all(model) else []
    lines += _placed(figure, qpos, soles)
    return "\n".join(lines)


def _placed(figure: Figure, qpos: Array, soles: Sequence[Point]) -> list[str]:
    """Return comments with the positions of feet, sites and ends of other limbs in a pose (nq,)."""
    places = Places(figure, soles)
    names = [*(point.name for point in soles), *posable_sites(figure.model)]
    points = [point for name in dict.fromkeys(names) if (point := places.point(name)) is not None and point.link]
    positions = [(f"sites.{_key(p.name)}", "{}", p) for p in points]
    busy = {point.link for point in points}
    for body in _ends(figure):
        name, link = str(figure.model.body(body).name), int(figure.body_link[body])
        if name and link not in busy:
            positions.append(
                (f"bodies.{_key(name)}", "{{position = {}}}", Point(name, *figure.point_on_link(body, np.zeros(3))))
            )
    if not positions:
        return []
    lines = [f"# {AT_REST}"]
    centres, _ = places_of([point for *_, point in positions], Samples.still(figure, figure.to_state(qpos[None])))
    for (key, form, point), place in zip(positions, centres[:, :, 0].T, strict=True):
        thick = f"  # the middle of a ball of radius {point.radius:.3g} m" if point.radius else ""
        where = ", ".join(f"{round(float(x), 4) + 0.0:g}" for x in place)
        lines.append(f"#   {key} = {form.format(f'[{where}]')}{thick}")
    return lines


def _ends(figure: Figure) -> list[int]:
    """Return the last body of every limb: hands, heads, tips of fingers."""
    carries = set(figure.tables.parents.tolist())
    return [link.body for i, link in enumerate(figure.links) if i and i not in carries]


def _joint_line(figure: Figure, link: Link) -> str:
    if link.kind is JointKind.FREE:
        main_root = figure.root
        is_root = main_root is not None and not main_root.is_ambiguous and figure.links[main_root.link] is link
        table = "root" if is_root else f"roots.{_key(link.name)}"
        return f"{table + '.position, .rotation':40} free joint '{link.name}': metres; a rotation"
    name, limited = f"joints.{_key(link.name)}", bool(figure.model.jnt_limited[link.joint])
    low, high = (float(bound) for bound in figure.model.jnt_range[link.joint])
    if link.kind is JointKind.SLIDE:
        return f"{name:40} slide, metres{_along(link)}" + (f", {low:g} to {high:g}" if limited else "")
    low, high = np.degrees([low, high])
    if link.kind is JointKind.HINGE:
        return f"{name:40} hinge, degrees" + (f", {low:.4g} to {high:.4g}" if limited else "")
    return f"{name:40} ball, a rotation such as {{rotvec = [0, 30, 0]}}" + (f", up to {high:.4g}°" if limited else "")


def _along(link: Link) -> str:
    """Return the world axis of a slide at rest, in words; "" for an oblique axis."""
    direction = quat.rotated(link.turn, link.axis)
    axis = int(np.abs(direction).argmax())
    return f" along {'-' if direction[axis] < 0 else ''}{'xyz'[axis]}" if abs(direction[axis]) > STRAIGHT else ""


def _key(name: str) -> str:
    return written({name: 0}).rsplit(" = ", 1)[0].strip()


def _list(title: str, names: Iterable[str]) -> list[str]:
    names = list(names)
    if not names:
        return []
    return [f"# {title}:", *textwrap.wrap(", ".join(names), WIDE, initial_indent="#   ", subsequent_indent="#   ")]
