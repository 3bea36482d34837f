"""The penalty on points that leave their contacts: stances, grasps and closed loops.

A point with a known position is drawn to it. Without one, it must not slide: its velocity is that of the material that
it touches, the surroundings or another link. A round foot, such as the heel or the tip of a shoe, rolls: its lowest
point rests, which may be another one at every instant.

A target represents a keyframe given by positions that the solver has to reach. The paper has keyframes of joint angles
only.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...array import Array, Index, Mask, pairs_within
from ...contacts import Contact
from ...contacts.thresholds import Thresholds
from ...figure.algebra import cross, dot, rotate, rotate_back
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_point, of_velocity
from ...surface import Surface
from ...surface.heights import height_over
from ...surface.points import arrays_of
from ...tolerances import TINY
from ..block import Block
from ..penalty import Normalization, Penalty, Role


@dataclass(frozen=True)
class Attachment(Penalty):
    """Σ over contacts, while they last, of weight times squared distance [m²] of the point from its position.

    Only the distance beyond the slack of the contact counts. A contact without a known position adds (0.05 s)² |v|²
    (for an adult), with v the velocity of the point's material relative to what it touches: for a sphere that rolls,
    v_centre − r ω × n with the normal n. On the surroundings it adds h², with h the height above the surface below.

    Attributes:
        contacts: The contacts.
        surfaces: The surfaces on which contacts without a position and a plane rest.
    """

    contacts: tuple[Contact, ...]
    surfaces: tuple[Surface, ...] = ()
    name: str = "attach.stance"

    role = Role.TARGET
    normalization = Normalization(1e-4, length_power=2)

    @cached_property
    def is_sharp(self) -> bool:
        return all(np.isfinite([c.first, c.last]).all() for c in self.contacts)

    @cached_property
    def resting(self) -> tuple[Contact, ...]:
        """The contacts with the surroundings at an unknown position."""
        return tuple(contact for contact in self.contacts if not contact.is_placed and not contact.on)

    def displacements(self, samples: Samples) -> tuple[Index, Index, Array]:
        """Return the displacements of points from their positions.

        Returns:
            The contacts (p,), a sample during each (p,), and the displacements (3, p) [m], zero along free axes.
        """
        piece, at = pairs_within(samples.t, self._pieces.first, self._pieces.last)
        return self._pieces.owners[piece], at, self._vectors(samples, piece, at)[2]

    def residuals(self, samples: Samples) -> Iterator[Block]:
        yield from self._distances(samples)
        if self.resting:
            yield from self._resting(samples)
        for contact in self.contacts:
            if contact.on and not contact.is_placed and (at := np.flatnonzero(contact.during(samples.t))).size:
                yield _sliding(samples, contact, at)

    def _distances(self, samples: Samples) -> Iterator[Block]:
        """Yield the distances of points from known positions."""
        pieces = self._pieces
        piece, at = pairs_within(samples.t, pieces.first, pieces.last)
        if not piece.size:
            return
        offset, spot, away = self._vectors(samples, piece, at)
        value, (when, link, direction) = away.ravel(), along_axes(at, pieces.links[piece])
        if pieces.slack.any():
            length = np.maximum(np.linalg.norm(away, axis=0), TINY)
            share = np.tile(np.maximum(1 - pieces.slack_at(samples.t[at], piece) / length, 0), 3)
            along = np.tile(away / length, 3)
            direction = share * direction + (share > 0) * (1 - share) * (away / length).ravel() * along
            value = share * value
        changes = [of_point(when, link, np.tile(offset, 3), direction)]
        if pieces.others.any():
            changes.append(of_point(when, np.tile(pieces.others[piece], 3), np.tile(spot, 3), -direction))
        weight = np.tile(pieces.weights[piece], 3)
        if not pieces.is_constrained.all():
            rows = np.flatnonzero(pieces.is_constrained[:, piece])
            when, value, weight = when[rows], value[rows], weight[rows]
            changes = [part.select(rows) for part in changes]
        yield Block(when, value, tuple(changes), weight)

    def _vectors(self, samples: Samples, piece: Index, at: Index) -> tuple[Array, Array, Array]:
        """Return vectors (3, p) [m] of pieces (p,) at samples (p,).

        These are the offsets of the points on their links, those of the positions on the other links, and the
        displacements from the positions to the points, zero along free axes.
        """
        pieces = self._pieces
        origin, rotation = samples.links.poses(pieces.links[piece] * samples.count + at)
        offset = rotate(rotation, pieces.points[:, piece])
        spot = pieces.spots[:, piece] + pieces.drifts[:, piece] * (samples.t[at] - pieces.since[piece])
        away = origin + offset - spot
        if pieces.others.any():
            origin, rotation = samples.links.poses(pieces.others[piece] * samples.count + at)
            away += spot
            spot = rotate(rotation, spot)
            away -= origin + spot
        return offset, spot, away * pieces.is_constrained[:, piece]

    @cached_property
    def _pieces(self) -> _Pieces:
        return _Pieces.of(self.contacts)

    def _resting(self, samples: Samples) -> Iterator[Block]:
        """Yield the heights and velocities of points that rest at unknown positions of the surroundings."""
        first, last = np.array([(rest.first, rest.last) for rest in self.resting]).T
        at, which = np.nonzero((samples.t[:, None] >= first) & (samples.t[:, None] <= last))
        link_of_rest, positions, radii = arrays_of([rest.point for rest in self.resting])
        links, link, radius = samples.links, link_of_rest[which], radii[which]
        offset = np.einsum("ijp,jp->ip", links.rotation[:, :, link, at], positions[:, which])
        place = links.x[:, link, at] + offset
        has_plane, normals, along = self._planes
        up = normals[:, which]
        height = dot(up, place) - along[which] - radius
        below = np.flatnonzero(~has_plane[which])
        if below.size:
            above, normals_below = height_over(self.surfaces, place[:, below, None], radius[below])
            height[below], up[:, below] = above[:, 0], normals_below[..., 0]
        yield Block(at, height, (of_point(at, link, offset, up),))
        rolls = np.array([rest.rolls for rest in self.resting], bool)[which]
        foot = offset - radius * rolls * up
        velocity = links.x_d[:, link, at] + cross(links.omega[:, link, at], foot)
        when, link_of_axis, axes = along_axes(at, link)
        moved = of_velocity(samples, when, link_of_axis, np.tile(foot, 3), axes, turning=np.tile(offset, 3))
        yield Block(when, velocity.ravel(), (moved,), Thresholds.of(samples.figure).settling ** 2)

    @cached_property
    def _planes(self) -> tuple[Mask, Array, Array]:
        """Mask (n,) of resting contacts with a plane, the planes' normals (3, n), and offsets (n,) [m] along these."""
        planes = [rest.surface for rest in self.resting]
        normals = np.array([np.zeros(3) if plane is None else plane.normal for plane in planes]).reshape(-1, 3).T
        along = [0.0 if plane is None else float(plane.normal @ plane.point) for plane in planes]
        return np.array([plane is not None for plane in planes], bool), normals, np.array(along)


