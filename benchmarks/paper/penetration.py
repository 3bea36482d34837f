"""How deep a motion's geoms are in the scene, judged by MuJoCo's own geometry (`mj_geomDistance`), not by the solver's.

Most geoms are far from everything at most times; a bound from bounding spheres picks the pairs that are worth asking.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.model import geom_name
from dynsplines.solver.surface import touch

NEAR = 0.02  # [m] up to which MuJoCo looks for the distance of two geoms


@dataclass(frozen=True)
class Penetration:
    """Per moving geom: the deepest penetration [m] (0 if it never touches), when [s] and into what.

    over_time  (T,) the deepest penetration of any geom [m]
    """

    names: tuple[str, ...]
    depth: Array
    time: Array
    into: tuple[str, ...]
    over_time: Array

    @property
    def deepest(self) -> float:
        """[m] over all geoms."""
        return float(self.depth.max(initial=0.0))

    def worst(self) -> str:
        """The deepest one in words."""
        if not self.names or self.deepest == 0:
            return "nothing"
        i = int(np.argmax(self.depth))
        return f"{self.names[i]} in {self.into[i]} at {self.time[i]:.3f} s"


def penetration(model: mujoco.MjModel, time: Array, qpos: Array) -> Penetration:
    """The deepest penetration of every moving geom in every static one along qpos (T, nq), but for what is bolted."""
    data = mujoco.MjData(model)
    movers, solids = np.array(touch.movers(model), int), touch.solids(model)
    depth, when = np.zeros(movers.size), np.full(movers.size, time[0])
    into = [""] * movers.size
    over_time = np.zeros(time.size)
    reach = model.geom_rbound[movers]
    body = model.body_weldid[model.geom_bodyid[movers]]
    apart = {
        solid: np.array([(int(b), solid) not in touch.overlapping_pairs(model) for b in body], bool) for solid in solids
    }
    for i, q in enumerate(qpos):
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        for solid in solids:
            gap = _gap(model, data, solid, data.geom_xpos[movers]) - reach
            for k in np.flatnonzero((gap < 0) & apart[solid]):
                distance = mujoco.mj_geomDistance(model, data, int(movers[k]), solid, NEAR, None)
                over_time[i] = max(over_time[i], -distance)
                if -distance > depth[k]:
                    depth[k], when[k], into[k] = -distance, time[i], geom_name(model, solid)
    names = tuple(geom_name(model, int(g)) for g in movers)
    return Penetration(names, depth, when, tuple(into), over_time)


def self_penetration(model: mujoco.MjModel, pairs: Index, time: Array, qpos: Array) -> tuple[float, str]:
    """The deepest penetration [m] of pairs of moving geoms (2, g) in each other along qpos (T, nq), and where."""
    data = mujoco.MjData(model)
    reach = model.geom_rbound[pairs].sum(axis=0)
    deepest, where = 0.0, "nothing"
    for t, q in zip(time, qpos, strict=True):
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        apart = data.geom_xpos[pairs[0]] - data.geom_xpos[pairs[1]]
        for k in np.flatnonzero(np.einsum("ij,ij->i", apart, apart) < np.maximum(reach - deepest, 0) ** 2):
            first, last = int(pairs[0, k]), int(pairs[1, k])
            depth = -mujoco.mj_geomDistance(model, data, first, last, NEAR, None)
            if depth > deepest:
                deepest, where = depth, f"{geom_name(model, first)} in {geom_name(model, last)} at {t:.3f} s"
    return deepest, where


def _gap(model: mujoco.MjModel, data: mujoco.MjData, solid: int, points: Array) -> Array:
    """Distance of points (n, 3) from a plane, negative inside its half space, or a geom's own box, 0 inside it."""
    local = (points - data.geom_xpos[solid]) @ data.geom_xmat[solid].reshape(3, 3)
    if model.geom_type[solid] == mujoco.mjtGeom.mjGEOM_PLANE:
        return local[:, 2]
    middle, half = np.split(model.geom_aabb[solid], 2)
    return np.linalg.norm(np.maximum(np.abs(local - middle) - half, 0), axis=1)
