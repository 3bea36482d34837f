"""Holds: a hand stays where it took hold of another body, while both may move.

Where keyframes say the spot on that body, the hand is held to it; where nobody does, it does not slide there: its
velocity is that of the body's own matter under it. A contact (`resting`) is the same with what does not move.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array, Index, Mask
from ...figure.adjoint import Cotangent
from ...figure.algebra import applied, cross, dot
from ...figure.kinematics import Samples
from ...surface.points import Point
from ..curvature import Curvature
from ..penalty import Penalty, Scale
from .contact import add_by_velocity, point_gradients, velocity_gradients
from .resting import SETTLING

TINY = 1e-12  # [m] a distance without a direction


@dataclass(frozen=True, eq=False)
class Spot:
    """A place on a body where it is held: from `start` (3,) in the link's axes [m] at time `first` [s] to `end` at
    `last`, the same but for what keyframes drift.

    slack  [m] how far from it the point may be for nothing, at either end: where a keyframe puts the body out of the
           limb's reach, the nearest place is one for a stretched limb alone, which whips there and back
    """

    first: float
    last: float
    start: Array
    end: Array
    slack: tuple[float, float] = (0.0, 0.0)

    def at(self, t: Array) -> Array:
        """(3, S) at times t (S,)."""
        return self.start[:, None] + (self.end - self.start)[:, None] * self._share(t)

    def slack_at(self, t: Array) -> Array:
        """(S,) [m] at times t (S,)."""
        start, end = self.slack
        return start + (end - start) * self._share(t)

    def _share(self, t: Array) -> Array:
        return (t - self.first) / (self.last - self.first)


@dataclass(frozen=True, eq=False)
class Hold:
    """A point of one link that holds another from `first` to `last` [s].

    link   index of the link that is held;  body  its name
    spots  where on it, one after the other without gaps; none if nobody says
    """

    point: Point
    link: int
    body: str
    first: float
    last: float
    spots: tuple[Spot, ...] = ()

    @property
    def name(self) -> str:
        """ "left_hand on crate" """
        return f"{self.point.name} on {self.body}"

    def spot(self, t: Array) -> Array | None:
        """(3, S) where on the link it is held at times t (S,) of the hold [m], or None if nobody says."""
        if not self.spots:
            return None
        out = np.empty((3, t.size))
        for spot, during in self._during(t):
            out[:, during] = spot.at(t[during])
        return out

    def slack(self, t: Array) -> Array:
        """(S,) how far [m] from its spot the point may be for nothing at times t (S,) of the hold."""
        out = np.zeros(t.size)
        for spot, during in self._during(t):
            out[during] = spot.slack_at(t[during])
        return out

    def _during(self, t: Array) -> Iterator[tuple[Spot, Mask]]:
        """The spots, and which of the times t (S,) are theirs."""
        which = np.clip(np.searchsorted([spot.last for spot in self.spots], t), 0, len(self.spots) - 1)
        for i, spot in enumerate(self.spots):
            yield spot, which == i


@dataclass(frozen=True)
class Holding(Penalty):
    """Σ over holds of the squared distance [m²] of the point from its spot on the body, less the spot's slack, or of
    (0.05 s)² |u|², u its velocity beside that of the body where it is, if the spot is unknown; while they last."""

    holds: tuple[Hold, ...]

    @property
    def name(self) -> str:
        return "hold"

    @property
    def scale(self) -> Scale:
        return Scale(1e-4, is_violation=True, is_sharp=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = np.zeros(samples.count)
        scale = 2 * scale + values
        for hold, at in self._during(samples.t):
            spot = hold.spot(samples.t[at])
            if spot is None:
                values[at] += self._slide(samples, hold, at, into, scale)
                continue
            offset, own, away = _apart(samples, hold, at, spot)
            away = away * _counted(hold, samples.t[at], away)
            values[at] += dot(away, away)
            if into is not None:
                into.add_forces(hold.point.link * samples.count + at, offset, scale[at] * away)
                into.add_forces(hold.link * samples.count + at, own, -scale[at] * away)
        return values

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        for hold, at in self._during(samples.t):
            spot = hold.spot(samples.t[at])
            offset, own, away = _apart(samples, hold, at, spot)
            for ways in _residual_ways(away, 1.0 if spot is None else _counted(hold, samples.t[at], away)):
                rows = _apart_rows(samples, hold, at, offset, own, ways)
                if spot is not None:
                    into.add_rows(at, scale[at], rows[:, None], (0,))
                    continue
                sliding = _velocity_rows(samples, hold, at, offset, own, ways)
                spin = samples.links.omega[:, hold.link, at]
                sliding[:, 0] -= _apart_rows(samples, hold, at, offset, own, cross(ways, spin))
                into.add_rows(at, SETTLING**2 * scale[at], sliding, (0, 1))

    def _during(self, t: Array) -> Iterator[tuple[Hold, Index]]:
        """The holds with the samples at times t (S,) that they last for, where there are any."""
        for hold in self.holds:
            at = np.flatnonzero((t >= hold.first) & (t <= hold.last))
            if at.size:
                yield hold, at

    def _slide(self, samples: Samples, hold: Hold, at: Index, into: Cotangent | None, scale: Array) -> Array:
        """(P,) (0.05 s)² |u|² at samples `at`."""
        links = samples.links
        offset, own, _ = _apart(samples, hold, at, None)
        spin = links.omega[:, hold.link, at]
        speed = links.x_d[:, hold.point.link, at] + cross(links.omega[:, hold.point.link, at], offset)
        slide = speed - links.x_d[:, hold.link, at] - cross(spin, own)
        if into is not None:
            by_slide = SETTLING**2 * scale[at] * slide
            for link, arms, force in ((hold.point.link, offset, by_slide), (hold.link, own, -by_slide)):
                add_by_velocity(into, link, at, arms, force)
            by_place = cross(spin, by_slide)  # the matter under the point is other matter when the point moves
            into.add_forces(hold.point.link * samples.count + at, offset, by_place)
            into.add_forces(hold.link * samples.count + at, own, -by_place)
        return SETTLING**2 * dot(slide, slide)


def slipped(samples: Samples, hold: Hold) -> Array:
    """(3, S) [m] where a hold's point is on the body that it holds, in that link's axes."""
    at = np.arange(samples.count)
    _, own, _ = _apart(samples, hold, at, None)
    return np.einsum("ijs,is->js", samples.links.rotation[:, :, hold.link], own)


def _apart(samples: Samples, hold: Hold, at: Index, spot: Array | None) -> tuple[Array, Array, Array]:
    """Of a hold at samples `at` (P,): the offset of the point on its link, that to the spot (3, P) on the other, or to
    where the point is if there is none, and the way from there to the point, (3, P) each."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, hold.point.link, at], hold.point.position)
    between = links.x[:, hold.point.link, at] + offset - links.x[:, hold.link, at]
    own = between if spot is None else applied(links.rotation[:, :, hold.link, at], spot)
    return offset, own, between - own


