"""Floor and step: contact points stay above the surfaces (eq. 12), squared so that the gradient is smooth.

A point is a sphere of a radius (0 for a site) on a link. `body_points` covers a figure's own spheres, capsules and
boxes by such points, so that the whole body stays out; for spheres and capsules against a plane the cover is exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import pairwise

import mujoco
import numpy as np
from numpy.typing import NDArray

from .. import quaternion as quat
from ..algebra import applied, dot
from ..allowance import Allowance
from ..curvature import Curvature, Sides
from ..figure import Figure, JointKind
from ..frame import Mask, Timeline
from ..joint_rows import any_point_rows, any_velocity_rows
from ..kinematics import Cotangent, Samples, attached_pulled_back
from ..naming import geom_name
from ..quaternion import Array, Index
from ..rows import has_point_rows, point_rows, velocity_rows
from ..surface import Surface
from ..touch import movers
from .penalty import Scale

NEAR = 0.03  # [m] within which a point may touch after one step of the search
DEEP = 0.15  # [m] below its top, a point is beside a surface or under it, not over it
FAR = 1e3  # [m]
ROUNDING = 1e-9  # [s] a keyframe may be outside an interval that it is meant to begin or end
MOST_TOGETHER = 64  # points that one sphere stands for; a limb of capsules has 10-30
DIRECTIONS = 600  # in which a link's outermost spheres are looked for
MOST_BETWEEN = 1000  # spheres along a capsule; no limb is 750 times as long as it is thick
MESH_DIRECTIONS = 150  # the same of the vertices of a mesh


@dataclass(frozen=True)
class Point:
    """A sphere fixed on a link: link index, centre (3,) in the link [m], radius [m]."""

    name: str
    link: int
    position: Array
    radius: float = 0.0


def arrays_of(points: Sequence[Point]) -> tuple[Index, Array, Array]:
    """Links (n,), positions (3, n) and radii (n,) of points."""
    links = np.array([point.link for point in points], np.intp)
    positions = np.array([point.position for point in points]).reshape(-1, 3).T
    return links, positions, np.array([point.radius for point in points])


@dataclass(frozen=True)
class Contact:
    """Σ over points and surfaces of depth² [m²], every point grown by `margin` [m].

    allowed  (n, K) [m] how much smaller points are, for what keyframes do themselves
    carrier  index of the link that carries the surfaces, which are in its axes; 0: the world, where they stand still
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    margin: float = 0.0
    allowed: Allowance | None = None
    name: str = "contact"
    carrier: int = 0

    def allowing(self, figure: Figure, keys: Timeline, holding: Sequence[tuple[int, float, float]] = ()) -> Contact:
        """The same that lets pass how deep points whose places keyframes fix are in them, margin and all.

        holding  links that hold on to the surfaces, with their limbs, each from when to when [s]: what a keyframe fixes
                 of these is as deep at those that leave it free
        """
        if not self.points or not self.surfaces:
            return self
        samples = Samples(figure, keys.states, 0 * keys.states, 0 * keys.states)
        centres = self.seen(samples, self.centres(samples)[0])
        deep = np.max([surface.depth(centres, self._arrays[2])[0] for surface in self.surfaces], axis=0)
        known = placed(figure, keys.fixed, self.points)
        excess, path = deep * known, figure.tables.path > 0
        for link, first, last in holding:
            limb = np.flatnonzero((path[:, link] | path[link])[self._arrays[0]])
            during = np.flatnonzero((keys.times >= first - ROUNDING) & (keys.times <= last + ROUNDING))
            for before, k in [*pairwise(during), *pairwise(during[::-1])]:
                free = limb[~known[limb, k] & known[limb, before]]
                excess[free, k], known[free, k] = excess[free, before], True
        return replace(self, allowed=Allowance(keys.times, excess))

    @property
    def scale(self) -> Scale:
        return Scale(1e-4, is_violation=True)

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points, margin included."""
        links, positions, radius = arrays_of(self.points)
        return links, positions, radius + self.margin

    @cached_property
    def _groups(self) -> tuple[Index, Index]:
        """Points are looked at in groups, those of a link or, where it has many, of a part of it: links of the groups
        (m,), and every point's group (n,)."""
        links, positions, _ = self._arrays
        found = [part for link in np.unique(links) for part in neighbours(positions, np.flatnonzero(links == link))]
        owner = np.empty(links.size, np.intp)
        for k, part in enumerate(found):
            owner[part] = k
        return np.array([links[part[0]] for part in found]), owner

    @cached_property
    def _bounds(self) -> tuple[Index, Array, Array]:
        """Spheres round each group's points: links (m,), centres (3, m), radii (m,)."""
        _, positions, radius = self._arrays
        carriers, owner = self._groups
        middles = np.array([positions[:, owner == k].mean(axis=1) for k in range(carriers.size)]).T
        far = np.linalg.norm(positions - middles[:, owner], axis=0) + radius
        return carriers, middles, np.array([far[owner == k].max() for k in range(carriers.size)])

    @cached_property
    def _places(self) -> tuple[Index, Index]:
        """Where every point stands in `_by_group`: rank (n,) in its group and group (n,)."""
        _, owner = self._groups
        order, counts = np.argsort(owner, kind="stable"), np.bincount(owner)
        rank = np.empty_like(order)
        rank[order] = np.arange(owner.size) - np.repeat(np.cumsum(counts) - counts, counts)
        return rank, owner

    @cached_property
    def _by_group(self) -> tuple[Array, Array]:
        """Every group's points: positions (3, p, m), radii (p, m); a group with fewer than p has some of radius −∞."""
        _, positions, radius = self._arrays
        rank, owner = self._places
        padded = np.zeros((3, rank.max() + 1, owner.max() + 1))
        radii = np.full(padded.shape[1:], -np.inf)
        padded[:, rank, owner], radii[rank, owner] = positions, radius
        return padded, radii

    @cached_property
    def _allowed_by_group(self) -> Allowance | None:
        """The allowances as `_by_group` lays the points out, (p, m, K), or None where there are none."""
        if self.allowed is None or not self.allowed.excess.any():
            return None
        rank, owner = self._places
        padded = np.zeros((rank.max() + 1, owner.max() + 1, self.allowed.times.size))
        padded[rank, owner] = self.allowed.excess
        return Allowance(self.allowed.times, padded)

    def centres(self, samples: Samples) -> tuple[Array, Array, Index]:
        """Centres (3, n, S) [m], the vectors to them from their links' origins, and the links' indices (n,)."""
        links, positions, _ = self._arrays
        return *samples.links.points(links, positions), links

    def seen(self, samples: Samples, points: Array) -> Array:
        """Points (3, n, S) of the world in the axes of the surfaces' carrier."""
        if not self.carrier:
            return points
        away = points - samples.links.x[:, self.carrier, None]
        return np.einsum("ijs,ins->jns", samples.links.rotation[:, :, self.carrier], away)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = np.zeros(samples.count)
        if not self.points or not self.surfaces:
            return values
        carriers, middles, reach = self._bounds
        around = self.seen(samples, samples.links.points(carriers, middles)[0])
        touching = [surface.near(around, reach[:, None]) for surface in self.surfaces]
        near = np.flatnonzero(np.logical_or.reduce(touching))
        if not near.size:
            return values
        flat, arms, centres, radii = self._near(samples, near)
        scale = 2 * scale + np.zeros(samples.count)
        for surface, touched in zip(self.surfaces, touching, strict=True):
            if not touched.any():
                continue
            depth, gradient = surface.depth(centres, radii)
            deep = np.flatnonzero(depth > 0)
            if not deep.size:
                continue
            depth, pairs = depth.take(deep), flat.take(deep % flat.size)
            at = pairs % samples.count
            values += np.bincount(at, depth * depth, samples.count)
            if into is not None:
                force = gradient.reshape(3, -1).take(deep, axis=1)
                force *= scale.take(at) * depth
                force, leg = self._in_world(samples, at, force, centres.reshape(3, -1).take(deep, axis=1))
                into.add_forces(pairs, arms.take(deep, axis=1), force)
                if self.carrier:
                    into.add_forces(self.carrier * samples.count + at, leg, -force)
        return values

    def _in_world(self, samples: Samples, at: Index, force: Array, place: Array) -> tuple[Array, Array]:
        """A vector and a place (3, P) in the carrier's axes, turned into the world's, at samples `at` (P,)."""
        if not self.carrier:
            return force, place
        rotation = samples.links.rotation[:, :, self.carrier, at]
        return applied(rotation, force), applied(rotation, place)

    def _near(self, samples: Samples, near: Index) -> tuple[Index, Array, Array, Array]:
        """All points of k pairs of a group and a sample: link · S + sample (k,), arms (3, p k), centres (3, p k, 1) in
        the axes of the surfaces and radii (p k,).

        near  (k,) which: group · S + sample
        """
        positions, radii = self._by_group
        carrier, at = np.divmod(near, samples.count)
        flat = self._bounds[0].take(carrier) * samples.count + at
        x, rotation = samples.links.poses(flat)
        arms = np.einsum("ijk,jpk->ipk", rotation, positions.take(carrier, axis=2))
        centres = arms + x[:, None]
        if self.carrier:
            origin, turn = samples.links.poses(self.carrier * samples.count + at)
            centres = np.einsum("ijk,ipk->jpk", turn, centres - origin[:, None])
        centres = centres.reshape(3, -1, 1)
        radii = radii.take(carrier, axis=1)
        if self._allowed_by_group is not None:
            radii = radii - self._allowed_by_group.of(carrier, samples.t.take(at))
        return flat, arms.reshape(3, -1), centres, radii.ravel()

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        """Nothing: depths count on one side only."""

    def sides(self, samples: Samples) -> Sides | None:
        if not self.points or not self.surfaces:
            return None
        carriers, middles, reach = self._bounds
        around = self.seen(samples, samples.links.points(carriers, middles)[0])
        parts = []
        for surface in self.surfaces:
            near = np.flatnonzero(surface.near(around, reach[:, None] + NEAR))
            if not near.size:
                continue
            flat, arms, centres, radii = self._near(samples, near)
            about, way_about = surface.depth(centres, radii + NEAR)
            kept = np.flatnonzero(about > 0)
            depth, way = surface.depth(centres[:, kept], radii[kept])
            inside = depth[:, 0] > 0
            # a depth grows by |way| a metre, through a box's sides by more than 1
            way_about = way_about[:, kept, 0]
            beyond = about[kept, 0] - NEAR * np.sqrt(dot(way_about, way_about))
            depth = np.where(inside, depth[:, 0], np.minimum(beyond, 0))
            way = np.where(inside, way[..., 0], way_about)
            link, at = np.divmod(flat[kept % flat.size], samples.count)
            way, leg = self._in_world(samples, at, way, centres[:, kept, 0])
            rows = point_gradients(samples, at, link, arms[:, kept], way)
            if self.carrier:
                rows -= point_gradients(samples, at, np.full(at.size, self.carrier), leg, way)
            parts.append(Sides(at, depth, rows))
        return Sides.joined(parts) if parts else Sides.none(samples)


