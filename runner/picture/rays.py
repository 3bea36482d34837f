"""Pictures without any GL library: rays cast by MuJoCo, shaded here.

Every geom type that MuJoCo's rays can hit is drawn, with the model's colours, headlight, lights and sky: hard shadows,
a little gloss, haze over the floor, smooth edges. A picture is the still part of the scene and any number of figures;
each is cast on its own, only where it can be on the screen, and the nearest wins or, if it is translucent, is blended.

Textures of floors are reduced to four quarters and a border line (MuJoCo's checkers and grids are just that) and are
averaged over the area a pixel covers. Other textures are reduced to their mean colour. Nothing mirrors.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from queue import SimpleQueue

import mujoco
import numpy as np
from numpy.typing import NDArray

from ..scene.mujoco_versions import remove
from ..system.workers import cores
from .camera import View
from .camera import axes as camera_axes
from .caster import VISIBLE_GROUPS, Caster, caster
from .ghost import Ghost
from .shading import Light, Materials, Silhouette, Sky, lights

Picture = NDArray[np.uint8]
Array = NDArray[np.float64]
Floats = NDArray[np.float32]
Ints = NDArray[np.int32]
Bools = NDArray[np.bool_]
Indices = NDArray[np.intp]

SCENE = -1  # in place of a geom's number: what stands still
SKY = -2  # in place of a geom's number: nothing
_HAZE_START, _HAZE_LENGTH = 9.0, 28.0  # [m]
_BAND = 40_000  # rays at a time: few enough for the processor's cache
_JUST_SEEN, _SEEN = 0.05, 0.15  # sums of differences in red, green and blue that deserve smoothing
_LIFT = 2e-4  # how far above a surface its shadow rays start, as a share of the distance
# Places in a pixel at which its edge is sampled: eight queens, so no two share a row or a column.
_SAMPLES = (np.array([[0, 3], [1, 6], [2, 1], [3, 5], [4, 0], [5, 7], [6, 2], [7, 4]]) + 0.5) / 8


@dataclass(frozen=True)
class Eye:
    """Where rays start and how they run through the pixels.

    position  (3,)    [m]
    axes      (3, 3)  rows right, up, forward
    tangent   of half the vertical field of view
    """

    position: Array
    axes: Array
    tangent: float


@dataclass(frozen=True)
class Hits:
    """What n rays met first.

    layer     (n,)    index of the figure, SCENE or SKY
    geom      (n,)    geom, -1 for the sky
    distance  (n,)    [m], infinite for the sky
    normal    (n, 3)  unit, towards the eye
    """

    layer: Ints
    geom: Ints
    distance: Array
    normal: Array

    def part(self, index: Bools | Indices) -> Hits:
        return Hits(self.layer[index], self.geom[index], self.distance[index], self.normal[index])


@dataclass(frozen=True)
class Worlds:
    """What rays are cast into: the scene without figures, and figures without the scene."""

    scene: Caster
    figure: Caster


class Rays:
    """Draws figures in the scene of one model."""

    def __init__(self, spec: mujoco.MjSpec, width: int, height: int, *, threads: int = 0) -> None:
        """width, height in pixels; threads 0 for one a core."""
        model = spec.compile()
        self.model, self.width, self.height = model, width, height
        self.data = mujoco.MjData(model)
        self.pose(model.qpos0)
        dynamic = np.flatnonzero(model.body_weldid[model.geom_bodyid] != 0)
        self.visible = dynamic[VISIBLE_GROUPS[model.geom_group[dynamic]] > 0]
        static = _without_figures(spec, model)
        self.still = np.flatnonzero(model.body_weldid[model.geom_bodyid] == 0).astype(np.int32)
        self._pairs = [Worlds(caster(static), caster(model)) for _ in range(threads or cores())]
        self._free: SimpleQueue[Worlds] = SimpleQueue()
        for pair in self._pairs:
            self._free.put(pair)
        self.materials = Materials(model, self.data)
        self.sky = Sky(model)
        self._flat = np.append(model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE, True)

    def picture(self, figures: Sequence[Ghost], view: View) -> Picture:
        """(height, width, 3) the figures in the scene, as seen from the view."""
        eye = self._eye(figures, view)
        shot = _Shot(self, eye, [figure for figure in figures if figure.opacity > 0])
        height, width = self.height, self.width
        with ThreadPoolExecutor(len(self._pairs)) as pool:
            pixels = np.array_split(np.arange(height * width), max(1, height * width // _BAND))
            bands = list(pool.map(lambda band: self._see(shot, band % width + 0.5, band // width + 0.5), pixels))
            colour = np.concatenate([band[0] for band in bands])
            lit = np.concatenate([band[2] for band in bands])
            hits = _joined([band[1] for band in bands])
            glassy = any(figure.opacity < 1 for figure in figures)
            edge = np.flatnonzero(_edges(hits, lit, colour, glassy, self._flat, width))
            parts = np.array_split(edge, max(1, len(edge) * len(_SAMPLES) // _BAND))
            colour[edge] = np.concatenate(list(pool.map(lambda part: self._smooth(shot, part), parts)))
        return np.rint(np.clip(colour, 0, 1) * 255).astype(np.uint8).reshape(height, width, 3)

    def _see(self, shot: _Shot, x: Array, y: Array) -> tuple[Floats, Hits, Floats]:
        """Cast into a pair of worlds that no other thread uses."""
        worlds = self._free.get()
        try:
            return shot.see(x, y, worlds)
        finally:
            self._free.put(worlds)

    def _smooth(self, shot: _Shot, pixels: Indices) -> Floats:
        """(n, 3) the mean colours of these pixels over the samples in each."""
        down, across = np.divmod(pixels, self.width)
        x, y = across + _SAMPLES[:, :1], down + _SAMPLES[:, 1:]
        colour = self._see(shot, x.ravel(), y.ravel())[0]
        return colour.reshape(len(_SAMPLES), len(pixels), 3).mean(axis=0)

    def _eye(self, figures: Sequence[Ghost], view: View) -> Eye:
        """The view as rays: MuJoCo's free camera, or a camera of the model."""
        if view.fixed is not None:
            camera = self.model.camera(view.fixed).id
            self.pose(figures[0].qpos if figures else self.model.qpos0)
            axes = self.data.cam_xmat[camera].reshape(3, 3).T * [[1], [1], [-1]]
            fovy = self.model.cam_fovy[camera]
            return Eye(self.data.cam_xpos[camera].copy(), axes, float(np.tan(np.radians(fovy) / 2)))
        axes = camera_axes(view.azimuth, view.elevation)
        fovy = self.model.vis.global_.fovy
        return Eye(np.asarray(view.lookat) - view.distance * axes[2], axes, float(np.tan(np.radians(fovy) / 2)))

    def pose(self, qpos: Array) -> None:
        """Let the figure stand there, the cameras and lights that follow it too."""
        self.data.qpos[:] = qpos
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_camlight(self.model, self.data)


