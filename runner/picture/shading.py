"""Colours of surfaces and of the sky, as red, green and blue in [0, 1], float32.

Textures of planes are averaged over about the area of a pixel (mipmaps), others over their whole area. There are no
reflections and highlights.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from ..scene.triangles import Piece, half_extent, picture_repeat, texels

Array = NDArray[np.float64]
Floats = NDArray[np.float32]

DAYLIGHT = np.array([[0.62, 0.72, 0.86], [0.9, 0.93, 0.97]], np.float32)  # zenith and horizon of the default sky
OFF_EDGES = 1e-6  # [1] of a texture, so that rounding does not decide about pixels on the edge of a texel
HAZE_RISE = 0.05  # sine of the angle above the horizon within which the haze thins


@dataclass(frozen=True)
class Pattern:
    """The repeated texture of a plane.

    Attributes:
        repeat: Textures per metre, (2,).
        levels: The texture, and its means over 2x2, 4x4, ... texels, up to its mean colour, (h, w, 3) each.
    """

    repeat: Array
    levels: tuple[Floats, ...]

    @classmethod
    def of(cls, model: mujoco.MjModel, plane: Piece) -> Pattern:
        levels = [(texels(model, plane.picture) / 255).astype(np.float32)]
        while min(height := levels[-1].shape[0] // 2, width := levels[-1].shape[1] // 2):
            levels.append(levels[-1][: 2 * height, : 2 * width].reshape(height, 2, width, 2, 3).mean(axis=(1, 3)))
        return cls(picture_repeat(model, plane, half_extent(plane, 1.0)), tuple(levels))

    def colour(self, local: Array, rays: Array, spacing: Array) -> Floats:
        """Return the colours of the texels as large as the patches that the pixels cover, (n, 3).

        Args:
            local: Points where rays meet the plane, in its frame, (n, 3) [m].
            rays: Their unit directions in its frame, (n, 3).
            spacing: The distance of neighbouring rays there, perpendicular to them, (n,) [m].
        """
        side = spacing / np.sqrt(np.maximum(np.abs(rays[:, 2]), 1e-4))  # geometric mean of the patch's sides
        covered = side * self.repeat.max() * max(self.levels[0].shape[:2])  # [texels]
        level = np.clip(np.rint(np.log2(np.maximum(covered, 1.0))), 0, len(self.levels) - 1).astype(int)
        place = (local[:, :2] * self.repeat + OFF_EDGES) % 1
        colour = np.empty((len(local), 3), np.float32)
        for number in np.unique(level):
            texture, of_level = self.levels[number], level == number
            height, width = texture.shape[:2]
            column, row = (place[of_level] * [width, height]).astype(int).T
            colour[of_level] = texture[row % height, column % width]
        return colour


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