def neighbours(positions: Array, some: Index) -> list[Index]:
    """Some of points (3, n) by groups of at most MOST_TOGETHER, halved across where they spread farthest."""
    if some.size <= MOST_TOGETHER:
        return [some]
    axis = int(np.argmax(np.ptp(positions[:, some], axis=1)))
    order = some[np.argsort(positions[axis, some], kind="stable")]
    half = order.size // 2
    return [*neighbours(positions, order[:half]), *neighbours(positions, order[half:])]


def point_gradients(samples: Samples, at: Index, link: Index, arm: Array, way: Array) -> Array:
    """(P, N): the gradient of way · p for points p at `arm` (3, P) from their links' origins, at samples `at` (P,)."""
    rows = point_rows if has_point_rows(samples.figure) else any_point_rows
    return rows(samples, at, link, arm, way)


def velocity_gradients(samples: Samples, at: Index, link: Index, arm: Array, way: Array) -> Array:
    """(P, 2, N): the gradients of way · v with respect to y and y', v the velocities of points as in
    `point_gradients`."""
    rows = velocity_rows if has_point_rows(samples.figure) else any_velocity_rows
    return rows(samples, at, link, arm, way)


def add_by_velocity(into: Cotangent, link: int, at: Index, arm: Array, gradient: Array) -> None:
    """Adds gradients (3, P) with respect to the velocities of points at `arm` (3, P) on a link, at samples `at`."""
    gradients, arms = np.zeros((2, 3, 1, into.samples.count))
    gradients[:, 0, at], arms[:, 0, at] = gradient, arm
    into.room("x_d")[:, link] += gradients[:, 0]
    attached_pulled_back(into, arms, (None, gradients, None), np.array([link]))


