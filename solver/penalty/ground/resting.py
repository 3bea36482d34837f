"""Resting points: at rest on a surface from one time to another, wherever that is.

For contacts whose spot nobody has said. Where keyframes say the spot, see `planted`. A foot that is round, as heels and
the tips of shoes are, rolls: what rests of it is its lowest point, which may be another one at every instant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import cross, dot
from ...figure.kinematics import Samples
from ...surface import Plane, Surface
from ...surface.heights import height_over
from ...surface.points import Point
from ..curvature import Curvature
from ..penalty import Penalty, Scale
from .contact import add_by_velocity, point_gradients, velocity_gradients

SETTLING = 0.05  # [s]: a speed counts like the way it makes in so long


@dataclass(frozen=True)
class Rest:
    """A point that rests from `first` to `last` [s]; on a plane, or else on whatever is below it.

    rolls  a sphere may turn on the ground as a wheel does; else its centre rests
    """

    point: Point
    first: float
    last: float
    ground: Plane | None = None
    rolls: bool = False


@dataclass(frozen=True)
class Resting(Penalty):
    """Σ over rests of (0.05 s)² |v|² + h² [m²], h the height of a point, or sphere, over the surface below it, v the
    velocity of what of it rests: that of its centre or, if it rolls, v_centre − r ω × n, n the way up."""

    rests: tuple[Rest, ...]
    surfaces: tuple[Surface, ...]

    @property
    def name(self) -> str:
        return "resting"

    @property
    def scale(self) -> Scale:
        return Scale(1e-4, is_violation=True, is_sharp=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = np.zeros(samples.count)
        scale = scale + values
        for rest, at in self._during(samples.t):
            height, up, offset, foot, velocity = self._seen(samples, rest, at)
            values[at] += SETTLING**2 * dot(velocity, velocity) + height**2
            if into is None:
                continue
            by_velocity = 2 * SETTLING**2 * scale[at] * velocity
            add_by_velocity(into, rest.point.link, at, offset, by_velocity)
            if rest.rolls:
                into.buffer("omega")[:, rest.point.link, at] += cross(foot - offset, by_velocity)
            into.add_forces(rest.point.link * samples.count + at, offset, 2 * scale[at] * height * up)
        return values

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        for rest, at in self._during(samples.t):
            _, up, offset, foot, _ = self._seen(samples, rest, at)
            links = np.full(at.size, rest.point.link)
            into.add_rows(at, scale[at], point_gradients(samples, at, links, offset, up)[:, None], (0,))
            for direction in np.eye(3):
                ways = np.repeat(direction[:, None], at.size, axis=1)
                rows = velocity_gradients(samples, at, links, foot, ways)
                into.add_rows(at, SETTLING**2 * scale[at], rows, (0, 1))

    def _during(self, t: Array) -> list[tuple[Rest, Index]]:
        """The rests with the samples at times t (S,) that they hold for, where there are any."""
        during = [(rest, np.flatnonzero((t >= rest.first) & (t <= rest.last))) for rest in self.rests]
        return [(rest, at) for rest, at in during if at.size]

    def _seen(self, samples: Samples, rest: Rest, at: Index) -> tuple[Array, Array, Array, Array, Array]:
        """Height (P,), its gradient (3, P), the offsets of a point and of what of it rests, and the velocity of that,
        (3, P) each, at samples `at` (P,)."""
        links, point = samples.links, rest.point
        offset = np.einsum("ijp,j->ip", links.rotation[:, :, point.link, at], point.position)
        below = self.surfaces if rest.ground is None else (rest.ground,)
        height, up = height_over(below, (links.x[:, point.link, at] + offset)[:, None], np.array([point.radius]))
        foot = offset - point.radius * up[:, 0] if rest.rolls else offset
        velocity = links.x_d[:, point.link, at] + cross(links.omega[:, point.link, at], foot)
        return height[0], up[:, 0], offset, foot, velocity
