"""Holds: a hand stays where it grasped another body, while both may move.

If keyframes specify the spot on that body, the hand is drawn to it. Otherwise it must not slide: its velocity is that
of the body's material below it. A contact (`rest`) is the same on a static surface.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...contacts.grasp import Hold
from ...contacts.thresholds import Thresholds
from ...figure.algebra import applied, cross
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ..block import Block
from ..penalty import Normalization, Penalty, Role

TINY = 1e-12  # [m] least distance in a division


@dataclass(frozen=True)
class HoldPenalty(Penalty):
    """Σ over holds, while they last, of the squared distance [m²] of the point from its spot beyond the spot's slack.

    If the spot is unknown, it is (0.05 s)² |u|² instead, with u the velocity relative to the body's material.
    """

    holds: tuple[Hold, ...]

    name = "attach.hold"
    role = Role.CONTACT
    normalization = Normalization(1e-4, length_power=2, is_violation=True, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for hold, at in self._during(samples.t):
            spot = hold.spot(samples.t[at])
            offset, spot_offset, away = _apart(samples, hold, at, spot)
            if spot is None:
                yield _sliding(samples, hold, at, offset, spot_offset)
                continue
            counted = _counted(hold, samples.t[at], away)
            one, two = (np.full(3 * at.size, link) for link in (hold.point.link, hold.link))
            directions, when = np.concatenate(list(_residual_ways(away, counted)), axis=1), np.tile(at, 3)
            changes = (
                of_point(when, one, np.tile(offset, 3), directions),
                of_point(when, two, np.tile(spot_offset, 3), -directions),
            )
            yield Block(when, (counted * away).ravel(), changes)

    def _during(self, t: Array) -> Iterator[tuple[Hold, Index]]:
        """Yield the holds with the indices of their samples among times t (S,)."""
        for hold in self.holds:
            at = np.flatnonzero((t >= hold.first) & (t <= hold.last))
            if at.size:
                yield hold, at


def _sliding(samples: Samples, hold: Hold, at: Index, offset: Array, own: Array) -> Block:
    """Return the velocity of a hold's point relative to the body's material, at samples `at` (P,)."""
    links, one, two = samples.links, np.full(at.size, hold.point.link), np.full(at.size, hold.link)
    spin = links.omega[:, hold.link, at]
    slide = links.x_d[:, hold.point.link, at] + cross(links.omega[:, hold.point.link, at], offset)
    slide -= links.x_d[:, hold.link, at] + cross(spin, own)
    (when, first, axes), (_, second, _) = along_axes(at, one), along_axes(at, two)
    arm, leg = np.tile(offset, 3), np.tile(own, 3)
    other = cross(np.tile(spin, 3), axes)  # moving the point changes the material below it
    changes = (
        of_velocity(samples, when, first, arm, axes),
        of_velocity(samples, when, second, leg, -axes),
        of_point(when, first, arm, other),
        of_point(when, second, leg, -other),
    )
    return Block(when, slide.ravel(), changes, Thresholds.of(samples.figure).settling ** 2)


def slipped(samples: Samples, hold: Hold) -> Array:
    """Return positions (3, S) [m] of a hold's point in the axes of the link that it holds."""
    at = np.arange(samples.count)
    _, spot_offset, _ = _apart(samples, hold, at, None)
    return np.einsum("ijs,is->js", samples.links.rotation[:, :, hold.link], spot_offset)


def _apart(samples: Samples, hold: Hold, at: Index, spot: Array | None) -> tuple[Array, Array, Array]:
    """Return vectors (3, P) of a hold at samples `at` (P,). These are the offset of the point on its link, that of the
    spot (3, P) on the other link (of the point without a spot), and the displacement from the spot to the point."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, hold.point.link, at], hold.point.position)
    between = links.x[:, hold.point.link, at] + offset - links.x[:, hold.link, at]
    spot_offset = between if spot is None else applied(links.rotation[:, :, hold.link, at], spot)
    return offset, spot_offset, between - spot_offset


def _counted(hold: Hold, t: Array, away: Array) -> Array:
    """Return the fraction (P,) beyond the slack of displacements (3, P) from the spot."""
    return np.maximum(1 - hold.slack(t) / np.maximum(np.linalg.norm(away, axis=0), TINY), 0)


def _residual_ways(away: Array, counted: Array | float) -> Iterator[Array]:
    """Yield the rows (3, P) of the derivative of `counted` × `away` (3, P) by `away`."""
    along = away / np.maximum(np.linalg.norm(away, axis=0), TINY)
    within = np.where(np.greater(counted, 0), 1 - counted, 0.0)
    for axis, unit in enumerate(np.eye(3)):
        yield counted * unit[:, None] + within * along[axis] * along
