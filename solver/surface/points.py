"""The contact geometry of a figure: points, which are spheres (of radius 0 for a site) on a link.

`body_points` covers a figure's geoms by such spheres, so that the whole body can be kept out of surfaces. For spheres
and capsules on a plane the cover is exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import mujoco
import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..figure.model import geom_name
from ..tolerances import ROUNDING
from .surface import Plane, Surface
from .touch import movers

DIRECTIONS = 600  # number of directions in which a link's outermost spheres are determined
MOST_BETWEEN = 1000  # maximum number of spheres along a capsule, more than any limb needs
MESH_DIRECTIONS = 150  # number of directions in which a mesh's outermost vertices are determined
RIM, RIM_POINTS = 0.002, (8, 32)  # [m] protrusion of a cylinder's rim between two points on it; least, most points
SPACING, THIN = 0.75, 0.01  # spacing of spheres along a capsule, in radii [1] of at least THIN [m]


@dataclass(frozen=True)
class Point:
    """A sphere fixed on a link: link index, centre in the link (3,) [m], radius [m]."""

    name: str
    link: int
    position: Array
    radius: float = 0.0

    def coincides(self, other: Point) -> bool:
        """Return whether the centres are the same on the same link, whatever the names."""
        return self.link == other.link and np.array_equal(self.position, other.position)


def arrays_of(points: Sequence[Point]) -> tuple[Index, Array, Array]:
    """Return links (n,), positions (3, n) and radii (n,) of points."""
    links = np.array([point.link for point in points], np.intp)
    positions = np.array([point.position for point in points]).reshape(-1, 3).T
    return links, positions, np.array([point.radius for point in points])


def places_of(points: Sequence[Point], samples: Samples) -> tuple[Array, Array]:
    """Return centres (3, n, S) [m] and radii (n,) [m] of points."""
    links, positions, radii = arrays_of(points)
    return samples.links.points(links, positions)[0], radii


def bottoms_of(points: Sequence[Point], samples: Samples) -> Array:
    """Return the heights (n, S) [m] of the lowest ends of points."""
    centres, radii = places_of(points, samples)
    return centres[2] - radii[:, None]


def hanging(figure: Figure, link: int, points: Sequence[Point]) -> tuple[Point, ...]:
    """Return the points on a link or on its descendants."""
    return tuple(point for point in points if figure.tables.path[point.link, link])


def split_at_feet(soles: Sequence[Point], body: Sequence[Point]) -> tuple[tuple[Point, ...], tuple[Point, ...]]:
    """Return the points of feet, which are soles and the points of the body on their links, and the rest of the body.

    A foot is wider than the marks of its sole.
    """
    feet = {point.link for point in soles}
    on_feet = tuple(point for point in body if point.link in feet)
    return (*soles, *on_feet), tuple(point for point in body if point.link not in feet)


def free_root(figure: Figure, points: Sequence[Point]) -> int | None:
    """Return the first free link with any of the points on it or its descendants; None if there is none."""
    return next((int(link) for link in figure.tables.free_links if hanging(figure, int(link), points)), None)


def site_points(figure: Figure, names: Sequence[str]) -> tuple[Point, ...]:
    """Return points at sites of the model, by name."""
    points = []
    for name in names:
        site = figure.model.site(name)
        link, position = figure.point_on_link(int(figure.model.site_bodyid[site.id]), site.pos)
        points.append(Point(name, link, position))
    return tuple(points)


@lru_cache(16)  # a clip uses them several times
def body_points(figure: Figure) -> tuple[Point, ...]:
    """Return spheres that cover the outside of the figure's moving geoms.

    The spheres are: spheres, ends of capsules, corners of boxes, rims of cylinders, small spheres at the tips of
    ellipsoids, and the vertices of meshes that reach farthest in many directions. Only those on the convex hull of
    their link are included, so that contact with planes is exact (for ellipsoids approximate). Capsules with both ends
    on the hull have more spheres in between, so close that a box's edge enters at most 2 mm between them.
    """
    model = figure.model
    ends: list[Point] = []
    pairs: list[tuple[int, int]] = []
    for geom in movers(model):
        body = int(model.geom_bodyid[geom])
        axes = quat.matrices(model.geom_quat[geom])
        kind = int(model.geom_type[geom])
        if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
            pairs.append((len(ends), len(ends) + 1))
        spheres = _cover(model, geom)
        offsets = np.reshape([offset for offset, _ in spheres], (-1, 3))
        link, positions = figure.point_on_link(body, model.geom_pos[geom] + offsets @ axes.T)
        name = geom_name(model, geom)
        ends += [Point(name, link, place, radius) for place, (_, radius) in zip(positions, spheres, strict=True)]
    outermost = _outermost(ends)
    between = [point for a, b in pairs if a in outermost and b in outermost for point in _between(ends[a], ends[b])]
    return (*(ends[i] for i in sorted(outermost)), *between)


def _between(a: Point, b: Point) -> list[Point]:
    """Return spheres along a capsule between its ends, three quarters of a radius apart."""
    length = float(np.linalg.norm(b.position - a.position))
    count = int(min(MOST_BETWEEN, length / (SPACING * max(a.radius, THIN))))
    shares = np.arange(1, count) / count
    return [Point(a.name, a.link, a.position + share * (b.position - a.position), a.radius) for share in shares]


def all_round(count: int) -> Array:
    """Return unit vectors spread evenly over all directions, (3, count)."""
    turn = np.pi * (1 + np.sqrt(5)) * np.arange(count)
    z = 1 - (2 * np.arange(count) + 1) / count
    return np.stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z])


def _outermost(points: list[Point]) -> set[int]:
    """Return the spheres on the convex hull of their link's spheres, which reach farthest in some direction. Of spheres
    that reach equally far within rounding, the first is returned."""
    directions = all_round(DIRECTIONS)
    hull: set[int] = set()
    for link in {point.link for point in points}:
        on_link = [i for i, point in enumerate(points) if point.link == link]
        support = np.array([points[i].position @ directions + points[i].radius for i in on_link])
        farthest = support >= support.max(axis=0) - ROUNDING
        hull |= {on_link[k] for k in np.unique(farthest.argmax(axis=0))}
    return hull


def mesh_vertices(model: mujoco.MjModel, geom: int) -> Array:
    """Return the vertices of a geom's mesh, in geom axes, (n, 3) [m]."""
    mesh = int(model.geom_dataid[geom])
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    return np.array(model.mesh_vert[first : first + count], float)


