"""Self-collision: squared depth of a figure's own capsules in one another.

The depth of two capsules is the sum of their radii minus the distance of their segments. By the envelope theorem the
gradient of this distance is that of two points fixed on the links. Ellipsoids, boxes and cylinders are represented by
spheres that fill them. Meshes, links joined to each other, and geoms that overlap at rest are excluded.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...figure.algebra import cross, dot
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.model import kinematics
from ...figure.wrenches import of_point
from ...surface.cover import filling_spheres
from ...surface.touch import movers
from ..block import Block
from ..penalty import Normalization, Penalty, Role

NEAR = 0.03  # [m] distance of capsules that one step of the search may cover
GAP = 0.008  # [m] maximum gap between spheres and the geom that they fill
HAIR = 0.015  # [m] protrusion from a thicker shape up to which a shape is omitted
PARALLEL = 1e-16  # [1] squared sine of the angle below which two segments are parallel
CROSSING = 1e-12  # [m] distance below which axes intersect, so that their direction of separation is arbitrary
FARTHEST = 0.01  # [m] limit of MuJoCo's distance computation, of which only the sign is used


@dataclass(frozen=True)
class Bar:
    """A capsule or sphere fixed on a link: centre in the link (3,) [m], unit axis (3,), half length, radius [m]."""

    geom: int
    link: int
    centre: Array
    axis: Array
    half: float
    radius: float


@dataclass(frozen=True)
class Meeting:
    """Nearest points of q pairs of capsules at samples.

    Attributes:
        at: The samples, (q,).
        first: The links of the first capsules, (q,).
        last: The links of the second capsules, (q,).
        first_offset: The first points relative to their links' origins, (3, q) [m].
        last_offset: The second points relative to their links' origins, (3, q) [m].
        depth: The depths, negative if the capsules do not touch, (q,) [m].
        direction: Unit vectors from the second points to the first, (3, q).
    """

    at: Index
    first: Index
    last: Index
    first_offset: Array
    last_offset: Array
    depth: Array
    direction: Array

    def select(self, which: Index) -> Meeting:
        chosen = (self.at[which], self.first[which], self.last[which])
        vectors = (self.first_offset[:, which], self.last_offset[:, which])
        return Meeting(*chosen, *vectors, self.depth[which], self.direction[:, which])


@dataclass(frozen=True)
class SelfContact(Penalty):
    """Σ over pairs of capsules of depth² [m²], with a `margin` [m] between them.

    Attributes:
        pairs: Indices of the bars of each pair, with the links in ascending order, (2, n).
        margin: The minimum distance [m].
    """

    bars: tuple[Bar, ...]
    pairs: Index
    margin: float = 0.0

    name = "collision.self"
    role = Role.OBSTACLE
    normalization = Normalization(1e-4, length_power=2, is_violation=True)

    @classmethod
    def of(cls, figure: Figure, margin: float = 0.0) -> SelfContact:
        """Return the penalty of all pairs of a figure's shapes that can collide."""
        bars = _outer([bar for geom in movers(figure.model) for bar in _bars(figure, geom)])
        return cls(bars, _pairs(figure, bars), margin)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        return self._met_by(samples, 0.0)

    def nearby(self, samples: Samples) -> Iterator[Block]:
        return self._met_by(samples, NEAR)

    def _met_by(self, samples: Samples, near: float) -> Iterator[Block]:
        """Yield the pairs of capsules less than `near` [m] apart."""
        if not self.pairs.size:
            return
        met = self.meetings(samples, near)
        if met is None:
            yield Block.joined([])
            return
        first = of_point(met.at, met.first, met.first_offset, -met.direction)
        last = of_point(met.at, met.last, met.last_offset, met.direction)
        yield Block(met.at, met.depth, (first, last), one_sided=True)

    def meetings(self, samples: Samples, near: float) -> Meeting | None:
        """Return the pairs of capsules less than `near` [m] apart, or None."""
        reach_limit = near + self.margin
        results = []
        for (_, _, pairs), is_close in zip(self._groups, self._close(samples, reach_limit), strict=True):
            at = np.flatnonzero(is_close)
            if at.size:
                met = self._met(samples, at, pairs, reach_limit)
                results.append(met.select(np.flatnonzero(met.depth > -near)))
        if not any(met.at.size for met in results):
            return None
        names = ("at", "first", "last", "first_offset", "last_offset", "depth", "direction")
        return Meeting(*(np.concatenate([getattr(met, name) for met in results], axis=-1) for name in names))

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array, Array]:
        """Links (n,), centres and axes (3, n), half lengths and radii (n,) of the bars."""
        links = np.array([bar.link for bar in self.bars], np.intp)
        centres, axes = (np.array([getattr(bar, name) for bar in self.bars]).T for name in ("centre", "axis"))
        halves, radii = (np.array([getattr(bar, name) for bar in self.bars]) for name in ("half", "radius"))
        return links, centres, axes, halves, radii

    def _close(self, samples: Samples, margin: float) -> Mask:
        """Return whether the bounding capsules of each pair of links are less than `margin` [m] apart, (pairs, S)."""
        carriers, middles, axes, halves, radii = self._bounds
        place, _ = samples.links.points(carriers, middles)
        axis = np.einsum("ijns,jn->ins", samples.links.rotation[:, :, carriers], axes)
        a, b = np.searchsorted(carriers, [(first, last) for first, last, _ in self._groups]).T
        d, u, v = place[:, a] - place[:, b], axis[:, a], axis[:, b]
        s, t = nearest_on_segments(d, u, v, halves[a, None], halves[b, None])
        apart = d + s * u - t * v
        return dot(apart, apart) < ((radii[a] + radii[b] + margin) ** 2)[:, None]

    @cached_property
    def _bounds(self) -> tuple[Index, Array, Array, Array, Array]:
        """Bounding capsules of each link's bars: ascending links (m,), centres and axes (3, m), half lengths and radii
        (m,)."""
        links, centres, axes, halves, radii = self._arrays
        carriers, bounds = np.unique(links), []
        for link in carriers:
            which = np.tile(links == link, 2)
            ends = np.hstack([centres - halves * axes, centres + halves * axes])[:, which]
            middle = 0.5 * (ends.min(axis=1) + ends.max(axis=1))
            axis = np.linalg.svd(ends - middle[:, None])[0][:, 0]
            along = axis @ (ends - middle[:, None])
            low, high = along.min(), along.max()
            off = ends - middle[:, None] - along * axis[:, None]
            radius = float((np.linalg.norm(off, axis=0) + np.tile(radii, 2)[which]).max())
            bounds.append((middle + 0.5 * (low + high) * axis, axis, 0.5 * (high - low), radius))
        middles, directions, lengths, reaches = (np.array(part).T for part in zip(*bounds, strict=True))
        return carriers, middles, directions, lengths, reaches

    @cached_property
    def _groups(self) -> list[tuple[int, int, Index]]:
        """Pairs of links with their pairs of bars (2, p)."""
        links = self._arrays[0]
        both = links[self.pairs]
        link_pairs = np.unique(both, axis=1).T
        return [(int(a), int(b), self.pairs[:, (both[0] == a) & (both[1] == b)]) for a, b in link_pairs]

    def _placed(self, samples: Samples, at: Index, bars: Index) -> tuple[Array, Array]:
        """Return offsets from the link's origin to the middles, and axes, of bars of one link at samples, (3, n, k)."""
        links, centres, axes, _, _ = self._arrays
        rotation = samples.links.rotation[:, :, links[bars[0]]][:, :, at]
        centre, axis = (np.einsum("ijk,jn->ink", rotation, local[:, bars]) for local in (centres, axes))
        return centre, axis

    def _met(self, samples: Samples, at: Index, pairs: Index, margin: float) -> Meeting:
        """Return the contacts of all pairs of bars of two links at samples `at`."""
        links, _, _, halves, radii = self._arrays
        (a, ia), (b, ib) = (np.unique(side, return_inverse=True) for side in pairs)
        (a_arm, a_axis), (b_arm, b_axis) = (self._placed(samples, at, bars) for bars in (a, b))
        first, last = int(links[a[0]]), int(links[b[0]])
        between = (samples.links.x[:, first] - samples.links.x[:, last]).take(at, axis=1)
        reach = np.full((a.size, b.size), -1.0)  # squared; negative for excluded pairs
        reach[ia, ib] = (halves[a[ia]] + radii[a[ia]] + halves[b[ib]] + radii[b[ib]] + margin) ** 2
        from_last = a_arm + between[:, None]
        squared = -2 * np.einsum("ink->kni", from_last) @ np.einsum("imk->kim", b_arm)
        squared += dot(from_last, from_last).T[:, :, None] + dot(b_arm, b_arm).T[:, None, :]
        k, i, j = np.nonzero(squared < reach)
        d, u, v = from_last[:, i, k] - b_arm[:, j, k], a_axis[:, i, k], b_axis[:, j, k]
        s, t = nearest_on_segments(d, u, v, halves[a[i]], halves[b[j]])
        apart = d + s * u - t * v
        gap = np.sqrt(dot(apart, apart))
        depth = radii[a[i]] + radii[b[j]] + self.margin - gap
        direction = np.where(gap > CROSSING, apart / np.maximum(gap, CROSSING), np.array([[0.0], [0], [1]]))
        arms = a_arm[:, i, k] + s * u, b_arm[:, j, k] + t * v
        return Meeting(at[k], np.full(k.size, first), np.full(k.size, last), *arms, depth, direction)


