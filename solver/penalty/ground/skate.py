"""Foot skate: the closer a sole point is to a surface, the more its velocity costs.

The paper leaves skidding to future work (§6). Contact times are not needed, because the weight depends on the height.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from ...array import Array, Index, Mask, segments_at
from ...contacts.thresholds import Thresholds
from ...figure.algebra import cross, dot
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches, of_point, of_velocity
from ...surface import Surface
from ...surface.heights import clearance_gradients, clearances
from ...surface.points import Point, arrays_of
from ..block import Block
from ..curvature import Curvature
from ..penalty import Normalization, Penalty

LEAST_IN_MODEL, LEAST = 0.03, 1e-8  # [1] smallest root of the weight of a point in a model of E, and in E
LOWEST = -0.25  # [1] height, relative to the reach, below which the weight is constant
WORTH = 1e-3  # [m² rad⁻² s²] reference value: 3 cm/s of a point on the ground cost as much as half a radian per s²


class _Near(NamedTuple):
    """P points near a surface at samples.

    Attributes:
        at: Samples, (P,).
        share: Roots of the weights, (P,).
        velocity: Velocities, (3, P) [m/s].
        speed: Their lengths, (P,) [m/s].
        by_velocity: Returns the derivatives of direction · v for directions (3, P).
        by_weight: The derivatives of √weight · |v| by the weight alone.
    """

    at: Index
    share: Array
    velocity: Array
    speed: Array
    by_velocity: Callable[[Array], Wrenches]
    by_weight: Wrenches


@dataclass(frozen=True)
class Skate(Penalty):
    """Σ over points of exp(−u (u + ½) / 1.5) |v|² [m²/s²]: v the point's velocity, u = h/reach, h its height.

    The height is that over the surface below, and u is at least −¼. On the surface, the weight already falls with the
    height, so a foot that would slide is raised.

    Unlike other terms, it is not divided by its own integral over the raw spline, which may skate little or much. It
    has the divisor of the squared angular accelerations, see `Normalization.normalize_by`.

    Attributes:
        reach: The height at which the weight of a point is 1/e of the weight on the surface [m].
        key_times: The times of the keyframes, (K,) [s].
        swings: Whether each of the n points may slip in each segment between keyframes, (n, K − 1); None: never.
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    reach: float = Thresholds.slip_reach
    key_times: Array | None = None
    swings: Mask | None = None

    name = "no_slip"
    normalization = Normalization(WORTH, length_power=2, time_power=2, normalize_by="acceleration.angular")

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """The links (n,) of the points, their positions (3, n) [m] and radii (n,) [m]."""
        return arrays_of(self.points)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for near in self._near(samples, LEAST):
            by_velocity = near.by_velocity(near.share * near.velocity / np.maximum(near.speed, LEAST))
            changes = by_velocity, near.by_weight
            yield Block(near.at, near.share * near.speed, changes, curved=self._add_curvature)

    def _add_curvature(self, into: Curvature, scale: Array) -> None:
        """Add the matrices of √weight · v with its derivatives by v, and of √weight · |v| with that by the weight.

        The gradient of E contains both kinds of derivatives. Without the second kind, the model would have no curvature
        in the height of a moving point, and raising it would seem to reduce E without limit. If the same residuals had
        both kinds, the model would make it costly to raise a point that stops in the same step of the search.
        """
        for near in self._near(into.samples, LEAST_IN_MODEL):
            value = near.share * near.velocity
            for k, axis in enumerate(np.eye(3)):
                Block(near.at, value[k], (near.by_velocity(near.share * axis[:, None]),)).add_to(into, scale)
            Block(near.at, near.share * near.speed, (near.by_weight,)).add_to(into, scale)

    def _near(self, samples: Samples, least: float) -> Iterator[_Near]:
        """Yield the points with √weight above `least`."""
        if not self.points or not self.surfaces:
            return
        links, positions, radius = self._arrays
        motion = samples.links
        where, arms = motion.points(links, positions)
        height, origin = clearances(self.surfaces, where, radius)
        relative = np.maximum(height / self.reach, LOWEST)
        root = np.sqrt(self._weight(relative, samples.t))
        at, which = np.nonzero(least < root.T)
        link, offset, share = links[which], arms[:, which, at], root[which, at]
        velocity = motion.x_d[:, link, at] + cross(motion.omega[:, link, at], offset)
        up = clearance_gradients(self.surfaces, origin[which, at], where[:, which, at], radius[which])
        fading = share * (LOWEST - relative[which, at]) / (1.5 * self.reach) * up  # of `share`, by position
        speed, by_velocity = np.sqrt(dot(velocity, velocity)), partial(of_velocity, samples, at, link, offset)
        yield _Near(at, share, velocity, speed, by_velocity, of_point(at, link, offset, fading * speed))

    def _weight(self, height: Array, t: Array) -> Array:
        """Return the weights (n, S) of points at heights (n, S) over the ground, relative to the reach."""
        near = np.exp(-height * (height + 0.5) / 1.5)
        if self.swings is None or self.key_times is None:
            return near
        return np.where(self.swings[:, segments_at(self.key_times, t)], 0.0, near)
