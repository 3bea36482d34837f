"""How the keyframes of a loop close it: the first and the last are one, moved on by a travel and turned by a heading.

What either of the two fixes is fixed in both; where they contradict each other, it is told.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array
from ..figure.figure import Figure, JointKind, quaternion_columns
from .frame import Frame, TimelineError
from .seam import Seam, heading_between

SAME = 1e-9  # entries of a loop's ends that differ by no more agree


def closed(figure: Figure, keys: list[Frame], travel: ArrayLike | None, turn: float | None) -> tuple[list[Frame], Seam]:
    """The keyframes (qpos) of a loop, the first and the last with what either fixes; and their seam, as one of qpos.

    travel  (3,) [m] of the first free root; None: as far in x and y as the keyframes say
    turn    [rad] of the first free root about the vertical; None: as the keyframes say
    """
    first, last = (_unit(figure, frame) for frame in (keys[0], keys[-1]))
    headings = _headings(figure, first, last, turn)
    seam = Seam.turned(figure, first.state, last.state, headings, "joint")
    seam = replace(seam, shift=_shift(figure, first, last, seam, _travelled(figure, first, last, travel)))
    fixed, known = first.fixed | last.fixed, first.known | last.known
    own = first.fixed | (first.known & ~last.fixed)
    for x, heading in zip(figure.tables.position_columns[0], headings, strict=True):
        if heading:
            own[x : x + 2] = _has_place(first, x)
    state = np.where(own, first.state, seam.moved(last.state, -1))
    begin, end = state, seam.moved(state)
    apart = np.maximum(np.abs(end - last.state) * last.fixed, np.abs(begin - first.state) * first.fixed)
    if apart.max() > SAME:
        raise TimelineError(
            f"periodic ends: the last keyframe (t = {last.time:g} s) differs from the first at "
            f"{_where(figure, int(np.argmax(apart)), seam)} by {apart.max():.3g}; "
            "they must agree, or leave it free in one of them"
        )
    posed = known & ~fixed
    ends = [replace(frame, state=at, fixed=fixed, posed=posed) for frame, at in ((first, begin), (last, end))]
    return [ends[0], *keys[1:-1], ends[1]], seam


def _unit(figure: Figure, frame: Frame) -> Frame:
    """A keyframe with unit quaternions."""
    state = np.array(frame.state)
    for columns in figure.tables.quaternion_columns.T:
        if frame.known[columns].all():
            state[columns] = quat.normalised(state[columns])
    return replace(frame, state=state)


def _headings(figure: Figure, first: Frame, last: Frame, turn: float | None) -> Array:
    """(f,) [rad] by how much each free root is turned: as both ends say, 0 where one leaves it free."""
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
    given = float(np.arctan2(np.sin(turn), np.cos(turn)))
    headings[0] = given if abs(given) > SAME else 0.0
    return headings


def _travelled(figure: Figure, first: Frame, last: Frame, travel: ArrayLike | None) -> Array:
    """(3, f) [m] how far each root's last place lies beyond its first."""
    roots = figure.tables.position_columns
    out = np.zeros(roots.shape)
    if travel is None:
        ground = roots[:2, :1]
        apart = np.where(first.fixed & last.fixed, last.state - first.state, 0.0)[ground]
        out[:2, :1] = np.where(np.abs(apart) > SAME, apart, 0.0)
        return out
    travel = np.asarray(travel, float)
    if travel.shape != (3,) or not np.all(np.isfinite(travel)):
        raise TimelineError(f"travel must be three finite numbers [x, y, z] in metres, not {travel.tolist()}")
    if not roots.size:
        raise TimelineError("the figure has no free joint, so no root to travel")
    out[:, 0] = travel
    return out


def _shift(figure: Figure, first: Frame, last: Frame, seam: Seam, travel: Array) -> Array:
    """(N,) [m] what a seam adds to turned places, for roots to travel (3, f) from where either end has them."""
    shift = np.zeros(figure.width)
    for (x, y, z), way, heading in zip(figure.tables.position_columns.T, travel.T, seam.headings, strict=True):
        shift[[x, y, z]] = way
        if not heading:
            continue
        if _has_place(first, x):
            begin = first.state[[x, y]]
        elif _has_place(last, x):
            begin = last.state[[x, y]] - way[:2]
        else:
            name = next(link.name for link in reversed(figure.links) if link.qpos <= x)
            raise TimelineError(f"a loop that turns has x and y of '{name}' given in its first or its last keyframe")
        state = np.zeros(figure.width)
        state[[x, y]] = begin
        shift[[x, y]] += begin - seam.linear(state)[[x, y]]
    return shift


def _has_place(frame: Frame, x: int) -> bool:
    """Whether a keyframe fixes x and y, the columns x and x + 1, of a root."""
    return bool(frame.fixed[x : x + 2].all())


def _where(figure: Figure, column: int, seam: Seam) -> str:
    """How an error calls an entry of a loop's ends: its joint, for a root with what may differ."""
    number = next(i for i in reversed(range(len(figure.links))) if figure.links[i].qpos <= column)
    link = figure.links[number]
    if link.kind is not JointKind.FREE:
        return f"'{link.name}'"
    heading = seam.headings[figure.tables.free_links.tolist().index(number)]
    if column >= link.qpos + 3:
        here = f", here by {np.degrees(heading):g} degrees" if heading else ""
        return f"'{link.name}' (a loop may travel, and turn about the vertical{here})"
    travel = ", ".join(f"{metres:g}" for metres in seam.shift[link.qpos : link.qpos + 3])
    said = f"turned by {np.degrees(heading):g} degrees" if heading else f"with travel = [{travel}]"
    return f"'{link.name}' along {'xyz'[column - link.qpos]} ({said})"
