"""The visible geoms of a model with their meshes and textures as JSON for a page; lengths in metres, z up."""

from __future__ import annotations

import base64
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver.array import Array

from ..scene.triangles import MeshPiece, half_extent, is_still, picture_repeat, pieces, png, triangles
from .skeleton import hierarchy

KINDS = {
    mujoco.mjtGeom.mjGEOM_PLANE: "plane",
    mujoco.mjtGeom.mjGEOM_BOX: "box",
    mujoco.mjtGeom.mjGEOM_SPHERE: "sphere",
    mujoco.mjtGeom.mjGEOM_ELLIPSOID: "ellipsoid",
    mujoco.mjtGeom.mjGEOM_CAPSULE: "capsule",
    mujoco.mjtGeom.mjGEOM_CYLINDER: "cylinder",
    mujoco.mjtGeom.mjGEOM_HFIELD: "hfield",
}


def visible_parts(model: mujoco.MjModel, reach: float) -> dict[str, Any]:
    """Return the visible parts of a model, with the meshes and textures that they refer to by index.

    reach [m]: distance from the model's middle to which infinite planes are drawn
    """
    meshes: dict[int, int] = {}
    pictures: dict[int, int] = {}
    visible = pieces(model)
    described = [_piece(model, piece, reach, meshes, pictures) for piece in visible]
    return {
        "pieces": described,
        "meshes": [_mesh(model, next(p for p in visible if p.geom == geom)) for geom in meshes],
        "pictures": ["data:image/png;base64," + base64.b64encode(png(model, picture)).decode() for picture in pictures],
    }


def pack(array: ArrayLike, kind: str = "<f4") -> str:
    """Return numbers in base64."""
    return base64.b64encode(np.ascontiguousarray(array, kind).tobytes()).decode()


def _short(array: Array) -> list[float]:
    return [round(float(x), 6) for x in array]


def _piece(
    model: mujoco.MjModel, piece: MeshPiece, reach: float, meshes: dict[int, int], pictures: dict[int, int]
) -> dict[str, Any]:
    """Return a geom in its body's axes; a mesh or texture that it uses first is added to `meshes` or `pictures`."""
    out: dict[str, Any] = {
        "name": piece.name, "body": piece.body, "kind": KINDS.get(piece.kind, "mesh"), "size": _short(piece.size),
        "position": _short(piece.position), "rotation": _short(hierarchy.xyzw(piece.rotation)),
        "colour": _short(piece.colour), "gloss": round(piece.gloss, 4), "still": is_still(model, piece),
    }  # fmt: skip
    if piece.kind == mujoco.mjtGeom.mjGEOM_PLANE:
        half = half_extent(piece, reach)
        out["size"] = _short(half)
        if piece.picture >= 0:
            out["picture"] = pictures.setdefault(piece.picture, len(pictures))
            out["repeat"] = _short(picture_repeat(model, piece, half))
    elif out["kind"] in ("mesh", "hfield"):
        out["mesh"] = meshes.setdefault(piece.geom, len(meshes))
    return out


def _mesh(model: mujoco.MjModel, piece: MeshPiece) -> dict[str, str]:
    mesh = triangles(model, piece)
    return {"points": pack(mesh.points), "normals": pack(mesh.normals), "faces": pack(mesh.faces, "<u4")}
