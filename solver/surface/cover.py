"""A whole body as spheres, so close together that not even a thin rail fits between them.

`body_points` suffices for planes, which touch a body's convex hull, and for steps, unless their edges enter a geom
between its corners. A rail can also touch parts inside the hull, and faces that bulge between corners. Here every geom
is therefore filled with spheres about its medial axis: segments in capsules and cylinders, rectangles in boxes. In an
ellipsoid of half axes a ≥ b ≥ c it is the ellipse of half axes (a² − c²)/a and (b² − c²)/b, where the sphere at (x, y)
has the radius c √(1 − x²/(a² − c²) − y²/(b² − c²)). In a mesh, spheres touch its convex hull from inside at the points
of a grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import mujoco
import numpy as np

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.dynamics import Size
from ..figure.figure import Figure
from ..figure.model import geom_name
from ..tolerances import ROUNDING, SINGLE, TINY
from . import Hull, hull_of, moving_surface
from .points import Point, mesh_vertices
from .touch import movers

WIDE = 0.3  # [m] length plus width of a geom's largest face from which it is wide, for an adult
NARROW = 0.08  # [m] the same from which an edge may enter between the geom's corners
THIN = 0.01  # [m] radius of the least of these spheres in geoms that are not wide, for an adult
STEP_GAP = 0.005  # [m] depth to which the edge of a step may enter a geom that is not wide
GAP = 0.001  # [m] depth to which a straight edge may enter between two spheres
THINNEST = 0.02  # [m] least radius of spheres beside edges
CLOSEST = 0.02  # [m] spacing of points on sharp edges
FINEST = 16  # maximum number of points along a mesh that is thick
MOST = 40  # maximum number of points along any mesh
TOUCHED = 0.002  # [m] distance of a sphere up to which a point on a mesh needs no other sphere
CORNERS = 60  # maximum number of corners of a mesh's hull
HIDDEN = 0.0002  # [m] protrusion up to which a sphere counts as inside a larger one

Spheres = tuple[Array, Array]


@lru_cache(16)  # editing a clip needs them repeatedly
def covering_points(figure: Figure) -> tuple[Point, ...]:
    """Return spheres that fill the solid geoms of the figure's links, without those inside others of their link."""
    return _fill(figure, movers(figure.model))


@lru_cache(16)
def wide_points(figure: Figure) -> tuple[Point, ...]:
    """Return spheres that fill the boxes, cylinders and meshes into which an edge may enter between the corners.

    Geoms that are not wide have fewer of them. Thin ones have none: an edge that passes through them meets other geoms.
    """
    length = Size.of(figure).length
    sizes = {geom: _face_size(figure.model, geom) / length for geom in movers(figure.model)}
    wide = _fill(figure, [geom for geom, size in sizes.items() if size > WIDE])
    small = _fill(figure, [geom for geom, size in sizes.items() if NARROW < size <= WIDE], STEP_GAP)
    return (*wide, *(point for point in small if point.radius >= THIN * length))


def _face_size(model: mujoco.MjModel, geom: int) -> float:
    """Return the length plus width [m] of the largest face of a box, cylinder or mesh, 0 of other geoms."""
    kinds, kind, size = mujoco.mjtGeom, int(model.geom_type[geom]), model.geom_size[geom]
    if kind == kinds.mjGEOM_BOX:
        extents = 2 * size
    elif kind == kinds.mjGEOM_CYLINDER:
        extents = 2 * size[[0, 0, 1]]
    elif kind == kinds.mjGEOM_MESH:
        extents = np.ptp(mesh_vertices(model, geom), axis=0)
    else:
        return 0.0
    return float(np.sort(extents)[1:].sum())


def _fill(figure: Figure, geoms: Sequence[int], gap: float = GAP) -> tuple[Point, ...]:
    """Return spheres that fill geoms, without those inside others of their link."""
    model = figure.model
    out: list[Point] = []
    by_link: dict[int, list[tuple[str, Array, Array]]] = {}
    for geom in geoms:
        body = int(model.geom_bodyid[geom])
        centres, radii = filling_spheres(model, geom, gap)
        axes = quat.matrices(model.geom_quat[geom])
        link = int(figure.body_link[body])
        places = figure.point_on_link(body, model.geom_pos[geom] + centres @ axes.T)[1]
        name = geom_name(model, geom)
        by_link.setdefault(link, []).append((name, places.reshape(-1, 3), radii))
    for link, parts in by_link.items():
        names = np.repeat([name for name, _, _ in parts], [len(radii) for _, _, radii in parts])
        centres, radii = np.concatenate([c for _, c, _ in parts]), np.concatenate([r for _, _, r in parts])
        out += [Point(str(names[i]), link, centres[i], float(radii[i])) for i in _visible(centres, radii)]
    return tuple(out)


