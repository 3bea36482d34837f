"""Contacts: points that stay in one place for a time, specified by a clip, or inferred from keyframes or a recording.

Feet on the ground, hands on a body that they grasp, objects at rest and the ends of a closed loop are all contacts. The
paper leaves skidding to future work (§6).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask
from ..figure.algebra import cross
from ..surface import Plane
from ..surface.points import Point
from ..tolerances import ROUNDING

Interval = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Contact:
    """A point that stays in one place of the world, or of another link, from `first` to `last`.

    Attributes:
        point: The point.
        first: The start of the contact [s]; minus infinity: of the motion.
        last: The end of the contact [s]; infinity: of the motion.
        on: The index of the link that the point touches; 0: the world.
        places: The positions at `times`, (m, 3) [m] in the axes of `on`; NaN along unconstrained axes of the world.
            They change linearly between the times, and are constant before and after them. Without any, the search
            determines the position, and the point must not slide.
        times: The times of the positions, ascending, (m,) [s].
        slack: The distances from the positions without cost, (m,) [m]; None: zero. If a keyframe puts a held body out
            of a limb's reach, only a stretched limb approaches the position. Without slack it would whip there and
            back.
        specified: The position that a clip specifies (3,) [m], from which keyframes may differ a little; None without.
        surface: The plane that the point touches; None: any surface below it.
        rolls: Whether a sphere may roll on the surface like a wheel; otherwise its centre rests.
        start: The orientation (4,) of the link in which a sphere that rolls is at its position; None: any.
        weight: The weight relative to other contacts [1].
    """

    point: Point
    first: float
    last: float
    on: int = 0
    places: Array | None = None
    times: Array | None = None
    slack: Array | None = None
    specified: Array | None = None
    surface: Plane | None = None
    rolls: bool = False
    start: Array | None = None
    weight: float = 1.0

    @classmethod
    def at(cls, point: Point, first: float, last: float, place: Array, *, on: int = 0) -> Contact:
        """Return a contact at one position (3,) [m] in the axes of link `on`."""
        return cls(point, first, last, on, place[None], np.array([first]))

    @property
    def is_placed(self) -> bool:
        """Whether the position is known."""
        return self.places is not None

    @property
    def normal(self) -> Array:
        """The unit normal (3,) of the surface; without one it is level."""
        return np.array([0.0, 0, 1]) if self.surface is None else self.surface.normal

    def place(self, t: Array) -> Array:
        """Return the positions at times t (S,) [s] of a contact with a known position, (3, S) [m], in the axes of
        `on`."""
        assert self.places is not None and self.times is not None
        if len(self.places) == 1:
            return np.repeat(self.places.T, t.size, axis=1)
        return np.array([np.interp(t, self.times, axis) for axis in self.places.T])

    def roll(self, turned: Array) -> Array:
        """Return the displacements (3, k) [m] of a sphere's centre that rolls while its link turns from `start` to
        orientations (4, k), each about a fixed axis; zero without `start`."""
        if self.start is None or not self.rolls:
            return np.zeros((3, turned.shape[1]))
        turns = quat.rotation_vector(quat.product(turned.T, quat.inverse(self.start)))
        return cross(turns.T, self.point.radius * self.normal[:, None])

    def pieces(self) -> list[Contact]:
        """Return contacts with at most two positions, in order of time, which together are this one."""
        if self.times is None or len(self.times) == 1:
            return [self]
        inner = [t for t in self.times.tolist() if self.first + ROUNDING < t < self.last - ROUNDING]
        edges = np.array([self.first, *inner, self.last])
        places, slack = self.place(edges).T, None if self.slack is None else np.interp(edges, self.times, self.slack)
        return [
            replace(
                self,
                first=float(edges[k]),
                last=float(edges[k + 1]),
                times=edges[k : k + 2],
                places=places[k : k + 2],
                slack=None if slack is None else slack[k : k + 2],
            )
            for k in range(edges.size - 1)
        ]

    def covers(self, t: float) -> bool:
        """Return whether a time [s] is within the contact."""
        return self.first - ROUNDING <= t <= self.last + ROUNDING

    def during(self, t: Array) -> Mask:
        """Return which times t (S,) [s] are within the contact, (S,)."""
        return np.asarray((self.first <= t) & (t <= self.last))

    def meets(self, first: float, last: float) -> bool:
        """Return whether the contact overlaps an interval [s]."""
        return self.first < last - ROUNDING and first < self.last - ROUNDING

    def overlaps(self, other: Contact) -> bool:
        """Return whether another contact of the same point overlaps this one in time."""
        return self.meets(other.first, other.last) and self.point.coincides(other.point)


def within(intervals: Sequence[Interval], t: Array) -> Mask:
    """Return which times t (S,) [s] are in one of the intervals, (S,)."""
    edges = np.reshape(intervals, (-1, 2))
    return np.any((edges[:, :1] <= t) & (t <= edges[:, 1:]), axis=0)
