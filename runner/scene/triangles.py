"""Visible geoms of a model, their appearance, and their triangles.

Geoms that MuJoCo's viewer hides by default are excluded: those of group 3 and above, and fully transparent ones.
"""

from __future__ import annotations

import io
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from dynsplines.solver.array import Array

from ..errors import UserError

HIDDEN_GROUP = 3  # first group that MuJoCo's viewer hides
SAG = 0.0008  # [m] maximum deviation of triangles from a round surface, which determines their number
MESHES = (mujoco.mjtGeom.mjGEOM_MESH, mujoco.mjtGeom.mjGEOM_SDF)
PLAIN = np.float32(0.5)  # MuJoCo's default grey; geoms of this colour have that of their material


@dataclass(frozen=True)
class MeshPiece:
    """A visible geom.

    Attributes:
        size: MuJoCo's size, (3,).
        position: The position in its body's frame, (3,) [m].
        rotation: The orientation in its body's frame, (4,) wxyz.
        colour: sRGB and opacity, (4,).
        gloss: From 0 to 1.
        picture: MuJoCo's id of a plane's texture, -1 for none.
    """

    name: str
    geom: int
    body: int
    kind: mujoco.mjtGeom
    size: Array
    position: Array
    rotation: Array
    colour: Array
    gloss: float
    picture: int


@dataclass(frozen=True)
class Triangles:
    """A triangle mesh in the geom's frame.

    Attributes:
        points: (n, 3) [m].
        normals: Unit normals, (n, 3).
        faces: Indices of points, counterclockwise from outside, (m, 3).
        texture: Texture coordinates from the image's upper left corner, (n, 2); None without a texture.
    """

    points: Array
    normals: Array
    faces: NDArray[np.uint32]
    texture: Array | None = None


def pieces(model: mujoco.MjModel) -> list[MeshPiece]:
    """Return every visible geom, in the model's order."""
    shown = [g for g in range(model.ngeom) if model.geom_group[g] < HIDDEN_GROUP]
    all_pieces = [piece_of(model, geom) for geom in shown]
    return [piece for piece in all_pieces if piece.colour[3] > 0]


def is_still(model: mujoco.MjModel, piece: MeshPiece) -> bool:
    """Return whether a piece belongs to the static scene, not to a figure."""
    return bool(model.body_weldid[piece.body] == 0)


def piece_of(model: mujoco.MjModel, geom: int) -> MeshPiece:
    """Return a geom, visible or not."""
    material = int(model.geom_matid[geom])
    colour = np.array(model.geom_rgba[geom], float)
    kind = mujoco.mjtGeom(model.geom_type[geom])
    gloss, picture = 0.25, -1
    if material >= 0:
        if np.all(model.geom_rgba[geom] == [PLAIN, PLAIN, PLAIN, 1]):
            colour = np.array(model.mat_rgba[material], float)
        gloss = float(model.mat_shininess[material])
        texture = int(model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)])
        if texture >= 0:
            flat = model.tex_type[texture] == mujoco.mjtTexture.mjTEXTURE_2D
            if flat and kind == mujoco.mjtGeom.mjGEOM_PLANE:
                picture = texture
            else:
                colour[:3] *= texels(model, texture).mean(axis=(0, 1)) / 255
    return MeshPiece(
        model.geom(geom).name or f"geom{geom}", geom, int(model.geom_bodyid[geom]), kind, model.geom_size[geom].copy(),
        model.geom_pos[geom].copy(), model.geom_quat[geom].copy(), np.clip(colour, 0, 1), gloss, picture,
    )  # fmt: skip


def linear(colour: Array) -> Array:
    """Return linear light for sRGB in [0, 1] (IEC 61966-2-1)."""
    return np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)


def texels(model: mujoco.MjModel, texture: int) -> NDArray[np.uint8]:
    """Return a texture's colours, (h, w, 3)."""
    height, width = int(model.tex_height[texture]), int(model.tex_width[texture])
    channels, start = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
    data = model.tex_data[start : start + height * width * channels].reshape(height, width, channels)
    return np.ascontiguousarray(data[..., :3] if channels >= 3 else np.repeat(data[..., :1], 3, axis=2))


def png(model: mujoco.MjModel, texture: int) -> bytes:
    """Return a texture as a PNG file."""
    from PIL import Image  # imported here because few figures have textures

    stream = io.BytesIO()
    Image.fromarray(texels(model, texture)).save(stream, "png", optimize=True)
    return stream.getvalue()


