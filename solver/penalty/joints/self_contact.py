"""Self-collision: squared depth of a figure's own capsules in one another.

The depth of two capsules is the sum of their radii minus the distance of their segments. By the envelope theorem the
gradient of this distance is that of two points fixed on the links. Ellipsoids, boxes and cylinders are represented by
spheres that fill them. Meshes, links joined to each other, geoms that overlap at rest, and geoms that do
not collide in the model are excluded.

Few pairs are near each other. Bounds find them: first the links' bounding capsules, then a link's shapes against the
bounding capsule of the other link, then the bounding spheres of the shapes. A search evaluates only the pairs of links
that penetrate each other on one of its paths.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import mujoco
import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...curve.frame import Timeline
from ...figure.algebra import cross, dot, rotate, rotate_fixed
from ...figure.dynamics import Size
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.model import kinematics
from ...figure.wrenches import of_point
from ...surface.cover import filling_spheres
from ...surface.points import sets_poses
from ...surface.touch import can_collide, movers
from ...tolerances import SINGLE, TINY
from ..block import Block
from ..penalty import NEAR_LENGTH, Allowance, Normalization, Penalty, Role

# [m] of figures up to the size of an adult; in proportion for larger ones, as for models in centimetres
GAP = 0.008  # maximum gap between spheres and the geom that they fill
HAIR = 0.015  # protrusion from a thicker shape up to which a shape is omitted
UNWATCHED = 0.005  # [m] depth up to which links of an adult need not be watched


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
class SelfContact(Penalty):
    """Σ over pairs of capsules of depth² [m²], with a `margin` [m] between them.

    Attributes:
        pairs: Indices of the bars of each pair, (2, n).
        margin: The minimum distance [m].
        allowed: Depths that keyframes fix, (P, K) for pairs of links.
        watched: The pairs of links to evaluate, ascending; None: all of them.
    """

    bars: tuple[Bar, ...]
    pairs: Index
    margin: float = 0.0
    allowed: Allowance | None = None
    watched: Index | None = None

    name = "collision.self"
    role = Role.COLLISION
    is_sharp = True
    normalization = Normalization(1e-4, length_power=2)

    @classmethod
    def of(cls, figure: Figure, margin: float = 0.0) -> SelfContact:
        """Return the penalty of all pairs of a figure's shapes that can collide."""
        return cls(*_shapes(figure), margin)

    def allowing(self, figure: Figure, keys: Timeline) -> SelfContact:
        """Return the penalty without the depths, including the margin, of links whose relative pose keyframes fix."""
        if not self.pairs.size:
            return self
        pairs, pair_of = self._link_pairs
        excess = np.zeros((pairs.shape[1], keys.times.size))
        at, i, j, depth, *_ = self._overlaps(Samples.still(figure, keys.states), 0.0, None)
        np.maximum.at(excess, (pair_of[i, j], at), depth)
        return replace(
            self, allowed=Allowance.in_keys(keys, excess, sets_poses(figure, keys.fixed, *self._bounds[0][pairs]))
        )

    def watching(self, parts: Iterable[Samples]) -> SelfContact:
        """Return the penalty of the watched pairs of links and those that are in each other."""
        found = [np.zeros(0, np.intp) if self.watched is None else self.watched]
        for part in parts:
            _, i, j, depth, *_ = self._overlaps(part, 0.0, None)
            deep = depth > UNWATCHED * Size.of(part.figure).length
            found.append(self._link_pairs[1][i[deep], j[deep]])
        watched = np.unique(np.concatenate(found))
        is_same = self.watched is not None and np.array_equal(watched, self.watched)
        return self if is_same else replace(self, watched=watched)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        if self.pairs.size and (self.watched is None or self.watched.size):
            links = self._arrays[0]
            near = NEAR_LENGTH * Size.of(samples.figure).enlargement
            at, i, j, depth, first, last, direction = self._overlaps(samples, near, self.watched)
            wrenches = of_point(at, links[i], first, -direction), of_point(at, links[j], last, direction)
            yield Block(at, depth, wrenches, one_sided=True)

    def _overlaps(
        self, samples: Samples, near: float, watched: Index | None
    ) -> tuple[Index, Index, Index, Array, Array, Array, Array]:
        """Return the pairs of capsules less than `near` [m] apart, of the `watched` pairs of links.

        Returns:
            Samples and both bars, (q,); depths, negative if the capsules do not touch, (q,) [m]; the nearest points
            relative to their links' origins, (3, q) [m]; and unit vectors from the second points to the first, (3, q).
        """
        links, centres, axes, halves, radii = self._arrays
        at, i, j = self._candidates(samples, near + self.margin, watched)
        (x, a, u), (y, b, v) = (
            (origin, rotate(rotation, centres[:, bar]), rotate(rotation, axes[:, bar]))
            for bar in (i, j)
            for origin, rotation in [samples.links.poses(links[bar] * samples.count + at)]
        )
        s, t, apart = nearest_on_segments(x - y + a - b, u, v, halves[i], halves[j])
        gap = np.sqrt(dot(apart, apart))
        depth = radii[i] + radii[j] + self.margin - gap
        if self.allowed is not None:
            depth -= self.allowed.of(self._link_pairs[1][i, j], samples.t[at])
        direction = np.where(gap > TINY, apart / np.maximum(gap, TINY), np.array([[0.0], [0], [1]]))
        k = np.flatnonzero(depth > -near)
        return at[k], i[k], j[k], depth[k], (a + s * u)[:, k], (b + t * v)[:, k], direction[:, k]

    def _candidates(self, samples: Samples, reach: float, watched: Index | None) -> tuple[Index, Index, Index]:
        """Return samples and both bars of pairs, (q,), among them all pairs less than `reach` [m] apart."""
        links, centres, _, halves, radii = self._arrays
        carriers, middles, directions, lengths, bounds = self._bounds
        pairs, pair_of = self._link_pairs
        place, _ = samples.links.points(carriers, middles)
        axis = rotate_fixed(samples.links.rotation[:, :, carriers], directions)
        a, b = pairs if watched is None else pairs[:, watched]
        *_, apart = nearest_on_segments(
            place[:, a] - place[:, b], axis[:, a], axis[:, b], lengths[a, None], lengths[b, None]
        )
        pair, at = np.nonzero(dot(apart, apart) < ((bounds[a] + bounds[b] + reach) ** 2)[:, None])
        a, b = a[pair], b[pair]

        extent = halves + radii
        centre, _ = samples.links.points(links, centres)
        centre, place, axis = (part.reshape(3, -1) for part in (centre, place, axis))
        order, count = np.argsort(links, kind="stable"), np.bincount(np.searchsorted(carriers, links))
        first, sides = np.cumsum(count) - count, []
        for one, other in ((a, b), (b, a)):
            entry, bar = _expand(first[one], count[one])
            bar, bound = order[bar], other * samples.count + at
            d = centre.take(bar * samples.count + at[entry], axis=1) - place.take(bound, axis=1).take(entry, axis=1)
            v, half = axis.take(bound, axis=1).take(entry, axis=1), lengths[other][entry]
            along = dot(d, v)
            squared = dot(d, d) - along**2 + (along - np.clip(along, -half, half)) ** 2
            near = np.flatnonzero(squared < (extent[bar] + (bounds[other] + reach)[entry]) ** 2)
            sides.append((entry[near], bar[near]))
        (entry, i), (entries, bars) = sides
        count = np.bincount(entries, minlength=pair.size)
        which, j = _expand((np.cumsum(count) - count)[entry], count[entry])
        at, i, j = at[entry[which]], i[which], bars[j]
        d = centre.take(i * samples.count + at, axis=1) - centre.take(j * samples.count + at, axis=1)
        near = np.flatnonzero((dot(d, d) < (extent[i] + extent[j] + reach) ** 2) & (pair_of[i, j] >= 0))
        return at[near], i[near], j[near]

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array, Array]:
        return _arrays(self.bars)

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
    def _link_pairs(self) -> tuple[Index, Index]:
        """Pairs of links that can collide, as indices in `_bounds`, (2, P); and the pair (n, n) of two bars, or −1."""
        carriers, (i, j) = self._bounds[0], self.pairs
        owners = np.searchsorted(carriers, self._arrays[0])
        numbers, which = np.unique(owners[i] * carriers.size + owners[j], return_inverse=True)
        pair_of = np.full((len(self.bars), len(self.bars)), -1)
        pair_of[i, j] = pair_of[j, i] = which
        return np.array(np.divmod(numbers, carriers.size)), pair_of


