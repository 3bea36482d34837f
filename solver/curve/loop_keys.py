"""The keyframes of a loop, made consistent: the last is the first, moved by the travel and turned by the heading.

Entries that either of the two fixes are fixed in both. Contradictions raise TimelineError.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array
from ..figure.figure import Figure, JointKind, quaternion_columns
from ..tolerances import ROUNDING
from .frame import Frame, TimelineError
from .seam import Seam, heading_between


def close_loop(
    figure: Figure, keys: list[Frame], travel: ArrayLike | None, turn: float | None
) -> tuple[list[Frame], Seam]:
    """Close the keyframes of a loop.

    Args:
        keys: Keyframes that hold qpos.
        travel: Displacement (3,) [m] of the first free root over one period; None: x and y from the keyframes.
        turn: Rotation [rad] of the first free root about the vertical; None: from the keyframes.

    Returns:
        The keyframes, with entries that the first or the last fixes fixed in both; and their seam, of qpos.

    Raises:
        TimelineError: The first and the last keyframe contradict each other, or travel or turn do not apply.
    """
    first, last = (_unit(figure, frame) for frame in (keys[0], keys[-1]))
    headings = _headings(figure, first, last, turn)
    seam = Seam.with_headings(figure, first.state, last.state, headings, "joint")
    seam = replace(seam, shift=_shift(figure, first, last, seam, _travel(figure, first, last, travel)))
    fixed, is_known = first.fixed | last.fixed, first.known | last.known
    from_first = first.fixed | (first.known & ~last.fixed)
    for x, heading in zip(figure.tables.position_columns[0], headings, strict=True):
        if heading:
            from_first[x : x + 2] = _has_place(first, x)
    state = np.where(from_first, first.state, seam.move(last.state, -1))
    begin, end = state, seam.move(state)
    difference = np.maximum(np.abs(end - last.state) * last.fixed, np.abs(begin - first.state) * first.fixed)
    if difference.max() > ROUNDING:
        raise TimelineError(
            f"periodic ends: the last keyframe (t = {last.time:g} s) differs from the first at "
            f"{_where(figure, int(np.argmax(difference)), seam)} by {difference.max():.3g}; "
            "they must agree, or leave it free in one of them. Only a root with a free joint can travel in a loop, "
            "and objects that it carries equally far"
        )
    posed = is_known & ~fixed
    ends = [replace(frame, state=at, fixed=fixed, posed=posed) for frame, at in ((first, begin), (last, end))]
    return [ends[0], *keys[1:-1], ends[1]], seam


def _unit(figure: Figure, frame: Frame) -> Frame:
    state = np.array(frame.state)
    for columns in figure.tables.quaternion_columns.T:
        if frame.known[columns].all():
            state[columns] = quat.normalise(state[columns])
    return replace(frame, state=state)


def _headings(figure: Figure, first: Frame, last: Frame, turn: float | None) -> Array:
    """Return the heading (f,) [rad] of each free root, 0 where either end leaves its orientation free."""
    headings = np.zeros(figure.tables.free_links.size)
    for i, link in enumerate(figure.tables.free_links):
        columns = quaternion_columns(figure.links[link])
        if (first.fixed & last.fixed)[columns].all():
            headings[i] = heading_between(first.state[columns], last.state[columns])
    if turn is None:
        return headings
    if not np.isfinite(turn):
        raise TimelineError(f"turn must be a finite angle, not {turn}")
    if not headings.size:
        raise TimelineError("the figure has no free joint, so no root to turn")
    angle = float(np.arctan2(np.sin(turn), np.cos(turn)))
    headings[0] = angle if abs(angle) > ROUNDING else 0.0
    return headings


def _travel(figure: Figure, first: Frame, last: Frame, travel: ArrayLike | None) -> Array:
    """Return the displacement (3, f) [m] of each root from its first position to its last. Roots after the first have
    that of the first, as carried objects do, if their positions in both keyframes are closer to it than to none."""
    roots = figure.tables.position_columns
    out = np.zeros(roots.shape)
    difference = np.where(first.fixed & last.fixed, last.state - first.state, 0.0)[roots]
    if travel is None:
        out[:2, :1] = np.where(np.abs(difference) > ROUNDING, difference, 0.0)[:2, :1]
    else:
        travel = np.asarray(travel, float)
        if travel.shape != (3,) or not np.all(np.isfinite(travel)):
            raise TimelineError(f"travel must be three finite numbers [x, y, z] in metres, not {travel.tolist()}")
        if not roots.size:
            raise TimelineError("the figure has no free joint, so no root to travel")
        out[:, 0] = travel
    is_carried = np.linalg.norm(difference - out[:, :1], axis=0) < np.linalg.norm(difference, axis=0)
    return np.where(is_carried, out[:, :1], out)


def _shift(figure: Figure, first: Frame, last: Frame, seam: Seam, travel: Array) -> Array:
    """Return the seam's shift (N,) [m] with which roots travel (3, f) from the position that either end fixes."""
    shift = np.zeros(figure.width)
    for (x, y, z), travelled, heading in zip(figure.tables.position_columns.T, travel.T, seam.headings, strict=True):
        shift[[x, y, z]] = travelled
        if not heading:
            continue
        if _has_place(first, x):
            begin = first.state[[x, y]]
        elif _has_place(last, x):
            begin = last.state[[x, y]] - travelled[:2]
        else:
            name = next(link.name for link in reversed(figure.links) if link.qpos <= x)
            raise TimelineError(f"a loop that turns needs x and y of '{name}' in its first or its last keyframe")
        state = np.zeros(figure.width)
        state[[x, y]] = begin
        shift[[x, y]] += begin - seam.linear(state)[[x, y]]
    return shift


def _has_place(frame: Frame, x: int) -> bool:
    """Return whether a keyframe fixes x and y of a root, the columns x and x + 1."""
    return bool(frame.fixed[x : x + 2].all())


def _where(figure: Figure, column: int, seam: Seam) -> str:
    """Return the name of a joint for an error about a loop's ends, for a root with the permitted differences."""
    number = next(i for i in reversed(range(len(figure.links))) if figure.links[i].qpos <= column)
    link = figure.links[number]
    if link.kind is not JointKind.FREE:
        return f"'{link.name}'"
    heading = seam.headings[figure.tables.free_links.tolist().index(number)]
    if column >= link.qpos + 3:
        here = f", here by {np.degrees(heading):g} degrees" if heading else ""
        return f"'{link.name}' (a loop may travel, and turn about the vertical{here})"
    travel = ", ".join(f"{metres:g}" for metres in seam.shift[link.qpos : link.qpos + 3])
    transform = f"turned by {np.degrees(heading):g} degrees" if heading else f"with travel = [{travel}]"
    return f"'{link.name}' along {'xyz'[column - link.qpos]} ({transform})"