def triangles(model: mujoco.MjModel, piece: MeshPiece, reach: float = 20.0) -> Triangles:
    """Return a piece as triangles. An infinite plane extends `reach` [m] from its middle."""
    size = piece.size
    match piece.kind:
        case mujoco.mjtGeom.mjGEOM_PLANE:
            return _plane(model, piece, reach)
        case mujoco.mjtGeom.mjGEOM_BOX:
            return _box(size)
        case mujoco.mjtGeom.mjGEOM_SPHERE:
            return _ellipsoid(size[[0, 0, 0]])
        case mujoco.mjtGeom.mjGEOM_ELLIPSOID:
            return _ellipsoid(size)
        case mujoco.mjtGeom.mjGEOM_CAPSULE:
            return _capsule(size[0], size[1])
        case mujoco.mjtGeom.mjGEOM_CYLINDER:
            return _cylinder(size[0], size[1])
        case mujoco.mjtGeom.mjGEOM_HFIELD:
            return _height_field(model, int(model.geom_dataid[piece.geom]))
        case kind if kind in MESHES:
            return _mesh(model, int(model.geom_dataid[piece.geom]))
        case kind:
            raise UserError(f"geom '{piece.name}' is of MuJoCo's type {kind}, which has no triangles here")


def half_extent(piece: MeshPiece, reach: float) -> Array:
    """Return the half size of a plane, (2,) [m]."""
    return np.where(piece.size[:2] > 0, piece.size[:2], reach)


def picture_repeat(model: mujoco.MjModel, piece: MeshPiece, half: Array) -> Array:
    """Return the number of texture repetitions per metre, (2,).

    MuJoCo stretches a texture over the whole plane, or over one metre if it is uniform.
    """
    material = int(model.geom_matid[piece.geom])
    repeat = np.array(model.mat_texrepeat[material], float)
    if model.mat_texuniform[material]:
        return repeat / 2
    return repeat / (2 * np.where(piece.size[:2] > 0, half, 1.0))


def _plane(model: mujoco.MjModel, piece: MeshPiece, reach: float) -> Triangles:
    half = half_extent(piece, reach)
    points = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * np.append(half, 0.0)
    texture = None
    if piece.picture >= 0:
        texture = points[:, :2] * picture_repeat(model, piece, half) * [1, -1]
    return Triangles(points, np.tile([0.0, 0, 1], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]], np.uint32), texture)


def _box(half: Array) -> Triangles:
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    points, normals = [], []
    for axis in range(3):
        for side in (-1.0, 1.0):
            face = np.zeros((4, 3))
            face[:, axis] = side
            face[:, [(axis + 1) % 3, (axis + 2) % 3]] = corners if side > 0 else corners[::-1]
            points.append(face * half)
            normals.append(np.tile(side * np.eye(3)[axis], (4, 1)))
    faces = 4 * np.arange(6)[:, None, None] + [[0, 1, 2], [0, 2, 3]]
    return Triangles(np.concatenate(points), np.concatenate(normals), faces.reshape(-1, 3).astype(np.uint32))


def slices(radius: float) -> int:
    """Return the number of corners of a circle whose sides deviate by at most SAG."""
    return int(np.clip(np.ceil(np.pi / np.sqrt(2 * SAG / max(radius, 1e-6))), 8, 32)) // 4 * 4


def _lathe(radius: Array, height: Array, normal: Array, count: int) -> Triangles:
    """Return a surface of revolution about z, from a profile (k,) from the bottom up and its outward normals (k, 2)."""
    angle = 2 * np.pi * np.arange(count) / count
    around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    points = np.concatenate(
        [radius[:, None, None] * around, np.broadcast_to(height[:, None, None], (len(radius), count, 1))], axis=-1
    )
    up = np.broadcast_to(normal[:, None, 1:], (len(radius), count, 1))
    normals = np.concatenate([normal[:, None, :1] * around, up], axis=-1)
    ring, turn = np.meshgrid(np.arange(len(radius) - 1), np.arange(count), indexing="ij")
    a, b = ring * count + turn, ring * count + (turn + 1) % count
    lower = np.stack([a, b, b + count], axis=-1)[(radius[:-1] > 0)]
    upper = np.stack([a, b + count, a + count], axis=-1)[(radius[1:] > 0)]
    faces = np.concatenate([lower.reshape(-1, 3), upper.reshape(-1, 3)])
    return _drop_unused(Triangles(points.reshape(-1, 3), normals.reshape(-1, 3), faces.astype(np.uint32)))


