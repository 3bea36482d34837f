"""Points at rest on a surface for an interval, at any position.

This is for contacts without a specified position; for others see `stance`. A round foot, such as the heel or the tip
of a shoe, rolls: its lowest point rests, which may be another one at every instant.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...contacts.stance import Rest
from ...contacts.thresholds import Thresholds
from ...figure.algebra import cross, dot
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ...surface import Surface
from ...surface.heights import height_over
from ...surface.points import arrays_of
from ..block import Block
from ..penalty import Normalization, Penalty

UP = np.array([0.0, 0, 1])  # normal of level ground


@dataclass(frozen=True, eq=False)
class Rolling:
    """A sphere of a link that rolls on a plane: the displacement of its centre without slip.

    offset  (3,) [m] from the lowest point of the sphere to its centre
    start   (4,) orientation of the link for which the displacement is zero
    """

    offset: Array
    start: Array

    @classmethod
    def of(cls, rest: Rest, start: Array) -> Rolling:
        """Return the rolling of a rest whose link has an orientation (4,) in its place; the arm is zero for none."""
        up = UP if rest.ground is None else rest.ground.normal
        return cls(rest.rolls * rest.point.radius * up, start)

    def displacement(self, turned: Array) -> Array:
        """Return displacements (3, k) [m] of the centre if the link turns to (4, k), each about a fixed axis."""
        return cross(quat.rotation_vector(quat.product(turned.T, quat.inverse(self.start))).T, self.offset[:, None])


@dataclass(frozen=True)
class RestPenalty(Penalty):
    """Σ over rests of (0.05 s)² |v|² + h² [m²], with h the height of a point or sphere above the surface below it.

    The velocity v is that of the resting material: of the centre or, if it rolls, v_centre − r ω × n with the normal n.
    """

    rests: tuple[Rest, ...]
    surfaces: tuple[Surface, ...]

    name = "attach.contact"
    normalization = Normalization(1e-4, length_power=2, is_violation=True, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        below = self._resting(samples)
        yield Block(below.at, below.height, (of_point(below.at, below.link, below.offset, below.up),))
        at, link, axes = along_axes(below.at, below.link)
        moved = of_velocity(samples, at, link, np.tile(below.foot, 3), axes, turning=np.tile(below.offset, 3))
        yield Block(at, below.velocity.ravel(), (moved,), Thresholds.of(samples.figure).settling ** 2)

    @cached_property
    def _grounds(self) -> tuple[Mask, Array, Array]:
        """Mask (n,) of the rests with a plane, the planes' normals (3, n), and offsets (n,) [m] along these."""
        planes = [rest.ground for rest in self.rests]
        normals = np.array([np.zeros(3) if plane is None else plane.normal for plane in planes]).reshape(-1, 3).T
        along = [0.0 if plane is None else float(plane.normal @ plane.point) for plane in planes]
        return np.array([plane is not None for plane in planes], bool), normals, np.array(along)

    def _during(self, t: Array) -> tuple[Index, Index]:
        """Return pairs of a rest and a sample within it, (P,) each, in order of the samples at times t (S,)."""
        first, last = np.array([(rest.first, rest.last) for rest in self.rests]).reshape(-1, 2).T
        at, which = np.nonzero((t[:, None] >= first) & (t[:, None] <= last))
        return which, at

    def _resting(self, samples: Samples) -> _RestingPoints:
        which, at = self._during(samples.t)
        links_of_rests, positions, radii = arrays_of([rest.point for rest in self.rests])
        links, link, radius = samples.links, links_of_rests[which], radii[which]
        offset = np.einsum("ijp,jp->ip", links.rotation[:, :, link, at], positions[:, which])
        place = links.x[:, link, at] + offset
        has_plane, normals, along = self._grounds
        up = normals[:, which]
        height = dot(up, place) - along[which] - radius
        below = np.flatnonzero(~has_plane[which])
        if below.size:
            above, normals_below = height_over(self.surfaces, place[:, below, None], radius[below])
            height[below], up[:, below] = above[:, 0], normals_below[..., 0]
        rolls = np.array([rest.rolls for rest in self.rests], bool)[which]
        foot = offset - radius * rolls * up
        velocity = links.x_d[:, link, at] + cross(links.omega[:, link, at], foot)
        return _RestingPoints(which, at, link, height, up, offset, foot, velocity)


class _RestingPoints(NamedTuple):
    """Pairs of a rest and a sample (P,) with links, heights (P,) and their gradients (3, P).

    The offsets (3, P) are those of the points and of the resting material, whose velocities are (3, P).
    """

    which: Index
    at: Index
    link: Index
    height: Array
    up: Array
    offset: Array
    foot: Array
    velocity: Array
