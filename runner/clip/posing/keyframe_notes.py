"""Notes on keyframes: ambiguous roots, and whole turns that keyframes specify and the motion omits.

Rotations are quaternions, so from one keyframe to the next a joint takes the shorter arc. A heading of 360 after 0
turns nothing, and one of 270 after 0 turns back by 90°. Both are reported, with the additional keyframes that produce
the turn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure, quaternion_columns

from ..table import KeyframeTable, RotationTable
from .root_entries import roots_by_name

HALF, SAME = 180.0, 1.0  # [degrees] largest turn between two keyframes; tolerance of equal turns
STEP = 120.0  # [degrees] largest turn between recommended keyframes


def keyframe_notes(figure: Figure, rows: Sequence[KeyframeTable], keys: Timeline) -> tuple[str, ...]:
    """Return the notes on a clip's keyframe tables, for its raw timeline."""
    return (*_ambiguities(figure, rows), *_lost_turns(figure, rows, keys))


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
    return [line for name in names for line in _lost(figure, name, rows, keys)]


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
        if _written(table) is not None:
            out[f"bodies.{name}"] = None, table
    return out


def _written(table: RotationTable) -> tuple[str, Array] | None:
    """Return the notation of a rotation, and its angles [degrees]; None for a quaternion, which has no whole turns."""
    if table.heading is not None and {"rotvec", "euler", "quat"}.isdisjoint(table.model_fields_set):
        return "heading", np.array([table.heading])
    if table.heading is None and table.rotvec is not None:
        return "rotvec", np.array(table.rotvec)
    if table.euler is not None:
        turned = [] if table.heading is None else [table.heading]
        return f"euler {table.order or 'xyz'}{' heading' * len(turned)}", np.array([*table.euler, *turned])
    return None


def _lost(figure: Figure, name: str, rows: Sequence[KeyframeTable], keys: Timeline) -> Iterator[str]:
    """Yield notes on omitted turns of one rotation, between the keyframes that specify it."""
    last: tuple[int, str | None, Array] | None = None  # no notation at rest, which matches all
    for k, row in enumerate(rows):
        link, table = _rotations(figure, row).get(name, (None, None))
        written = None if table is None else _written(table)
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
    if size <= HALF + SAME:
        return None
    if link is not None and _is_made(figure, link, pair, size, keys):
        return None
    count = int(np.ceil(size / STEP - 1e-9))
    between = ", ".join(_spoken(first + step * i / count) for i in range(1, count))
    rest = float(np.abs((size + HALF) % 360 - HALF))
    comes = "nothing turns" if rest < SAME else f"it takes the shorter way, {rest:g} degrees"
    return (
        f"keyframe {{}} (t = {{:g}} s): {name}: {{}} {_spoken(last)} is {size:g} degrees from keyframe {pair[0] + 1}, "
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


def _spoken(angles: Array) -> str:
    """Return angles [degrees] in the notation of clips."""
    listed = ", ".join(f"{angle:g}" for angle in np.round(angles, 3))
    return listed if angles.size == 1 else f"[{listed}]"