def nearest_on_segments(d: Array, u: Array, v: Array, h: Array, g: Array) -> tuple[Array, Array]:
    """Return the nearest points of two segments, as s and t (p,) along their axes from the middles.

    Args:
        d: Vectors from the second middle to the first, (3, p).
        u: Unit axes of the first segments, (3, p).
        v: Unit axes of the second segments, (3, p).
        h: Half lengths of the first segments, (p,).
        g: Half lengths of the second segments, (p,).
    """
    b, c, f = dot(u, v), dot(u, d), dot(v, d)
    across = cross(u, v)
    steep = dot(across, across)  # for nearly parallel axes, 1 − b² would be rounding
    s = np.clip(np.where(steep > PARALLEL, (b * f - c) / np.maximum(steep, PARALLEL), 0.0), -h, h)
    t = np.clip(b * s + f, -g, g)
    return np.clip(b * t - c, -h, h), t


def _pairs(figure: Figure, bars: Sequence[Bar]) -> Index:
    """Return the pairs of bars that can collide, (2, n): not on one or joined links, and not overlapping at rest."""
    carrying = {bar.link for bar in bars}
    joined = {(_carrier(figure, link, carrying), link) for link in carrying}
    resting = _overlapping(figure.model, {bar.geom for bar in bars})
    pairs = []
    for i, j in itertools.combinations(range(len(bars)), 2):
        if bars[i].link > bars[j].link:
            i, j = j, i
        links, geoms = (bars[i].link, bars[j].link), sorted((bars[i].geom, bars[j].geom))
        if links[0] != links[1] and links not in joined and tuple(geoms) not in resting:
            pairs.append((i, j))
    return np.array(pairs, np.intp).reshape(-1, 2).T


