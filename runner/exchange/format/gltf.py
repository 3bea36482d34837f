"""glTF 2.0 (.glb): a node per body with its geoms as a mesh, moved by one animation; the root node rotates z up to y
up.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html; metres, the figure faces +z. Times are i / fps from 0 in
float32, the only type that the format allows, so at 10 s they are off by up to 0.5 µs. Viewers interpolate positions
linearly and rotations along the arc. Bodies that never move have no channels. The nodes are in the pose of the first
sample.
"""

from __future__ import annotations

from itertools import groupby
from pathlib import Path

import mujoco
import numpy as np
import pygltflib as gl
from numpy.typing import NDArray

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...scene.triangles import Piece, Triangles, joined, linear, pieces, png, triangles
from ..skeleton import hierarchy
from ..trajectory import SampledTrajectory

STILL = 1e-7  # [m, or 1 for quaternions] largest change that counts as no motion
KINDS = {1: gl.SCALAR, 2: gl.VEC2, 3: gl.VEC3, 4: gl.VEC4}


class _Blob:
    """The binary part of the file, with its views and accessors."""

    def __init__(self, asset: gl.GLTF2) -> None:
        self.asset, self.data = asset, bytearray()

    def view(self, data: bytes, target: int | None = None) -> int:
        start = len(self.data)
        self.data += data + b"\0" * (-len(data) % 4)
        self.asset.bufferViews.append(gl.BufferView(buffer=0, byteOffset=start, byteLength=len(data), target=target))
        return len(self.asset.bufferViews) - 1

    def accessor(self, array: Array, target: int | None = None, *, bounded: bool = False) -> int:
        """Add float32 rows; `bounded` adds their minimum and maximum, required for times and positions."""
        rows = np.ascontiguousarray(array, np.float32).reshape(len(array), -1)
        low, high = (rows.min(axis=0).tolist(), rows.max(axis=0).tolist()) if bounded else (None, None)
        kind, view = KINDS[rows.shape[1]], self.view(rows.tobytes(), target)
        self.asset.accessors.append(
            gl.Accessor(bufferView=view, componentType=gl.FLOAT, count=len(rows), type=kind, min=low, max=high)
        )
        return len(self.asset.accessors) - 1

    def indices(self, faces: NDArray[np.uint32]) -> int:
        view = self.view(faces.astype(np.uint32).tobytes(), gl.ELEMENT_ARRAY_BUFFER)
        self.asset.accessors.append(
            gl.Accessor(bufferView=view, componentType=gl.UNSIGNED_INT, count=faces.size, type=gl.SCALAR)
        )
        return len(self.asset.accessors) - 1


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write the whole scene and its animation; the animation's extras contain the times of the keyframes."""
    model = trajectory.model
    asset = gl.GLTF2(asset=gl.Asset(version="2.0", generator="dynamic-splines"))
    blob = _Blob(asset)
    names = hierarchy.names(model)
    position, rotation = hierarchy.local(model, trajectory.bodies)
    asset.nodes = [
        gl.Node(name=name, translation=_least(position[0, body]), rotation=_least(hierarchy.xyzw(rotation[0, body])))
        for body, name in enumerate(names)
    ]
    for body in range(model.nbody):
        asset.nodes[body].children = [int(child) for child in np.flatnonzero(model.body_parentid == body) if child]
    asset.nodes[0].rotation = hierarchy.xyzw(hierarchy.Y_UP).tolist()
    asset.nodes[0].translation = None
    _meshes(asset, blob, model, names, 10.0 + float(np.abs(trajectory.bodies.position).max()))
    _animation(asset, blob, trajectory, position, rotation)
    asset.scenes, asset.scene = [gl.Scene(name=trajectory.name, nodes=[0])], 0
    asset.buffers = [gl.Buffer(byteLength=len(blob.data))]
    asset.set_binary_blob(bytes(blob.data))
    path.write_bytes(b"".join(asset.save_to_bytes()))


def _least(row: Array) -> list[float] | None:
    """Return numbers as stored in the file, None for the default of the format."""
    at_rest = np.zeros(3) if len(row) == 3 else np.array([0.0, 0, 0, 1])
    return None if np.allclose(row, at_rest, atol=1e-12) else row.astype(np.float32).astype(float).tolist()


