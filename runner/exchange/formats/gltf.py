"""glTF 2.0 (.glb): a node per body with its geoms as a mesh, moved by one animation; the root node rotates z up to y
up.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html; metres, the figure faces +z. Times are i / fps from 0 in
float32, the only type that the format allows, so at 10 s they are off by up to 0.5 µs. Viewers interpolate positions
linearly and rotations along the arc. Bodies that never move have no channels. The nodes are in the pose of the first
sample.
"""

from __future__ import annotations

import json
import struct
from collections import defaultdict
from itertools import groupby
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.tolerances import SINGLE

from ...motion import Sampled
from ...scene.triangles import MeshPiece, Triangles, join, linear, pieces, png, triangles
from ..skeleton import hierarchy

COMPONENTS = {"<f4": 5126, "<u4": 5125}  # types of components
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963  # targets of views
WIDTHS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}


class _Document:
    """The arrays of the JSON part, by name, and the binary part that they refer to."""

    def __init__(self) -> None:
        self.arrays: dict[str, list[dict[str, Any]]] = defaultdict(list)
        self.data = bytearray()

    def add(self, array: str, **entry: Any) -> int:
        """Append an entry and return its index."""
        self.arrays[array].append(entry)
        return len(self.arrays[array]) - 1

    def view(self, data: bytes, **target: int) -> int:
        start = len(self.data)
        self.data += data + b"\0" * (-len(data) % 4)
        return self.add("bufferViews", buffer=0, byteOffset=start, byteLength=len(data), **target)

    def rows(self, array: Array, *, bounded: bool = False, **target: int) -> int:
        """Add an accessor of float32 rows; `bounded` adds their bounds, required for times and positions."""
        rows = np.ascontiguousarray(array, "<f4").reshape(len(array), -1)
        bounds = {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()} if bounded else {}
        view, width = self.view(rows.tobytes(), **target), WIDTHS[rows.shape[1]]
        return self.add(
            "accessors", bufferView=view, componentType=COMPONENTS["<f4"], count=len(rows), type=width, **bounds
        )

    def indices(self, faces: NDArray[np.uint32]) -> int:
        view = self.view(faces.astype("<u4").tobytes(), target=ELEMENT_ARRAY_BUFFER)
        return self.add("accessors", bufferView=view, componentType=COMPONENTS["<u4"], count=faces.size, type="SCALAR")

    def binary(self, scene: str) -> bytes:
        """Return the file, whose only scene has the first node as its root."""
        asset = {"version": "2.0", "generator": "dynamic-splines"}
        head = {"asset": asset, "scene": 0, "scenes": [{"name": scene, "nodes": [0]}]}
        text = json.dumps(head | self.arrays | {"buffers": [{"byteLength": len(self.data)}]}).encode()
        text += b" " * (-len(text) % 4)
        chunks = [(b"JSON", text), (b"BIN\0", self.data)]
        body = b"".join(struct.pack("<I4s", len(data), kind) + data for kind, data in chunks)
        return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def write(sampled: Sampled, path: Path) -> None:
    """Write the whole scene and its animation; the animation's extras contain the times of the keyframes."""
    model, document = sampled.model, _Document()
    position, rotation = hierarchy.local(model, sampled.bodies)
    names, rotation = hierarchy.names(model), hierarchy.xyzw(rotation)
    meshes = _meshes(document, model, names, 10.0 + float(np.abs(sampled.bodies.position).max()))
    for body, name in enumerate(names):
        place, turn = position[0, body].astype(np.float32), rotation[0, body].astype(np.float32)
        children = [int(child) for child in np.flatnonzero(model.body_parentid == body) if child]
        more = {"children": children} if children else {}
        more |= {"mesh": meshes[body]} if body in meshes else {}
        document.add("nodes", name=name, translation=place.tolist(), rotation=turn.tolist(), **more)
    document.arrays["nodes"][0]["rotation"] = hierarchy.xyzw(hierarchy.Y_UP).tolist()
    _add_animation(document, sampled, position, rotation)
    path.write_bytes(document.binary(sampled.name))


def _add_animation(document: _Document, sampled: Sampled, position: Array, rotation: Array) -> None:
    """Add a channel for every position and rotation (xyzw) that changes; all share the times."""
    tracks = {
        (body, path): track[:, body]
        for body in range(sampled.model.nbody)
        for path, track in (("translation", position), ("rotation", rotation))
        if np.ptp(track[:, body], axis=0).max() > SINGLE
    }
    if not tracks:
        return
    times = document.rows(np.arange(len(sampled.time)) / sampled.fps, bounded=True)
    keys = [round(key.time - float(sampled.time[0]), 9) for key in sampled.motion.keys]
    document.add(
        "animations",
        name=sampled.name,
        samplers=[{"input": times, "output": document.rows(track)} for track in tracks.values()],
        channels=[{"sampler": i, "target": {"node": body, "path": path}} for i, (body, path) in enumerate(tracks)],
        extras={"fps": sampled.fps, "keyframes": keys},
    )


def _meshes(document: _Document, model: mujoco.MjModel, names: list[str], reach: float) -> dict[int, int]:
    """Add a mesh for every visible body, with one primitive per material; return the meshes by body."""
    meshes: dict[int, int] = {}
    materials: dict[tuple[object, ...], int] = {}
    for body, group in groupby(pieces(model), lambda piece: piece.body):
        alike: dict[int, list[Triangles]] = {}
        for piece in group:
            look = (*piece.colour.tolist(), piece.gloss, piece.picture)
            if look not in materials:
                materials[look] = _material(document, model, piece)
            alike.setdefault(materials[look], []).append(_place(piece, triangles(model, piece, reach)))
        primitives = [_primitive(document, join(parts), look) for look, parts in alike.items()]
        meshes[body] = document.add("meshes", name=names[body], primitives=primitives)
    return meshes


def _place(piece: MeshPiece, part: Triangles) -> Triangles:
    """Transform from the geom's axes to its body's."""
    points = quat.rotate(piece.rotation, part.points) + piece.position
    return Triangles(points, quat.rotate(piece.rotation, part.normals), part.faces, part.texture)


def _primitive(document: _Document, part: Triangles, material: int) -> dict[str, Any]:
    attributes = {
        "POSITION": document.rows(part.points, bounded=True, target=ARRAY_BUFFER),
        "NORMAL": document.rows(part.normals, target=ARRAY_BUFFER),
    }
    if part.texture is not None:
        attributes["TEXCOORD_0"] = document.rows(part.texture, target=ARRAY_BUFFER)
    return {"attributes": attributes, "indices": document.indices(part.faces), "material": material}


def _material(document: _Document, model: mujoco.MjModel, piece: MeshPiece) -> int:
    """Add a material; colours of models are sRGB and become linear, as the format requires."""
    look: dict[str, Any] = {
        "baseColorFactor": [*linear(piece.colour[:3]).tolist(), float(piece.colour[3])],
        "metallicFactor": 0.0,
        "roughnessFactor": round(float(np.clip(1 - piece.gloss, 0.05, 1)), 4),
    }
    if piece.picture >= 0:
        image = document.add("images", bufferView=document.view(png(model, piece.picture)), mimeType="image/png")
        look["baseColorTexture"] = {"index": document.add("textures", source=image)}
    material = int(model.geom_matid[piece.geom])
    name = model.mat(material).name if material >= 0 else piece.name
    mode = "BLEND" if piece.colour[3] < 1 else "OPAQUE"
    return document.add("materials", name=name, pbrMetallicRoughness=look, alphaMode=mode)
