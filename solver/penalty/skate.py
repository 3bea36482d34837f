"""Feet that stay: a point of the sole near a surface is slow, the slower the nearer.

The paper leaves skidding to future work (§6). Nothing here needs to know when a foot is down: the height says it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..algebra import cross, dot
from ..curvature import Curvature, Sides
from ..kinematics import Cotangent, Samples, attached_pulled_back
from ..quaternion import Array, Index
from ..rows import velocity_rows
from ..surface import Surface
from .contact import Point
from .penalty import Scale

NEGLIGIBLE = 1e-3  # of the weight: higher up a point is free


@dataclass(frozen=True)
class Skate:
    """Σ over points of exp(−(h/reach)²) |v|² [m²/s²]: v the point's velocity, h ≥ 0 its height over the surface below.

    reach   [m] the height at which a point is 1/e as bound as on the surface
    upward  share of the vertical velocity that counts
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    reach: float = 0.04
    upward: float = 1.0
    ref: float = 1.0
    fast: float = np.inf
    name: str = "skate"

    @property
    def scale(self) -> Scale:
        return Scale(self.ref, time_power=2, beside="covariant")

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        links = np.array([point.link for point in self.points], np.intp)
        positions = np.array([point.position for point in self.points]).reshape(-1, 3).T
        return links, positions, np.array([point.radius for point in self.points])

    @cached_property
    def _ways(self) -> Array:
        """(3,) how much each component of the velocity counts."""
        return np.array([1.0, 1.0, np.sqrt(self.upward)])

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        if not self.points or not self.surfaces:
            return np.zeros(samples.count)
        links, positions, radius = self._arrays
        motion = samples.links
        at, arm = motion.points(links, positions)
        height, up = _height(self.surfaces, at, radius)
        velocity = motion.x_d.take(links, axis=1) + cross(motion.omega.take(links, axis=1), arm)
        counted = velocity * self._ways[:, None, None] ** 2
        weight = np.exp(-((height / self.reach) ** 2))
        squared = dot(counted, velocity)
        slow = 1 / (1 + squared / self.fast**2)
        energy = weight * squared * slow
        if into is not None:
            by_velocity = (2 * scale * weight * slow**2) * counted
            into.room("x_d")
            for i, link in enumerate(links):
                into.room("x_d")[:, link] += by_velocity[:, i]
            attached_pulled_back(into, arm, (None, by_velocity, None), links)
            force = (-2 * scale * energy * height / self.reach**2) * up
            flat = links[:, None] * samples.count + np.arange(samples.count)
            into.add_forces(flat.ravel(), arm.reshape(3, -1), force.reshape(3, -1))
        return energy.sum(axis=0)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        if not self.points or not self.surfaces:
            return
        links, positions, radius = self._arrays
        where, arms = samples.links.points(links, positions)
        height, _ = _height(self.surfaces, where, radius)
        weight = np.exp(-((height / self.reach) ** 2))
        at, which = np.nonzero(weight.T > NEGLIGIBLE)
        if not at.size:
            return
        velocity = samples.links.x_d[:, links[which], at] + cross(samples.links.omega[:, links[which], at], arms[:, which, at])
        slow = 1 / (1 + dot(velocity * self._ways[:, None] ** 2, velocity) / self.fast**2)
        arm, share = arms[:, which, at], scale[at] * weight[which, at] * slow**2
        for k, way in enumerate(np.eye(3)):
            if self._ways[k] == 0:
                continue
            ways = np.repeat(way[:, None], at.size, axis=1)
            rows = velocity_rows(samples, at, links[which], arm, ways)
            into.add_rows(at, share * self._ways[k] ** 2, rows, (0, 1))

    def sides(self, samples: Samples) -> Sides | None:
        return None


def _height(surfaces: tuple[Surface, ...], points: Array, radius: Array) -> tuple[Array, Array]:
    """Height of spheres over the nearest surface below (n, S), 0 inside, and its gradient (3, n, S)."""
    heights = np.array([surface.height(points) for surface in surfaces]) - radius[:, None]
    heights[heights < -0.15] = np.inf
    nearest = heights.argmin(axis=0)
    height = np.take_along_axis(heights, nearest[None], axis=0)[0]
    up = np.zeros(points.shape)
    for i, surface in enumerate(surfaces):
        mine = (nearest == i) & np.isfinite(height) & (height > 0)
        if mine.any():
            up += np.where(mine, surface.up[:, None, None], 0)
    return np.maximum(np.where(np.isfinite(height), height, 1e3), 0), up
