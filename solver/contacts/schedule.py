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
from .flight import flights
from .footing import Footing, Interval, footings
from .footsteps import Footsteps, footsteps
from .gait import GaitCycle
from .gait_period import Gait
from .grasp import Grasp, grasped_links, resting_objects
from .keyframe_points import KeyframePoints
from .stance import Rest, Stance, stances
from .steps import Steps, hops
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
        alone = tuple(s for s in inferred if not self.contacts.overlaps(s) and not self._leaves(s))
        return (*alone, *(stance for steps in self.footsteps for stance in self._unspecified(steps)))

    @cached_property
    def footsteps(self) -> tuple[Footsteps, ...]:
        """The steps between keyframes, in the first order that contradicts no specified contact or target.

        There are none in a gait cycle, which has its own steps, and none if the footings are specified.
        """
        if self.specified_footings is not None:
            return ()
        inferred = footsteps(self._soles.with_points(self.stepping_points))
        if not inferred or self.gait_cycle is not None:
            return ()
        fitting = [[steps for steps in orders if self._fits(steps)] for orders in inferred]
        return tuple(orders[0] for orders in fitting if orders)

    def _fits(self, steps: Footsteps) -> bool:
        """Return whether no specified contact, flight or target contradicts steps."""
        begin, end = self.keys.times[steps.segment : steps.segment + 2].tolist()
        flies = any(first < end and begin < last for first, last in self.specified_flights or ())
        is_held = any(self.contacts.holds(swing.point.link, swing.first, swing.last) for swing in steps.swings)
        return not (flies or is_held or any(self._leaves(stance) for stance in self._unspecified(steps)))

    @property
    def stepping_points(self) -> tuple[Point, ...]:
        """The sole points that can step: those of the first figure on a free joint with feet, else all; not grasped."""
        root = free_root(self.figure, self.points)
        return self.exclude_grasped(self.points if root is None else hanging(self.figure, root, self.points))

    def _unspecified(self, steps: Footsteps) -> list[Stance]:
        """Return the stances of steps that specified contacts do not replace."""
        return [stance for stance in steps.stances if not self.contacts.overlaps(stance)]

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

    @property
    def step_durations(self) -> Array:
        """The time for a step in each segment between keyframes, (K − 1,) [s]."""
        durations = np.diff(self.keys.times)
        for steps in self.footsteps:
            durations[steps.segment] /= steps.count
        return durations

    @cached_property
    def footings(self) -> tuple[Footing, ...]:
        """The points that can support the figure, each with the interval in which it does."""
        if self.specified_footings is not None or self.root is None:
            return self.specified_footings or ()
        return footings(self._tree_soles, self._carriers, self._tree_body)

    @cached_property
    def flights(self) -> tuple[Interval, ...]:
        """The intervals [s] in which nothing supports the figure."""
        if self.specified_flights is not None or self.root is None:
            return self.specified_flights or ()
        return flights(self.root, self._tree_soles, self._carriers, self._tree_body)

    @property
    def has_support(self) -> bool:
        """Whether there is an interval in which the support of the figure is known: a footing or a flight."""
        return bool(self.footings or self.flights)

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
    def grounded(self) -> tuple[Interval, ...]:
        """The segments [s] whose two keyframes touch the ground, except hops, flights and `held_down`."""
        lift_off = Thresholds.of(self.figure).lift_off
        intervals = grounded_intervals(self.keys, self._low_points.touches, self.hops, self.flights, lift_off)
        return tuple(interval for interval in intervals if interval not in self.held_down)

    @cached_property
    def hops(self) -> Mask:
        """The segments in which a figure on one leg has to hop, (K − 1,)."""
        return hops(self._low_points)

    @cached_property
    def held_down(self) -> tuple[Interval, ...]:
        """The intervals [s] next to keyframes on the ground that leave the root's height free, except flights."""
        if self.root is None or not self.points:
            return ()
        is_open = ~self.keys.fixed[:, self.figure.links[self.root].qpos + 2]
        return open_intervals(self.keys, self._low_points.touches, is_open, self.flights)

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


def grounded_intervals(
    keys: Timeline, down: Mask, is_hop: Mask, flights: Sequence[Interval] = (), lift_off: float = 0.0
) -> tuple[Interval, ...]:
    """Return the segments between two keyframes on the ground, `down` (K,), without hops (K − 1,) and flights.

    If a flight begins or ends between keyframes, the interval between it and the keyframe on the ground is added, but
    for `lift_off` [s] next to the flight.
    """
    is_grounded = down[:-1] & down[1:] & ~is_hop
    segments = zip(keys.times[:-1].tolist(), keys.times[1:].tolist(), is_grounded, strict=True)
    intervals = list(_outside(flights, [(first, last) for first, last, near in segments if near]))
    for begin, end in flights:
        before, after = np.searchsorted(keys.times, begin) - 1, np.searchsorted(keys.times, end, side="right")
        if down[before] and begin - lift_off > keys.times[before]:  # false if no keyframe is before the flight
            intervals.append((float(keys.times[before]), begin - lift_off))
        if after < keys.times.size and down[after] and end + lift_off < keys.times[after]:
            intervals.append((end + lift_off, float(keys.times[after])))
    return tuple(sorted(intervals))


def open_intervals(keys: Timeline, down: Mask, is_open: Mask, flights: Sequence[Interval] = ()) -> tuple[Interval, ...]:
    """Return intervals next to keyframes on the ground, `down` (K,), that leave the root's height free, `is_open` (K,).

    Such an interval extends to the neighbouring keyframe if this touches the ground, else over a part of the segment.
    Intervals that overlap flights are omitted.
    """
    is_open = is_open & down
    intervals: list[Interval] = []
    for k in np.flatnonzero(is_open[:-1] | is_open[1:]).tolist():
        (first, last), begins, ends = keys.times[k : k + 2].tolist(), is_open[k], is_open[k + 1]
        part = 1.0 if down[k] and down[k + 1] else 0.25  # of a segment into the air
        if begins:
            intervals.append((first, first + part * (last - first)))
        elif ends:
            intervals.append((last - part * (last - first), last))
    return _outside(flights, intervals)


def _outside(flights: Sequence[Interval], intervals: Sequence[Interval]) -> tuple[Interval, ...]:
    """Return the intervals that overlap no flight."""
    return tuple(one for one in intervals if not any(begin < one[1] and one[0] < end for begin, end in flights))