def height_over(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Array]:
    """Signed height of spheres over the nearest surface that one can stand on below them, and its gradient.

    points  (3, n, S) centres [m];  radius  (n,) [m]
    Returns (n, S) [m], FAR where there is none or it is deep below, and (3, n, S).
    """
    height, nearest = heights(surfaces, points, radius)
    return height, ways_up(surfaces, nearest.ravel(), points.reshape(3, -1)).reshape(points.shape)


def heights(surfaces: Sequence[Surface], points: Array, radius: Array) -> tuple[Array, Index]:
    """`height_over` without the gradient, and which surface each is over, −1 for none, (n, S) each."""
    height, nearest = np.full(points.shape[1:], FAR), np.full(points.shape[1:], -1)
    for i, surface in enumerate(surfaces):
        over = surface.height(points) - radius[:, None]
        lower = (over >= -DEEP) & (over < height)
        np.copyto(height, over, where=lower)
        nearest[lower] = i
    return height, nearest


def ways_up(surfaces: Sequence[Surface], nearest: Index, points: Array) -> Array:
    """(3, p): the gradients of the heights of points (3, p) over the surfaces with these indices (p,)."""
    up = np.zeros(points.shape)
    for i, surface in enumerate(surfaces):
        mine = np.flatnonzero(nearest == i)
        if mine.size:
            up[:, mine] = surface.up(points[:, mine])
    return up


