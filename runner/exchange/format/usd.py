"""USD (.usd, .usda, .usdc): an Xform per body, moved at every time code; z up, metres, one time code per sample.

A body's position is relative to its parent. Its geoms are Gprims (cubes, spheres, capsules, cylinders and meshes) with
displayColor for viewers and UsdPreviewSurface for renderers. https://openusd.org/release/api/
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdShade, Vt

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError
from ...scene.triangles import Piece, linear, pieces, texels, triangles
from ..nodes import usd_file
from ..skeleton import hierarchy
from ..trajectory import Recording, SampledTrajectory
from .bvh import recording

ENDINGS = (".usd", ".usda", ".usdc")
STILL = 1e-9  # [m, or 1 for quaternions] largest change that counts as no motion


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write binary for .usd and .usdc, text for .usda."""
    if path.suffix not in ENDINGS:
        raise UserError(f"a USD file's name ends in one of: {', '.join(ENDINGS)}")
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(trajectory.fps)
    stage.SetFramesPerSecond(trajectory.fps)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(len(trajectory.time) - 1)
    paths = _bodies(stage, trajectory)
    looks: dict[tuple[object, ...], UsdShade.Material] = {}
    scope = UsdGeom.Scope.Define(stage, _free(stage, paths[0], "looks")).GetPrim()
    reach = 10.0 + float(np.abs(trajectory.bodies.position).max())
    for piece in pieces(trajectory.model):
        _bind(_prim(stage, trajectory.model, piece, paths[piece.body], reach), trajectory.model, piece, looks, scope)
    try:
        is_written = stage.GetRootLayer().Export(str(path))
    except Tf.ErrorException:  # its message has many lines of internal state
        is_written = False
    if not is_written:
        raise UserError(f"cannot write '{path}': the disk is full, or a limit on the size of files is reached")


def read(path: Path, model: mujoco.MjModel | None, fps: float | None, *, scale: float | None = None) -> Recording:
    """Read the file's skeleton, or its motion on a figure; fps [1/s] to resample; scale [m], its unit."""
    return recording(usd_file.read(path, fps, scale), path, model, scale, is_metric=True)


def _free(stage: Usd.Stage, above: Sdf.Path, text: str) -> Sdf.Path:
    """Return an unused path of this name, of letters, digits and underscores, without a leading digit."""
    clean = Tf.MakeValidIdentifier(text)
    count, path = 2, above.AppendChild(clean)
    while stage.GetPrimAtPath(path):
        count, path = count + 1, above.AppendChild(f"{clean}_{count}")
    return path


def _bodies(stage: Usd.Stage, trajectory: SampledTrajectory) -> list[Sdf.Path]:
    """Add an Xform for every body; the world is the default prim."""
    model, position_rotation = trajectory.model, hierarchy.local(trajectory.model, trajectory.bodies)
    names = hierarchy.names(model)
    rest_place, rest_turn = (track[0] for track in hierarchy.local(model, hierarchy.rest(model)))
    paths: list[Sdf.Path] = []
    for body in range(model.nbody):
        above = paths[int(model.body_parentid[body])] if body else Sdf.Path.absoluteRootPath
        path = _free(stage, above, names[body] if body else trajectory.name)
        paths.append(path)
        form = UsdGeom.Xform.Define(stage, path)
        form.GetPrim().SetDisplayName(names[body] if body else trajectory.name)
        if body == 0:
            stage.SetDefaultPrim(form.GetPrim())
            codes = [(key.time - trajectory.time[0]) * trajectory.fps for key in trajectory.saved.keys]
            form.GetPrim().SetCustomDataByKey("keyframes", Vt.DoubleArray([round(float(code), 6) for code in codes]))
            continue
        at_rest = Vt.DoubleArray([*rest_place[body].tolist(), *rest_turn[body].tolist()])
        form.GetPrim().SetCustomDataByKey(usd_file.REST, at_rest)
        position, rotation = (track[:, body] for track in position_rotation)
        _animate(form.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble), position, lambda row: Gf.Vec3d(*row.tolist()))
        _animate(form.AddOrientOp(UsdGeom.XformOp.PrecisionDouble), rotation, lambda row: Gf.Quatd(*row.tolist()))
    return paths


