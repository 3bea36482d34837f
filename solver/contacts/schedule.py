"""The schedule of contacts of a clip: when and where the figure touches its surroundings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..array import Array, Mask
from ..curve.frame import Timeline
from ..figure.figure import Figure
from ..surface import Surface
from ..surface.points import Point, body_points, free_root, hanging
from .contact import Contact, Interval
from .flight import Air, Fall
from .gait import Gait, GaitCycle
from .grasp import grasped_links, resting_objects
from .keyframe_points import KeyframePoints
from .stances import Steps, footings, is_grounded, planted_place, stances
from .thresholds import Thresholds


@dataclass(frozen=True, eq=False)
class ContactSchedule:
    """The stances, grasps, flights and gait of a figure over time. What is not specified is inferred once, when needed.

    Attributes:
        figure: The figure.
        keys: The keyframes.
        points: The sole points, or the points of the option `points` of `collision`.
        surfaces: The floor and the obstacles.
        on_ground: The contacts with the surroundings: those that the clip specifies, and the stances of its recording.
        grasps: The contacts with links, which the clip specifies.
        turns: The contacts that hold the rotation of grasped bodies, of points beside the grasps.
        specified_flights: The intervals [s] in which nothing supports the figure; None: inferred from keyframes.
        has_cycle: Whether the keyframes form a gait cycle; None: inferred, true only if a cycle is unambiguous.
        period: The period of a gait cycle [s]; None: the likeliest one.
        is_recording: Whether the frames are those of a recording, so that `on_ground` contains every support.
    """

    figure: Figure
    keys: Timeline
    points: tuple[Point, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    on_ground: tuple[Contact, ...] = ()
    grasps: tuple[Contact, ...] = ()
    turns: tuple[Contact, ...] = ()
    specified_flights: tuple[Interval, ...] | None = None
    has_cycle: bool | None = None
    period: float | None = None
    is_recording: bool = False

    @cached_property
    def root(self) -> int | None:
        """The index of the link on a free joint whose kinematic tree contains the feet; None without a free joint."""
        links = self.figure.tables.free_links
        if not links.size:
            return None
        root = free_root(self.figure, self.points)
        return int(links[0]) if root is None else root

    @cached_property
    def stances(self) -> tuple[Contact, ...]:
        """The stances inferred from keyframes, without those that contradict specified contacts."""
        inferred = stances(self.soles)
        return tuple(stance for stance in inferred if not any(contact.overlaps(stance) for contact in self.on_ground))

    @cached_property
    def grasped(self) -> tuple[int, ...]:
        """The indices of the links of grasped objects."""
        return grasped_links(self.figure, self.grasps)

    @property
    def objects(self) -> list[int]:
        """The indices of grasped links with a separate kinematic tree."""
        return [link for link in self.grasped if self.figure.links[link].parent == 0]

    @cached_property
    def resting_objects(self) -> tuple[Contact, ...]:
        """The stances of grasped objects before and after holds."""
        return resting_objects(self.soles, self.objects, self.grasps)

    @cached_property
    def steps(self) -> Steps:
        """The legs that take a step while another leg stands."""
        return Steps.of(self.soles, (*self.stances, *self.on_ground))

    @cached_property
    def footings(self) -> tuple[Contact, ...]:
        """The contacts that can support the figure. The ground of a recording is taken to be level."""
        if self.root is None:
            return ()
        if self.is_recording:
            return tuple(replace(contact, surface=None) for contact in self.on_ground)
        rests = (*self.stances, *self.on_ground)
        carriers = [rest for rest in rests if self.figure.tables.path[rest.point.link, self.root]]
        return footings(self._tree_soles, carriers, self._tree_body)

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
        contacts = [(contact.first, contact.last) for contact in self.on_ground]
        body = self.soles.with_points((*self._tree_soles.points, *self._tree_body))
        air = Air.of(self.root, body, self._tree_soles.points, contacts)
        return () if air is None else tuple(air.falls())

    @cached_property
    def is_grounded(self) -> Mask:
        """Whether any of `low_points` is on the ground in each keyframe, (K,)."""
        return is_grounded(self.soles.with_points(self.low_points))

    @property
    def grounded_intervals(self) -> tuple[Interval, ...]:
        """The intervals [s] in which the ground carries the figure.

        They are between a free fall and the keyframe on the ground before or after it, and between two keyframes on the
        ground of which one leaves the height of the root free, if the root does not travel. A specified flight
        implies no contact before or after it.
        """
        keys, blur, intervals = self.keys.times, Thresholds.of(self.figure).lift_off, list[Interval]()
        for begin, end in () if self.specified_flights is not None else self.flights:
            before, after = np.searchsorted(keys, begin) - 1, np.searchsorted(keys, end, side="right")
            if before >= 0 and self.is_grounded[before]:
                intervals.append((float(keys[before]), begin - blur))
            if after < keys.size and self.is_grounded[after]:
                intervals.append((end + blur, float(keys[after])))
        if self.root is not None and self.points:
            first = self.figure.links[self.root].qpos
            is_open, down = ~self.keys.fixed[:, first + 2], self.is_grounded
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
        gait = Gait(self.soles)
        if self.has_cycle is None:
            return gait.infer()
        return gait.likeliest() if self.period is None else gait.with_period(self.period)

    @cached_property
    def soles(self) -> KeyframePoints:
        """The sole points at the keyframes."""
        return KeyframePoints.of(self.figure, self.keys, self.points, self.surfaces)

    @cached_property
    def low_points(self) -> tuple[Point, ...]:
        """The points on soles and body, without grasped objects. A keyframe is grounded if the lowest one is."""
        points = self.exclude_grasped((*self.points, *body_points(self.figure)))
        return points if self.root is None else hanging(self.figure, self.root, points)

    @cached_property
    def resting_points(self) -> KeyframePoints:
        """The sole points, and the other points of contacts at known positions, at the keyframes."""
        points = list(self.points)
        for contact in self.on_ground:
            if contact.is_placed and not any(contact.point.coincides(other) for other in points):
                points.append(contact.point)
        return self.soles.with_points(points)

    def rest(self, i: int, k: int) -> Array | None:
        """Return the position (3,) [m] where one of `resting_points` rests at keyframe k, which leaves it free.

        It is that of the contact that covers the keyframe, or that of a stance if the keyframe sets no joint of the
        limb. It is None for other points, and for contacts that contradict each other or have no position.
        """
        point, t = self.resting_points.points[i], self.keys.times[[k]]
        contacts = [each for each in self.on_ground if each.covers(t[0]) and each.point.coincides(point)]
        if contacts:
            spots = [contact.place(t)[:, 0] for contact in contacts if contact.is_placed]
            same = Thresholds.of(self.figure).same_spot
            return spots[0] if spots and all(np.linalg.norm(spot - spots[0]) < same for spot in spots) else None
        limb = self.figure.limb(self.figure.links[point.link].body)
        is_set = any(self.keys.fixed[k, self.figure.links[link].columns].any() for link in limb)
        return None if is_set or i >= len(self.points) else planted_place(self.resting_points, i, k)

    def exclude_grasped(self, points: Sequence[Point]) -> tuple[Point, ...]:
        """Return the points that do not belong to grasped objects."""
        return tuple(point for point in points if point.link not in self.grasped)

    @cached_property
    def _tree_soles(self) -> KeyframePoints:
        """The sole points in the kinematic tree of `root`, at the keyframes."""
        return self.soles.with_points(() if self.root is None else hanging(self.figure, self.root, self.points))

    @property
    def _tree_body(self) -> tuple[Point, ...]:
        """The points of the body in the kinematic tree of `root`."""
        return (
            () if self.root is None else hanging(self.figure, self.root, self.exclude_grasped(body_points(self.figure)))
        )
