"""The inputs of soft constraints, from keyframes and tables: soles, contacts, holds, flights, a cycle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrench import height
from dynsplines.solver.inference.gait import GaitCycle
from dynsplines.solver.inference.gait_period import Gait
from dynsplines.solver.penalty import (
    Bend,
    Hold,
    Lean,
    Placed,
    Range,
    Stance,
    Support,
    flights,
    footings,
    grasped_links,
    leans,
    resting_objects,
    stances,
    steady,
)
from dynsplines.solver.penalty.ground.hover import TOUCHING, clearance
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.points import Point, body_points, free_root, hanging

from ..errors import UserError, unknown
from .contacts import Contacts, contacts, holds
from .posing.feet import sole_points
from .posing.places import Places
from .table import ContactTable, HoldTable

FAR_APART = 0.4  # [s] between keyframes, in which a figure takes a step
STEP = 0.2  # of the height of a figure: how far a foot moves in one
TRAVELS = 0.5  # [m/s] horizontal speed of a root from one keyframe to the next: half of a walk's
REPEATED = 1e-3  # [m] and of a quaternion's entries (0.1°): a keyframe that differs by less repeats its neighbour
KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")


@dataclass(frozen=True, eq=False)
class Context:
    """The inputs of soft constraints.

    where     how errors call the clip
    points    of the soles, or the sites that the clip names for `collision`
    bends     knees and elbows on ball joints, or those that the clip names for `limits`
    contacts  that the clip gives;  holds, too;  placed, the points that it leaves to the search to place
    support   what carries the figure when, for one that moves freely
    gait_cycle  the cycle that the keyframes are parts of, if they are
    """

    figure: Figure
    keys: Timeline
    surfaces: tuple[Surface, ...]
    where: str
    points: tuple[Point, ...] = ()
    bends: tuple[Bend, ...] = ()
    contacts: Contacts = Contacts()  # noqa: RUF009 - never changed
    holds: tuple[Hold, ...] = ()
    placed: tuple[Placed, ...] = ()
    support: Support | None = None
    gait_cycle: GaitCycle | None = None

    @classmethod
    def of(
        cls,
        figure: Figure,
        keys: Timeline,
        surfaces: tuple[Surface, ...],
        where: str,
        placed: tuple[Placed, ...] = (),
        tables: Sequence[ContactTable] = (),
        held: Sequence[HoldTable] = (),
    ) -> Context:
        """What keyframes and tables specify, independent of the [[penalty]] tables."""
        whole = [frame.state for frame in keys.frames if frame.fixed.all()]
        points = sole_points(figure, figure.to_qpos(np.reshape(whole, (-1, figure.width))))
        given_contacts = contacts(figure, keys, tables, where, points, surfaces)
        bends = tuple(knees_and_elbows(figure))
        return cls(
            figure,
            keys,
            surfaces,
            where,
            points,
            bends,
            given_contacts,
            holds(figure, keys, held, where, points),
            placed,
        )

    @property
    def is_stationary_at_ends(self) -> tuple[bool, bool]:
        """Whether the figure is stationary at the first and at the last keyframe.

        It is if the keyframe repeats its neighbour, or if all feet are planted and the root does not travel. Other ends
        than free ones, and partial keyframes there, are not stationary.
        """
        keys = self.keys
        if keys.ends != "free":
            return False, False
        feet, inferred = {point.link for point in self.points}, (*self.stances, *self.contacts.stances)
        planted = (
            {stance.point.link for stance in inferred if stance.first <= keys.times[0]},
            {stance.point.link for stance in inferred if stance.last >= keys.times[-1]},
        )

        def is_stationary(end: int, beside: int, links: set[int]) -> bool:
            moves = keys.states[beside] - keys.states[end]
            if not keys.fixed[end].all():
                return False
            travel = np.linalg.norm(moves[self.figure.tables.position_columns[:2]], axis=0).max(initial=0.0)
            is_slow = travel < TRAVELS * abs(keys.times[beside] - keys.times[end])
            return bool(np.abs(moves).max() < REPEATED or (feet and feet <= links and is_slow))

        return is_stationary(0, 1, planted[0]), is_stationary(-1, -2, planted[1])

    @property
    def lacking(self) -> list[str]:
        """Notes on features that figures commonly have and this one lacks."""
        lines: list[str] = []
        if not self.surfaces:
            lines.append("no static geom found: nothing to stay out of")
        if not self.points and self.is_free:
            lines.append("no feet found, nor a site named heel or toe: no contact points")
        if not self.bends and self.figure.tables.ball_links.size:
            lines.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")
        return lines

    @property
    def lost_steps(self) -> list[str]:
        """A note on neighbouring keyframes with steps between them that the motion will not have.

        Every foot moves along the ground from one to the other, outside flights, and the keyframes form no gait cycle.
        """
        keys, support = self.keys, self.support
        if support is None or self.gait_cycle is not None or not self.points:
            return []
        feet = sorted({point.link for point in self.points if self.figure.tables.path[point.link, support.root]})
        places = Samples.still(self.figure, keys.states).links.x[:2, feet]
        moves = np.linalg.norm(np.diff(places, axis=2), axis=0).min(axis=0, initial=np.inf)
        gaps, whole = np.diff(keys.times), keys.fixed.all(axis=1)
        stands = whole & (clearance(self.figure, keys, self.points, self.surfaces) < TOUCHING)
        lost = (gaps >= FAR_APART) & (moves > STEP * height(self.figure, support.root)) & stands[:-1] & stands[1:]
        for first, last in support.flights:
            lost &= (keys.times[1:] <= first) | (last <= keys.times[:-1])
        if not feet or not lost.any():
            return []
        worst, others = int(np.where(lost, moves, 0.0).argmax()), int(lost.sum()) - 1
        more = f", as for {others} more pair{'s' if others > 1 else ''} of keyframes" if others else ""
        return [
            f"keyframes {worst + 1} and {worst + 2}, {gaps[worst]:.2g} s apart, form no gait cycle, so that no "
            f"steps are added between them, though every foot moves {moves[worst]:.2g} m{more}; add a keyframe, or "
            "[[penalty]] kind = 'cycle' with its period"
        ]

    @property
    def is_free(self) -> bool:
        """Whether the figure may move about on a ground."""
        return bool(self.figure.tables.free_links.size)

    @cached_property
    def grasped(self) -> tuple[int, ...]:
        """The links that hands hold."""
        return tuple(grasped_links(self.figure, self.holds))

    def exclude_grasped(self, points: Sequence[Point]) -> tuple[Point, ...]:
        """Return the points that do not belong to grasped objects."""
        return tuple(point for point in points if point.link not in self.grasped)

    @property
    def flies(self) -> bool:
        """Whether there are flights: who runs has feet on the ground for a short while only, between keyframes."""
        return self.support is not None and bool(self.support.flights)

    @cached_property
    def stances(self) -> tuple[Stance, ...]:
        """The stances inferred from keyframes, except for points that the clip's contacts already cover."""
        inferred = stances(self.figure, self.keys, self.points, self.surfaces)
        return tuple(stance for stance in inferred if not self.contacts.overlaps(stance))

    @cached_property
    def held_joints(self) -> tuple[Range, ...]:
        """The joints that neighbouring keyframes hold at one value and that the raw spline would swing."""
        aloft = () if self.support is None else self.support.flights
        repeats = self.keys.ends == "periodic" or self.gait_cycle is not None
        return steady(self.figure, self.keys, repeats=repeats, aloft=aloft)

    @property
    def resting_objects(self) -> tuple[Stance, ...]:
        """Position of carried objects before and after they are grasped."""
        return resting_objects(
            self.figure, self.keys, [link for link in self.grasped if self.figure.links[link].parent == 0]
        )

    @property
    def leans(self) -> tuple[Lean, ...]:
        """The trunk's tilt in the poses before placing."""
        roots = [link for link in self.figure.tables.free_links.tolist() if link not in self.grasped]
        root = self.figure.root
        if root is not None and not root.is_free:
            roots.append(root.link)
        return leans(self.figure, self.keys, roots)

    def carried_when(self, intervals: Sequence[tuple[float, float]] | None, asked: bool) -> Support | None:
        """The support schedule: the flights given in the clip, else those inferred from its keyframes; for the tree
        of one free joint, whatever else moves freely."""
        figure, keys = self.figure, self.keys
        if not figure.tables.free_links.size:
            return None
        root_link = free_root(figure, self.points)
        root = int(figure.tables.free_links[0]) if root_link is None else root_link
        points = hanging(figure, root, self.points)
        body = hanging(figure, root, self.exclude_grasped(body_points(figure)))
        every = (*self.stances, *self.contacts.stances, *self.contacts.rests)
        supports = tuple(stance for stance in every if figure.tables.path[stance.point.link, root])
        carriers = footings(figure, keys, points, self.surfaces, supports, body)
        if intervals is not None:
            aloft = tuple(intervals)
        elif asked and not self.surfaces:
            aloft = ((float(keys.times[0]), float(keys.times[-1])),)
        else:
            aloft = flights(figure, root, keys, points, self.surfaces, supports, body)
        for first, last in aloft:
            if not keys.times[0] <= first < last <= keys.times[-1]:
                interval, span = f"[{first:g}, {last:g}]", f"{keys.times[0]:g} to {keys.times[-1]:g} s"
                raise UserError(
                    f"{self.where}: penalty 'flight': {interval} is not an interval of the clip, which runs from {span}"
                )
        return Support.of(figure, root, carriers, aloft)

    def cycle(self, period: float | None, asked: bool) -> GaitCycle | None:
        """The clip's cycle: with the given period, or inferred from keyframes, and then only if it is unambiguous."""
        gait = Gait(self.figure, self.keys, self.points, self.surfaces)
        if not asked:
            return gait.infer()
        return gait.likeliest() if period is None else gait.with_period(period)

    def sites(self, names: Sequence[str]) -> tuple[Point, ...]:
        """Points by name. Raises UserError for unknown names."""
        places, result = Places(self.figure, self.points), list[Point]()
        for name in names:
            point = places.point(name)
            if point is None:
                raise UserError(f"{self.where}: penalty 'collision': {unknown('site', name, places.points_listed)}")
            result.append(point)
        return tuple(result)

    def limbs(self, names: Sequence[str]) -> tuple[Bend, ...]:
        """Knees and elbows by the name of their joint. Raises UserError for unknown names."""
        bends = {bend.name: bend for bend in self.bends}
        for name in names:
            if name not in bends:
                raise UserError(f"{self.where}: penalty 'limits': {unknown('joint', name, bends)}")
        return tuple(bends[name] for name in names)


