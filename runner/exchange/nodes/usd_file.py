"""The nodes of a USD file: joints of an animated skeleton, else the transforms that move.

A skeleton's rest pose is the one to which its mesh is bound. Up axis and unit are those of the stage. References to
other files are refused. https://openusd.org/release/api/usd_skel_page_front.html
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Sdf, Tf, Usd, UsdGeom, UsdSkel

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError, words_of
from ...system import size_limit
from .. import gaps
from ..skeleton.bvh_file import Skeleton
from .node_tree import Nodes, moving_tree

REST = "rest"  # in custom data of prims written by this program: translation and rotation wxyz in the rest pose


def read(path: Path, fps: float | None, scale: float | None) -> Skeleton:
    """Return the skeleton of the moving parts of a stage, y up.

    fps [1/s] to resample, else the stage's rate; scale [m], the unit if the user names it, else lengths become metres.
    Raises UserError for a stage without motion, or with references to other files.
    """
    try:
        stage = _stage(path)
        nodes = _nodes(stage, path, fps)
    except Tf.ErrorException as error:
        raise UserError(f"{path}: not a readable USD file: {words_of(error)[:200]}") from None
    unit = UsdGeom.GetStageMetersPerUnit(stage) if scale is None else 1.0
    for matrices in (nodes.rest, nodes.moving):
        if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z:
            matrices[..., :3, :] = np.roll(matrices[..., :3, :], -1, axis=-2)
        matrices[..., :3, 3] *= unit
    return nodes.skeleton()


def _stage(path: Path) -> Usd.Stage:
    layer = Sdf.Layer.FindOrOpen(str(path))
    if layer is None:
        raise UserError(f"{path}: not a readable USD file")
    others = layer.GetCompositionAssetDependencies()
    if others:
        raise UserError(f"{path}: it refers to another file, '{others[0]}'; flatten it to one file")
    stage = Usd.Stage.Open(layer)
    if stage is None:
        raise UserError(f"{path}: not a readable USD file")
    return stage


def _nodes(stage: Usd.Stage, path: Path, fps: float | None) -> Nodes:
    """Return the moving nodes at equal time steps."""
    queries = [query for query in _skeletons(stage) if query.GetAnimQuery()]
    if queries:
        query = max(queries, key=lambda each: len(each.GetJointOrder()))
        codes = query.GetAnimQuery().GetJointTransformTimeSamples()
        times, rate = _times(stage, path, codes, fps, len(query.GetJointOrder()))
        note = f"read the skeleton {query.GetPrim().GetPath()}, the largest of {len(queries)}"
        return replace(_of_skeleton(query, times, rate), notes=(note,) if len(queries) > 1 else ())
    prims = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Xformable) and not prim.IsA(UsdGeom.Gprim)]
    animated = [len(UsdGeom.Xformable(prim).GetTimeSamples()) >= gaps.FEWEST for prim in prims]
    codes = sorted({code for prim in prims for code in UsdGeom.Xformable(prim).GetTimeSamples()})
    times, rate = _times(stage, path, codes, fps, len(prims))
    place = {prim.GetPath(): i for i, prim in enumerate(prims)}
    parents = [place.get(prim.GetPath().GetParentPath(), -1) for prim in prims]
    rows, parents = moving_tree(parents, animated)
    return _of_prims([prims[i] for i in rows], parents, times, rate)


def _skeletons(stage: Usd.Stage) -> list[Any]:
    """Return queries of the skeletons, with the animations bound to them."""
    cache, prims = UsdSkel.Cache(), list(stage.Traverse())
    for prim in prims:
        if prim.IsA(UsdSkel.Root):
            cache.Populate(UsdSkel.Root(prim), Usd.TraverseInstanceProxies())
    queries = [cache.GetSkelQuery(UsdSkel.Skeleton(prim)) for prim in prims if prim.IsA(UsdSkel.Skeleton)]
    return [query for query in queries if query]


def _times(
    stage: Usd.Stage, path: Path, codes: list[float], fps: float | None, nodes: int
) -> tuple[list[float], float]:
    """Return equally spaced time codes, and their rate [1/s]."""
    if len(codes) < gaps.FEWEST:
        raise UserError(f"{path}: nothing moves on its stage")
    a_second = stage.GetTimeCodesPerSecond()
    rate = fps or a_second / float(np.median(np.diff(codes)))
    count = int((codes[-1] - codes[0]) / a_second * rate + 1e-6) + 1
    size_limit.check(path, 8 * 16 * count * nodes, "its motion")
    return [codes[0] + i * a_second / rate for i in range(count)], rate


def _of_skeleton(query: Any, times: list[float], rate: float) -> Nodes:
    names = [Sdf.Path(joint).name for joint in query.GetJointOrder()]
    parents = list(query.GetTopology().GetParentIndices())
    prim = query.GetPrim()
    moving = [
        _matrices(query.ComputeJointSkelTransforms(Usd.TimeCode(code)))
        @ _matrix(UsdGeom.XformCache(Usd.TimeCode(code)).GetLocalToWorldTransform(prim)).T
        for code in times
    ]
    bound = query.GetJointWorldBindTransforms()
    rest = _matrices(bound) if len(bound) == len(names) else moving[0]
    rows, parents = moving_tree(parents, [True] * len(parents))
    names, rest, moving = [names[i] for i in rows], rest[rows], [matrices[rows] for matrices in moving]
    return Nodes(names, parents, np.swapaxes(rest, -1, -2), np.swapaxes(np.array(moving), -1, -2), rate)


def _of_prims(prims: list[Usd.Prim], above: list[int], times: list[float], rate: float) -> Nodes:
    moving = np.empty((len(times), len(prims), 4, 4))
    for row, code in enumerate(times):
        cache = UsdGeom.XformCache(Usd.TimeCode(code))
        for i, prim in enumerate(prims):
            moving[row, i] = _matrix(cache.GetLocalToWorldTransform(prim))
    rest = np.empty(moving.shape[1:])
    for i, prim in enumerate(prims):
        local = _rest_of(prim)
        over = np.eye(4) if above[i] < 0 else rest[above[i]]
        if local is None:
            first = np.eye(4) if above[i] < 0 else moving[0, above[i]]
            local = np.linalg.inv(first) @ moving[0, i]
        rest[i] = over @ local
    return Nodes([prim.GetDisplayName() or prim.GetName() for prim in prims], above, rest, moving, rate)


def _rest_of(prim: Usd.Prim) -> Array | None:
    """Return the rest matrix (4, 4), in its parent's axes, of a prim that this program wrote."""
    stored = prim.GetCustomDataByKey(REST)
    if stored is None or len(stored) != 7:
        return None
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = quat.matrices(np.array(stored[3:], float)), stored[:3]
    return out


def _matrix(matrix: Any) -> Array:
    """Return a matrix (4, 4) for column vectors; the library's are for row vectors."""
    return np.array(matrix, float).T


def _matrices(values: Any) -> Array:
    """Return matrices (J, 4, 4) for row vectors, as in the library."""
    return np.array(values, float).reshape(-1, 4, 4)
