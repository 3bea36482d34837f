"""An ellipsoid: the nearest point of its surface by Newton's method on one equation.

With half axes a_i the nearest point x of a point y has y_i = x_i (1 + t / a_i²), so that t is the largest root of
Σ (a_i y_i / (t + a_i²))² = 1. From the left the left-hand side is convex and falls: Newton's steps never pass the root.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array
from .solid import Solid, lengths, roots

STEPS = 60  # of Newton, at most
ASIDE = 1e-12  # of the shortest half axis: how far a point in a plane of symmetry is moved out of it
SETTLED = 1e-14  # of the unknown: a step of Newton that is no longer is the last


@dataclass(frozen=True)
class Ellipsoid(Solid):
    """centre (3,) [m], axes (3, 3) by columns, half axes (3,) [m]"""

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
        """The nearest points of the surface, in the ellipsoid's axes (3, p)."""
        half = self.half[:, None]
        shortest = float(self.half.min())
        offset = half**2 - shortest**2
        # a point in a plane of symmetry is moved out of it by next to nothing: inside, two points are nearest then
        there = np.maximum(np.abs(local), ASIDE * shortest)
        pull = half * there
        s = np.max(pull - offset, axis=0)  # t + the least a²
        for _ in range(STEPS):
            share = pull / (s + offset)
            squared = share * share
            step = (squared.sum(axis=0) - 1) / (2 * np.sum(squared / (s + offset), axis=0))
            s += np.maximum(step, 0)
            if np.all(step <= SETTLED * s):
                break
        share = pull / (s + offset)
        return np.copysign(half * share / np.sqrt(np.sum(share * share, axis=0)), local)
