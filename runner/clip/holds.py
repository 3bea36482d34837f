"""A clip's [[hold]] tables: which site stays where on which body, from when to when.

Where: at the table's `position`, else where the keyframes inside the interval have the site on the body, the first of
them first; without either the site only does not slide there. Where a keyframe puts the body out of the limb's reach,
the hold gives way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Hold, Spot, slipped
from dynsplines.solver.penalty.ground.planted import SAME_SPOT
from dynsplines.solver.surface.points import Point, placed

from ..errors import UserError, unknown
from .contacts import ROUNDING, agreeing, check_interval, check_overlap, stretches
from .posing.places import Places
from .table import HoldTable

NEARLY = 1e-3  # [m, rad] by which a pose may miss a place and still tell what is there
REACH = 0.15  # [m] by which a keyframe may put a hold out of reach and still tell where the limb is, stretched for it
SLACK = 1.0  # of that, what the site may be away from there: a limb stretched to its end whips there and back


@dataclass(frozen=True)
class _Row:
    """A table with the hold that it asks for, and how errors call it."""

    table: HoldTable
    hold: Hold
    name: str


def holds(
    figure: Figure, keys: Timeline, tables: Sequence[HoldTable], where: str, soles: Sequence[Point] = ()
) -> tuple[Hold, ...]:
    """The holds of a clip's tables. Raises UserError that names the table and what is wrong with it."""
    places, bodies = Places(figure, soles), moving_bodies(figure)
    rows: list[_Row] = []
    for number, table in enumerate(tables, start=1):
        name = f"{where}: hold {number} ('{table.hand}' on '{table.body}')"
        point = places.point(table.hand)
        if point is None:
            raise UserError(f"{name}: {unknown('site', table.hand, places.points_listed)}")
        if table.body not in bodies:
            raise UserError(f"{name}: {_no_body(figure, table.body, bodies)}")
        link = int(figure.body_link[bodies[table.body]])
        if point.link == link:
            raise UserError(f"{name}: the site is on that body itself, where it always stays")
        check_interval(table, keys, name)
        rows.append(_Row(table, Hold(point, link, table.body, table.start, table.end), name))
        check_overlap(table, tables[: number - 1], name, "hold {} of the same site", "a site holds one thing at a time")
    return tuple(replace(row.hold, spots=tuple(_spots(figure, keys, row))) for row in rows)


def asked(figure: Figure, tables: Sequence[HoldTable], soles: Sequence[Point]) -> tuple[Hold, ...]:
    """The holds of tables whose sites and bodies are there, however little a motion keeps to them."""
    places, bodies = Places(figure, soles), moving_bodies(figure)
    found = [(places.point(table.hand), table) for table in tables if table.body in bodies]
    return tuple(
        Hold(point, int(figure.body_link[bodies[table.body]]), table.body, table.start, table.end)
        for point, table in found
        if point is not None
    )


def moving_bodies(figure: Figure) -> dict[str, int]:
    """The bodies that joints move, by name."""
    model = figure.model
    return {model.body(i).name: i for i in range(1, model.nbody) if model.body(i).name and figure.body_link[i]}


def _no_body(figure: Figure, name: str, bodies: dict[str, int]) -> str:
    """Why there is no such body to hold."""
    model = figure.model
    still = {model.body(i).name for i in range(model.nbody)} | {model.geom(i).name for i in range(model.ngeom)}
    if name in still and name not in bodies:
        return f"'{name}' does not move by itself; hold a body that does, or let the site rest by a [[contact]]"
    return unknown("body", name, bodies)


def _spots(figure: Figure, keys: Timeline, row: _Row) -> list[Spot]:
    """Where the site is on the body over the interval, as far as the table and keyframes say."""
    hold, table = row.hold, row.table
    said, places, exact = _said(figure, keys, hold)
    wanted = None
    if table.position is not None:
        wanted = figure.point_on_link(moving_bodies(figure)[table.body], np.array(table.position, float))[1]

    def contradicts(k: int, apart: float, first: int | None) -> str:
        where = "the hold's position" if first is None else f"where keyframe {first + 1} has it"
        return (
            f"{row.name}: keyframe {k + 1} (t = {keys.times[k]:g} s) has the site {apart:.3f} m from {where} on "
            f"the body; a hold may drift by {SAME_SPOT:g} m"
        )

    firm = said[exact[said]] if exact[said].any() else said
    found = {float(keys.times[k]): places[:, k].copy() for k in agreeing(places, firm, exact, wanted, contradicts)}
    if wanted is not None and not found:
        found = {hold.first: wanted}
    if not found:
        return []
    there = replace(hold, spots=tuple(Spot(*stretch) for stretch in _stretches(found, hold)))
    slack: dict[float, float] = {}
    for k in np.setdiff1d(said, firm):
        t = float(keys.times[k])
        spot = there.spot(np.array([t]))
        assert spot is not None
        short = float(np.linalg.norm(places[:, k] - spot[:, 0]))
        if short <= REACH:
            found[t], slack[t] = places[:, k].copy(), SLACK * short * (short > NEARLY)
    return [
        Spot(*stretch, (slack.get(stretch[0], 0.0), slack.get(stretch[1], 0.0))) for stretch in _stretches(found, hold)
    ]


def _stretches(found: dict[float, Array], hold: Hold) -> Iterator[tuple[float, float, Array, Array]]:
    """(first, last, from, to) from place to place of a hold, by time."""
    return stretches(sorted(found.items(), key=lambda pair: pair[0]), hold.first, hold.last)


def _said(figure: Figure, keys: Timeline, hold: Hold) -> tuple[Index, Array, Mask]:
    """The keyframes (k,) within a hold that tell both site and body, the place on the body in all (3, K), and which of
    them fix it (K,)."""
    samples = Samples.still(figure, keys.states)
    both = [hold.point, Point(hold.body, hold.link, np.zeros(3))]
    known, exact = (np.logical_and.reduce(placed(figure, told, both)) for told in (keys.known, keys.fixed))
    inside = (keys.times >= hold.first - ROUNDING) & (keys.times <= hold.last + ROUNDING)
    return np.flatnonzero(inside & known), slipped(samples, hold), exact