def site_points(figure: Figure, names: Sequence[str]) -> tuple[Point, ...]:
    """Points at sites of the model, by name."""
    points = []
    for name in names:
        site = figure.model.site(name)
        link, position = figure.point_on_link(int(figure.model.site_bodyid[site.id]), site.pos)
        points.append(Point(name, link, position))
    return tuple(points)


@lru_cache(maxsize=2)  # a clip asks for them several times
def body_points(figure: Figure) -> tuple[Point, ...]:
    """Spheres that cover the outside of the figure's moving geoms.

    Spheres, the ends of capsules, corners of boxes, rims of cylinders, ellipsoids by small spheres at their tips, and
    meshes by their vertices that reach farthest in some hundred directions:
    those of them that lie on the convex hull of their link, so that planes are met exactly (ellipsoids: nearly). Along
    the capsules whose ends both do lie more spheres, close enough that the edge of a box cuts at most 2 mm between.
    """
    model = figure.model
    ends: list[Point] = []
    pairs: list[tuple[int, int]] = []
    for geom in movers(model):
        body = int(model.geom_bodyid[geom])
        axes = np.stack([quat.rotated(model.geom_quat[geom], e) for e in np.eye(3)], axis=1)
        kind = int(model.geom_type[geom])
        if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
            pairs.append((len(ends), len(ends) + 1))
        found = _cover(model, geom)
        offsets = np.reshape([offset for offset, _ in found], (-1, 3))
        link, positions = figure.point_on_link(body, model.geom_pos[geom] + offsets @ axes.T)
        name = geom_name(model, geom)
        ends += [Point(name, link, place, radius) for place, (_, radius) in zip(positions, found, strict=True)]
    kept = _outermost(ends)
    between = [point for a, b in pairs if a in kept and b in kept for point in _between(ends[a], ends[b])]
    return (*(ends[i] for i in sorted(kept)), *between)


