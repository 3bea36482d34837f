"""Lights of a scene and their shadow maps, each of the region near the middle of the picture."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..scene.mujoco_versions import lamp
from .depth_buffer import Eye, Faces

Array = NDArray[np.float64]
Floats = NDArray[np.float32]

SUN_DISTANCE = 1000.0  # [1] distance of a directional light, relative to the radius of the region with shadows
WIDEST = 2.0  # tangent of the half angle of a shadow map for a light among the figures
LIFT = 2.0  # [texels] offset of a shadow lookup above its surface, so that no surface shades itself
SOFT_RIM = 0.02  # difference of cosines over which a spot's light fades at its cone
ALL_ROUND = -2.0  # cosine of the cone of lights that have none


class Light(NamedTuple):
    """A light as a spot; a directional one is a distant spot.

    Attributes:
        cone: Cosine of the half angle of the light's cone.
        eye: The projection of the shadow map, None without shadows.
        nearest: 1 / depth of the nearest surface in the shadow map, (height * width,).
    """

    position: Array
    direction: Floats
    cone: float
    ambient: Floats
    diffuse: Floats
    eye: Eye | None
    nearest: Array

    @classmethod
    def of(cls, light: Any, points: Array, centre: Array, radius: float, size: int) -> Light:
        """Return a light (MjvLight) with a shadow map, size x size texels, of triangles (m, 3, 3) in a sphere [m]."""
        kind, direction = lamp(light), np.array(light.dir, float)
        position = np.array(light.pos, float)
        if kind == "directional":
            position = centre - SUN_DISTANCE * radius * direction
        cone = float(np.cos(np.radians(light.cutoff))) if kind == "spot" else ALL_ROUND
        eye, nearest = None, np.empty(0)
        if light.castshadow:
            distance = float(np.linalg.norm(centre - position)) + 1e-9
            forward = (centre - position) / distance
            right = np.cross(forward, np.eye(3)[np.argmin(np.abs(forward))])
            right /= np.linalg.norm(right)
            axes = np.stack([right, np.cross(forward, right), forward])
            eye = Eye(position, axes, size / 2 / min(radius / distance, WIDEST), size, size, near=1e-3 * radius)
            nearest = Faces(eye, points).cover(np.array([0.5, 0.5]))[0]
        colours = light.ambient.copy(), light.diffuse.copy()
        return cls(position, direction.astype(np.float32), cone, *colours, eye, nearest)

    def shine(self, points: Array, normals: Floats) -> Floats:
        """Return the share of diffuse light (Lambert) at points (n, 3) with unit normals (n, 3), (n,)."""
        towards = (self.position - points).astype(np.float32)
        towards /= np.linalg.norm(towards, axis=1, keepdims=True) + np.float32(1e-9)
        within = ((towards @ -self.direction - np.float32(self.cone)) / np.float32(SOFT_RIM)).clip(0, 1)
        reached = np.einsum("ij,ij->i", normals, towards).clip(0) * within
        faced = np.flatnonzero(reached)
        if self.eye is not None:
            reached[faced] *= self._lit(self.eye, points[faced], normals[faced])
        return reached

    def _lit(self, eye: Eye, points: Array, normals: Floats) -> Floats:
        """Return the fraction of light at surface points (n, 3), (n,): interpolated over a texel, 1 outside."""
        texel = np.linalg.norm(points - eye.position, axis=1, keepdims=True) / eye.focus
        x, y, depth = eye.project(points + LIFT * texel * normals).T
        depth = np.where(depth > eye.near, depth, np.inf)
        x, y = x / depth - 0.5, y / depth - 0.5
        inside = np.flatnonzero((x > 0) & (y > 0) & (x < eye.width - 1) & (y < eye.height - 1))
        x, y, limit = x[inside], y[inside], 1 / depth[inside]
        column, row = x.astype(int), y.astype(int)
        x, y = x - column, y - row
        place = row * eye.width + column
        out = np.ones(len(points), np.float32)
        for step, share in ((0, (1 - x) * (1 - y)), (1, x * (1 - y)), (eye.width, (1 - x) * y), (eye.width + 1, x * y)):
            out[inside] -= share * (self.nearest[place + step] > limit)
        return out
