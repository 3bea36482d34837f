"""Software rendering of a MuJoCo scene: triangles in a depth buffer, and four samples per pixel at edges.

The lighting is ambient and diffuse (Lambert), without shadows of lights. Instead, the scene is shaded directly below
figures: the nearer a foot, the darker, so that its height is visible. Colours are red, green and blue in [0, 1],
float32.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from dynsplines.solver.array import IN_CACHE, Array, Index, Mask, count_off
from dynsplines.solver.tolerances import SINGLE, TINY

from ..scene.mujoco_versions import lamp
from ..scene.triangles import MESHES, half_extent, picture_repeat, piece_of, texels, triangles
from .film import Picture

Floats = NDArray[np.float32]

_KINDS = mujoco.mjtGeom
PLANE = int(_KINDS.mjGEOM_PLANE)
ROUND = (_KINDS.mjGEOM_SPHERE, _KINDS.mjGEOM_CAPSULE, _KINDS.mjGEOM_ELLIPSOID, _KINDS.mjGEOM_CYLINDER)
DRAWN = {int(kind) for kind in (_KINDS.mjGEOM_PLANE, _KINDS.mjGEOM_HFIELD, _KINDS.mjGEOM_BOX, *ROUND, *MESHES)}
FAR = 1000.0  # [m] extent of an infinite plane
SAMPLES = np.array([[1, 5], [3, 1], [5, 7], [7, 3]]) / 8  # positions in a pixel, in different rows and columns
SKY = np.array([0.84, 0.88, 0.93], np.float32)  # colour of the background
HAZE_START, HAZE_LENGTH = 9.0, 28.0  # [m] distance at which haze begins, and length scale of its increase
SHADE, SHADE_HEIGHT = 0.6, 0.25  # share of light that a foot on the ground takes, and length scale of its decrease [m]
SHADE_TEXELS = 1024  # width and height of the map of heights above the ground
FADING = 4.0  # [1] reciprocal of the share of a repetition of a texture at whose extent per pixel it has faded


class Eye(NamedTuple):
    """A perspective projection, of a camera or a light.

    Attributes:
        position: (3,) [m].
        axes: Rows right, down, forward, (3, 3).
        focus: The distance from the middle of a ray at 45 degrees [pixels].
        width: [pixels].
        height: [pixels].
        near: The smallest visible depth [m].
    """

    position: Array
    axes: Array
    focus: float
    width: int
    height: int
    near: float

    def project(self, points: Array) -> Array:
        """Return pixels from the left and from the top, both times the depth, and the depth [m], (..., 3)."""
        out = (points - self.position) @ self.axes.T
        out[..., 0] = out[..., 0] * self.focus + out[..., 2] * (self.width / 2)
        out[..., 1] = out[..., 1] * self.focus + out[..., 2] * (self.height / 2)
        return out

    def rays(self, x: Array, y: Array) -> Array:
        """Return directions through pixels, with unit depth, (n, 3)."""
        across, down = (x - self.width / 2) / self.focus, (y - self.height / 2) / self.focus
        return np.stack([across, down, np.ones_like(across)], axis=-1) @ self.axes


class Faces:
    """Triangles in a projection: linear functions (m, 3) of pixels for their edges and for 1 / depth."""

    def __init__(self, eye: Eye, points: Array) -> None:
        """Project points (m, 3, 3), counterclockwise from outside. Back faces are hidden."""
        corners = eye.project(points)
        edges = np.cross(np.roll(corners, -2, axis=1), np.roll(corners, -1, axis=1))
        volume = np.einsum("mi,mi->m", corners[:, 0], edges[:, 0])
        self.number = np.flatnonzero((volume > TINY) & (corners[..., 2].max(axis=1) > eye.near))
        self.edges = edges[self.number]
        self.closeness = self.edges.sum(axis=1) / volume[self.number, None]
        self._low, self._high = _extent(corners[self.number], eye.near)
        self._size = np.array([eye.width, eye.height])

    def weights(self, face: Index, x: Array, y: Array) -> Array:
        """Return barycentric coordinates at pixels on faces, (n, 3)."""
        out = self.edges[face] @ np.stack([x, y, np.ones_like(x)], axis=-1)[..., None]
        return out[..., 0] / out.sum(axis=1)

    def cover(self, at: Array) -> tuple[Array, Index]:
        """Return 1 / depth and index of the nearest face at an offset (2,) in every pixel, (h, w); else 0 and −1."""
        width, height = self._size
        nearest, winner = np.zeros(width * height), np.full(width * height, -1)
        low = np.clip(np.ceil(self._low - at), 0, self._size).astype(int)
        high = np.clip(np.floor(self._high - at), -1, self._size - 1).astype(int)
        for start in range(0, len(self.edges), 10 * IN_CACHE):
            part = slice(start, start + 10 * IN_CACHE)
            face, row = count_off(np.maximum(high[part, 1] - low[part, 1] + 1, 0))
            face += start
            row += low[face, 1]
            slope, rest = (
                self.edges[face, :, 0],
                self.edges[face, :, 1] * (row + at[1])[:, None] + self.edges[face, :, 2],
            )
            with np.errstate(divide="ignore", invalid="ignore"):
                place = -rest / slope - at[0]
            begin = np.ceil(np.where(slope > 0, place, -np.inf).max(axis=1, initial=0)).clip(low[face, 0])
            right = np.floor(np.where(slope < 0, place, np.inf).min(axis=1, initial=width)).clip(None, high[face, 0])
            right[((slope == 0) & (rest < 0)).any(axis=1)] = -1
            run, column = count_off(np.maximum(right - begin + 1, 0).astype(int))
            column += begin.astype(int)[run]
            face, row = face[run], row[run]
            along, down, start_value = self.closeness[face].T
            closeness = along * (column + at[0]) + (down * (row + at[1]) + start_value)
            pixel = row * width + column
            np.maximum.at(nearest, pixel, closeness)
            won = closeness == nearest[pixel]
            winner[pixel[won]] = face[won]
        return nearest, winner


def _extent(corners: Array, near: float) -> tuple[Array, Array]:
    """Return the smallest and largest pixels of triangles in front of the near plane, (m, 2) each."""
    with np.errstate(divide="ignore", invalid="ignore"):
        places = np.where(corners[..., 2:] > near, corners[..., :2] / corners[..., 2:], np.nan)
        crossing = np.flatnonzero(np.isnan(places).any(axis=(1, 2)))
        a, b = corners[crossing], np.roll(corners[crossing], -1, axis=1)
        share = (near - a[..., 2:]) / (b[..., 2:] - a[..., 2:])
        cut = (a + share * (b - a))[..., :2] / near
    low, high = np.nanmin(places, axis=1), np.nanmax(places, axis=1)
    cut = np.where((share >= 0) & (share <= 1), cut, np.nan)
    low[crossing] = np.fmin(low[crossing], np.fmin.reduce(cut, axis=1))
    high[crossing] = np.fmax(high[crossing], np.fmax.reduce(cut, axis=1))
    return low, high


class Projection(NamedTuple):
    """The inputs of a picture.

    By triangle: normals at its corners (m, 3, 3) and its geom (m,). By geom: colour (k, 3), emission (k,), and whether
    it is part of the static scene (k,). `closeness` is that of `_closeness_over`.
    """

    eye: Eye
    faces: Faces
    normals: Array
    geom: Index
    closeness: Callable[[Array], Floats]
    geoms: list[Any]
    colour: Floats
    emission: Floats
    is_still: Mask


class Raster:
    """A renderer with the interface of `mujoco.Renderer`."""

    def __init__(self, model: mujoco.MjModel, height: int, width: int, max_geom: int) -> None:
        self.scene = mujoco.MjvScene(model, max_geom)
        self._model, self._width, self._height = model, width, height
        self._shape = cache(self._shape_of)
        self._pattern = cache(lambda geom: _pattern_of(model, geom))
        self._tint = cache(lambda material: _texture_tint(model, material))

    def close(self) -> None:
        """Do nothing; there are no resources to release."""

    def render(self) -> Picture:
        """Return the present scene, (height, width, 3)."""
        view = self._view()
        closeness, face = (np.stack(part) for part in zip(*(view.faces.cover(at) for at in SAMPLES), strict=True))
        geom = np.append(view.geom[view.faces.number], -1)[face]
        is_edge = (geom != geom[0]).any(axis=0)
        inner, edge = np.flatnonzero(~is_edge), np.flatnonzero(is_edge)
        pixel = np.concatenate([inner, np.tile(edge, len(SAMPLES))])
        sample = np.repeat([0, *range(len(SAMPLES))], [len(inner)] + len(SAMPLES) * [len(edge)])
        colour = np.empty((len(pixel), 3), np.float32)
        for start in range(0, len(pixel), 10 * IN_CACHE):
            part = slice(start, start + 10 * IN_CACHE)
            which = sample[part], pixel[part]
            x, y = which[1] % self._width + SAMPLES[which[0], 0], which[1] // self._width + SAMPLES[which[0], 1]
            colour[part] = self._colour(view, x, y, face[which], closeness[which])
        image = np.empty((self._height * self._width, 3), np.float32)
        image[inner] = colour[: len(inner)]
        image[edge] = colour[len(inner) :].reshape(len(SAMPLES), len(edge), 3).mean(axis=0)
        return np.rint(image.clip(0, 1) * 255).astype(np.uint8).reshape(self._height, self._width, 3)

    def _view(self) -> Projection:
        geoms = [geom for geom in self.scene.geoms[: self.scene.ngeom] if geom.type in DRAWN and geom.rgba[3] > 0]
        eye, (points, normals, geom) = self._eye(), self._surface(geoms)
        colour = np.array([g.rgba[:3] * self._tint(g.matid) for g in geoms], np.float32).reshape(-1, 3)
        emission = np.array([g.emission for g in geoms], np.float32)
        is_still = np.array([g.category == mujoco.mjtCatBit.mjCAT_STATIC for g in geoms], bool)
        closeness = _closeness_over(points[~is_still[geom]])
        return Projection(eye, Faces(eye, points), normals, geom, closeness, geoms, colour, emission, is_still)

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

    def _surface(self, geoms: list[Any]) -> tuple[Array, Array, Index]:
        """Return all triangles of the scene in the world: corners and normals (m, 3, 3), and index in `geoms` (m,)."""
        parts = [(np.empty((0, 3, 3)), np.empty((0, 3, 3)), np.empty(0, int))]
        for index, geom in enumerate(geoms):
            (points, normals), turn = self._shape(geom.objid), np.asarray(geom.mat, float).T
            parts.append((points @ turn + geom.pos, normals @ turn, np.full(len(points), index)))
        points, normals, owner = (np.concatenate(part) for part in zip(*parts, strict=True))
        return points, normals, owner

    def _light(self, points: Array, normals: Floats) -> Floats:
        """Return the light at points (n, 3) with unit normals (n, 3), without shadows, (n, 3)."""
        out = np.zeros((len(points), 3), np.float32)
        for light in self.scene.lights[: self.scene.nlight]:
            kind, direction = lamp(light), np.array(light.dir, np.float32)
            if kind == "image":
                continue
            towards = -direction[None] if kind == "directional" else (light.pos - points).astype(np.float32)
            towards /= np.linalg.norm(towards, axis=1, keepdims=True) + np.float32(1e-9)
            reached = (normals * towards).sum(axis=1).clip(0)
            if kind == "spot":
                reached *= towards @ -direction > np.cos(np.radians(light.cutoff))
            out += light.ambient + light.diffuse * reached[:, None]
        return out

    def _colour(self, view: Projection, x: Array, y: Array, face: Index, closeness: Array) -> Floats:
        """Return colours at pixels (n, 3), of the visible face, or of the sky where its index is negative."""
        rays = view.eye.rays(x, y)
        length = np.linalg.norm(rays, axis=1)
        rays /= length[:, None]
        met, empty = np.flatnonzero(face >= 0), np.flatnonzero(face < 0)
        out = np.empty((len(face), 3), np.float32)
        out[empty] = SKY
        face, rays, distance = face[met], rays[met], length[met] / closeness[met]
        number = view.faces.number[face]
        points, geom = view.eye.position + rays * distance[:, None], view.geom[number]
        normals = np.einsum("nk,nki->ni", view.faces.weights(face, x[met], y[met]), view.normals[number])
        normals = (normals / (np.linalg.norm(normals, axis=1, keepdims=True) + 1e-9)).astype(np.float32)
        base = view.colour[geom]
        for index in np.unique(geom):
            plane = view.geoms[index]
            if plane.type == PLANE and piece_of(self._model, plane.objid).picture >= 0:
                on = np.flatnonzero(geom == index)
                slope = np.abs(rays[on] @ plane.mat[:, 2]).clip(1e-3)
                patch = distance[on] / view.eye.focus / slope
                local = (points[on] - plane.pos) @ plane.mat
                base[on] = plane.rgba[:3] * _pattern_colour(*self._pattern(plane.objid), local, patch)
        energy = view.emission[geom, None] + self._light(points, normals)
        still = np.flatnonzero(view.is_still[geom])
        base[still] *= 1 - SHADE * view.closeness(points[still])[:, None]
        depth = np.where(view.is_still[geom], np.maximum(distance - HAZE_START, 0), 0)
        clear = np.exp(-depth.astype(np.float32) / np.float32(HAZE_LENGTH))[:, None]
        out[met] = SKY + clear * (np.minimum(base * energy, 1) - SKY)
        return out


def _texture_tint(model: mujoco.MjModel, material: int) -> Array:
    """Return the mean colour of a material's texture, (3,); white without a texture."""
    texture = model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] if material >= 0 else -1
    return texels(model, texture).mean(axis=(0, 1)) / 255 if texture >= 0 else np.ones(3)


