"""What the rays' pictures are made of: a model's surfaces, lights and sky as numbers.

Light adds up as in MuJoCo's own renderer: ambient, diffuse by Lambert, gloss by Blinn. Colours are 0..1, float32.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from ..scene.mujoco_versions import Lamp, lamp

Array = NDArray[np.float64]
Floats = NDArray[np.float32]
Bools = NDArray[np.bool_]

_RGB = int(mujoco.mjtTextureRole.mjTEXROLE_RGB)
_PLAIN_GLOSS = (0.5, 0.5)  # specular and shininess of a geom without material, as MuJoCo draws it
_SHARPEST = 128  # exponent at shininess 1, as in OpenGL
_DAYLIGHT = np.array([[0.62, 0.72, 0.86], [0.9, 0.93, 0.97]], np.float32)  # zenith, horizon


@dataclass(frozen=True)
class Pattern:
    """The texture of a plane: four quarters and a border line, repeated.

    geom      the plane
    origin    (3,)       its centre [m]
    axes      (3, 3)     rows: its x, y and normal in the world
    repeat    (2,)       textures a metre
    quarters  (2, 2, 3)  colours by half in x, half in y
    line      (3,)       colour of the border
    border    its width, as a share of the texture
    """

    geom: int
    origin: Array
    axes: Array
    repeat: Array
    quarters: Floats
    line: Floats
    border: float

    def colour(self, point: Array, rays: Array, spacing: Array) -> Floats:
        """(n, 3) mean colours of the patches that the pixels cover.

        point    (n, 3)  where the rays meet the plane [m]
        rays     (n, 3)  their unit directions
        spacing  (n,)    how far neighbouring rays are apart there, across themselves [m]
        """
        across, along, normal = self.axes @ rays.T
        flat = np.sqrt(across**2 + along**2) + 1e-9
        stretch = flat / np.maximum(np.abs(normal), 1e-4)  # a patch is long in the direction of a flat ray
        u, v = self.axes[:2] @ (point - self.origin).T * self.repeat[:, None]
        width_u = self.repeat[0] * spacing * (np.abs(along) / flat + np.abs(across) / flat * stretch) + 1e-6
        width_v = self.repeat[1] * spacing * (np.abs(across) / flat + np.abs(along) / flat * stretch) + 1e-6
        half_u, half_v = _share(u, width_u, 0.5, 0.5), _share(v, width_v, 0.5, 0.5)
        low = self.quarters[0, 0] + (self.quarters[0, 1] - self.quarters[0, 0]) * half_v[:, None]
        high = self.quarters[1, 0] + (self.quarters[1, 1] - self.quarters[1, 0]) * half_v[:, None]
        colour = low + (high - low) * half_u[:, None]
        if self.border > 0:
            on_u = _share(u, width_u, -self.border, 2 * self.border)
            on_v = _share(v, width_v, -self.border, 2 * self.border)
            colour += (self.line - colour) * (on_u + on_v - on_u * on_v)[:, None]
        return colour


def _share(position: Array, width: Array, start: float, length: float) -> Floats:
    """(n,) which share of an interval of this width lies in [start, start + length], repeated with period 1."""

    def covered(end: Array) -> Array:
        whole = np.floor(end)
        return whole * length + np.minimum(end - whole, length)

    low = position - start - width / 2
    return ((covered(low + width) - covered(low)) / width).astype(np.float32)


class Materials:
    """Colours and gloss of every geom, and the spheres round what stands still and casts shadows.

    colours    (ngeom + 1, 3)  the last row is for a ray that met nothing
    obstacles  (k, 4)          centre and radius [m] of the still geoms that are not planes
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """data has seen mj_kinematics."""
        owner, count = model.geom_matid, model.ngeom
        self.colours = np.zeros((count + 1, 3), np.float32)
        self._specular = np.full(count + 1, _PLAIN_GLOSS[0], np.float32)
        self._exponent = np.full(count + 1, _PLAIN_GLOSS[1] * _SHARPEST, np.float32)
        self.patterns: list[Pattern] = []
        for geom in range(count):
            material = int(owner[geom])
            self.colours[geom] = model.geom_rgba[geom, :3]
            if material >= 0:
                self.colours[geom] = model.mat_rgba[material, :3]
                self._specular[geom] = model.mat_specular[material]
                self._exponent[geom] = max(1.0, model.mat_shininess[material] * _SHARPEST)
                self._texture(model, data, geom, material)
        still = [g for g in range(count) if _stands_still(model, g) and model.geom_rbound[g] > 0]
        self.obstacles = np.column_stack([data.geom_xpos[still], model.geom_rbound[still]]).reshape(-1, 4)

    def _texture(self, model: mujoco.MjModel, data: mujoco.MjData, geom: int, material: int) -> None:
        texture = int(model.mat_texid[material, _RGB])
        if texture < 0:
            return
        texels = _texels(model, texture)
        flat = model.tex_type[texture] == mujoco.mjtTexture.mjTEXTURE_2D
        if flat and model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE and _stands_still(model, geom):
            self.patterns.append(_pattern(model, data, geom, material, texels))
        else:
            self.colours[geom] *= texels.mean(axis=(0, 1))

    def tinted(self, shade: float) -> Floats:
        """(ngeom + 1, 3) the colours, blended towards white."""
        return (self.colours + shade * (1 - self.colours)).astype(np.float32)

    def gloss(self, geom: NDArray[np.int32]) -> tuple[Floats, Floats]:
        """(n,) strength and (n,) sharpness of the shine."""
        return self._specular[geom], self._exponent[geom]