def _cover(model: mujoco.MjModel, index: int) -> list[tuple[Array, float]]:
    """Return offset in geom axes and radius of the spheres that cover one geom."""
    geom, kind, size = mujoco.mjtGeom, int(model.geom_type[index]), np.array(model.geom_size[index])
    if kind == geom.mjGEOM_MESH:
        vertices = mesh_vertices(model, index)
        return [(vertices[i], 0.0) for i in np.unique(np.argmax(vertices @ all_round(MESH_DIRECTIONS), axis=0))]
    if kind == geom.mjGEOM_SPHERE:
        return [(np.zeros(3), float(size[0]))]
    if kind == geom.mjGEOM_CAPSULE:
        return [(np.array([0, 0, z]), float(size[0])) for z in (-size[1], size[1])]
    if kind == geom.mjGEOM_CYLINDER:
        count = int(np.clip(np.ceil(np.pi / np.arccos(max(1 - RIM / size[0], 0))), *RIM_POINTS))
        ring = [np.array([np.cos(a), np.sin(a), 0]) * size[0] for a in np.arange(count) * 2 * np.pi / count]
        return [(p + np.array([0, 0, z]), 0.0) for p in ring for z in (-size[1], size[1])]
    if kind == geom.mjGEOM_BOX:
        signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
        return [(s * size, 0.0) for s in signs]
    if kind == geom.mjGEOM_ELLIPSOID:
        return [(sign * e * (size - size.min()), float(size.min())) for e in np.eye(3) for sign in (-1, 1)]
    return []


def displacements(places: Array) -> Array:
    """Return the distances between successive places of points (d, n, K), (n, K − 1) [m]."""
    return np.asarray(np.linalg.norm(np.diff(places, axis=2), axis=0))


def sets_places(figure: Figure, specified: Mask, points: Sequence[Point]) -> Mask:
    """Return whether a keyframe specifies every joint from the root to a point, and so its position, (n, K).

    Args:
        specified: Entries of qpos that keyframes specify, (K, nq).
    """
    links = [point.link for point in points]
    return sets_poses(figure, specified, links, np.zeros(len(links), np.intp))


def sets_depths(figure: Figure, specified: Mask, points: Sequence[Point], surfaces: Sequence[Surface]) -> Mask:
    """Return whether a keyframe specifies the depth of a point in surfaces, (n, K): its position, or on level planes
    alone the joints that determine its height.

    Args:
        specified: Entries of qpos that keyframes specify, (K, nq).
    """
    if surfaces and all(isinstance(surface, Plane) and surface.is_level for surface in surfaces):
        specified = np.array(specified)
        for link in figure.tables.free_links:
            specified[:, figure.links[link].qpos + np.arange(2)] = True
    return sets_places(figure, specified, points)


def sets_poses(figure: Figure, specified: Mask, first: Sequence[int] | Index, last: Sequence[int] | Index) -> Mask:
    """Return whether a keyframe specifies every joint between two links, and so their relative pose, (n, K).

    Args:
        specified: Entries of qpos that keyframes specify, (K, nq).
        first: The indices of n links.
        last: Those of n others; 0 is the world.
    """
    whole = np.array([specified[:, link.columns].all(axis=1) for link in figure.links[1:]]).reshape(-1, len(specified))
    path = figure.tables.path[:, 1:] > 0
    between = path[np.asarray(first, np.intp)] != path[np.asarray(last, np.intp)]
    return np.array([whole[row].all(axis=0) for row in between], bool).reshape(len(between), len(specified))