class _Shot:
    """One picture being taken: the figures stand, the eye is open."""

    def __init__(self, rays: Rays, eye: Eye, figures: Sequence[Ghost]) -> None:
        self._rays, self._eye, self._figures = rays, eye, figures
        model, data = rays.model, rays.data
        self._masks: list[Bools] = []
        self._spheres: list[Array] = []
        self._silhouettes: list[dict[int, Silhouette]] = []
        for figure in figures:
            rays.pose(figure.qpos)
            centres, radii = data.geom_xpos[rays.visible], model.geom_rbound[rays.visible]
            self._masks.append(self._on_screen(centres, radii))
            self._spheres.append(_around(centres, radii))
            self._silhouettes.append(_silhouettes(centres, radii, lights(model, data)))
        rays.pose(figures[0].qpos if figures else model.qpos0)
        self._lights = lights(model, data)
        self._tables = [rays.materials.tinted(figure.shade) for figure in figures]

    def see(self, x: Array, y: Array, worlds: Worlds) -> tuple[Floats, Hits, Floats]:
        """(n, 3) colours, the hits of what is solid, and (n,) how much of the light reaches them.

        x, y  (n,) pixels from the left and from the top
        """
        directions, footprint = self._directions(x, y)
        solid = self._cast_scene(directions, worlds)
        sheets: list[tuple[Indices, Hits]] = []
        for index, figure in enumerate(self._figures):
            where, hits = self._cast_figure(index, directions, x, y, worlds)
            if figure.opacity == 1.0:
                nearer = hits.distance < solid.distance[where]
                _overwrite(solid, where[nearer], hits.part(nearer))
            else:
                sheets.append((where, hits))
        colour, lit = self._shade(solid, directions, footprint, worlds)
        self._blend(colour, solid, sheets, directions, footprint, worlds)
        return colour, solid, lit

    def _directions(self, x: Array, y: Array) -> tuple[Array, float]:
        """(n, 3) unit directions through the pixels, and how far pixels are apart at one metre."""
        step = 2 * self._eye.tangent / self._rays.height
        across = (x - self._rays.width / 2) * step
        down = (y - self._rays.height / 2) * step
        rays = np.empty((len(x), 3))
        rays[:, 2] = 1 / np.sqrt(1 + across**2 + down**2)
        rays[:, 0], rays[:, 1] = across * rays[:, 2], -down * rays[:, 2]
        return rays @ self._eye.axes, step

    def _cast_scene(self, directions: Array, worlds: Worlds) -> Hits:
        found = worlds.scene.cast(self._eye.position, directions, static=True)
        met = np.append(self._rays.still, np.int32(-1))[found.geom]
        return _hits(SCENE, found.distance, met, found.normal, directions)

    def _cast_figure(self, index: int, directions: Array, x: Array, y: Array, worlds: Worlds) -> tuple[Indices, Hits]:
        """The rays that meet a figure, and what they meet."""
        where = np.flatnonzero(self._masks[index][y.astype(np.int32), x.astype(np.int32)])
        rays = directions[where]
        worlds.figure.pose(self._figures[index].qpos)
        distance, geom, normal = worlds.figure.cast(self._eye.position, rays, static=False)
        met = np.flatnonzero(geom >= 0)
        return where[met], _hits(index, distance[met], geom[met], normal[met], rays[met])

    def _blend(
        self,
        colour: Floats,
        solid: Hits,
        sheets: list[tuple[Indices, Hits]],
        directions: Array,
        footprint: float,
        worlds: Worlds,
    ) -> None:
        """Lay the translucent figures over the solid picture, the farther ones first, pixel by pixel."""
        if not sheets:
            return
        count = len(solid.layer)
        depth = np.full((len(sheets), count), np.inf)
        tint = np.zeros((len(sheets), count, 3), np.float32)
        opacity = np.zeros((len(sheets), count), np.float32)
        for row, (where, hits) in enumerate(sheets):
            seen = hits.distance < solid.distance[where]
            where, hits = where[seen], hits.part(seen)
            if len(where):
                depth[row, where] = hits.distance
                tint[row, where] = self._shade(hits, directions[where], footprint, worlds)[0]
                opacity[row, where] = self._figures[int(hits.layer[0])].opacity
        touched = np.flatnonzero(opacity.any(axis=0))
        for rank in np.argsort(-depth[:, touched], axis=0):
            alpha = opacity[rank, touched][:, None]
            colour[touched] += alpha * (tint[rank, touched] - colour[touched])

    def _shade(self, hits: Hits, directions: Array, footprint: float, worlds: Worlds) -> tuple[Floats, Floats]:
        """(n, 3) colours of what the rays met, and (n,) how much of the lights' light reaches them."""
        colour = np.empty((len(hits.layer), 3), np.float32)
        lit = np.ones(len(hits.layer), np.float32)
        empty = hits.layer == SKY
        colour[empty] = self._rays.sky.colour(directions[empty])
        ground = np.flatnonzero(~empty)
        if not len(ground):
            return colour, lit
        met, rays = hits.part(ground), directions[ground]
        point = self._eye.position + rays * met.distance[:, None]
        base = self._base(met, rays, point, footprint)
        normal, ray = met.normal.astype(np.float32), rays.astype(np.float32)
        headlight = self._rays.model.vis.headlight
        # Light from the sky is a little stronger on what looks up. The headlight shines along the camera's axis.
        sky = 0.95 + 0.05 * normal[:, 2:]
        ahead = np.maximum(normal @ -self._eye.axes[2].astype(np.float32), 0)[:, None]
        energy = (headlight.ambient * sky + headlight.diffuse * ahead) * np.float32(bool(headlight.active))
        gloss = np.zeros_like(base)
        gleam, sharpness = self._rays.materials.gloss(met.geom)
        for number, light in enumerate(self._lights):
            towards = light.towards(point).astype(np.float32)
            slope = np.maximum(np.einsum("ij,ij->i", normal, towards), 0)
            reached = self._reached(number, met, point, slope, worlds)
            lit[ground] *= reached
            energy += light.ambient + light.diffuse * (slope * reached)[:, None]
            if light.specular.any():
                shine = _shine(normal, towards - ray, sharpness) * gleam * reached * (slope > 0)
                gloss += light.specular * shine[:, None]
        full = np.minimum(base * energy + gloss, 1)
        far = np.where(met.layer == SCENE, np.maximum(met.distance - _HAZE_START, 0), 0)
        clear = np.exp(-far / _HAZE_LENGTH).astype(np.float32)[:, None]
        haze = self._rays.sky.haze
        colour[ground] = haze + clear * (full - haze)
        return colour, lit

    def _base(self, met: Hits, rays: Array, point: Array, footprint: float) -> Floats:
        """(n, 3) the surface's own colours: from the tables, and the floors' patterns."""
        base = self._rays.materials.colours[met.geom]
        for index, table in enumerate(self._tables):
            own = met.layer == index
            base[own] = table[met.geom[own]]
        for pattern in self._rays.materials.patterns:
            on = np.flatnonzero((met.layer == SCENE) & (met.geom == pattern.geom))
            if len(on):
                base[on] *= pattern.colour(point[on], rays[on], met.distance[on] * footprint)
        return base

    def _reached(self, number: int, met: Hits, point: Array, slope: Floats, worlds: Worlds) -> Floats:
        """(n,) 1 where the light arrives, 0 in shadow, between the two in a translucent figure's shadow."""
        light = self._lights[number]
        reached = light.strength(point)
        if not light.casts_shadow:
            return reached
        start = point + met.normal * (_LIFT * met.distance)[:, None]
        lit = np.flatnonzero(slope > 0)
        near = np.zeros(len(lit), bool)
        for sphere in self._rays.materials.obstacles:
            near |= light.passes(start[lit], sphere[:3], sphere[3])
        self._darken(reached, light, start, lit[near], worlds.scene, True, 1.0)
        for figure, sphere, outlines in zip(self._figures, self._spheres, self._silhouettes, strict=True):
            near = light.passes(start[lit], sphere[:3], sphere[3])
            if number in outlines:
                near[near] = outlines[number].covers(start[lit[near]])
            worlds.figure.pose(figure.qpos)
            self._darken(reached, light, start, lit[near], worlds.figure, False, figure.opacity)
        return reached

    def _darken(
        self,
        reached: Floats,
        light: Light,
        start: Array,
        rays: Indices,
        world: Caster,
        static: bool,
        opacity: float,
    ) -> None:
        """Take the light from those of the points, numbered by `rays`, that have something in the way to it."""
        rays = rays[reached[rays] > 0]
        if not len(rays):
            return
        towards = light.towards(start[rays])
        blocked = world.blocked(start[rays], towards, light.range_from(start[rays]), static=static)
        reached[rays[blocked]] *= np.float32(1 - opacity)

    def _on_screen(self, centres: Array, radii: Array) -> Bools:
        """(H, W) the pixels that these spheres can touch, and some more."""
        height, width = self._rays.height, self._rays.width
        right, up, forward = self._eye.axes @ (centres - self._eye.position).T
        near, far = forward - radii, forward + radii
        if (near < 0.05).any():
            return np.ones((height, width), bool)
        scale = height / 2 / self._eye.tangent

        def extreme(offset: Array, sign: int) -> Array:
            edge = sign * offset + radii
            return sign * scale * np.maximum(edge / near, edge / far)

        left, last = (width / 2 + extreme(right, sign) for sign in (-1, 1))
        bottom, top = (height / 2 - extreme(up, sign) for sign in (-1, 1))
        mask = np.zeros((height, width), bool)
        corners = np.stack([np.floor(left), np.ceil(last), np.floor(top), np.ceil(bottom)], axis=1)
        for x0, x1, y0, y1 in np.maximum(corners, 0).astype(int):
            mask[y0:y1, x0:x1] = True
        return mask