def _visible(centres: Array, radii: Array) -> list[int]:
    """Return the spheres that are not inside a larger one, within a tolerance."""
    outer: list[int] = []
    places, limits = np.empty_like(centres), np.empty_like(radii)  # of the spheres in `outer`
    for i in np.argsort(-radii, kind="stable"):
        count = len(outer)
        apart = np.linalg.norm(places[:count] - centres[i], axis=1)
        if not np.any(apart + radii[i] <= limits[:count]):
            places[count], limits[count] = centres[i], radii[i] + HIDDEN
            outer.append(int(i))
    return sorted(outer)


def filling_spheres(model: mujoco.MjModel, geom: int, gap: float = GAP) -> Spheres:
    """Return spheres that fill one geom up to a gap [m]: centres (n, 3) in geom axes and radii (n,) [m], 0 at edges."""
    kinds, kind, size = mujoco.mjtGeom, int(model.geom_type[geom]), np.array(model.geom_size[geom])
    if kind == kinds.mjGEOM_SPHERE:
        return np.zeros((1, 3)), size[:1]
    if kind == kinds.mjGEOM_CAPSULE:
        return _along(size[1], size[0], gap)
    if kind == kinds.mjGEOM_CYLINDER:
        return _cylinder(size[0], size[1], gap)
    if kind == kinds.mjGEOM_BOX:
        return _box(size, gap)
    if kind == kinds.mjGEOM_ELLIPSOID:
        return _ellipsoid(size, gap)
    if kind == kinds.mjGEOM_MESH:
        return _mesh(model, geom)
    return np.zeros((0, 3)), np.zeros(0)


def _mesh(model: mujoco.MjModel, geom: int) -> Spheres:
    """Return spheres inside a mesh's convex hull that touch a grid of points on it, and points on its edges."""
    vertices = mesh_vertices(model, geom)
    coarse, hull = hull_of(vertices, CORNERS), moving_surface(model, geom, np.zeros(3), np.eye(3))
    if coarse is None or not isinstance(hull, Hull):
        return np.zeros((0, 3)), np.zeros(0)
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    pace = max(CLOSEST, size / FINEST)
    touched, centres = _touching(*coarse, pace)
    radii = np.maximum(-hull.least(centres.T), 0)
    thin = max(radii.max(), size / MOST)
    if thin < pace:
        touched, centres = _touching(*coarse, thin)
        radii = np.maximum(-hull.least(centres.T), 0)
    outer, rest = list[int](), np.argsort(-radii, kind="stable")
    while rest.size:
        i, rest = int(rest[0]), rest[1:]
        outer.append(i)
        rest = rest[np.linalg.norm(touched[rest] - centres[i], axis=1) > radii[i] + TOUCHED]
    return centres[outer], radii[outer]


def _touching(corners: Array, faces: Index, pace: float) -> tuple[Array, Array]:
    """Return points (n, 3) of a grid on a convex hull, and the centres (n, 3) of the largest spheres that touch them.

    A sphere of radius r that touches a face of normal n at p has its centre at p − r n. It is as far from the plane
    m · x = h of another face if r = (h − m · p) / (1 − m · n). The smallest r of all faces is the largest possible.

    Args:
        corners: The corners of the hull, (3, v) [m].
        faces: Its triangles, (f, 3).
        pace: Maximum spacing of the grid [m].
    """
    places = corners.T[faces.T]
    sides = np.stack([places[k - 1] - places[k - 2] for k in range(3)])  # opposite each corner
    normals = np.cross(sides[2], -sides[1])
    areas = np.linalg.norm(normals, axis=1)
    solid = areas > ROUNDING
    places, sides, normals = places[:, solid], sides[:, solid], normals[solid] / areas[solid, None]
    offsets, lengths = np.sum(normals * places[0], axis=1), np.linalg.norm(sides, axis=2)
    middles = np.sum(places * (lengths / lengths.sum(axis=0))[:, :, None], axis=0)  # of the inscribed circles
    counts = np.ceil(np.sort(lengths, axis=0)[1] / pace).astype(int)  # the grid is along the two shorter sides
    touched, centres = [corners.T], [corners.T]
    for count in np.unique(counts):
        i, j = (part.ravel() for part in np.meshgrid(np.arange(count + 1), np.arange(count + 1)))
        shares, which = np.column_stack([i, j, count - i - j])[i + j <= count] / count, np.flatnonzero(counts == count)
        grid = np.einsum("sk,kfi->fsi", shares, places[:, which])
        points = np.concatenate([grid, middles[which, None]], axis=1)
        gaps, turn = np.maximum(offsets - points @ normals.T, 0), 1 - normals[which, None] @ normals.T
        radii = np.min(np.where(turn > SINGLE, gaps / np.maximum(turn, SINGLE), np.inf), axis=2)
        touched.append(points.reshape(-1, 3))
        centres.append((points - radii[:, :, None] * normals[which, None]).reshape(-1, 3))
    return np.concatenate(touched), np.concatenate(centres)


