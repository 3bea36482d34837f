"""The surfaces of a model: the solid geoms that are welded to the world."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np

from ..array import Array, Index
from ..figure.model import geom_name, kinematics
from .box import Box
from .height_field import HeightField
from .hull import Hull
from .round import Capsule, Cylinder, Ellipsoid
from .surface import GROUNDED, UPRIGHT, Plane, Surface
from .touch import LEVEL, solids

DOWN = 10.0  # [m] extension of cylinders below the floor, so that there is no exit downwards


def static_surfaces(model: mujoco.MjModel) -> tuple[Surface, ...]:
    """Return the solid geoms welded to the world, planes first, and meshes as their convex hulls."""
    data = kinematics(model)
    ids = solids(model)
    planes = [_plane(model, data, g) for g in ids if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_PLANE]
    floor = max((p.point[2] for p in planes if p.normal[2] > LEVEL), default=-np.inf)
    shapes = [_solid(model, g, data.geom_xpos[g].copy(), data.geom_xmat[g].reshape(3, 3).copy(), floor) for g in ids]
    return (*planes, *(solid for solid in shapes if solid is not None))


def moving_surface(model: mujoco.MjModel, geom: int, centre: Array, axes: Array) -> Surface | None:
    """Return the surface of a geom that moves, or None for shapes without one. All its faces are equivalent exits.

    Args:
        geom: MuJoCo's id of the geom.
        centre: The centre in the axes of the carrying link, (3,) [m].
        axes: The geom's axes in those of the carrying link, (3, 3).
    """
    solid = _solid(model, geom, centre, axes, -np.inf)
    return replace(solid, sideways=1.0) if isinstance(solid, Box) else solid


def _plane(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> Plane:
    normal = data.geom_xmat[geom].reshape(3, 3)[:, 2].copy()
    return Plane(geom_name(model, geom), data.geom_xpos[geom].copy(), normal)


def _solid(model: mujoco.MjModel, geom: int, centre: Array, axes: Array, floor: float) -> Surface | None:
    """Return the surface of one geom that is not a plane; None for shapes without one."""
    kinds, kind = mujoco.mjtGeom, int(model.geom_type[geom])
    name, size = geom_name(model, geom), np.array(model.geom_size[geom])
    if kind == kinds.mjGEOM_BOX:
        bottom = centre[2] - np.abs(axes[2]) @ size
        return Box(name, centre, axes, size, bool(bottom <= floor + GROUNDED))
    if kind == kinds.mjGEOM_SPHERE:
        return Capsule(name, centre, axes[:, 2], 0.0, float(size[0]))
    if kind == kinds.mjGEOM_CAPSULE:
        return Capsule(name, centre, axes[:, 2], float(size[1]), float(size[0]))
    if kind == kinds.mjGEOM_CYLINDER:
        return _cylinder(name, centre, axes[:, 2], size, floor)
    if kind == kinds.mjGEOM_ELLIPSOID:
        return Ellipsoid(name, centre, axes, size)
    if kind == kinds.mjGEOM_MESH:
        return _hull(model, name, centre, axes, int(model.geom_dataid[geom]), floor)
    if kind == kinds.mjGEOM_HFIELD:
        return _height_field(model, name, centre, axes, int(model.geom_dataid[geom]))
    return None


def _cylinder(name: str, centre: Array, axis: Array, size: Array, floor: float) -> Cylinder:
    """Return a cylinder. If it stands on the floor, it extends below it."""
    radius, half = float(size[0]), float(size[1])
    upward = axis if axis[2] > 0 else -axis
    bottom = centre[2] - half * upward[2] - radius * np.sqrt(max(1 - upward[2] ** 2, 0))
    if upward[2] > UPRIGHT and bottom <= floor + GROUNDED:
        return Cylinder(name, centre - 0.5 * DOWN * upward, upward, half + 0.5 * DOWN, radius)
    return Cylinder(name, centre, axis, half, radius)


def _hull(model: mujoco.MjModel, name: str, centre: Array, axes: Array, mesh: int, floor: float) -> Hull | None:
    """Return a mesh's convex hull as MuJoCo computed it, with the corners of triangles counterclockwise from outside;
    None for a flat mesh, which encloses no volume."""
    graph = int(model.mesh_graphadr[mesh])
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    vertices = centre + np.array(model.mesh_vert[first : first + count], float) @ axes.T
    if graph < 0:
        return _computed_hull(name, vertices, floor)
    corners, faces = int(model.mesh_graph[graph]), int(model.mesh_graph[graph + 1])
    # counts of corners and faces; per corner the start of its edges, and its vertex; the edges; three vertices per face
    at = graph + 2 + corners
    used = np.array(model.mesh_graph[at : at + corners], np.intp)
    at += corners + corners + 3 * faces
    triangles = np.array(model.mesh_graph[at : at + 3 * faces], np.intp).reshape(-1, 3)
    order = np.zeros(count, np.intp)
    order[used] = np.arange(corners)
    hull = vertices[used].T
    return Hull(name, hull, order[triangles], bool(hull[2].min() <= floor + GROUNDED))


def hull_of(vertices: Array, most: int = -1) -> tuple[Array, Index] | None:
    """Return corners (3, v) and triangles (f, 3) of the convex hull of points (n, 3), or None if they lie in a plane.

    Args:
        most: The maximum number of corners; −1: no limit.
    """
    hull = _computed_hull("hull", vertices, -np.inf, most)
    return None if hull is None else (hull.corners, hull.faces)


def _computed_hull(name: str, vertices: Array, floor: float, most: int = -1) -> Hull | None:
    """Return the hull of points (v, 3) in the world [m], for meshes of which the model contains no hull."""
    spec = mujoco.MjSpec()
    spec.add_mesh(name="hull", uservert=vertices.ravel(), maxhullvert=most)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="hull")
    try:
        model = spec.compile()
    except ValueError:
        return None
    data = kinematics(model)
    return _hull(model, name, data.geom_xpos[0], data.geom_xmat[0].reshape(3, 3), 0, floor)


def _height_field(model: mujoco.MjModel, name: str, centre: Array, axes: Array, field: int) -> HeightField:
    rows, columns = int(model.hfield_nrow[field]), int(model.hfield_ncol[field])
    first = int(model.hfield_adr[field])
    data = np.array(model.hfield_data[first : first + rows * columns], float).reshape(rows, columns)
    size = np.array(model.hfield_size[field])
    return HeightField(name, centre, axes, size[:2], size[2] * data)