def _between(a: Point, b: Point) -> list[Point]:
    """Spheres along a capsule between its ends, three quarters of a radius apart."""
    length = float(np.linalg.norm(b.position - a.position))
    count = int(min(MOST_BETWEEN, length / (0.75 * max(a.radius, 0.01))))
    shares = np.arange(1, count) / max(count, 1)
    return [Point(a.name, a.link, a.position + share * (b.position - a.position), a.radius) for share in shares]


def all_round(count: int) -> Array:
    """(3, count): unit vectors spread evenly over all directions."""
    turn = np.pi * (1 + np.sqrt(5)) * np.arange(count)
    z = 1 - (2 * np.arange(count) + 1) / count
    return np.stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z])


def _outermost(points: list[Point]) -> set[int]:
    """Which spheres lie on the convex hull of their link's spheres: those that reach farthest some way."""
    ways = all_round(DIRECTIONS)
    kept: set[int] = set()
    for link in {point.link for point in points}:
        own = [i for i, point in enumerate(points) if point.link == link]
        support = np.array([points[i].position @ ways + points[i].radius for i in own])
        kept |= {own[k] for k in np.unique(support.argmax(axis=0))}
    return kept


def mesh_vertices(model: mujoco.MjModel, geom: int) -> Array:
    """(n, 3) [m] the vertices of a geom's mesh, in the geom's axes."""
    mesh = int(model.geom_dataid[geom])
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    return np.array(model.mesh_vert[first : first + count], float)


def _cover(model: mujoco.MjModel, index: int) -> list[tuple[Array, float]]:
    """(offset in the geom's axes, radius) of the spheres that cover one geom."""
    geom, kind, size = mujoco.mjtGeom, int(model.geom_type[index]), np.array(model.geom_size[index])
    if kind == geom.mjGEOM_MESH:
        vertices = mesh_vertices(model, index)
        return [(vertices[i], 0.0) for i in np.unique(np.argmax(vertices @ all_round(MESH_DIRECTIONS), axis=0))]
    if kind == geom.mjGEOM_SPHERE:
        return [(np.zeros(3), float(size[0]))]
    if kind == geom.mjGEOM_CAPSULE:
        return [(np.array([0, 0, z]), float(size[0])) for z in (-size[1], size[1])]
    if kind == geom.mjGEOM_CYLINDER:
        ring = [np.array([np.cos(a), np.sin(a), 0]) * size[0] for a in np.arange(8) * np.pi / 4]
        return [(p + np.array([0, 0, z]), 0.0) for p in ring for z in (-size[1], size[1])]
    if kind == geom.mjGEOM_BOX:
        signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
        return [(s * size, 0.0) for s in signs]
    if kind == geom.mjGEOM_ELLIPSOID:
        return [(sign * e * (size - size.min()), float(size.min())) for e in np.eye(3) for sign in (-1, 1)]
    return []


def placed(figure: Figure, told: Mask, points: Sequence[Point]) -> NDArray[np.bool_]:
    """(n, K): whether a keyframe tells every joint from the root to a point, so that it says where the point is.

    told  (K, nq) what keyframes fix, or all that they tell
    """
    entries = {JointKind.FREE: 7, JointKind.BALL: 4, JointKind.HINGE: 1, JointKind.SLIDE: 1}
    whole = [told[:, link.qpos : link.qpos + entries[link.kind]].all(axis=1) for link in figure.links[1:]]
    path = figure.tables.path[:, 1:] > 0
    return np.array([np.all(np.array(whole)[path[point.link]], axis=0) for point in points])
