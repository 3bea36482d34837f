"""Software rendering of a MuJoCo scene: triangles in a depth buffer, four samples per pixel, and shadow maps.

The lighting is that of MuJoCo's renderer without reflections and highlights: ambient, diffuse (Lambert), and haze in
the distance. Colours are red, green and blue in [0, 1], float32.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from ..scene.mujoco_versions import lamp
from ..scene.triangles import MESHES, half_extent, picture_repeat, piece_of, texels, triangles
from .depth_buffer import Eye, Faces
from .lights import Light

Picture = NDArray[np.uint8]
Array = NDArray[np.float64]
Floats = NDArray[np.float32]
Ints = NDArray[np.intp]

_KINDS = mujoco.mjtGeom
PLANE = int(_KINDS.mjGEOM_PLANE)
ROUND = (_KINDS.mjGEOM_SPHERE, _KINDS.mjGEOM_CAPSULE, _KINDS.mjGEOM_ELLIPSOID, _KINDS.mjGEOM_CYLINDER)
DRAWN = {int(kind) for kind in (_KINDS.mjGEOM_PLANE, _KINDS.mjGEOM_HFIELD, _KINDS.mjGEOM_BOX, *ROUND, *MESHES)}
FAR = 1000.0  # [m] extent of an infinite plane
SAMPLES = np.array([[1, 5], [3, 1], [5, 7], [7, 3]]) / 8  # positions in a pixel, in different rows and columns
AT_ONCE = 30_000  # samples shaded at once, few enough for the processor's cache
SHADOW_DETAIL = 1.6  # texels of a shadow map for each pixel of the picture's longer side
SHADOW_MARGIN = 1.3  # radius of the region with shadows, relative to that of the region in view
HAZE_START, HAZE_LENGTH = 9.0, 28.0  # [m] distance at which haze begins, and length scale of its increase
HAZE_RISE = 0.05  # sine of the angle above the horizon within which the haze thins
DAYLIGHT = np.array([[0.62, 0.72, 0.86], [0.9, 0.93, 0.97]], np.float32)  # zenith and horizon of the default sky
OFF_EDGES = 1e-6  # [1] of a texture, so that rounding does not decide about pixels on the edge of a texel


class Surface(NamedTuple):
    """Triangles: corners (m, 3, 3), normals at the corners (m, 3, 3), and index of each in a list of geoms (m,)."""

    points: Array
    normals: Array
    geom: Ints


class View(NamedTuple):
    """The inputs of a picture; by geom: colour (k, 3), emission (k,), whether it is part of the static scene (k,)."""

    eye: Eye
    surface: Surface
    faces: Faces
    lights: list[Light]
    geoms: list[Any]
    colour: Floats
    emission: Floats
    is_still: NDArray[np.bool_]


class Raster:
    """A renderer with the interface of `mujoco.Renderer`."""

    def __init__(self, model: mujoco.MjModel, height: int, width: int, max_geom: int) -> None:
        self.scene = mujoco.MjvScene(model, max_geom)
        self._model, self._width, self._height = model, width, height
        self._sky = Sky(model)
        self._shape = cache(self._shape_of)
        self._pattern = cache(lambda geom: Pattern(model, geom))
        self._tint = cache(lambda material: _texture_tint(model, material))

    def close(self) -> None:
        """Do nothing; there are no resources to release."""

    def render(self) -> Picture:
        """Return the present scene, (height, width, 3)."""
        view = self._view()
        closeness, face = (np.stack(part) for part in zip(*(view.faces.cover(at) for at in SAMPLES), strict=True))
        geom = np.append(view.surface.geom[view.faces.number], -1)[face]
        is_edge = (geom != geom[0]).any(axis=0)
        inner, edge = np.flatnonzero(~is_edge), np.flatnonzero(is_edge)
        pixel = np.concatenate([inner, np.tile(edge, len(SAMPLES))])
        sample = np.repeat([0, *range(len(SAMPLES))], [len(inner)] + len(SAMPLES) * [len(edge)])
        colour = np.empty((len(pixel), 3), np.float32)
        for start in range(0, len(pixel), AT_ONCE):
            part = slice(start, start + AT_ONCE)
            which = sample[part], pixel[part]
            x, y = which[1] % self._width + SAMPLES[which[0], 0], which[1] // self._width + SAMPLES[which[0], 1]
            colour[part] = self._colour(view, x, y, face[which], closeness[which])
        image = np.empty((self._height * self._width, 3), np.float32)
        image[inner] = colour[: len(inner)]
        image[edge] = colour[len(inner) :].reshape(len(SAMPLES), len(edge), 3).mean(axis=0)
        return np.rint(image.clip(0, 1) * 255).astype(np.uint8).reshape(self._height, self._width, 3)

    def _view(self) -> View:
        geoms = [geom for geom in self.scene.geoms[: self.scene.ngeom] if geom.type in DRAWN and geom.rgba[3] > 0]
        eye, surface = self._eye(), self._surface(geoms)
        colour = np.array([g.rgba[:3] * self._tint(g.matid) for g in geoms], np.float32).reshape(-1, 3)
        emission = np.array([g.emission for g in geoms], np.float32)
        is_still = np.array([g.category == mujoco.mjtCatBit.mjCAT_STATIC for g in geoms], bool)
        lights = self._lights(eye, surface, geoms, is_still)
        return View(eye, surface, Faces(eye, surface.points), lights, geoms, colour, emission, is_still)

    def _eye(self) -> Eye:
        """Return the camera of the scene, midway between its two stereo cameras."""
        left_eye, right = self.scene.camera
        forward, up = np.array(left_eye.forward, float), np.array(left_eye.up, float)
        focus = self._height * left_eye.frustum_near / (left_eye.frustum_top - left_eye.frustum_bottom)
        position = (np.array(left_eye.pos, float) + right.pos) / 2
        axes = np.stack([np.cross(forward, up), -up, forward])
        return Eye(position, axes, focus, self._width, self._height, float(left_eye.frustum_near))

    def _shape_of(self, geom: int) -> tuple[Array, Array]:
        """Return the corners and normals (m, 3, 3) of a geom's triangles in its frame."""
        shape = triangles(self._model, piece_of(self._model, geom), FAR)
        return shape.points[shape.faces], shape.normals[shape.faces]

    def _surface(self, geoms: list[Any]) -> Surface:
        """Return all triangles of the scene, in the world."""
        parts = [Surface(*(np.empty((0, 3, 3)),) * 2, np.empty(0, int))]
        for index, geom in enumerate(geoms):
            (points, normals), turn = self._shape(geom.objid), np.asarray(geom.mat, float).T
            parts.append(Surface(points @ turn + geom.pos, normals @ turn, np.full(len(points), index)))
        return Surface(*(np.concatenate(part) for part in zip(*parts, strict=True)))

    def _lights(self, eye: Eye, surface: Surface, geoms: list[Any], is_still: NDArray[np.bool_]) -> list[Light]:
        """Return the active lights, with shadows of objects near the figures."""
        solid = np.array([geom.type != PLANE for geom in geoms], bool)[surface.geom]
        figures = surface.points[~is_still[surface.geom]].reshape(-1, 3)
        if not len(figures):
            figures = (eye.position + eye.axes[2] * self._model.stat.extent)[None]
        low, high = figures.min(axis=0), figures.max(axis=0)
        centre = (low + high) / 2
        in_view = np.linalg.norm(centre - eye.position) * np.hypot(eye.width, eye.height) / 2 / eye.focus
        radius = SHADOW_MARGIN * max(float(np.linalg.norm(high - low)) / 2, float(in_view))
        size = round(SHADOW_DETAIL * max(eye.width, eye.height))
        return [
            Light.of(light, surface.points[solid], centre, radius, size)
            for light in self.scene.lights[: self.scene.nlight]
            if lamp(light) != "image"
        ]

    def _colour(self, view: View, x: Array, y: Array, face: Ints, closeness: Array) -> Floats:
        """Return colours at pixels (n, 3), of the visible face, or of the sky where its index is negative."""
        rays = view.eye.rays(x, y)
        length = np.linalg.norm(rays, axis=1)
        rays /= length[:, None]
        met, empty = np.flatnonzero(face >= 0), np.flatnonzero(face < 0)
        out = np.empty((len(face), 3), np.float32)
        out[empty] = self._sky.colour(rays[empty])
        face, rays, distance = face[met], rays[met], length[met] / closeness[met]
        number = view.faces.number[face]
        points, geom = view.eye.position + rays * distance[:, None], view.surface.geom[number]
        normals = np.einsum("nk,nki->ni", view.faces.weights(face, x[met], y[met]), view.surface.normals[number])
        normals = (normals / (np.linalg.norm(normals, axis=1, keepdims=True) + 1e-9)).astype(np.float32)
        base = view.colour[geom]
        for index in np.unique(geom):
            plane = view.geoms[index]
            if plane.type == PLANE and piece_of(self._model, plane.objid).picture >= 0:
                on = np.flatnonzero(geom == index)
                local, ahead = (points[on] - plane.pos) @ plane.mat, rays[on] @ plane.mat
                spacing = distance[on] / view.eye.focus
                base[on] = plane.rgba[:3] * self._pattern(plane.objid).colour(local, ahead, spacing)
        energy = np.repeat(view.emission[geom, None], 3, axis=1)
        for light in view.lights:
            energy += light.ambient + light.diffuse * light.shine(points, normals)[:, None]
        depth = np.where(view.is_still[geom], np.maximum(distance - HAZE_START, 0), 0)
        clear = np.exp(-depth.astype(np.float32) / np.float32(HAZE_LENGTH))[:, None]
        out[met] = self._sky.haze + clear * (np.minimum(base * energy, 1) - self._sky.haze)
        return out


