"""A cylinder: a post, a log or a round table top."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array
from .capsule import across, barrel_span
from .solid import TINY, Solid, directions, lengths


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