def _stands_still(model: mujoco.MjModel, geom: int) -> bool:
    return bool(model.body_weldid[model.geom_bodyid[geom]] == 0)


def _texels(model: mujoco.MjModel, texture: int) -> Floats:
    """(h, w, 3) a texture's colours."""
    height, width = int(model.tex_height[texture]), int(model.tex_width[texture])
    channels, start = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
    texels = model.tex_data[start : start + height * width * channels].reshape(height, width, channels)
    colours = texels[..., :3] if channels >= 3 else np.repeat(texels[..., :1], 3, axis=2)
    return (colours / 255).astype(np.float32)


def _pattern(model: mujoco.MjModel, data: mujoco.MjData, geom: int, material: int, texels: Floats) -> Pattern:
    """A plane's texture as four quarters and a line."""
    height, width = texels.shape[:2]
    inner = texels[2:-2, 2:-2] if min(height, width) > 8 else texels
    rows, columns = np.array_split(np.arange(inner.shape[0]), 2), np.array_split(np.arange(inner.shape[1]), 2)
    quarters = np.array([[inner[np.ix_(y, x)].mean(axis=(0, 1)) for y in rows] for x in columns], np.float32)
    line = texels[0].mean(axis=0)
    plain = min(height, width) <= 8 or np.allclose(line, quarters.mean(axis=(0, 1)), atol=0.02)
    repeat = model.mat_texrepeat[material] / 2.0  # MuJoCo's unit of a texture is two metres
    size = model.geom_size[geom, :2]
    if not model.mat_texuniform[material]:
        repeat = np.where(size > 0, repeat / np.maximum(size, 1e-9), repeat)
    return Pattern(
        geom=geom,
        origin=data.geom_xpos[geom].copy(),
        axes=data.geom_xmat[geom].reshape(3, 3).T.copy(),
        repeat=repeat,
        quarters=quarters,
        line=line,
        border=0.0 if plain else 1 / width,
    )


@dataclass(frozen=True)
class Light:
    """One lamp of the model.

    position   (3,)  [m]; meaningless if directional
    direction  (3,)  unit, the way the light goes
    cutoff     half angle of a spot's cone [radians], pi for a lamp that shines all round
    ambient, diffuse, specular  (3,)
    """

    directional: bool
    casts_shadow: bool
    position: Array
    direction: Array
    cutoff: float
    ambient: Floats
    diffuse: Floats
    specular: Floats

    def towards(self, point: Array) -> Array:
        """(n, 3) unit, from the points to the light."""
        if self.directional:
            return np.broadcast_to(-self.direction, point.shape)
        away = self.position - point
        return away / (np.linalg.norm(away, axis=1, keepdims=True) + 1e-12)

    def range_from(self, point: Array) -> Array:
        """(n,) how far the light is [m]: what is farther cannot block it."""
        if self.directional:
            return np.full(len(point), np.inf)
        return np.linalg.norm(self.position - point, axis=1)

    def strength(self, point: Array) -> Floats:
        """(n,) 1 inside the cone, 0 outside, with a soft rim."""
        if self.directional or self.cutoff >= np.pi:
            return np.ones(len(point), np.float32)
        cosine = self.towards(point) @ -self.direction
        return np.clip((cosine - np.cos(self.cutoff)) / 0.02, 0, 1).astype(np.float32)

    def passes(self, point: Array, centre: Array, radius: float) -> Bools:
        """(n,) whether the way from the points to the light can meet a sphere."""
        offset = centre - point
        towards = self.towards(point)
        along = np.einsum("ij,ij->i", offset, towards)
        aside = np.einsum("ij,ij->i", offset, offset) - along**2
        return (aside < radius**2) & (along > -radius)


