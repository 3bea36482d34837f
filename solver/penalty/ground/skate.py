"""Feet that stay: a point of the sole near a surface is slow, the slower the nearer.

The paper leaves skidding to future work (§6). No times of contact are needed: the height decides.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...curve.frame import Timeline
from ...figure.algebra import cross
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ...surface import Surface
from ...surface.heights import height_over
from ...surface.points import Point, arrays_of, placed, places_of
from ..block import Block
from ..penalty import Normalization, Penalty, Role

NEGLIGIBLE, TINY = 0.03, 1e-8  # of the weight's root: higher up a point is free in a model of E, and in E
STRIDDEN = 0.08  # [m] between two neighbouring keyframes, from which on a point is in the air in between
SHORTLY = 0.25  # [s] between them, up to which it cannot stand on the way as well
LONG = 0.45  # [s] between two keyframes, from which on they say little about the feet in between
WORTH = 1e-3  # [m² rad⁻² s²]: 3 cm/s of a point on the ground count like half a radian per s²
REACH = 0.04  # [m] by default


@dataclass(frozen=True, eq=False)
class Bound:
    """How much points are bound from keyframe to keyframe: key times (K,) [s], shares of the weight (n, K − 1)."""

    times: Array
    shares: Array

    @classmethod
    def of(cls, figure: Figure, keys: Timeline, points: Sequence[Point], *, swings: bool = True) -> Bound:
        """Less in a long segment, by the square of its length: a foot may take steps there. Not at
        all, if it may be that a foot `swings`, where two keyframes up to 0.25 s apart put a point more than 8 cm apart:
        one that comes so far so fast passes low, and is not to be braked."""
        spans = np.diff(keys.times)
        shares = np.tile(np.minimum(1.0, (LONG / spans) ** 2), (len(points), 1))
        if swings:
            samples = Samples.still(figure, keys.states)
            centres, _, _ = places_of(points, samples)
            steps = np.linalg.norm(np.diff(centres, axis=2), axis=0)
            is_set = placed(figure, keys.known, points)
            shares[(steps > STRIDDEN) & (spans <= SHORTLY) & is_set[:, 1:] & is_set[:, :-1]] = 0.0
        return cls(keys.times, shares)

    def at(self, t: Array) -> Array:
        """(n, S) at times t (S,) [s]."""
        span = np.searchsorted(self.times, t, side="right") - 1
        return self.shares[:, np.clip(span, 0, self.times.size - 2)]


@dataclass(frozen=True)
class Skate(Penalty):
    """Σ over points of exp(−(h/reach)²) |v|² [m²/s²]: v the point's velocity, h ≥ 0 its height over the surface below.

    Counts beside the angular accelerations, not by what the raw spline happens to skate: so the clock of the clip and
    the distance of its keyframes do not matter.

    reach   [m] the height at which a point is 1/e as bound as on the surface
    bound   how much which points are bound when, however low; None: all are, always
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    reach: float = REACH
    bound: Bound | None = None

    name = "no_slip"
    role = Role.CONTACT
    normalization = Normalization(WORTH, time_power=2, normalize_by="acceleration.angular")

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points."""
        return arrays_of(self.points)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        return self._slides(samples, TINY)

    def nearby(self, samples: Samples) -> Iterator[Block]:
        """With the weight held: squares of what it changes by would keep down a foot that costs less higher up."""
        for block in self._slides(samples, NEGLIGIBLE):
            velocity, _ = block.changes
            yield replace(block, changes=(velocity,))

    def _slides(self, samples: Samples, least: float) -> Iterator[Block]:
        """√weight · v where √weight is more than `least`; it changes with v and, by the weight, with the height."""
        if not self.points or not self.surfaces:
            return
        links, positions, radius = self._arrays
        motion = samples.links
        where, arms = motion.points(links, positions)
        height, up = height_over(self.surfaces, where, radius)
        np.maximum(height, 0, out=height)
        root = np.sqrt(self._weight(height, samples.t))
        at, which = np.nonzero(least < root.T)
        link, arm, share, high = links[which], arms[:, which, at], root[which, at], height[which, at]
        velocity = motion.x_d[:, link, at] + cross(motion.omega[:, link, at], arm)
        fading = (-share * high / self.reach**2 * velocity).ravel()
        value, normals = (share * velocity).ravel(), np.tile(up[:, which, at], 3)
        arm, share = np.tile(arm, 3), np.tile(share, 3)
        at, link, axes = along_axes(at, link)
        changes = of_velocity(samples, at, link, arm, share * axes), of_point(at, link, arm, fading * normals)
        yield Block(at, value, changes)

    def _weight(self, height: Array, t: Array) -> Array:
        """(n, S) how much points at heights (n, S) over the ground are bound."""
        near = np.exp(-((height / self.reach) ** 2))
        return near if self.bound is None else near * self.bound.at(t)