def knees_and_elbows(figure: Figure) -> list[Bend]:
    """Ball joints that are knees or elbows by their own name or their body's, of a figure that faces x."""
    bends, rest = [], _turned_at_rest(figure)
    for i, link in enumerate(figure.links[1:], start=1):
        names = f"{link.name} {figure.model.body(link.body).name}".lower()
        lateral = 1.0 if any(w in names for w in KNEES) else -1.0 if any(w in names for w in ELBOWS) else 0.0
        if lateral and link.kind is JointKind.BALL:
            down = quat.rotated(rest[i], link.centre - link.anchor)
            down[1] = 0.0
            if np.linalg.norm(down) > 1e-6:
                axes = np.array([[0.0, lateral, 0.0], _principal(down)])
                bends.append(Bend(link.name, i, *quat.rotated(quat.inverse(rest[link.parent]), axes)))
    return bends


def _turned_at_rest(figure: Figure) -> list[Array]:
    """(4,) of every link, the world first: how it is turned in the world at rest."""
    rotations = [np.array([1.0, 0, 0, 0])]
    for link in figure.links[1:]:
        rotations.append(quat.product(rotations[link.parent], link.turn))
    return rotations


def _principal(direction: Array) -> Array:
    """The coordinate axis nearest to a direction: limbs hang along one at rest."""
    axis = np.zeros(3)
    axis[np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    return axis
