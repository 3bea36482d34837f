"""Lights of a scene and their shadow maps, each of the region near the middle of the picture."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..scene.mujoco_versions import Lamp, drawn_lamp
from .depth_buffer import Eye, Faces

Array = NDArray[np.float64]
Floats = NDArray[np.float32]

SUN_DISTANCE = 1000.0  # [1] distance of a directional light's eye, relative to the radius of the region with shadows
WIDEST = 2.0  # tangent of the half angle of a shadow map for a light among the figures
LIFT = 2.0  # [texels] offset of a shadow lookup above its surface, so that no surface shades itself
SOFT_RIM = 0.02  # difference of cosines over which a spot's light fades at its cone


class Shadow(NamedTuple):
    """A light's shadow map: its eye, and 1 / depth of the nearest surface, (height * width,)."""

    eye: Eye
    nearest: Array

    @classmethod
    def of(cls, light: Any, points: Array, centre: Array, radius: float, size: int) -> Shadow:
        """Return the shadow map, size x size texels, of triangles (m, 3, 3) within a sphere [m]."""
        if drawn_lamp(light) is Lamp.DIRECTIONAL:
            distance = SUN_DISTANCE * radius
            position = centre - distance * np.asarray(light.dir, float)
        else:
            position = np.asarray(light.pos, float)
            distance = float(np.linalg.norm(centre - position)) + 1e-9
        forward = (centre - position) / distance
        right = np.cross(forward, np.eye(3)[np.argmin(np.abs(forward))])
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(forward, right), forward])
        eye = Eye(position, axes, size / 2 / min(radius / distance, WIDEST), size, size, near=1e-3 * radius)
        return cls(eye, Faces(eye, points).cover(np.array([0.5, 0.5]))[0])

    def lit(self, points: Array, normals: Floats) -> Floats:
        """Return the fraction of light at surface points (n, 3), (n,): interpolated over a texel, 1 outside."""
        eye = self.eye
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


class Light(NamedTuple):
    """A light, as in MjvLight, with its shadow map, if it casts shadows."""

    kind: Lamp
    position: Array
    direction: Floats
    cutoff: float
    ambient: Floats
    diffuse: Floats
    shadow: Shadow | None

    @classmethod
    def of(cls, light: Any, points: Array, centre: Array, radius: float, size: int) -> Light:
        """Return a light of a scene (MjvLight); the other arguments are those of `Shadow.of`."""
        shadow = Shadow.of(light, points, centre, radius, size) if light.castshadow else None
        colours = light.ambient.copy(), light.diffuse.copy()
        position, direction = np.array(light.pos, float), np.array(light.dir, np.float32)
        return cls(drawn_lamp(light), position, direction, float(np.radians(light.cutoff)), *colours, shadow)

    def shine(self, points: Array, normals: Floats) -> Floats:
        """Return the share of diffuse light (Lambert) at points (n, 3) with unit normals (n, 3), (n,)."""
        towards, cone = self._towards(points)
        slope = np.einsum("ij,ij->i", normals, towards)
        faced = np.flatnonzero(slope > 0)
        reached = np.zeros(len(slope), np.float32)
        reached[faced] = slope[faced] * cone[faced]
        if self.shadow is not None:
            reached[faced] *= self.shadow.lit(points[faced], normals[faced])
        return reached

    def _towards(self, points: Array) -> tuple[Floats, Floats]:
        """Return unit directions to the light (n, 3), and its strength (n,), less at the rim of a spot's cone."""
        everywhere = np.ones(len(points), np.float32)
        if self.kind is Lamp.DIRECTIONAL:
            return np.broadcast_to(-self.direction, points.shape), everywhere
        away = (self.position - points).astype(np.float32)
        away /= np.linalg.norm(away, axis=1, keepdims=True) + np.float32(1e-9)
        if self.kind is Lamp.POINT:
            return away, everywhere
        return away, ((away @ -self.direction - np.float32(np.cos(self.cutoff))) / np.float32(SOFT_RIM)).clip(0, 1)