def _arrays(bars: Sequence[Bar]) -> tuple[Index, Array, Array, Array, Array]:
    """Return the links (n,), centres and axes (3, n), half lengths and radii (n,) of bars."""
    names = "link", "centre", "axis", "half", "radius"
    links, centres, axes, halves, radii = (np.array([getattr(bar, name) for bar in bars]) for name in names)
    return links, centres.reshape(-1, 3).T, axes.reshape(-1, 3).T, halves, radii


def _expand(first: Index, count: Index) -> tuple[Index, Index]:
    """Return for ranges of `count` (n,) integers from `first` (n,) each integer's range, and the integers."""
    owner = np.repeat(np.arange(count.size), count)
    return owner, np.arange(owner.size) + np.repeat(first - np.cumsum(count) + count, count)


def nearest_on_segments(d: Array, u: Array, v: Array, h: Array, g: Array) -> tuple[Array, Array, Array]:
    """Return the nearest points of two segments, as s and t (p,) along their axes from the middles, and the vectors
    from the second points to the first, (3, p).

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
    s = np.clip(np.where(steep > TINY, (b * f - c) / np.maximum(steep, TINY), 0.0), -h, h)
    t = np.clip(b * s + f, -g, g)
    s = np.clip(b * t - c, -h, h)
    return s, t, d + s * u - t * v


@lru_cache(16)  # editing a clip needs them repeatedly
def _shapes(figure: Figure) -> tuple[tuple[Bar, ...], Index]:
    """Return the bars of a figure, and the pairs of them that can collide, (2, n)."""
    every = [bar for geom in movers(figure.model) for bar in _bars(figure, geom)]
    bars = _outer(every, HAIR * Size.of(figure).enlargement)
    return bars, _pairs(figure, bars)


def _pairs(figure: Figure, bars: Sequence[Bar]) -> Index:
    """Return the pairs of bars that can collide in the model, (2, n): not on one or joined links, not overlapping at
    rest, and not on links at most two joints apart that do. The link of the first bar has the smaller index."""
    links, geoms = (np.array([getattr(bar, name) for bar in bars], np.intp) for name in ("link", "geom"))
    i, j = np.triu_indices(links.size, 1)
    i, j = np.where(links[i] < links[j], (i, j), (j, i))
    carrier = np.array([_carrier(figure, link, set(links.tolist())) for link in range(len(figure.links))], np.intp)
    joined = (links[i] == links[j]) | (links[i] == carrier[links[j]])
    resting, by_design = np.zeros((figure.model.ngeom,) * 2, bool), np.zeros((len(figure.links),) * 2, bool)
    for one, other in _overlapping(figure.model, movers(figure.model)):
        resting[one, other] = resting[other, one] = True
        between = figure.body_link[figure.model.geom_bodyid[[one, other]]]
        by_design[between, between[::-1]] = True
    by_design &= steps_between(figure) <= 2
    free = (can_collide(figure.model) & ~resting)[geoms[i], geoms[j]]
    return np.array([i, j])[:, free & ~joined & ~by_design[links[i], links[j]]]


def steps_between(figure: Figure) -> Array:
    """Return the number of bodies from one link to another, (L, L): 1 to a child, infinite between free trees."""
    bodies, path = np.array([link.body for link in figure.links]), figure.tables.path
    first = np.append(True, bodies[1:] != bodies[:-1])  # a body's other joints do not count
    depth, shared = path[:, first].sum(axis=1), path[:, first] @ path[:, first].T
    is_free: Mask = np.any(path[:, figure.tables.free_links] > 0, axis=1)
    apart = np.logical_or.outer(is_free, is_free) & (path @ path.T == 0)
    return np.where(apart, np.inf, depth[:, None] + depth - 2 * shared)


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
    axes = quat.matrices(model.geom_quat[geom])
    axis = quat.rotate(figure.body_turn[body], axes[:, 2])
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CAPSULE:
        filled, half = (np.zeros((1, 3)), size[:1]), float(size[1])
    else:
        filled, half = filling_spheres(model, geom, GAP * Size.of(figure).enlargement), 0.0
    offsets, radii = filled
    link, centres = figure.point_on_link(body, model.geom_pos[geom] + offsets @ axes.T)
    bars = zip(centres, radii.tolist(), strict=True)
    return [Bar(geom, link, centre, axis, half, radius) for centre, radius in bars if radius > 0]


def _outer(bars: list[Bar], hair: float) -> tuple[Bar, ...]:
    """Return the bars without those that protrude by at most `hair` [m] from a thicker one on their link."""
    bars = sorted(bars, key=lambda bar: -bar.radius)
    links, *arrays = _arrays(bars)
    is_outer = np.zeros(len(bars), bool)
    for link in np.unique(links):
        own = np.flatnonzero(links == link)
        centres, axes, halves, radii = (values[..., own] for values in arrays)
        ends = np.stack([centres - halves * axes, centres + halves * axes], axis=1)
        away = ends[..., None] - centres[:, None, None]
        axis = axes[:, None, None]
        away -= np.clip(dot(axis, away), -halves, halves) * axis
        limit = np.maximum(radii - radii[:, None] + hair, 0)  # at both ends, as the thicker bar is convex
        is_in = dot(away, away).max(axis=0) <= limit**2
        for k, row in zip(own, is_in, strict=True):
            is_outer[k] = not row[is_outer[own]].any()
    return tuple(bars[k] for k in np.flatnonzero(is_outer))


def _overlapping(model: mujoco.MjModel, geoms: Sequence[int]) -> set[tuple[int, int]]:
    data = kinematics(model)
    ids = np.array(geoms, np.intp)
    place, reach = data.geom_xpos[ids], model.geom_rbound[ids]
    close = np.linalg.norm(place[:, None] - place, axis=2) < reach[:, None] + reach
    return {
        (int(ids[i]), int(ids[j]))
        for i, j in np.argwhere(np.triu(close, 1))
        if mujoco.mj_geomDistance(model, data, int(ids[i]), int(ids[j]), SINGLE, None) < 0  # only the sign counts
    }
