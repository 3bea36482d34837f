"""An ellipsoid: the nearest point of its surface by Newton's method on one equation.

With half axes a_i, the surface point x nearest to y satisfies y_i = x_i (1 + t / a_i²). Hence t is the largest root of
Σ (a_i y_i / (t + a_i²))² = 1. To the left of the root, the left-hand side is convex and decreasing, so Newton's steps
do not pass it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array
from .solid import Solid, lengths, roots

STEPS = 60  # maximum number of Newton steps
ASIDE = 1e-12  # [1] minimum distance from planes of symmetry, relative to the shortest half axis
SETTLED = 1e-14  # [1] relative size of a Newton step that is the last


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
        there = np.maximum(np.abs(local), ASIDE * shortest)
        pull = half * there
        s = np.max(pull - offset, axis=0)  # t + the smallest a²
        for _ in range(STEPS):
            share = pull / (s + offset)
            squared = share * share
            step = (squared.sum(axis=0) - 1) / (2 * np.sum(squared / (s + offset), axis=0))
            s += np.maximum(step, 0)
            if np.all(step <= SETTLED * s):
                break
        share = pull / (s + offset)
        return np.copysign(half * share / np.sqrt(np.sum(share * share, axis=0)), local)