def _animation(asset: gl.GLTF2, blob: _Blob, trajectory: SampledTrajectory, position: Array, rotation: Array) -> None:
    """Add a channel for every position and rotation that changes; all share the times."""
    clip = gl.Animation(
        name=trajectory.name,
        extras={
            "fps": trajectory.fps,
            "keyframes": [round(k.time - float(trajectory.time[0]), 9) for k in trajectory.saved.keys],
        },
    )
    times = None
    for body in range(1, trajectory.model.nbody):
        for path, track in (("translation", position[:, body]), ("rotation", hierarchy.xyzw(rotation[:, body]))):
            if np.abs(track - track[0]).max() <= STILL:
                continue
            if times is None:
                times = blob.accessor(np.arange(len(trajectory.time)) / trajectory.fps, bounded=True)
            clip.samplers.append(
                gl.AnimationSampler(input=times, output=blob.accessor(track), interpolation=gl.ANIM_LINEAR)
            )
            target = gl.AnimationChannelTarget(node=body, path=path)
            clip.channels.append(gl.AnimationChannel(sampler=len(clip.samplers) - 1, target=target))
    asset.animations = [clip] if clip.channels else []


def _meshes(asset: gl.GLTF2, blob: _Blob, model: mujoco.MjModel, names: list[str], reach: float) -> None:
    """Add one mesh per body, with one primitive per material."""
    materials: dict[tuple[object, ...], int] = {}
    for body, group in groupby(pieces(model), lambda piece: piece.body):
        alike: dict[int, list[Triangles]] = {}
        for piece in group:
            look = (*piece.colour.tolist(), piece.gloss, piece.picture)
            if look not in materials:
                materials[look] = len(materials)
                asset.materials.append(_material(asset, blob, model, piece))
            alike.setdefault(materials[look], []).append(_placed(piece, triangles(model, piece, reach)))
        primitives = [_primitive(blob, joined(parts), look) for look, parts in alike.items()]
        asset.meshes.append(gl.Mesh(name=names[body], primitives=primitives))
        asset.nodes[body].mesh = len(asset.meshes) - 1


def _placed(piece: Piece, part: Triangles) -> Triangles:
    """Transform from the geom's axes to its body's."""
    points = quat.rotated(piece.rotation, part.points) + piece.position
    return Triangles(points, quat.rotated(piece.rotation, part.normals), part.faces, part.texture)


def _primitive(blob: _Blob, part: Triangles, material: int) -> gl.Primitive:
    attributes = gl.Attributes(
        POSITION=blob.accessor(part.points, gl.ARRAY_BUFFER, bounded=True),
        NORMAL=blob.accessor(part.normals, gl.ARRAY_BUFFER),
    )
    if part.texture is not None:
        attributes.TEXCOORD_0 = blob.accessor(part.texture, gl.ARRAY_BUFFER)
    return gl.Primitive(attributes=attributes, indices=blob.indices(part.faces), material=material)


def _material(asset: gl.GLTF2, blob: _Blob, model: mujoco.MjModel, piece: Piece) -> gl.Material:
    """Add a material; colours of models are sRGB and become linear, as the format requires."""
    look = gl.PbrMetallicRoughness(
        baseColorFactor=[*linear(piece.colour[:3]).tolist(), float(piece.colour[3])],
        metallicFactor=0.0,
        roughnessFactor=round(float(np.clip(1 - piece.gloss, 0.05, 1)), 4),
    )
    if piece.picture >= 0:
        asset.images.append(gl.Image(bufferView=blob.view(png(model, piece.picture)), mimeType="image/png"))
        asset.samplers.append(gl.Sampler(wrapS=gl.REPEAT, wrapT=gl.REPEAT, minFilter=gl.LINEAR_MIPMAP_LINEAR,
                                         magFilter=gl.LINEAR))  # fmt: skip
        asset.textures.append(gl.Texture(source=len(asset.images) - 1, sampler=len(asset.samplers) - 1))
        look.baseColorTexture = gl.TextureInfo(index=len(asset.textures) - 1)
    material = int(model.geom_matid[piece.geom])
    name = model.mat(material).name if material >= 0 else piece.name
    see_through = piece.colour[3] < 1
    return gl.Material(name=name, pbrMetallicRoughness=look, alphaMode=gl.BLEND if see_through else gl.OPAQUE,
                       alphaCutoff=None)  # fmt: skip
