"""Spheres and capsules: the points within a radius of a point or of a segment, such as a hand rail."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array
from .solid import TINY, Solid, directions, lengths, roots


@dataclass(frozen=True)
class Sphere(Solid):
    """A ball: centre (3,) [m], radius [m]."""

    centre: Array
    radius: float

    def distance(self, points: Array) -> tuple[Array, Array]:
        away = points - self.centre[:, None]
        size = lengths(away)
        return size - self.radius, directions(away, size, np.array([0.0, 0, 1]))

    def least(self, points: Array) -> Array:
        return lengths(points - self.centre[:, None]) - self.radius

    def span(self, points: Array) -> tuple[Array, Array]:
        x, y = points[:2] - self.centre[:2, None]
        low, high = roots(1.0, np.zeros(x.size), x * x + y * y - self.radius**2)
        return self.centre[2] + low, self.centre[2] + high


@dataclass(frozen=True)
class Capsule(Solid):
    """A capsule: centre (3,) [m], unit axis (3,), half length of the segment [m], radius [m]."""

    centre: Array
    axis: Array
    half: float
    radius: float

    def distance(self, points: Array) -> tuple[Array, Array]:
        away = self._from_segment(points)
        size = lengths(away)
        return size - self.radius, directions(away, size, self._across)

    def least(self, points: Array) -> Array:
        return lengths(self._from_segment(points)) - self.radius

    def span(self, points: Array) -> tuple[Array, Array]:
        ends = [Sphere(self.name, self.centre + side * self.half * self.axis, self.radius) for side in (-1, 1)]
        (first_low, first_high), (last_low, last_high) = (end.span(points) for end in ends)
        low, high = barrel_span(points, self.centre, self.axis, self.radius)
        low, high = (np.where(self._is_alongside(points, z), z, np.nan) for z in (low, high))
        return np.fmin(np.fmin(first_low, last_low), low), np.fmax(np.fmax(first_high, last_high), high)

    @cached_property
    def _across(self) -> Array:
        return across(self.axis)

    def _from_segment(self, points: Array) -> Array:
        """Return the vector from the nearest point of the segment, (3, p)."""
        away = points - self.centre[:, None]
        return away - np.multiply.outer(self.axis, np.clip(self.axis @ away, -self.half, self.half))

    def _is_alongside(self, points: Array, z: Array) -> Array:
        """Return whether points at heights z are between the segment's ends."""
        along = self.axis[:2] @ (points[:2] - self.centre[:2, None]) + self.axis[2] * (z - self.centre[2])
        return np.abs(along) <= self.half


def across(axis: Array) -> Array:
    """Return the unit vector across an axis (3,) that rises most."""
    up = np.array([0.0, 0, 1]) - axis[2] * axis
    size = np.linalg.norm(up)
    return up / size if size > TINY else np.array([1.0, 0, 0])


def barrel_span(points: Array, centre: Array, axis: Array, radius: float) -> tuple[Array, Array]:
    """Return the intersections of vertical lines through points (3, p) with an infinite cylinder, as z [m].

    For a vertical cylinder they are infinite.
    """
    away = points - centre[:, None]
    away[2] = -centre[2]
    away -= np.multiply.outer(axis, axis @ away)
    rise = np.array([0.0, 0, 1]) - axis[2] * axis
    squared = float(rise @ rise)
    if squared < TINY:
        within = np.where(lengths(away) <= radius, np.inf, np.nan)
        return -within, within
    return roots(squared, rise @ away, lengths(away) ** 2 - radius**2)
