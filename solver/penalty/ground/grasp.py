"""Grasps: a hand stays where it grasped another body, while both may move.

If keyframes specify the spot on that body, the hand is drawn to it. Otherwise it must not slide: its velocity is that
of the body's material below it. A contact (`rest`) is the same on a static surface.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...contacts.grasp import Grasp
from ...contacts.thresholds import Thresholds
from ...figure.algebra import applied, cross
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ..block import Block
from ..penalty import Normalization, Penalty

TINY = 1e-12  # [m] least distance in a division


@dataclass(frozen=True)
class GraspPenalty(Penalty):
    """Σ over grasps, while they last, of the squared distance [m²] of the point from its spot beyond the spot's slack.

    If the spot is unknown, it is τ² |u|² instead, with u the velocity relative to the body's material and τ = 0.05 s
    for an adult.
    """

    grasps: tuple[Grasp, ...]

    name = "attach.grasp"
    normalization = Normalization(1e-4, length_power=2, is_violation=True, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for grasp, at in self._during(samples.t):
            spot = grasp.spot(samples.t[at])
            offset, spot_offset, away = _grasp_vectors(samples, grasp, at, spot)
            if spot is None:
                yield _sliding(samples, grasp, at, offset, spot_offset)
                continue
            counted = _share_beyond_slack(grasp, samples.t[at], away)
            one, two = (np.full(3 * at.size, link) for link in (grasp.point.link, grasp.link))
            directions, when = np.concatenate(list(_residual_rows(away, counted)), axis=1), np.tile(at, 3)
            changes = (
                of_point(when, one, np.tile(offset, 3), directions),
                of_point(when, two, np.tile(spot_offset, 3), -directions),
            )
            yield Block(when, (counted * away).ravel(), changes)

    def _during(self, t: Array) -> Iterator[tuple[Grasp, Index]]:
        """Yield the grasps with the indices of their samples among times t (S,)."""
        for grasp in self.grasps:
            at = np.flatnonzero((t >= grasp.first) & (t <= grasp.last))
            if at.size:
                yield grasp, at


def _sliding(samples: Samples, grasp: Grasp, at: Index, offset: Array, spot_offset: Array) -> Block:
    """Return the velocity of a grasp's point relative to the body's material, at samples `at` (P,)."""
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
    at = np.arange(samples.count)
    _, spot_offset, _ = _grasp_vectors(samples, grasp, at, None)
    return np.einsum("ijs,is->js", samples.links.rotation[:, :, grasp.link], spot_offset)


def _grasp_vectors(samples: Samples, grasp: Grasp, at: Index, spot: Array | None) -> tuple[Array, Array, Array]:
    """Return vectors (3, P) of a grasp at samples `at` (P,). These are the offset of the point on its link, that of the
    spot (3, P) on the other link (of the point without a spot), and the displacement from the spot to the point."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, grasp.point.link, at], grasp.point.position)
    between = links.x[:, grasp.point.link, at] + offset - links.x[:, grasp.link, at]
    spot_offset = between if spot is None else applied(links.rotation[:, :, grasp.link, at], spot)
    return offset, spot_offset, between - spot_offset


def _share_beyond_slack(grasp: Grasp, t: Array, displacement: Array) -> Array:
    """Return the fraction (P,) beyond the slack of displacements (3, P) from the spot."""
    return np.maximum(1 - grasp.slack(t) / np.maximum(np.linalg.norm(displacement, axis=0), TINY), 0)


def _residual_rows(displacement: Array, share: Array | float) -> Iterator[Array]:
    """Yield the rows (3, P) of the derivative of `share` × `displacement` (3, P) by `displacement`."""
    along = displacement / np.maximum(np.linalg.norm(displacement, axis=0), TINY)
    within = np.where(np.greater(share, 0), 1 - share, 0.0)
    for axis, unit in enumerate(np.eye(3)):
        yield share * unit[:, None] + within * along[axis] * along