def _carrier(figure: Figure, link: int, carrying: set[int]) -> int:
    parent = figure.links[link].parent
    while parent and parent not in carrying:
        parent = figure.links[parent].parent
    return parent


def _bars(figure: Figure, geom: int) -> list[Bar]:
    model = figure.model
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
        return []
    body, size = int(model.geom_bodyid[geom]), np.array(model.geom_size[geom])
    axes = np.stack([quat.rotated(model.geom_quat[geom], e) for e in np.eye(3)], axis=1)
    axis = quat.rotated(figure.body_turn[body], axes[:, 2])
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CAPSULE:
        filled, half = (np.zeros((1, 3)), size[:1]), float(size[1])
    else:
        filled, half = filling_spheres(model, geom, GAP), 0.0
    out = []
    for offset, radius in zip(*filled, strict=True):
        link, centre = figure.point_on_link(body, model.geom_pos[geom] + axes @ offset)
        if radius > 0:
            out.append(Bar(geom, link, centre, axis, half, float(radius)))
    return out


def _outer(bars: list[Bar]) -> tuple[Bar, ...]:
    """Return the bars without those that hardly protrude from a thicker one on their link."""
    outer: list[Bar] = []
    for bar in sorted(bars, key=lambda bar: -bar.radius):
        if not any(_inside(bar, other) for other in outer if other.link == bar.link):
            outer.append(bar)
    return tuple(outer)


def _inside(bar: Bar, other: Bar) -> bool:
    """Return whether a bar is inside another within HAIR. Both its ends are tested, because the other is convex."""
    for side in (-1, 1):
        away = bar.centre + side * bar.half * bar.axis - other.centre
        away = away - np.clip(other.axis @ away, -other.half, other.half) * other.axis
        if np.linalg.norm(away) + bar.radius > other.radius + HAIR:
            return False
    return True


def _overlapping(model: mujoco.MjModel, geoms: set[int]) -> set[tuple[int, int]]:
    data = kinematics(model)
    ids = np.array(sorted(geoms), np.intp)
    place, reach = data.geom_xpos[ids], model.geom_rbound[ids]
    close = np.linalg.norm(place[:, None] - place, axis=2) < reach[:, None] + reach
    return {
        (int(ids[i]), int(ids[j]))
        for i, j in np.argwhere(np.triu(close, 1))
        if mujoco.mj_geomDistance(model, data, int(ids[i]), int(ids[j]), FARTHEST, None) < 0
    }
