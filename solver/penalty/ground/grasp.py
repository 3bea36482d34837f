"""Grasps: a hand stays where it grasped another body, while both may move.

If keyframes specify the spot on that body, the hand is drawn to it. Otherwise it must not slide: its velocity is that
of the body's material below it. A contact (`rest`) is the same on a static surface.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...array import Array, Index
from ...contacts.grasp import Grasp
from ...contacts.stance import Stance
from ...contacts.thresholds import Thresholds
from ...figure.algebra import cross, turned_back
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ..block import Block
from .attachment import Attachment


@dataclass(frozen=True)
class GraspPenalty(Attachment):
    """The penalty of grasps whose positions on the held body are known, and for the others Σ τ² |u|².

    u is the velocity of the point relative to the body's material, and τ = 0.05 s for an adult.

    Attributes:
        sliding: The grasps whose positions on the held body are unknown.
    """

    term_name: str = "attach.grasp"
    sliding: tuple[Grasp, ...] = ()

    @classmethod
    def of(cls, grasps: Sequence[Grasp]) -> GraspPenalty:
        """Return the penalty of grasps."""
        spots = list[Stance]()
        for grasp in grasps:
            for k, spot in enumerate(grasp.spots):
                # a sample where two spots meet counts once
                spots.append(replace(spot, first=np.nextafter(spot.first, spot.last)) if k else spot)
        return cls(tuple(spots), sliding=tuple(grasp for grasp in grasps if not grasp.spots))

    def residuals(self, samples: Samples) -> Iterator[Block]:
        yield from super().residuals(samples)
        for grasp in self.sliding:
            at = np.flatnonzero((samples.t >= grasp.first) & (samples.t <= grasp.last))
            if at.size:
                yield _sliding(samples, grasp, at)


def _sliding(samples: Samples, grasp: Grasp, at: Index) -> Block:
    """Return the velocity of a grasp's point relative to the body's material, at samples `at` (P,)."""
    offset, spot_offset = _offsets(samples, grasp, at)
    links, one, two = samples.links, np.full(at.size, grasp.point.link), np.full(at.size, grasp.link)
    spin = links.omega[:, grasp.link, at]
    slide = links.x_d[:, grasp.point.link, at] + cross(links.omega[:, grasp.point.link, at], offset)
    slide -= links.x_d[:, grasp.link, at] + cross(spin, spot_offset)
    (when, first, axes), (_, second, _) = along_axes(at, one), along_axes(at, two)
    point_offsets, spot_offsets = np.tile(offset, 3), np.tile(spot_offset, 3)
    other = cross(np.tile(spin, 3), axes)  # moving the point changes the material below it
    changes = (
        of_velocity(samples, when, first, point_offsets, axes),
        of_velocity(samples, when, second, spot_offsets, -axes),
        of_point(when, first, point_offsets, other),
        of_point(when, second, spot_offsets, -other),
    )
    return Block(when, slide.ravel(), changes, Thresholds.of(samples.figure).settling ** 2)


def slipped(samples: Samples, grasp: Grasp) -> Array:
    """Return positions (3, S) [m] of a grasp's point in the axes of the link that it grasps."""
    _, spot_offset = _offsets(samples, grasp, np.arange(samples.count))
    return turned_back(samples.links.rotation[:, :, grasp.link], spot_offset)


def _offsets(samples: Samples, grasp: Grasp, at: Index) -> tuple[Array, Array]:
    """Return the offsets (3, P) [m] of a grasp's point on its link and on the link that it grasps, at samples (P,)."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, grasp.point.link, at], grasp.point.position)
    return offset, links.x[:, grasp.point.link, at] + offset - links.x[:, grasp.link, at]
