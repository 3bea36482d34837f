"""Colours of surfaces and of the sky, as red, green and blue in [0, 1], float32.

Textures of planes are reduced to four quarters and a border line, which describes MuJoCo's checkers and grids, and are
averaged over the area of a pixel. Other textures are reduced to their mean colour. There are no reflections.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from ..scene.triangles import Piece, half_extent, picture_repeat, texels

Array = NDArray[np.float64]
Floats = NDArray[np.float32]

SHARPEST = 128  # specular exponent at shininess 1, as in OpenGL
SMALL = 8  # [texels] textures up to this size have no border line
DAYLIGHT = np.array([[0.62, 0.72, 0.86], [0.9, 0.93, 0.97]], np.float32)  # zenith and horizon of the default sky
HAZE_RISE = 0.05  # sine of the angle above the horizon within which the haze thins


@dataclass(frozen=True)
class Pattern:
    """The texture of a plane: four quarters and a border line, repeated.

    Attributes:
        repeat: Textures per metre, (2,).
        quarters: Colours by half in x and half in y, (2, 2, 3).
        line: The colour of the border, (3,).
        border: The width of the border, relative to the texture.
    """

    repeat: Array
    quarters: Floats
    line: Floats
    border: float

    @classmethod
    def of(cls, model: mujoco.MjModel, plane: Piece) -> Pattern:
        picture = (texels(model, plane.picture) / 255).astype(np.float32)
        height, width = picture.shape[:2]
        has_line = min(height, width) > SMALL
        inner = picture[2:-2, 2:-2] if has_line else picture
        quarters = np.array(
            [[part.mean(axis=(0, 1)) for part in np.array_split(half, 2)] for half in np.array_split(inner, 2, axis=1)]
        )
        line = picture[0].mean(axis=0)
        has_line = has_line and not np.allclose(line, quarters.mean(axis=(0, 1)), atol=0.02)
        repeat = picture_repeat(model, plane, half_extent(plane, 1.0))
        return cls(repeat, quarters, line, 1 / width if has_line else 0.0)

    def colour(self, local: Array, rays: Array, spacing: Array) -> Floats:
        """Return mean colours of the patches that the pixels cover, (n, 3).

        Args:
            local: Points where rays meet the plane, in its frame, (n, 3) [m].
            rays: Their unit directions in its frame, (n, 3).
            spacing: The distance of neighbouring rays there, perpendicular to them, (n,) [m].
        """
        across, along, normal = np.abs(rays.T)
        flat = np.sqrt(across**2 + along**2) + 1e-9
        stretch = flat / np.maximum(normal, 1e-4)  # a patch is long in the direction of a flat ray
        u, v = local[:, :2].T * self.repeat[:, None]
        width_u = self.repeat[0] * spacing * (along + across * stretch) / flat + 1e-6
        width_v = self.repeat[1] * spacing * (across + along * stretch) / flat + 1e-6
        half_u, half_v = (_share(place, width, 0.5, 0.5)[:, None] for place, width in ((u, width_u), (v, width_v)))
        low = self.quarters[0, 0] + (self.quarters[0, 1] - self.quarters[0, 0]) * half_v
        high = self.quarters[1, 0] + (self.quarters[1, 1] - self.quarters[1, 0]) * half_v
        colour = low + (high - low) * half_u
        if self.border > 0:
            on_u = _share(u, width_u, -self.border, 2 * self.border)
            on_v = _share(v, width_v, -self.border, 2 * self.border)
            colour += (self.line - colour) * (on_u + on_v - on_u * on_v)[:, None]
        return colour


def _share(position: Array, width: Array, start: float, length: float) -> Floats:
    """Return the share of intervals of this width that is in [start, start + length], repeated with period 1, (n,)."""

    def covered(end: Array) -> Array:
        whole = np.floor(end)
        return whole * length + np.minimum(end - whole, length)

    low = position - start - width / 2
    return ((covered(low + width) - covered(low)) / width).astype(np.float32)


def texture_tint(model: mujoco.MjModel, material: int) -> Array:
    """Return the mean colour of a material's texture, (3,); white without a texture."""
    texture = model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] if material >= 0 else -1
    return texels(model, texture).mean(axis=(0, 1)) / 255 if texture >= 0 else np.ones(3)


class Sky:
    """The colour above the horizon, from the model's skybox, or daylight if it has none.

    Attributes:
        haze: The colour into which the distance fades, (3,).
    """

    def __init__(self, model: mujoco.MjModel) -> None:
        boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX)
        if not len(boxes):
            zenith, self.haze = DAYLIGHT
            self._profile = self.haze + (zenith - self.haze) * np.linspace(1, -1, 64, dtype=np.float32).clip(0)[:, None]
            return
        self.haze = model.vis.rgba.haze[:3].astype(np.float32)
        picture = (texels(model, int(boxes[0])) / 255).astype(np.float32)
        faces = picture.reshape(-1, picture.shape[1], picture.shape[1], 3)
        self._profile = faces[4 if len(faces) == 6 else 0].mean(axis=1)  # a side of the box, from top to bottom

    def colour(self, directions: Array) -> Floats:
        """Return the colours of unit directions, by their elevation, with haze at the horizon, (n, 3)."""
        rise = directions[:, 2].astype(np.float32)
        steep = np.clip(rise / np.sqrt(np.maximum(1 - rise**2, 1e-6)), -1, 1)
        sky = self._profile[((1 - steep) / 2 * (len(self._profile) - 1)).astype(np.int32)]
        return sky + np.exp(-np.maximum(rise, 0) / HAZE_RISE)[:, None] * (self.haze - sky)