def _silhouettes(centres: Array, radii: Array, lamps: Sequence[Light]) -> dict[int, Silhouette]:
    """By number of the light, for those that shine in parallel and cast shadows."""
    return {
        number: Silhouette.of(centres, radii, lamp.direction)
        for number, lamp in enumerate(lamps)
        if lamp.directional and lamp.casts_shadow and len(radii)
    }


def _shine(normal: Floats, halfway: Floats, sharpness: Floats) -> Floats:
    """(n,) Blinn's gloss; halfway (n, 3) points between the light and the eye, of any length."""
    length = np.sqrt(np.einsum("ij,ij->i", halfway, halfway)) + np.float32(1e-9)
    return (np.maximum(np.einsum("ij,ij->i", normal, halfway), 0) / length) ** sharpness


def _joined(parts: Sequence[Hits]) -> Hits:
    return Hits(
        np.concatenate([part.layer for part in parts]),
        np.concatenate([part.geom for part in parts]),
        np.concatenate([part.distance for part in parts]),
        np.concatenate([part.normal for part in parts]),
    )


def _without_figures(spec: mujoco.MjSpec, model: mujoco.MjModel) -> mujoco.MjModel:
    """The model with nothing in it that moves, so that rays do not have to pass by it."""
    scene = spec.copy()
    for key in list(scene.keys):
        remove(scene, key)
    moving = np.flatnonzero((model.body_weldid != 0) & (model.body_weldid[model.body_parentid] == 0))
    bodies = list(scene.bodies)
    for body in moving:
        remove(scene, bodies[body])
    return scene.compile()


