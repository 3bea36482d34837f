"""What keyframes and tables tell that soft constraints are made of: soles, contacts, holds, flights, a cycle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.penalty import (
    Bend,
    Lean,
    Placed,
    Stance,
    Support,
    carried_links,
    flights,
    footings,
    leans,
    lying,
    stances,
)
from dynsplines.solver.reading.rhythm import Rhythm
from dynsplines.solver.reading.stride import Gait
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.points import Point, body_points

from ..errors import UserError, unknown
from .contacts import contacts
from .holds import holds
from .posing.feet import sole_points
from .posing.places import Places
from .table import ContactTable, HoldTable

KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")


class Context:
    """What there is to make soft constraints of.

    points   of the soles, or the sites that the clip names for `contact`
    bends    knees and elbows on ball joints
    support  what carries the figure when, for one that moves freely
    rhythm   the cycle that the keyframes are parts of, if they are
    notes    gets a line for what the user should know
    """

    def __init__(
        self,
        figure: Figure,
        keys: Timeline,
        surfaces: tuple[Surface, ...],
        notes: list[str],
        place: str,
        placed: tuple[Placed, ...] = (),
        tables: Sequence[ContactTable] = (),
        held: Sequence[HoldTable] = (),
    ) -> None:
        self.figure, self.keys, self.surfaces, self.notes, self.place = figure, keys, surfaces, notes, place
        self.placed = placed
        whole = [figure.to_qpos(frame.state) for frame in keys.frames if frame.fixed.all()]
        self.points = sole_points(figure, np.reshape(whole, (-1, figure.width)))
        self.bends = tuple(knees_and_elbows(figure))
        self.contacts = contacts(figure, keys, tables, place, self.points, surfaces)
        self.holds = holds(figure, keys, held, place, self.points)
        self.carried = carried_links(figure, self.holds)
        self.support: Support | None = None
        self.rhythm: Rhythm | None = None
        if not surfaces:
            notes.append("no static geom found: nothing to stay out of")
        if not self.points and _is_free(figure):
            notes.append("no feet found, nor a site named heel or toe: no contact points")
        if not self.bends and figure.tables.ball_links.size:
            notes.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")

    def own(self, points: Sequence[Point]) -> tuple[Point, ...]:
        """The points that are not of what is carried."""
        return tuple(point for point in points if point.link not in self.carried)

    @property
    def flies(self) -> bool:
        """Whether there are flights: who runs has feet on the ground for a short while only, between keyframes."""
        return self.support is not None and bool(self.support.flights)

    @property
    def stances(self) -> tuple[Stance, ...]:
        """The stances that keyframes tell, where the clip's contacts do not speak of the same point."""
        found = stances(self.figure, self.keys, self.points, self.surfaces)
        return tuple(stance for stance in found if not self.contacts.overlaps(stance))

    @property
    def lying(self) -> tuple[Stance, ...]:
        """Where what is carried lies before and after."""
        return lying(self.figure, self.keys, [link for link in self.carried if self.figure.links[link].parent == 0])

    @property
    def leans(self) -> tuple[Lean, ...]:
        """How the trunk leans where it was posed."""
        roots = [link for link in self.figure.tables.free_links.tolist() if link not in self.carried]
        return leans(self.figure, self.keys, roots)

    def carried_when(self, intervals: Sequence[tuple[float, float]] | None, asked: bool) -> Support | None:
        """What carries the figure when: the flights that the clip gives, or what its keyframes tell."""
        figure, keys = self.figure, self.keys
        if not figure.tables.free_links.size:
            return None
        root = next((r for r in figure.tables.free_links if self._stands(int(r))), figure.tables.free_links[0])
        held, body = (*self.stances, *self.contacts.stances, *self.contacts.rests), self.own(body_points(figure))
        carriers = footings(figure, keys, self.points, self.surfaces, held, body)
        if intervals is not None:
            aloft = tuple(intervals)
        elif asked and not self.surfaces:
            aloft = ((float(keys.times[0]), float(keys.times[-1])),)
        else:
            aloft = flights(figure, int(root), keys, self.points, self.surfaces, held, body)
        for first, last in aloft:
            if not keys.times[0] <= first < last <= keys.times[-1]:
                given, span = f"[{first:g}, {last:g}]", f"{keys.times[0]:g} to {keys.times[-1]:g} s"
                raise UserError(
                    f"{self.place}: penalty 'flight': {given} is no interval of the clip, which runs from {span}"
                )
        return Support.of(figure, int(root), carriers, aloft)

    def cycle(self, period: float | None, asked: bool) -> Rhythm | None:
        """The clip's cycle: with the period that it gives, or as its keyframes tell it, beyond doubt unless asked."""
        gait = Gait(self.figure, self.keys, self.points, self.surfaces)
        if not asked:
            return gait.told()
        found = gait.likeliest() if period is None else gait.given(period)
        if found is None:
            self.notes.append(
                "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"
            )
        return found

    def _stands(self, root: int) -> bool:
        """Whether sole points are on the tree of a free link."""
        return any(self.figure.tables.path[point.link, root] for point in self.points)

    def sites(self, names: list[str]) -> tuple[Point, ...]:
        places, found = Places(self.figure, self.points), list[Point]()
        for name in names:
            point = places.point(name)
            if point is None:
                raise UserError(f"{self.place}: penalty 'contact': {unknown('site', name, places.points_listed)}")
            found.append(point)
        return tuple(found)


def _is_free(figure: Figure) -> bool:
    """Whether it may move about on a ground."""
    return bool(figure.tables.free_links.size)


def knees_and_elbows(figure: Figure) -> list[Bend]:
    """Ball joints that are knees or elbows by their own name or their body's, of a figure that faces x."""
    found = []
    for i, link in enumerate(figure.links[1:], start=1):
        names = f"{link.name} {figure.model.body(link.body).name}".lower()
        lateral = 1.0 if any(w in names for w in KNEES) else -1.0 if any(w in names for w in ELBOWS) else 0.0
        if lateral and link.kind is JointKind.BALL:
            long_axis = link.centre - link.anchor
            down = quat.rotated(link.turn, long_axis)
            down[1] = 0.0
            if np.linalg.norm(down) > 1e-6:
                axis = np.array([0.0, lateral, 0.0])
                found.append(Bend(link.name, i, axis, _principal(down)))
    return found


def _principal(direction: Array) -> Array:
    """The coordinate axis nearest to a direction: limbs hang along one at rest."""
    axis = np.zeros(3)
    axis[np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    return axis