def _counted(hold: Hold, t: Array, away: Array) -> Array:
    """(P,) the share beyond the slack of the way (3, P) from the spot."""
    return np.maximum(1 - hold.slack(t) / np.maximum(np.linalg.norm(away, axis=0), TINY), 0)


def _residual_ways(away: Array, counted: Array | float) -> Iterator[Array]:
    """Row by row, (3, P), the derivative of `counted` × `away` (3, P) by `away`."""
    along = away / np.maximum(np.linalg.norm(away, axis=0), TINY)
    within = np.where(np.greater(counted, 0), 1 - counted, 0.0)
    for axis, unit in enumerate(np.eye(3)):
        yield counted * unit[:, None] + within * along[axis] * along


def _apart_rows(samples: Samples, hold: Hold, at: Index, offset: Array, own: Array, direction: Array) -> Array:
    """(P, N) the gradient of direction · (point − spot), both fixed on their links."""
    one, two = (np.full(at.size, link) for link in (hold.point.link, hold.link))
    return point_gradients(samples, at, one, offset, direction) - point_gradients(samples, at, two, own, direction)


def _velocity_rows(samples: Samples, hold: Hold, at: Index, offset: Array, own: Array, direction: Array) -> Array:
    """(P, 2, N) the gradients of direction · (velocity of the point − that of the spot), both fixed on their links."""
    one, two = (np.full(at.size, link) for link in (hold.point.link, hold.link))
    return velocity_gradients(samples, at, one, offset, direction) - velocity_gradients(
        samples, at, two, own, direction
    )
