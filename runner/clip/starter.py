"""A starting clip for any model: the pose of its first key, or its rest pose, and every available name in comments."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from dynsplines import models
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, JointKind, Link
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import kinematics
from dynsplines.solver.penalty import couplings
from dynsplines.solver.surface.points import Point, body_points, bottoms_of, hanging, places_of
from dynsplines.solver.surface.touch import counts_all, grounds
from dynsplines.solver.tolerances import NEGLIGIBLE

from ..errors import UserError, words_of
from ..scene.compose import compile_model, compose, figure_spec
from ..scene.configuration import first_wrong
from ..scene.model_notes import fixed_base, vertical_notes
from ..system.mujoco_warnings import quietly
from .pose import follow
from .posing.places import Places, posable_sites, rest_within_ranges, sole_points
from .table import KEY, KeyframeTable
from .text import keyframe_tables, tables, text_of

APART = 0.5  # [s] distance of the two keyframes
DIGITS = 6  # decimal places of degrees and metres
WIDE = 110  # characters per line of comments
AT_REST = "Positions in the first keyframe, in metres. Such a line in a keyframe is a target position:"
ALL_COUNT = "Nothing of this model collides (contype, conaffinity), so all of its geoms are checked for collisions."
NEXT = "# Add here what changes, such as a joint from the list above. Then add more keyframes."
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
        report: Receives notes on the model. The text contains them too.

    Raises:
        UserError: The figure cannot be loaded.
    """
    with quietly():
        spec = figure_spec(source)
    key = _first_key(spec, Path(source).name)
    scene = compose(spec)
    try:
        figure = Figure(scene.model())
    except ValueError as error:
        raise UserError(f"{Path(source).name}: {words_of(error)}") from None
    soles = sole_points(figure, np.zeros((0, figure.width)) if key is None else key[1][None])
    notes = [*([line] if (line := fixed_base(source, figure.model)) else []), *vertical_notes(figure.model)]
    for note in notes:
        report(note)
    coupled = _with_followers(figure, rest_within_ranges(figure) if key is None else key[1])
    pose = _on_floor(figure, coupled, lowers=bool(soles) and key is None)
    (table,) = keyframe_tables(figure, [Frame.key(0.0, pose)])
    first = _without_followers(figure, table)
    if key is not None and key[0] and np.array_equal(pose, key[1]):
        first = KeyframeTable.without_checks(time=0.0, others=KEY + key[0])
    rows = [first, KeyframeTable.without_checks(time=APART, others="previous")]
    head = {"figure": source if source in models.figures() else _path(source, target), "fps": 30}
    blocks = [
        _head(source, "its rest pose" if key is None else "its first key", float(max((pose - coupled).flat, key=abs))),
        text_of(head).rstrip("\n"),
        *([_comment(notes)] if notes else []),
        _name_lines(figure, pose, soles),
        PENALTIES.rstrip("\n"),
        "\n\n".join(text_of({"keyframe": [_round(tables(row))]}).strip("\n") for row in rows),
        NEXT,
    ]
    return "\n\n".join(blocks) + "\n"


def _first_key(spec: mujoco.MjSpec, where: str) -> tuple[str, Array] | None:
    """Return the name and the pose (nq,) of the first key of a model; None without keys."""
    written = [np.array(key.qpos) for key in spec.keys[:1]]  # compiling changes them
    model = compile_model(spec, where)
    if not model.njnt:
        raise UserError(f"{where}: the model has no joints: nothing can move")
    if not written:
        return None
    qpos = written[0] if written[0].size else np.array(model.qpos0)
    if qpos.size != model.nq:
        raise UserError(f"{where}: qpos of its first key has {qpos.size} numbers, not the figure's {model.nq}")
    if wrong := first_wrong(model, np.zeros(1), qpos[None]):
        raise UserError(f"{where}: its first key: {wrong[1]}")
    return spec.keys[0].name, qpos


def _path(source: str, target: Path) -> str:
    """Return a model's path relative to the clip's folder."""
    return Path(os.path.relpath(Path(source).resolve(), target.resolve().parent)).as_posix()


def _with_followers(figure: Figure, qpos: Array) -> Array:
    """Return a pose (nq,) with coupled joints at the values that their drivers determine."""
    out = np.array(qpos)
    follow(figure, out, np.ones(figure.width, bool), lambda _: False)
    return out


def _without_followers(figure: Figure, row: KeyframeTable) -> KeyframeTable:
    """Return a keyframe without coupled joints, so that they stay consistent when it is edited."""
    names = {coupling.name for coupling in couplings(figure)}
    return row.change(joints={name: value for name, value in row.joints.items() if name not in names})


def _on_floor(figure: Figure, qpos: Array, *, lowers: bool) -> Array:
    """Return a pose (nq,) with free parts raised out of the floor, or with `lowers` also lowered onto it."""
    out, data = np.array(qpos), kinematics(figure.model)
    floor = max((float(data.geom_xpos[geom, 2]) for geom in grounds(figure.model)), default=None)
    if floor is None:
        return out
    for root in figure.tables.free_links.tolist():
        points = hanging(figure, root, body_points(figure))
        if points:
            low = float(bottoms_of(points, Samples.of_qpos(figure, qpos)).min())
            out[figure.links[root].qpos + 2] += floor - low if lowers else max(floor - low, 0.0)
    return out


def _round(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: (entry if key == "rotvec" else _round(entry)) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_round(entry) for entry in value]
    return _short(value) if isinstance(value, float) else value