def _drop_unused(mesh: Triangles) -> Triangles:
    """Return the triangles without points that no face uses."""
    used, faces = np.unique(mesh.faces, return_inverse=True)
    return Triangles(mesh.points[used], mesh.normals[used], faces.reshape(-1, 3).astype(np.uint32))


def _arc(count: int, *, top: bool) -> Array:
    """Return angles above the horizon, of the upper or lower quarter of a profile."""
    return np.linspace(0, np.pi / 2, count + 1) if top else np.linspace(-np.pi / 2, 0, count + 1)


def _ellipsoid(size: Array) -> Triangles:
    count = slices(float(size.max()))
    angle = np.concatenate([_arc(count // 4, top=False), _arc(count // 4, top=True)[1:]])
    profile = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    profile[[0, -1], 0] = 0
    ball = _lathe(profile[:, 0], profile[:, 1], profile, count)
    normals = ball.normals / size
    return Triangles(ball.points * size, normals / np.linalg.norm(normals, axis=1, keepdims=True), ball.faces)


def _capsule(radius: float, half: float) -> Triangles:
    count = slices(radius)
    angle = np.concatenate([_arc(count // 4, top=False), _arc(count // 4, top=True)])
    normal = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    normal[[0, -1], 0] = 0
    height = radius * normal[:, 1] + np.repeat([-half, half], len(angle) // 2)
    return _lathe(radius * normal[:, 0], height, normal, count)


def _cylinder(radius: float, half: float) -> Triangles:
    profile = radius * np.array([0.0, 1, 1, 1, 1, 0])
    height = half * np.array([-1.0, -1, -1, 1, 1, 1])
    normal = np.array([[0.0, -1], [0, -1], [1, 0], [1, 0], [0, 1], [0, 1]])
    parts = [_lathe(profile[i : i + 2], height[i : i + 2], normal[i : i + 2], slices(radius)) for i in (0, 2, 4)]
    return join(parts)


def join(parts: list[Triangles]) -> Triangles:
    """Return several meshes as one; meshes with and without textures must not be mixed."""
    starts = np.cumsum([0, *(len(part.points) for part in parts[:-1])])
    texture = [part.texture for part in parts if part.texture is not None]
    return Triangles(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.faces + start for part, start in zip(parts, starts, strict=True)]).astype(np.uint32),
        np.concatenate(texture) if len(texture) == len(parts) else None,
    )


def _mesh(model: mujoco.MjModel, mesh: int) -> Triangles:
    """Return a mesh with MuJoCo's smooth normals, except at sharp corners, where the face's normal is used."""
    points = model.mesh_vert[model.mesh_vertadr[mesh] :][: model.mesh_vertnum[mesh]].astype(float)
    smooth = model.mesh_normal[model.mesh_normaladr[mesh] :][: model.mesh_normalnum[mesh]].astype(float)
    rows = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])
    faces = model.mesh_face[rows]
    a, b, c = (points[faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    area = np.linalg.norm(across, axis=1)
    whole = area > 0
    flat = (across[whole] / area[whole, None])[:, None]
    normals = smooth[model.mesh_facenormal[rows][whole]]
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    normals = np.where(np.sum(normals * flat, axis=-1, keepdims=True) > 0.5, normals / np.maximum(length, 0.5), flat)
    corners = np.concatenate([points[faces[whole]], normals], axis=-1).reshape(-1, 6)
    vertices, index = np.unique(corners.astype(np.float32), axis=0, return_inverse=True)
    unit = vertices[:, 3:].astype(float)
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    return Triangles(vertices[:, :3].astype(float), unit, index.reshape(-1, 3).astype(np.uint32))


def _height_field(model: mujoco.MjModel, field: int) -> Triangles:
    rows, columns = int(model.hfield_nrow[field]), int(model.hfield_ncol[field])
    half_x, half_y, top, _ = model.hfield_size[field]
    start = int(model.hfield_adr[field])
    z = top * model.hfield_data[start : start + rows * columns].reshape(rows, columns).astype(float)
    x, y = np.linspace(-half_x, half_x, columns), np.linspace(-half_y, half_y, rows)
    points = np.stack([*np.meshgrid(x, y), z], axis=-1)
    slope_y, slope_x = np.gradient(z, y, x)
    normals = np.stack([-slope_x, -slope_y, np.ones_like(z)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    row, column = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = row * columns + column
    faces = np.stack([a, a + 1, a + columns + 1, a, a + columns + 1, a + columns], axis=-1).reshape(-1, 3)
    return Triangles(points.reshape(-1, 3), normals.reshape(-1, 3), faces.astype(np.uint32))