def _around(centres: Array, radii: Array) -> Array:
    """(4,) centre and radius of a sphere round spheres."""
    if not len(radii):
        return np.zeros(4)
    centre = (centres.min(axis=0) + centres.max(axis=0)) / 2
    return np.array([*centre, (np.linalg.norm(centres - centre, axis=1) + radii).max()])


def _hits(layer: int, distance: Array, geom: Ints, normal: Array, directions: Array) -> Hits:
    """What a cast returned, the normals turned towards the eye."""
    missed = geom < 0
    away = np.einsum("ij,ij->i", normal, directions) > 0
    return Hits(
        layer=np.where(missed, SKY, layer).astype(np.int32),
        geom=np.array(geom, np.int32),
        distance=np.where(missed, np.inf, distance),
        normal=np.where(away[:, None], -normal, normal),
    )


def _overwrite(hits: Hits, where: Indices, nearer: Hits) -> None:
    hits.layer[where], hits.geom[where] = nearer.layer, nearer.geom
    hits.distance[where], hits.normal[where] = nearer.distance, nearer.normal


def _edges(hits: Hits, lit: Floats, colour: Floats, glassy: bool, flat: Bools, width: int) -> Bools:
    """(n,) pixels that can be seen to lie beside another thing, another side of a thing, or the rim of a shadow.

    lit     (n,)         how much light arrives
    colour  (n, 3)
    glassy  whether there is something translucent, which only the colours tell
    flat    (ngeom + 1)  geoms without creases
    """
    key = (hits.layer + 2) * len(flat) + hits.geom + 1
    edge = np.zeros(len(key), bool)
    column = np.arange(len(key)) % width
    creased = np.flatnonzero(~flat[hits.geom])
    for step, inside in ((1, column < width - 1), (width, np.arange(len(key)) < len(key) - width)):
        differs = np.zeros(len(key), bool)
        differs[:-step] = (key[:-step] != key[step:]) | (lit[:-step] != lit[step:])
        start = creased[inside[creased]]
        differs[start] |= np.einsum("ij,ij->i", hits.normal[start], hits.normal[start + step]) < 0.8
        differs &= inside
        near = np.flatnonzero(inside if glassy else differs)
        contrast = np.abs(colour[near] - colour[near + step]).sum(axis=1)
        marked = near[contrast > np.where(differs[near], _JUST_SEEN, _SEEN)]
        edge[marked] = edge[marked + step] = True
    return edge