def _pattern_of(model: mujoco.MjModel, geom: int) -> tuple[Floats, Floats, Array]:
    """Return the texture of a plane (height, width, 3), its mean colour (3,), and its repetitions per metre (2,)."""
    plane = piece_of(model, geom)
    texture = (texels(model, plane.picture) / 255).astype(np.float32)
    return texture, texture.mean(axis=(0, 1)), picture_repeat(model, plane, half_extent(plane, 1.0))


def _pattern_colour(texture: Floats, mean: Floats, repeat: Array, points: Array, patch: Array) -> Floats:
    """Return the colours (n, 3) of points (n, 3) in a plane's frame. In the distance, its repeated texture fades into
    its mean colour.

    Args:
        patch: The largest extents of pixels on the plane, (n,) [m].
    """
    height, width = texture.shape[:2]
    # off edges of texels, where rounding would decide
    column, row = (((points[:, :2] * repeat + SINGLE) % 1) * [width, height]).astype(int).T
    strength = (1 - FADING * patch * repeat.max()).clip(0, 1).astype(np.float32)[:, None]
    return mean + strength * (texture[row % height, column % width] - mean)


def _closeness_over(figures: Array) -> Callable[[Array], Floats]:
    """Return a function of points (n, 3): how near the lowest surface above them is, 1 at contact and towards 0 in
    height, (n,). It is determined from far below.

    Args:
        figures: The triangles of the figures, (m, 3, 3).
    """
    low, high = (figures.min(axis=(0, 1)), figures.max(axis=(0, 1))) if len(figures) else np.zeros((2, 3))
    away = 1000 * (float((high - low).max()) + 1e-3)  # so far that rays are almost vertical
    size = SHADE_TEXELS
    eye = Eye((low + high) / 2 - [0, 0, away], np.eye(3), 990.0 * size, size, size, near=1e-3)
    lowest, _ = Faces(eye, figures).cover(np.array([0.5, 0.5]))

    def closeness(points: Array) -> Floats:
        x, y, depth = eye.project(points).T
        column, row = (x / depth).astype(int), (y / depth).astype(int)
        inside = (column > 0) & (row > 0) & (column < size) & (row < size)
        closest = np.where(inside, lowest[np.where(inside, row * size + column, 0)], 0.0)
        with np.errstate(divide="ignore"):
            height = 1 / closest - depth
        return np.exp(-np.abs(height) / SHADE_HEIGHT).astype(np.float32)

    return closeness