def _spread(half: float, radius: float, gap: float) -> Array:
    """Return positions from −half to half with the maximum spacing for spheres of this radius."""
    pace = max(2 * np.sqrt(2 * radius * gap), gap) if radius > 0 else CLOSEST
    return np.linspace(-half, half, int(np.ceil(2 * half / pace)) + 1) if half > 0 else np.zeros(1)


def _along(half: float, radius: float, gap: float) -> Spheres:
    z = _spread(half, radius, gap)
    return np.column_stack([0 * z, 0 * z, z]), np.full(z.size, radius)


def _cylinder(radius: float, half: float, gap: float) -> Spheres:
    """Return spheres along the axis, or a disc of them in a flat cylinder, thinner ones inside the rims, and points on
    these."""
    inner = min(radius, half)
    x, y = (part.ravel() for part in np.meshgrid(*[_spread(radius - inner, inner, gap)] * 2))
    size = np.hypot(x, y)
    shrink = np.where(size > 0, np.maximum(np.abs(x), np.abs(y)) / np.maximum(size, TINY), 1.0)  # squares to rings
    rest, _ = _along(half - inner, inner, gap)
    parts = [np.array([[a, b, z] for a, b in zip(x * shrink, y * shrink, strict=True) for z in rest[:, 2]])]
    radii = [inner, *_thinner(inner), 0.0]
    for thin in radii[1:]:
        count = max(8, _spread(np.pi * (radius - thin), thin, gap).size - 1)
        angle = 2 * np.pi * np.arange(count) / count
        across = (radius - thin) * np.column_stack([np.cos(angle), np.sin(angle)])
        parts.append(np.concatenate([np.column_stack([across, 0 * angle + side * (half - thin)]) for side in (-1, 1)]))
    return np.concatenate(parts), np.repeat(radii, [len(part) for part in parts])


def _thinner(inner: float) -> Array:
    """Return the radii [m] of the thinner spheres beside the edges of a box or cylinder with spheres of this radius."""
    return np.array([inner * 0.5**k for k in range(1, 1 + max(0, int(np.log2(inner / THINNEST))))])


def _box(half: Array, gap: float) -> Spheres:
    """Return spheres as thick as the box in its middle plane, thinner ones beside its edges, and points on these."""
    inner = float(half.min())
    parts = [np.array(np.meshgrid(*[_spread(size - inner, inner, gap) for size in half])).reshape(3, -1).T]
    radii = [inner, *_thinner(inner), 0.0]
    for radius in radii[1:]:
        edges = []
        for axis in range(3):
            for sides in np.array(np.meshgrid([-1, 1], [-1, 1])).reshape(2, -1).T:
                along = _spread(half[axis] - radius, radius, gap)
                edge = np.empty((along.size, 3))
                edge[:, axis] = along
                edge[:, np.delete(np.arange(3), axis)] = sides * (np.delete(half, axis) - radius)
                edges.append(edge)
        parts.append(np.concatenate(edges))
    return np.concatenate(parts), np.repeat(radii, [len(part) for part in parts])


def _ellipsoid(half: Array, gap: float) -> Spheres:
    order = np.argsort(-half)
    a, b, c = half[order]
    long, wide = (a * a - c * c) / a, (b * b - c * c) / b
    x, y = (part.ravel() for part in np.meshgrid(_spread(long, c, gap), _spread(wide, c, gap)))
    # map squares of the grid to rings, so that the outermost is the ellipse itself
    reach = np.maximum(np.abs(x) / max(long, TINY), np.abs(y) / max(wide, TINY))
    size = np.hypot(x / max(long, TINY), y / max(wide, TINY))
    shrink = np.where(size > 0, reach / np.maximum(size, TINY), 1.0)
    x, y = x * shrink, y * shrink
    remainder = 1 - x**2 / max(a * a - c * c, TINY**2) - y**2 / max(b * b - c * c, TINY**2)
    centres = np.zeros((x.size, 3))
    centres[:, order[0]], centres[:, order[1]] = x, y
    return centres, c * np.sqrt(np.maximum(remainder, 0))