@dataclass(frozen=True)
class Silhouette:
    """Where spheres are when one looks along a direction: a mask that is never too small.

    origin  (3,)    its corner [m]
    axes    (2, 3)  its sides, one unit long per cell
    mask    (k, k)
    """

    origin: Array
    axes: Array
    mask: Bools

    @classmethod
    def of(cls, centres: Array, radii: Array, direction: Array, cells: int = 192) -> Silhouette:
        """centres (n, 3), radii (n,) [m], direction (3,) unit."""
        side = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
        axes = np.stack([side, np.cross(direction, side)]) / np.linalg.norm(side)
        flat = centres @ axes.T
        low, high = (flat - radii[:, None]).min(axis=0), (flat + radii[:, None]).max(axis=0)
        cell = (high - low).max() / cells + 1e-9
        mask = np.zeros((cells, cells), bool)
        first = np.floor((flat - radii[:, None] - low) / cell).astype(int)
        last = np.ceil((flat + radii[:, None] - low) / cell).astype(int)
        for (u0, v0), (u1, v1) in zip(first, last, strict=True):
            mask[u0:u1, v0:v1] = True
        return cls(low @ axes, axes / cell, mask)

    def covers(self, point: Array) -> Bools:
        """(n,) which points lie in the mask."""
        u, v = np.floor((point - self.origin) @ self.axes.T).astype(np.int32).T
        inside = np.flatnonzero((u >= 0) & (v >= 0) & (u < len(self.mask)) & (v < len(self.mask)))
        covered = np.zeros(len(point), bool)
        covered[inside] = self.mask[u[inside], v[inside]]
        return covered


def lights(model: mujoco.MjModel, data: mujoco.MjData) -> list[Light]:
    """The lamps that are on. data has seen mj_camlight."""
    return [
        Light(
            directional=lamp(model, k) is Lamp.DIRECTIONAL,
            casts_shadow=bool(model.light_castshadow[k]),
            position=data.light_xpos[k].copy(),
            direction=data.light_xdir[k] / np.linalg.norm(data.light_xdir[k]),
            cutoff=float(np.radians(model.light_cutoff[k])) if lamp(model, k) is Lamp.SPOT else np.pi,
            ambient=model.light_ambient[k].copy(),
            diffuse=model.light_diffuse[k].copy(),
            specular=model.light_specular[k].copy(),
        )
        for k in range(model.nlight)
        if model.light_active[k] and lamp(model, k) is not Lamp.IMAGE
    ]


class Sky:
    """The colour above the horizon, from the model's skybox, or daylight without one.

    haze  (3,)  the colour into which the distance fades
    """

    def __init__(self, model: mujoco.MjModel) -> None:
        self.haze = model.vis.rgba.haze[:3].astype(np.float32)
        boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX)
        if not len(boxes):
            zenith, horizon = _DAYLIGHT
            self.haze = horizon.copy()
            self._profile = horizon + (zenith - horizon) * np.linspace(1, -1, 64, dtype=np.float32).clip(0)[:, None]
            return
        texels = _texels(model, int(boxes[0]))
        size = texels.shape[1]
        faces = texels.reshape(-1, size, size, 3)
        self._profile = faces[4 if len(faces) == 6 else 0].mean(axis=1)  # a side of the box, from top to bottom

    def colour(self, directions: Array) -> Floats:
        """(n, 3) by how steeply the unit directions rise; hazy at the horizon."""
        rise = directions[:, 2].astype(np.float32)
        steep = np.clip(rise / np.sqrt(np.maximum(1 - rise**2, 1e-6)), -1, 1)
        row = ((1 - steep) / 2 * (len(self._profile) - 1)).astype(np.int32)
        haze = np.exp(-np.maximum(rise, 0) / 0.05)[:, None]
        sky = self._profile[row]
        return sky + haze * (self.haze - sky)
