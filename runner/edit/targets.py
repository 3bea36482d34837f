"""Positions in the world that an edit displaces: targets of keyframes that the search meets, and those of contacts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import places_of

from ..clip.build import NEXT
from ..clip.parse import table_of
from ..clip.pose import soles_of
from ..clip.posing.placement import wanted
from ..clip.posing.places import Places
from ..clip.table import ContactTable, KeyframeTable, SiteTable
from ..motion import Saved

Row = TypeVar("Row", KeyframeTable, Frame)
Displacement = Callable[[Array], Array]  # of points (..., 3) [m]


def searched_targets(saved: Saved) -> list[KeyframeTable]:
    """Return the keyframes of a motion that have targets which the search meets, with these targets alone."""
    rows = table_of(saved.text, saved.name).keyframe if saved.text else ()
    targets = [
        KeyframeTable.unchecked(
            time=row.time,
            sites={name: t for name, t in row.sites.items() if isinstance(t, SiteTable) and t.by == "search"},
        )
        for row in rows
    ]
    return [row for row in targets if row.sites]


def moved_targets(
    saved: Saved, rows: Sequence[KeyframeTable], displaced: Displacement, shift: float
) -> list[KeyframeTable]:
    """Return targets of a motion displaced, and `shift` seconds later. If the displacement rotates a target with one
    free horizontal axis, this axis is fixed where the motion has the site, so that the distance from it is the same."""
    places, figure = Places(saved.figure, soles_of(saved.figure, saved.keys)), saved.figure
    turns = not np.allclose(displaced(np.eye(3)) - displaced(np.zeros((1, 3))), np.eye(3))

    def position(at: Array, target: Array) -> tuple[float | str, ...]:
        free = np.isnan(target)
        moved = displaced(np.where(free, at, target))
        if turns:
            free[:2] = free[:2].all()
        return tuple("free" if is_free else x for x, is_free in zip(moved.tolist(), free, strict=True))

    def later(row: KeyframeTable) -> KeyframeTable:
        placed = wanted(places, row, saved.name).placed
        states = path_of(saved.timeline).at(np.array([row.time]))
        at, _ = places_of([goal.point for goal in placed], Samples.still(figure, states))
        sites = {
            name: table.changed(position=position(at[:, i, 0], goal.target))
            for i, ((name, table), goal) in enumerate(zip(row.sites.items(), placed, strict=True))
            if isinstance(table, SiteTable)
        }
        return row.changed(time=row.time + shift, sites=sites)

    return [later(row) for row in rows]


def moved_contacts(rows: Sequence[ContactTable], displaced: Displacement) -> list[ContactTable]:
    """Return contacts with displaced positions."""
    return [
        row if row.position is None else row.changed(position=tuple(displaced(np.array(row.position)).tolist()))
        for row in rows
    ]


def with_targets(tables: Sequence[KeyframeTable], targets: Sequence[KeyframeTable]) -> list[KeyframeTable]:
    """Return keyframes with the targets at their times."""
    rows = [_at(targets, table.time) for table in tables]
    return [table if row is None else table.changed(sites=row.sites) for table, row in zip(tables, rows, strict=True)]


def at_cut(edge: Frame, keys: Sequence[Frame], targets: Sequence[KeyframeTable]) -> Frame:
    """Return the complete keyframe at which a motion is cut. If one of its keyframes with targets is there, entries
    that this keyframe leaves free remain free, so that the search can meet the targets."""
    key = _at(keys, edge.time)
    if key is None or _at(targets, edge.time) is None:
        return edge
    return Frame(edge.time, edge.state, key.fixed, ~key.fixed)


def _at(rows: Sequence[Row], time: float) -> Row | None:
    """Return the keyframe at a time [s], if any."""
    return next((row for row in rows if abs(row.time - time) <= NEXT), None)
