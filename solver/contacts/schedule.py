"""The schedule of contacts of a clip: when and where the figure touches its surroundings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array, Mask
from ..curve.frame import Timeline
from ..figure.figure import Figure
from ..surface import Surface
from ..surface.points import Point, body_points, free_root, hanging
from .flight import Air, Fall
from .footing import Footing, Interval, footings
from .gait import GaitCycle
from .gait_period import Gait
from .grasp import Grasp, grasped_links, resting_objects
from .keyframe_points import KeyframePoints
from .stance import Rest, Stance, stances
from .steps import Steps
from .thresholds import Thresholds

ROUNDING = 1e-9  # [s] rounding tolerance of times


@dataclass(frozen=True)
class Contacts:
    """The contacts that a clip specifies.

    Attributes:
        stances: Contacts at a known position.
        rests: Contacts whose position the search determines.
        requested: All contacts of the clip, in its order, before they were divided into `stances` and `rests`.
    """

    stances: tuple[Stance, ...] = ()
    rests: tuple[Rest, ...] = ()
    requested: tuple[Rest, ...] = ()

    def overlaps(self, stance: Stance | Rest) -> bool:
        """Return whether a specified contact of the same point overlaps a stance in time."""
        return any(contact.point.coincides(stance.point) for contact in self._during(stance.first, stance.last))

    def holds(self, link: int, first: float, last: float) -> bool:
        """Return whether a specified contact of a link overlaps an interval [s]."""
        return any(contact.point.link == link for contact in self._during(first, last))

    def _during(self, first: float, last: float) -> Iterator[Stance | Rest]:
        """Yield the specified contacts that overlap an interval [s]."""
        for contact in (*self.stances, *self.rests):
            if contact.first < last - ROUNDING and first < contact.last - ROUNDING:
                yield contact


@dataclass(frozen=True, eq=False)
class ContactSchedule:
    """The stances, grasps, flights and gait of a figure over time. What is not specified is inferred once, when needed.

    Attributes:
        figure: The figure.
        keys: The keyframes.
        points: The sole points, or the points of the option `points` of `collision`.
        surfaces: The floor and the obstacles.
        contacts: The contacts that the clip specifies.
        grasps: The grasps that the clip specifies.
        targets: Points, times [s] and positions (3,) [m] that the search has to reach, with NaN along free axes. A foot
            with a target elsewhere does not stand.
        specified_footings: The points that can support the figure, each with its interval; None: inferred from stances.
        specified_flights: The intervals [s] in which nothing supports the figure; None: inferred from keyframes.
        has_cycle: Whether the keyframes form a gait cycle; None: inferred, true only if a cycle is unambiguous.
        period: The period of a gait cycle [s]; None: the likeliest one.
    """

    figure: Figure
    keys: Timeline
    points: tuple[Point, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    contacts: Contacts = Contacts()
    grasps: tuple[Grasp, ...] = ()
    targets: tuple[tuple[Point, float, Array], ...] = ()
    specified_footings: tuple[Footing, ...] | None = None
    specified_flights: tuple[Interval, ...] | None = None
    has_cycle: bool | None = None
    period: float | None = None

    @cached_property
    def root(self) -> int | None:
        """The index of the link on a free joint whose kinematic tree contains the feet; None without a free joint."""
        links = self.figure.tables.free_links
        if not links.size:
            return None
        root = free_root(self.figure, self.points)
        return int(links[0]) if root is None else root

    @cached_property
    def stances(self) -> tuple[Stance, ...]:
        """The stances inferred from keyframes, without those that contradict specified contacts or targets."""
        inferred = stances(self._soles)
        return tuple(s for s in inferred if not self.contacts.overlaps(s) and not self._leaves(s))

    def _leaves(self, stance: Stance) -> bool:
        """Return whether a target of the stance's link is too near or too far for it during the stance."""
        tolerance = Thresholds.of(self.figure).near_surface
        for point, time, target in self.targets:
            if point.link != stance.point.link or not stance.first <= time <= stance.last:
                continue
            known = np.isfinite(target)
            apart = np.linalg.norm((target - stance.place(np.array([time]))[:, 0])[known])
            length = np.linalg.norm(point.position - stance.point.position)
            if apart > length + tolerance or (known.all() and apart < length - tolerance):
                return True
        return False

    @cached_property
    def grasped(self) -> tuple[int, ...]:
        """The indices of the links of grasped objects."""
        return grasped_links(self.figure, self.grasps)

    @property
    def objects(self) -> list[int]:
        """The indices of grasped links with a separate kinematic tree."""
        return [link for link in self.grasped if self.figure.links[link].parent == 0]

    @cached_property
    def resting_objects(self) -> tuple[Stance, ...]:
        """The stances of grasped objects before and after holds."""
        return resting_objects(self._soles, self.objects, self.grasps)

    @cached_property
    def steps(self) -> Steps:
        """The legs that take a step while another leg stands."""
        return Steps.of(self._soles, self._standing)

    @cached_property
    def footings(self) -> tuple[Footing, ...]:
        """The points that can support the figure, each with the interval in which it does."""
        if self.specified_footings is not None or self.root is None:
            return self.specified_footings or ()
        return footings(self._tree_soles, self._carriers, self._tree_body)

    @property
    def flights(self) -> tuple[Interval, ...]:
        """The intervals [s] in which nothing supports the figure: those specified, or falls through keyframes."""
        if self.specified_flights is not None:
            return self.specified_flights
        return tuple((fall.first, fall.last) for fall in self.falls if fall.is_met)

    @cached_property
    def falls(self) -> tuple[Fall, ...]:
        """The free falls through keyframes in the air, including those that keyframes miss."""
        if self.root is None:
            return ()
        carriers = (*self.contacts.stances, *self.contacts.rests, *(grasp for grasp in self.grasps if not grasp.link))
        contacts = [(each.first, each.last) for each in carriers]
        body = self._soles.with_points((*self._tree_soles.points, *self._tree_body))
        air = Air.of(self.root, body, self._tree_soles.points, contacts)
        return () if air is None else tuple(air.falls())

    @property
    def is_grounded(self) -> bool:
        """Whether the figure is on the ground in any keyframe."""
        return bool(self._low_points.touches.any())

    @property
    def landed(self) -> tuple[Interval, ...]:
        """The intervals [s] in which the ground carries the figure.

        They are between a free fall and the keyframe on the ground before or after it, and between two keyframes on the
        ground of which one leaves the height of the root free, if the root does not travel. A specified flight
        implies no contact before or after it.
        """
        keys, blur, intervals = self.keys.times, Thresholds.of(self.figure).lift_off, list[Interval]()
        for begin, end in () if self.specified_flights is not None else self.flights:
            before, after = np.searchsorted(keys, begin) - 1, np.searchsorted(keys, end, side="right")
            if before >= 0 and self._low_points.touches[before]:
                intervals.append((float(keys[before]), begin - blur))
            if after < keys.size and self._low_points.touches[after]:
                intervals.append((end + blur, float(keys[after])))
        if self.root is not None and self.points:
            first = self.figure.links[self.root].qpos
            is_open, down = ~self.keys.fixed[:, first + 2], self._low_points.touches
            travel = np.linalg.norm(np.diff(self.keys.states[:, first : first + 2], axis=0), axis=1)
            is_slow = travel < Thresholds.of(self.figure).travels * np.diff(keys)
            for k in np.flatnonzero((is_open[:-1] | is_open[1:]) & down[:-1] & down[1:] & is_slow).tolist():
                intervals.append((float(keys[k]), float(keys[k + 1])))
        return tuple(interval for interval in intervals if interval[0] < interval[1])

    @cached_property
    def gait_cycle(self) -> GaitCycle | None:
        """The gait cycle of the keyframes; None if they form none."""
        if self.has_cycle is False:
            return None
        gait = Gait(self.figure, self.keys, self.points, self.surfaces)
        if self.has_cycle is None:
            return gait.infer()
        return gait.likeliest() if self.period is None else gait.with_period(self.period)

    @cached_property
    def low_points(self) -> tuple[Point, ...]:
        """The points on soles and body, without grasped objects. A keyframe is grounded if the lowest one is."""
        points = self.exclude_grasped((*self.points, *body_points(self.figure)))
        return points if self.root is None else hanging(self.figure, self.root, points)

    @property
    def touches(self) -> Mask:
        """For each keyframe, whether any sole point is on the ground, (K,)."""
        return self._soles.touches

    def exclude_grasped(self, points: Sequence[Point]) -> tuple[Point, ...]:
        """Return the points that do not belong to grasped objects."""
        return tuple(point for point in points if point.link not in self.grasped)

    @cached_property
    def _soles(self) -> KeyframePoints:
        """`points` at the keyframes."""
        return KeyframePoints.of(self.figure, self.keys, self.points, self.surfaces)

    @cached_property
    def _low_points(self) -> KeyframePoints:
        """`low_points` at the keyframes."""
        return self._soles.with_points(self.low_points)

    @cached_property
    def _tree_soles(self) -> KeyframePoints:
        """The sole points in the kinematic tree of `root`, at the keyframes."""
        return self._soles.with_points(() if self.root is None else hanging(self.figure, self.root, self.points))

    @property
    def _tree_body(self) -> tuple[Point, ...]:
        """The points of the body in the kinematic tree of `root`."""
        return (
            () if self.root is None else hanging(self.figure, self.root, self.exclude_grasped(body_points(self.figure)))
        )

    @property
    def _standing(self) -> tuple[Stance | Rest, ...]:
        """The stances and specified contacts."""
        return (*self.stances, *self.contacts.stances, *self.contacts.rests)

    @property
    def _carriers(self) -> tuple[Stance | Rest, ...]:
        """Those in the kinematic tree of `root`."""
        return tuple(each for each in self._standing if self.figure.tables.path[each.point.link, self.root])
