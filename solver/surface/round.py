"""Round solids: capsules, cylinders and ellipsoids, such as posts, hand rails, logs and round table tops.

The nearest point of an ellipsoid is found by Newton's method on one equation. With half axes a_i, the surface point x
nearest to y satisfies y_i = x_i (1 + t / a_i²). Hence t is the largest root of Σ (a_i y_i / (t + a_i²))² = 1. To the
left of the root, the left-hand side is convex and decreasing, so Newton's steps do not pass it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array
from ..tolerances import LAST_STEP, NEWTON_STEPS, TINY
from .solid import Solid, directions, lengths, roots


@dataclass(frozen=True)
class Capsule(Solid):
    """A capsule: centre (3,) [m], unit axis (3,), half length of the segment [m], 0 for a sphere, radius [m]."""

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
        if not self.half:
            return _ball_span(points, self.centre, self.radius)
        ends = (self.centre + side * self.half * self.axis for side in (-1, 1))
        (first_low, first_high), (last_low, last_high) = (_ball_span(points, end, self.radius) for end in ends)
        low, high = barrel_span(points, self.centre, self.axis, self.radius)
        low, high = (np.where(self._is_alongside(points, z), z, np.nan) for z in (low, high))
        return np.fmin(np.fmin(first_low, last_low), low), np.fmax(np.fmax(first_high, last_high), high)

    @cached_property
    def _across(self) -> Array:
        return across(self.axis)

    def _from_segment(self, points: Array) -> Array:
        """Return the vector from the nearest point of the segment, (3, p)."""
        away = points - self.centre[:, None]
        if not self.half:
            return away
        return away - np.multiply.outer(self.axis, np.clip(self.axis @ away, -self.half, self.half))

    def _is_alongside(self, points: Array, z: Array) -> Array:
        """Return whether points at heights z are between the segment's ends."""
        along = self.axis[:2] @ (points[:2] - self.centre[:2, None]) + self.axis[2] * (z - self.centre[2])
        return np.abs(along) <= self.half


def _ball_span(points: Array, centre: Array, radius: float) -> tuple[Array, Array]:
    """Return the intersections of vertical lines through points (3, p) with a sphere, as z [m]."""
    x, y = points[:2] - centre[:2, None]
    low, high = roots(1.0, np.zeros(x.size), x * x + y * y - radius**2)
    return centre[2] + low, centre[2] + high


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


@dataclass(frozen=True)
class Cylinder(Solid):
    """A cylinder: centre (3,) [m], unit axis (3,), half length [m], radius [m]."""

    centre: Array
    axis: Array
    half: float
    radius: float

    def distance(self, points: Array) -> tuple[Array, Array]:
        along, away, size = self._split(points)
        past = np.array([size - self.radius, np.abs(along) - self.half])
        side = directions(away, size, self._across)
        end = np.multiply.outer(self.axis, np.where(along < 0, -1.0, 1.0))
        over = np.maximum(past, 0)
        corner = np.hypot(*over)
        outside = corner > TINY
        rim = (over[0] * side + over[1] * end) / np.where(outside, corner, 1.0)
        inward = np.where(past[0] > past[1], side, end)
        return np.where(outside, corner, past.max(axis=0)), np.where(outside, rim, inward)

    def least(self, points: Array) -> Array:
        along, _, size = self._split(points)
        return np.maximum(size - self.radius, np.abs(along) - self.half)

    def span(self, points: Array) -> tuple[Array, Array]:
        low, high = barrel_span(points, self.centre, self.axis, self.radius)
        across_lines = self.axis[:2] @ (points[:2] - self.centre[:2, None])
        if abs(self.axis[2]) < TINY:
            within = np.where(np.abs(across_lines) <= self.half, np.inf, np.nan)
            ends = np.array([-within, within])
        else:
            ends = self.centre[2] + (np.array([[-self.half], [self.half]]) - across_lines) / self.axis[2]
            ends.sort(axis=0)
        bottom, top = np.maximum(low, ends[0]), np.minimum(high, ends[1])
        return np.where(bottom <= top, bottom, np.nan), np.where(bottom <= top, top, np.nan)

    @cached_property
    def _across(self) -> Array:
        return across(self.axis)

    def _split(self, points: Array) -> tuple[Array, Array, Array]:
        """Return distance along the axis (p,), vector from the axis (3, p), and its length (p,)."""
        away = points - self.centre[:, None]
        along = self.axis @ away
        away -= np.multiply.outer(self.axis, along)
        return along, away, lengths(away)


@dataclass(frozen=True)
class Ellipsoid(Solid):
    """An ellipsoid: centre (3,) [m], axes (3, 3) as columns, half axes (3,) [m]."""

    centre: Array
    axes: Array
    half: Array

    def distance(self, points: Array) -> tuple[Array, Array]:
        local = self._local(points)
        foot = self._foot(local)
        normal = foot / self.half[:, None] ** 2
        normal /= lengths(normal)
        distance = np.einsum("ip,ip->p", normal, local - foot)
        return distance, self.axes @ normal

    def least(self, points: Array) -> Array:
        return lengths(points - self.centre[:, None]) - self.half.max()

    def span(self, points: Array) -> tuple[Array, Array]:
        flat = np.array([*points[:2], np.full(points.shape[1], self.centre[2])])
        rise, level = self.axes[2] / self.half, self._local(flat) / self.half[:, None]
        low, high = roots(float(rise @ rise), rise @ level, np.einsum("ip,ip->p", level, level) - 1)
        return self.centre[2] + low, self.centre[2] + high

    def _local(self, points: Array) -> Array:
        return self.axes.T @ (points - self.centre[:, None])

    def _foot(self, local: Array) -> Array:
        """Return the nearest points of the surface, in the ellipsoid's axes (3, p)."""
        half = self.half[:, None]
        shortest = float(self.half.min())
        offset = half**2 - shortest**2
        # a point in a plane of symmetry inside has two nearest points: a tiny displacement selects one
        there = np.maximum(np.abs(local), TINY * shortest)
        pull = half * there
        s = np.max(pull - offset, axis=0)  # t + the smallest a²
        for _ in range(NEWTON_STEPS):
            share = pull / (s + offset)
            squared = share * share
            step = (squared.sum(axis=0) - 1) / (2 * np.sum(squared / (s + offset), axis=0))
            s += np.maximum(step, 0)
            if np.all(step <= LAST_STEP * s):
                break
        share = pull / (s + offset)
        return np.copysign(half * share / np.sqrt(np.sum(share * share, axis=0)), local)