class _Pieces(NamedTuple):
    """The n pieces of contacts with known positions, each with a position that is linear in time.

    Attributes:
        owners: The contacts, (n,).
        first: The start times, (n,) [s].
        last: The end times, (n,) [s].
        since: The times since which positions drift, (n,) [s].
        links: The links of the points, (n,).
        others: The links of the positions, (n,).
        points: The points on their links, (3, n) [m].
        spots: The initial positions, (3, n) [m], zero along free axes.
        drifts: The drifts, (3, n) [m/s].
        is_constrained: The axes that are not free, (3, n).
        slack: The slack at the start and its growth, (2, n) [m, m/s].
        weights: The weights, (n,).
    """

    owners: Index
    first: Array
    last: Array
    since: Array
    links: Index
    others: Index
    points: Array
    spots: Array
    drifts: Array
    is_constrained: Mask
    slack: Array
    weights: Array

    @classmethod
    def of(cls, contacts: Sequence[Contact]) -> _Pieces:
        owned = [(i, k, p) for i, c in enumerate(contacts) if c.is_placed for k, p in enumerate(c.pieces())]
        pieces = [piece for _, _, piece in owned]
        first, last = (np.array([getattr(piece, name) for piece in pieces], float) for name in ("first", "last"))
        length = np.where(last > first, last - first, 1.0)
        since = np.where(np.isfinite(first), first, 0.0)
        is_later = np.array([k > 0 for _, k, _ in owned], bool)
        first[is_later] = np.nextafter(first[is_later], np.inf)  # a sample where two pieces meet counts once
        places = [piece.places for piece in pieces if piece.places is not None]
        spots, landed = (np.array([place[end] for place in places]).reshape(-1, 3).T for end in (0, -1))
        slacks = [np.zeros(1) if piece.slack is None else piece.slack for piece in pieces]
        slack, then = (np.array([values[end] for values in slacks], float) for end in (0, -1))
        others = np.array([piece.on for piece in pieces], np.intp)
        links, points, _ = arrays_of([piece.point for piece in pieces])
        return cls(
            owners=np.array([i for i, _, _ in owned], np.intp),
            first=first,
            last=last,
            since=since,
            links=links,
            others=others,
            points=points,
            spots=np.nan_to_num(spots),
            drifts=np.nan_to_num(landed - spots) / length,
            is_constrained=~np.isnan(spots),
            slack=np.array([slack, (then - slack) / length]),
            weights=np.array([piece.weight for piece in pieces], float),
        )

    def slack_at(self, t: Array, piece: Index) -> Array:
        """Return the slack (P,) [m] of pieces (P,) at times t (P,) [s]."""
        start, growth = self.slack[:, piece]
        return start + growth * (t - self.since[piece])


def _sliding(samples: Samples, grasp: Contact, at: Index) -> Block:
    """Return the velocity of a point relative to the material of the link that it grasps, at samples `at` (P,)."""
    offset, spot_offset = _offsets(samples, grasp, at)
    links, one, two = samples.links, np.full(at.size, grasp.point.link), np.full(at.size, grasp.on)
    spin = links.omega[:, grasp.on, at]
    slide = links.x_d[:, grasp.point.link, at] + cross(links.omega[:, grasp.point.link, at], offset)
    slide -= links.x_d[:, grasp.on, at] + cross(spin, spot_offset)
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


def grasp_places(samples: Samples, grasp: Contact) -> Array:
    """Return positions (3, S) [m] of a grasp's point in the axes of the link that it grasps."""
    _, spot_offset = _offsets(samples, grasp, np.arange(samples.count))
    return rotate_back(samples.links.rotation[:, :, grasp.on], spot_offset)


def _offsets(samples: Samples, grasp: Contact, at: Index) -> tuple[Array, Array]:
    """Return the offsets (3, P) [m] of a grasp's point on its link and on the link that it grasps, at samples (P,)."""
    links = samples.links
    offset = np.einsum("ijp,j->ip", links.rotation[:, :, grasp.point.link, at], grasp.point.position)
    return offset, links.x[:, grasp.point.link, at] + offset - links.x[:, grasp.on, at]
