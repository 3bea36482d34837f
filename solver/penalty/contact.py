"""Floor and step: contact points stay above the surfaces (eq. 12), squared so that the gradient is smooth.

A point is a sphere of a radius (0 for a site) on a link. `body_points` covers a figure's own spheres, capsules and
boxes by such points, so that the whole body stays out; for spheres and capsules against a plane the cover is exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from .. import quaternion as quat
from ..figure import Figure
from ..kinematics import Cotangent, Samples, cross, turned
from ..quaternion import Array
from ..surface import Surface


@dataclass(frozen=True)
class Point:
    """A sphere fixed on a link: link index, centre (3,) in the link [m], radius [m]."""

    name: str
    link: int
    position: Array
    radius: float = 0.0


@dataclass(frozen=True)
class Contact:
    """Σ over points and surfaces of depth² [m²], every point grown by `margin` [m]."""

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    margin: float = 0.0
    name: str = "contact"

    @property
    def reference(self) -> float:
        return 1e-4

    def centres(self, samples: Samples) -> tuple[Array, Array, Array]:
        """Centres (3, n, S) [m], the vectors to them from their links' origins, and the links' indices (n,)."""
        links = np.array([point.link for point in self.points], np.intp)
        arm = turned(samples.links.rotation[:, :, links], np.array([point.position for point in self.points]).T)
        return samples.links.x[:, links] + arm, arm, links

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = np.zeros(samples.count)
        if not self.points or not self.surfaces:
            return values
        centres, arm, links = self.centres(samples)
        radius = np.array([point.radius for point in self.points]) + self.margin
        force = None
        for surface in self.surfaces:
            depth, gradient = surface.depth(centres, radius)
            if not depth.any():
                continue
            values += np.sum(depth**2, axis=0)
            push = (2 * depth) * gradient
            force = push if force is None else force + push
        if into is not None and force is not None:
            force *= scale
            x_bar, turn_bar = into.room("x"), into.room("turn")
            np.add.at(x_bar, (slice(None), links), force)
            np.add.at(turn_bar, (slice(None), links), cross(arm, force))
        return values


def site_points(figure: Figure, names: Sequence[str]) -> tuple[Point, ...]:
    """Points at sites of the model, by name."""
    points = []
    for name in names:
        site = figure.model.site(name)
        link, position = figure.point_on_link(int(figure.model.site_bodyid[site.id]), site.pos)
        points.append(Point(name, link, position))
    return tuple(points)


def body_points(figure: Figure, spacing: float = 0.12) -> tuple[Point, ...]:
    """Spheres that cover the figure's moving geoms: capsules and cylinders along their axis, boxes by their corners.

    spacing  [m] between the spheres along a capsule
    """
    model, points = figure.model, []
    for geom in range(model.ngeom):
        body = int(model.geom_bodyid[geom])
        if figure.body_link[body] == 0:
            continue
        axes = np.stack([quat.rotated(model.geom_quat[geom], e) for e in np.eye(3)], axis=1)
        for offset, radius in _cover(int(model.geom_type[geom]), np.array(model.geom_size[geom]), spacing):
            link, position = figure.point_on_link(body, model.geom_pos[geom] + axes @ offset)
            points.append(Point(model.geom(geom).name or f"geom {geom}", link, position, radius))
    return tuple(points)


def _cover(kind: int, size: Array, spacing: float) -> list[tuple[Array, float]]:
    """(offset in the geom's axes, radius) of the spheres that cover one geom."""
    geom = mujoco.mjtGeom
    if kind == geom.mjGEOM_SPHERE:
        return [(np.zeros(3), float(size[0]))]
    if kind == geom.mjGEOM_CAPSULE:
        count = max(2, int(np.ceil(2 * size[1] / spacing)) + 1)
        return [(np.array([0, 0, z]), float(size[0])) for z in np.linspace(-size[1], size[1], count)]
    if kind == geom.mjGEOM_CYLINDER:
        ring = [np.array([np.cos(a), np.sin(a), 0]) * size[0] for a in np.arange(8) * np.pi / 4]
        return [(p + [0, 0, z], 0.0) for p in ring for z in (-size[1], size[1])]
    if kind == geom.mjGEOM_BOX:
        signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
        return [(s * size, 0.0) for s in signs]
    if kind == geom.mjGEOM_ELLIPSOID:
        return [(sign * e * (size - size.min()), float(size.min())) for e in np.eye(3) for sign in (-1, 1)]
    return []