def _texture_tint(model: mujoco.MjModel, material: int) -> Array:
    """Return the mean colour of a material's texture, (3,); white without a texture."""
    texture = model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] if material >= 0 else -1
    return texels(model, texture).mean(axis=(0, 1)) / 255 if texture >= 0 else np.ones(3)


class Pattern:
    """The repeated texture of a plane, averaged over about the area of a pixel (mipmaps)."""

    def __init__(self, model: mujoco.MjModel, geom: int) -> None:
        plane = piece_of(model, geom)
        self._repeat = picture_repeat(model, plane, half_extent(plane, 1.0))
        self._levels = [(texels(model, plane.picture) / 255).astype(np.float32)]
        while min(height := self._levels[-1].shape[0] // 2, width := self._levels[-1].shape[1] // 2):
            finer = self._levels[-1][: 2 * height, : 2 * width]
            self._levels.append(finer.reshape(height, 2, width, 2, 3).mean(axis=(1, 3)))

    def colour(self, local: Array, rays: Array, spacing: Array) -> Floats:
        """Return the colours of the texels as large as the patches that the pixels cover, (n, 3).

        local (n, 3) [m] are points where unit rays (n, 3) meet the plane, in its frame. spacing (n,) [m] is the
        distance of neighbouring rays there, perpendicular to them.
        """
        side = spacing / np.sqrt(np.maximum(np.abs(rays[:, 2]), 1e-4))  # geometric mean of the patch's sides
        covered = side * self._repeat.max() * max(self._levels[0].shape[:2])  # [texels]
        level = np.clip(np.rint(np.log2(np.maximum(covered, 1.0))), 0, len(self._levels) - 1).astype(int)
        place = (local[:, :2] * self._repeat + OFF_EDGES) % 1
        colour = np.empty((len(local), 3), np.float32)
        for number in np.unique(level):
            texture, of_level = self._levels[number], level == number
            height, width = texture.shape[:2]
            column, row = (place[of_level] * [width, height]).astype(int).T
            colour[of_level] = texture[row % height, column % width]
        return colour


class Sky:
    """The colour above the horizon, from the model's skybox or of daylight; haze (3,): that of the distance."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._zenith, self.haze = DAYLIGHT
        boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX)
        self._horizon = self.haze
        if len(boxes):
            self.haze = model.vis.rgba.haze[:3].astype(np.float32)
            picture = (texels(model, int(boxes[0])) / 255).astype(np.float32)
            faces = picture.reshape(-1, picture.shape[1], picture.shape[1], 3)
            side = faces[4 if len(faces) == 6 else 0].mean(axis=1)  # of the box, from top to bottom
            self._zenith, self._horizon = side[0], side[len(side) // 2]

    def colour(self, directions: Array) -> Floats:
        """Return the colours of unit directions, by their elevation, with haze at the horizon, (n, 3)."""
        rise = np.maximum(directions[:, 2].astype(np.float32), 0)[:, None]
        steep = np.minimum(rise / np.sqrt(np.maximum(1 - rise**2, 1e-6)), 1)
        sky = self._horizon + steep * (self._zenith - self._horizon)
        return sky + np.exp(-rise / HAZE_RISE) * (self.haze - sky)
