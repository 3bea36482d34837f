"""Software rendering of a MuJoCo scene: triangles in a depth buffer, four samples per pixel, and shadow maps.

The lighting is that of MuJoCo's renderer without highlights: ambient, diffuse (Lambert), and haze in the distance.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from ..scene.mujoco_versions import Lamp, drawn_lamp
from ..scene.triangles import MESHES, Triangles, joined, piece_of, triangles
from .depth_buffer import Eye, Faces
from .lights import Light
from .shading import Pattern, Sky, texture_tint

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


class Surface(NamedTuple):
    """Triangles of a scene.

    Attributes:
        points: The corners, (m, 3, 3).
        normals: The normals at the corners, (m, 3, 3).
        patch: The smooth patch of each, (m,).
        geom: The index of each in a list of geoms, (m,).
    """

    points: Array
    normals: Array
    patch: Ints
    geom: Ints


class Hits(NamedTuple):
    """Surface points (n, 3) in a picture, unit normals, unit rays from the eye, distances, and indices of geoms."""

    points: Array
    normals: Floats
    rays: Floats
    distance: Array
    geom: Ints


class Materials(NamedTuple):
    """Materials by geom: colour (k, 3), emission (k,) ...; for textured planes index, position, frame, tint, pattern"""

    colour: Floats
    emission: Floats
    is_still: NDArray[np.bool_]
    patterns: list[tuple[int, Array, Array, Floats, Pattern]]


class View(NamedTuple):
    """The inputs of a picture."""

    eye: Eye
    surface: Surface
    faces: Faces
    materials: Materials
    lights: list[Light]


class Raster:
    """A renderer with the interface of `mujoco.Renderer`."""

    def __init__(self, model: mujoco.MjModel, height: int, width: int, max_geom: int) -> None:
        self.scene = mujoco.MjvScene(model, max_geom)
        self._model, self._width, self._height = model, width, height
        self._sky = Sky(model)
        self._shape = cache(self._shape_of)
        self._pattern = cache(lambda geom: Pattern.of(model, piece_of(model, geom)))
        self._tint = cache(lambda material: texture_tint(model, material))

    def close(self) -> None:
        """Do nothing; there are no resources to release."""

    def render(self) -> Picture:
        """Return the present scene, (height, width, 3)."""
        geoms = [geom for geom in self.scene.geoms[: self.scene.ngeom] if geom.type in DRAWN and geom.rgba[3] > 0]
        eye, surface = self._eye(), self._surface(geoms)
        faces = Faces(eye, surface.points)
        closeness, face = (np.stack(part) for part in zip(*(faces.cover(at) for at in SAMPLES), strict=True))
        patch = np.append(surface.patch[faces.number], -1)[face]
        is_edge = (patch != patch[0]).any(axis=0)
        inner, edge = np.flatnonzero(~is_edge), np.flatnonzero(is_edge)
        pixel = np.concatenate([inner, np.tile(edge, len(SAMPLES))])
        sample = np.repeat([0, *range(len(SAMPLES))], [len(inner)] + len(SAMPLES) * [len(edge)])
        view = View(eye, surface, faces, self._materials(geoms), self._lights(eye, surface, geoms))
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
        normals = np.einsum("nk,nki->ni", view.faces.weights(face, x[met], y[met]), view.surface.normals[number])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-9
        points = view.eye.position + rays * distance[:, None]
        hits = Hits(points, normals.astype(np.float32), rays.astype(np.float32), distance, view.surface.geom[number])
        out[met] = self._shade(hits, view)
        return out

    def _eye(self) -> Eye:
        """Return the camera of the scene, midway between its two stereo cameras."""
        left_eye, right = self.scene.camera
        forward, up = np.array(left_eye.forward, float), np.array(left_eye.up, float)
        focus = self._height * left_eye.frustum_near / (left_eye.frustum_top - left_eye.frustum_bottom)
        position = (np.array(left_eye.pos, float) + right.pos) / 2
        axes = np.stack([np.cross(forward, up), -up, forward])
        return Eye(position, axes, focus, self._width, self._height, float(left_eye.frustum_near))

    def _shape_of(self, geom: int) -> Surface:
        """Return a geom of the model in its frame."""
        shape = triangles(self._model, piece_of(self._model, geom), FAR)
        if self._model.geom_type[geom] == _KINDS.mjGEOM_HFIELD:
            field = self._model.geom_dataid[geom]
            depth = float(self._model.hfield_size[field][3])
            shape = joined([shape, _sides(shape.points.reshape(-1, int(self._model.hfield_ncol[field]), 3), depth)])
        faces, count = shape.faces.astype(int), len(shape.points)
        ends = faces[:, [0, 0]].ravel(), faces[:, 1:].ravel()
        patches = connected_components(coo_array((np.ones(len(ends[0])), ends), (count, count)), directed=False)[1]
        geoms = np.zeros(len(faces), int)
        return Surface(shape.points[faces], shape.normals[faces], patches[faces[:, 0]].astype(int), geoms)

    def _surface(self, geoms: list[Any]) -> Surface:
        """Return all triangles of the scene, in the world."""
        parts, patches = [Surface(*(np.empty((0, 3, 3)),) * 2, *(np.empty(0, int),) * 2)], 0
        for index, geom in enumerate(geoms):
            shape, turn = self._shape(geom.objid), np.asarray(geom.mat, float).T
            points = shape.points @ turn + geom.pos
            parts.append(Surface(points, shape.normals @ turn, shape.patch + patches, shape.geom + index))
            patches += len(shape.patch)
        return Surface(*(np.concatenate(part) for part in zip(*parts, strict=True)))

    def _lights(self, eye: Eye, surface: Surface, geoms: list[Any]) -> list[Light]:
        """Return the active lights, with shadows of objects near the figures."""
        moves = np.array([geom.category == mujoco.mjtCatBit.mjCAT_DYNAMIC for geom in geoms], bool)
        solid = np.array([geom.type != PLANE for geom in geoms], bool)[surface.geom]
        figures = surface.points[moves[surface.geom]].reshape(-1, 3)
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
            if drawn_lamp(light) is not Lamp.IMAGE
        ]

    def _materials(self, geoms: list[Any]) -> Materials:
        emission = np.array([g.emission for g in geoms], np.float32)
        colour = np.array([g.rgba[:3] * self._tint(g.matid) for g in geoms], np.float32).reshape(-1, 3)
        is_still = np.array([g.category == mujoco.mjtCatBit.mjCAT_STATIC for g in geoms], bool)
        patterns = [
            (i, g.pos, g.mat, g.rgba[:3], self._pattern(g.objid))
            for i, g in enumerate(geoms)
            if g.type == PLANE and piece_of(self._model, g.objid).picture >= 0
        ]
        return Materials(colour, emission, is_still, patterns)

    def _shade(self, hits: Hits, view: View) -> Floats:
        looks = view.materials
        base = looks.colour[hits.geom]
        for index, origin, frame, tint, pattern in looks.patterns:
            on = np.flatnonzero(hits.geom == index)
            local, rays = (hits.points[on] - origin) @ frame, hits.rays[on] @ frame
            base[on] = tint * pattern.colour(local, rays, hits.distance[on] / view.eye.focus)
        energy = np.repeat(looks.emission[hits.geom, None], 3, axis=1)
        for light in view.lights:
            energy += light.ambient + light.diffuse * light.shine(hits.points, hits.normals)[:, None]
        full = np.minimum(base * energy, 1)
        depth = np.where(looks.is_still[hits.geom], np.maximum(hits.distance - HAZE_START, 0), 0)
        clear = np.exp(-depth.astype(np.float32) / np.float32(HAZE_LENGTH))[:, None]
        return self._sky.haze + clear * (full - self._sky.haze)


def _sides(grid: Array, depth: float) -> Triangles:
    """Return the sides of a height field with points (rows, columns, 3), down to a depth [m] below its zero."""
    rim = np.concatenate([grid[0], grid[1:, -1], grid[-1, -2::-1], grid[-2:0:-1, 0]])  # counterclockwise from above
    after, down = np.roll(rim, -1, axis=0), [1.0, 1.0, 0.0]
    low, low_after = rim * down - [0, 0, depth], after * down - [0, 0, depth]
    normals = np.cross(after * down - rim * down, [0.0, 0, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    faces = 4 * np.arange(len(rim))[:, None, None] + [[0, 1, 2], [0, 2, 3]]
    points = np.stack([low, low_after, after, rim], axis=1).reshape(-1, 3)
    return Triangles(points, np.repeat(normals, 4, axis=0), faces.reshape(-1, 3).astype(np.uint32))
