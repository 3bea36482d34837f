"""HTML: the motion in a page of its own that plays it, from the disk and without any other file or address.

The page is `player/page.html` with its style, its program and three.js (MIT; see the head of `player/three.js`) put in,
and the motion as JSON: MuJoCo's poses of every body at equal times, float32 in base64.
"""

from __future__ import annotations

import base64
import html
import json
import re
from importlib.resources import files
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver.array import Array

from ...motion import sampled
from ..skeleton import hierarchy
from ..take import Bodies, Take
from ..triangles import Piece, half_extent, is_still, picture_repeat, pieces, png, triangles

KINDS = {
    mujoco.mjtGeom.mjGEOM_PLANE: "plane",
    mujoco.mjtGeom.mjGEOM_BOX: "box",
    mujoco.mjtGeom.mjGEOM_SPHERE: "sphere",
    mujoco.mjtGeom.mjGEOM_ELLIPSOID: "ellipsoid",
    mujoco.mjtGeom.mjGEOM_CAPSULE: "capsule",
    mujoco.mjtGeom.mjGEOM_CYLINDER: "cylinder",
    mujoco.mjtGeom.mjGEOM_HFIELD: "hfield",
}
SAME = 1e-6  # [m, or of a quaternion's entries]: nearer, before and after are one motion


def write(take: Take, path: Path) -> None:
    """A page that plays the motion, whole in one file."""
    path.write_text(page(take), encoding="utf-8")


def page(take: Take) -> str:
    """The complete HTML text."""
    folder = files("dynsplines.exchange") / "player"
    parts = {
        "title": html.escape(take.name),
        "data": json.dumps(content(take), separators=(",", ":")).replace("<", "\\u003c"),
        **{
            name: (folder / file).read_text(encoding="utf-8")
            for name, file in (("style", "style.css"), ("three", "three.js"), ("player", "player.js"))
        },
    }
    frame = (folder / "page.html").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], frame)


def content(take: Take) -> dict[str, Any]:
    """What the page plays; lengths in metres, z up, quaternions xyzw, times from 0."""
    model, start = take.model, float(take.time[0])
    raw = sampled(take.figure, take.saved.raw, take.fps)
    before = Bodies.of(model, raw.qpos, raw.qvel)
    changed = any(
        np.abs(getattr(before, part) - getattr(take.bodies, part)).max() > SAME for part in ("position", "rotation")
    )
    seen = pieces(model)
    moving = sorted({piece.body for piece in seen if not is_still(model, piece)}) or list(range(1, model.nbody))
    places = take.bodies.position[:, moving]
    extent = float(np.ptp(places, axis=(0, 1))[:2].max())
    meshes: dict[int, int] = {}
    pictures: dict[int, int] = {}
    told = [_piece(model, piece, 30.0 + 2 * float(np.abs(places).max()), meshes, pictures) for piece in seen]
    return {
        "name": take.name,
        "fps": take.fps,
        "count": len(take.time),
        "keys": [{"time": key.time - start, "partial": not bool(np.all(key.fixed))} for key in take.saved.keys],
        "bodies": hierarchy.names(model),
        "after": _track(take.bodies),
        "before": _track(before) if changed else None,
        "pieces": told,
        "meshes": [_mesh(model, next(p for p in seen if p.geom == geom)) for geom in meshes],
        "pictures": ["data:image/png;base64," + base64.b64encode(png(model, each)).decode() for each in pictures],
        "extent": extent,
        "size": float(np.linalg.norm(np.ptp(places, axis=1), axis=-1).max()) if len(moving) > 1 else 1.0,
    }


def packed(array: ArrayLike, kind: str = "<f4") -> str:
    """Numbers in base64."""
    return base64.b64encode(np.ascontiguousarray(array, kind).tobytes()).decode()


def _track(bodies: Bodies) -> dict[str, str]:
    return {"position": packed(bodies.position), "rotation": packed(hierarchy.xyzw(bodies.rotation))}


def _short(array: Array) -> list[float]:
    return [round(float(x), 6) for x in array]


def _piece(
    model: mujoco.MjModel, piece: Piece, reach: float, meshes: dict[int, int], pictures: dict[int, int]
) -> dict[str, Any]:
    """A geom; meshes and pictures that it is the first to use get a number there."""
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


def _mesh(model: mujoco.MjModel, piece: Piece) -> dict[str, str]:
    found = triangles(model, piece)
    return {"points": packed(found.points), "normals": packed(found.normals), "faces": packed(found.faces, "<u4")}
