"""Holds: a hand stays where it took hold of another body, while both may move.

Where keyframes specify the spot on that body, the hand is held to it. Otherwise it does not slide: its velocity is that
of the body's material under it. A contact (`resting`) is the same on a surface that does not move.
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

TINY = 1e-12  # [m] a distance without a direction


@dataclass(frozen=True)
class HoldPenalty(Penalty):
    """Σ over holds of the squared distance [m²] of the point from its spot on the body, less the spot's slack, or of
    τ² |u|², τ = 0.05 s for an adult, u its velocity relative to the body there, if the spot is unknown; while they
    last."""

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
        """The holds with the samples at times t (S,) that they last for, where there are any."""
        for hold in self.holds:
            at = np.flatnonzero((t >= hold.first) & (t <= hold.last))
            if at.size:
                yield hold, at


def _sliding(samples: Samples, hold: Hold, at: Index, offset: Array, own: Array) -> Block:
    """The velocity of a hold's point beside the matter of the body under it, at samples `at` (P,)."""
    links, one, two = samples.links, np.full(at.size, hold.point.link), np.full(at.size, hold.link)
    spin = links.omega[:, hold.link, at]
    slide = links.x_d[:, hold.point.link, at] + cross(links.omega[:, hold.point.link, at], offset)
    slide -= links.x_d[:, hold.link, at] + cross(spin, own)
    (when, first, axes), (_, second, _) = along_axes(at, one), along_axes(at, two)
    arm, leg = np.tile(offset, 3), np.tile(own, 3)
    other = cross(np.tile(spin, 3), axes)  # the matter under the point is other matter when the point moves
    changes = (
        of_velocity(samples, when, first, arm, axes),
        of_velocity(samples, when, second, leg, -axes),
        of_point(when, first, arm, other),
        of_point(when, second, leg, -other),
    )
    return Block(when, slide.ravel(), changes, Thresholds.of(samples.figure).settling ** 2)


def slipped(samples: Samples, hold: Hold) -> Array:
    """(3, S) [m] where a hold's point is on the body that it holds, in that link's axes."""
    at = np.arange(samples.count)
    _, spot_offset, _ = _apart(samples, hold, at, None)
    return np.einsum("ijs,is->js", samples.links.rotation[:, :, hold.link], spot_offset)


def _apart(samples: Samples, hold: Hold, at: Index, spot: Array | None) -> tuple[Array, Array, Array]:
    """Of a hold at samples `at` (P,): the offset of the point on its link, that to the spot (3, P) on the other, or to
    where the point is if there is none, and the way from there to the point, (3, P) each."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, hold.point.link, at], hold.point.position)
    between = links.x[:, hold.point.link, at] + offset - links.x[:, hold.link, at]
    spot_offset = between if spot is None else applied(links.rotation[:, :, hold.link, at], spot)
    return offset, spot_offset, between - spot_offset


def _counted(hold: Hold, t: Array, away: Array) -> Array:
    """(P,) the share beyond the slack of the way (3, P) from the spot."""
    return np.maximum(1 - hold.slack(t) / np.maximum(np.linalg.norm(away, axis=0), TINY), 0)


def _residual_ways(away: Array, counted: Array | float) -> Iterator[Array]:
    """Row by row, (3, P), the derivative of `counted` × `away` (3, P) by `away`."""
    along = away / np.maximum(np.linalg.norm(away, axis=0), TINY)
    within = np.where(np.greater(counted, 0), 1 - counted, 0.0)
    for axis, unit in enumerate(np.eye(3)):
        yield counted * unit[:, None] + within * along[axis] * along