def _animate(op: UsdGeom.XformOp, track: Array, kind: Callable[[Array], Any]) -> None:
    """Set a value at every time code, or one default value if nothing changes."""
    if np.abs(track - track[0]).max() <= STILL:
        op.Set(kind(track[0]))
        return
    for code, row in enumerate(track):
        op.Set(kind(row), Usd.TimeCode(code))


def _prim(stage: Usd.Stage, model: mujoco.MjModel, piece: Piece, body: Sdf.Path, reach: float) -> UsdGeom.Gprim:
    path = _free(stage, body, f"{piece.name}_geom")
    size, scale = piece.size, None
    match piece.kind:
        case mujoco.mjtGeom.mjGEOM_BOX:
            prim, scale = UsdGeom.Cube.Define(stage, path), size
            prim.CreateSizeAttr(2.0)
        case mujoco.mjtGeom.mjGEOM_SPHERE:
            prim = UsdGeom.Sphere.Define(stage, path)
            prim.CreateRadiusAttr(float(size[0]))
        case mujoco.mjtGeom.mjGEOM_ELLIPSOID:
            prim, scale = UsdGeom.Sphere.Define(stage, path), size
            prim.CreateRadiusAttr(1.0)
        case mujoco.mjtGeom.mjGEOM_CAPSULE | mujoco.mjtGeom.mjGEOM_CYLINDER as kind:
            shape = UsdGeom.Capsule if kind == mujoco.mjtGeom.mjGEOM_CAPSULE else UsdGeom.Cylinder
            prim = shape.Define(stage, path)
            prim.CreateAxisAttr(UsdGeom.Tokens.z)
            prim.CreateRadiusAttr(float(size[0]))
            prim.CreateHeightAttr(2 * float(size[1]))
        case _:
            prim = _mesh(stage, model, piece, path, reach)
    prim.CreateExtentAttr(UsdGeom.Boundable.ComputeExtentFromPlugins(prim, Usd.TimeCode.Default()))
    prim.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(*piece.position.tolist()))
    turn = quat.normalised(piece.rotation)
    prim.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Quatd(*turn.tolist()))
    if scale is not None:
        prim.AddScaleOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(*scale.tolist()))
    return prim


def _mesh(stage: Usd.Stage, model: mujoco.MjModel, piece: Piece, path: Sdf.Path, reach: float) -> UsdGeom.Mesh:
    part = triangles(model, piece, reach)
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(part.points, np.float32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(np.ascontiguousarray(part.faces.ravel(), np.int32)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(part.faces), 3, np.int32)))
    mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(part.normals, np.float32)))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateDoubleSidedAttr(bool(piece.kind == mujoco.mjtGeom.mjGEOM_HFIELD))
    return mesh


def _bind(
    prim: UsdGeom.Gprim,
    model: mujoco.MjModel,
    piece: Piece,
    materials: dict[tuple[object, ...], UsdShade.Material],
    scope: Usd.Prim,
) -> None:
    """Bind a linear colour as a material shared by bodies of equal colour; a texture is replaced by its mean colour."""
    shown = piece.colour[:3] * (texels(model, piece.picture).mean(axis=(0, 1)) / 255 if piece.picture >= 0 else 1.0)
    colour, opacity = Gf.Vec3f(*linear(shown).tolist()), float(piece.colour[3])
    prim.CreateDisplayColorAttr(Vt.Vec3fArray([colour]))
    if opacity < 1:
        prim.CreateDisplayOpacityAttr(Vt.FloatArray([opacity]))
    look = (*piece.colour.tolist(), piece.gloss, piece.picture)
    if look not in materials:
        stage = scope.GetStage()
        material = UsdShade.Material.Define(stage, scope.GetPath().AppendChild(f"look_{len(materials) + 1}"))
        shader = UsdShade.Shader.Define(stage, material.GetPath().AppendChild("surface"))
        shader.CreateIdAttr("UsdPreviewSurface")
        shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(colour)
        shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(max(0.05, 1 - piece.gloss))
        shader.CreateInput("opacity", Sdf.ValueTypeNames.Float).Set(opacity)
        material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
        materials[look] = material
    UsdShade.MaterialBindingAPI.Apply(prim.GetPrim()).Bind(materials[look])