def _short(value: float) -> float | int:
    number = round(value, DIGITS) + 0.0
    return int(number) if number == int(number) else number


def _head(source: str, content: str, raised: float) -> str:
    up = ""
    if abs(raised) >= NEGLIGIBLE:
        verb = "Raised" if raised > 0 else "Lowered"
        up = f" {verb} by up to {1000 * abs(raised):.1f} mm, {'out of' if raised > 0 else 'onto'} the floor."
    return (
        f"# A clip for {Path(source).name}: {content}.{up}\n"
        "# Units are degrees, metres and seconds. The solver chooses joints that a keyframe does not name. To specify\n"
        '# them, add others = "previous" (as in the previous keyframe), "rest" or "key:NAME" (a <key> of the model).\n'
        "# To see the motion: dynsplines render THIS_FILE"
    )


def _comment(notes: Sequence[str]) -> str:
    return "\n".join(f"# {line}" for note in notes for line in textwrap.wrap(f"NOTE: {note}", WIDE))


def _name_lines(figure: Figure, qpos: Array, soles: Sequence[Point]) -> str:
    model = figure.model
    lines = ["# Joints, by their keys in keyframes; axes in the rest pose, angles by the right-hand rule:"]
    axes = kinematics(model).xaxis
    for link in figure.links[1:]:
        lines.append(f"#   {_joint_line(figure, link, axes[link.joint])}")
    bodies = [model.body(i).name for i in range(1, model.nbody) if model.body(i).name]
    lines += _list("Bodies, for bodies.NAME = {flat = true}, a rotation or {position = [x, y, z]}", bodies)
    ground = "Sole points"
    lines += _list(ground, list(dict.fromkeys(point.name for point in soles))) or [f"# {ground}: {NO_FEET}"]
    lines += _list(
        "Joints that follow others (equality constraints), so that keyframes need not name them",
        [c.name for c in couplings(figure)],
    )
    lines += [f"# {ALL_COUNT}"] if counts_all(model) else []
    lines += _place_lines(figure, qpos, soles)
    return "\n".join(lines)


def _place_lines(figure: Figure, qpos: Array, soles: Sequence[Point]) -> list[str]:
    """Return comments with the positions of feet, sites and ends of other limbs in a pose (nq,)."""
    places = Places(figure, soles)
    names = [*(point.name for point in soles), *posable_sites(figure.model)]
    points = [point for name in dict.fromkeys(names) if (point := places.point(name)) is not None and point.link]
    positions = [(f"sites.{_key(p.name)}", "{}", p) for p in points]
    busy = {point.link for point in points}
    for body in (figure.links[limb[0]].body for limb in figure.limbs):  # hands, heads, tips of fingers
        name, link = str(figure.model.body(body).name), int(figure.body_link[body])
        if name and link not in busy:
            positions.append(
                (f"bodies.{_key(name)}", "{{position = {}}}", Point(name, *figure.point_on_link(body, np.zeros(3))))
            )
    if not positions:
        return []
    lines = [f"# {AT_REST}"]
    centres, _ = places_of([point for *_, point in positions], Samples.of_qpos(figure, qpos))
    for (key, form, point), place in zip(positions, centres[:, :, 0].T, strict=True):
        thick = f"  # centre of a sphere of radius {point.radius:.3g} m" if point.radius else ""
        where = ", ".join(f"{round(float(x), 4) + 0.0:g}" for x in place)
        lines.append(f"#   {key} = {form.format(f'[{where}]')}{thick}")
    return lines


def _joint_line(figure: Figure, link: Link, axis: Array) -> str:
    """Return the comment on a joint; axis (3,): that of a hinge or slide in the world."""
    if link.kind is JointKind.FREE:
        main_root = figure.root
        is_root = main_root is not None and not main_root.is_ambiguous and figure.links[main_root.link] is link
        table = "root" if is_root else f"roots.{_key(link.name)}"
        return f"{table + '.position, .rotation':40} free joint '{link.name}': metres; a rotation"
    name, limited = f"joints.{_key(link.name)}", bool(figure.model.jnt_limited[link.joint])
    low, high = (float(bound) for bound in figure.model.jnt_range[link.joint])
    if link.kind is JointKind.SLIDE:
        return f"{name:40} slide, metres along {_direction(axis)}" + (f", {low:g} to {high:g}" if limited else "")
    low, high = np.degrees([low, high])
    if link.kind is JointKind.HINGE:
        bounds = f", {low:.4g} to {high:.4g}" if limited else ""
        return f"{name:40} hinge, degrees about {_direction(axis)}{bounds}"
    return f"{name:40} ball, a rotation such as {{rotvec = [0, 30, 0]}}" + (f", up to {high:.4g}°" if limited else "")


def _direction(axis: Array) -> str:
    """Return a unit vector (3,) as text, such as "y", "-x" or "[0, 0.6, 0.8]"."""
    rounded = axis.round(2) + 0.0
    main = int(np.abs(rounded).argmax())
    if np.count_nonzero(rounded) == 1:
        return f"{'-' if rounded[main] < 0 else ''}{'xyz'[main]}"
    return f"[{', '.join(f'{part:g}' for part in rounded)}]"


def _key(name: str) -> str:
    return text_of({name: 0}).rsplit(" = ", 1)[0].strip()


def _list(title: str, names: Iterable[str]) -> list[str]:
    names = list(names)
    if not names:
        return []
    return [f"# {title}:", *textwrap.wrap(", ".join(names), WIDE, initial_indent="#   ", subsequent_indent="#   ")]
