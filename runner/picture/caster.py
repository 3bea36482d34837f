"""Rays cast into a model: by `mujoco.batch`, or one origin at a time by a MuJoCo that is older than 4.

What `mj_multiRay` lacks beside a batch, it is asked for in another way. Normals: two more rays beside each one meet the
same geom, and three points tell its plane. Shadows, whose rays have an origin each: they are cast from the light,
which for a directional one is far off, and reach a point unless they meet something before it.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Ints = NDArray[np.int32]
Bools = NDArray[np.bool_]

VISIBLE_GROUPS = np.array([1, 1, 1, 0, 0, 0], np.uint8)  # what MuJoCo's own renderer shows unless told otherwise
_ASIDE = 1e-5  # [rad] between a ray and those that tell the normal: far over rounding, far under any roundness
_FAR = 1e4  # [m] at which a directional light is put: over 10 m its rays are parallel to 1 mm a metre
_SLACK = 1e-6  # [m] by which rounding from so far off may miss a point


class Cast(NamedTuple):
    """What n rays met: distance (n,) [m], negative for nothing; geom (n,), -1; unit normal (n, 3) of any side."""

    distance: Array
    geom: Ints
    normal: Array


class Caster(Protocol):
    """A model in a pose that rays are cast into. No two threads may use one at once."""

    def pose(self, qpos: Array) -> None: ...

    def cast(self, origin: Array, directions: Array, *, static: bool) -> Cast:
        """Rays from one point (3,) in unit directions (n, 3); static: they meet what is fixed to the world, too."""
        ...

    def blocked(self, start: Array, towards: Array, reach: Array, *, static: bool) -> Bools:
        """(n,) whether anything is in the way from points (n, 3) in directions (n, 3) as far as `reach` (n,) [m]."""
        ...


def caster(model: mujoco.MjModel) -> Caster:
    """The faster one that there is."""
    return Batched(model) if has_batch() else Single(model)


def has_batch() -> bool:
    """Whether this MuJoCo casts rays with an origin each."""
    try:
        import mujoco.batch  # noqa: F401
    except ImportError:
        return False
    return True


class Batched:
    """By `mujoco.batch`."""

    def __init__(self, model: mujoco.MjModel) -> None:
        from mujoco import batch

        self._batch: Any = batch.Batch(model, nsim=1, nthread=1)

    def pose(self, qpos: Array) -> None:
        self._batch.qpos = qpos

    def cast(self, origin: Array, directions: Array, *, static: bool) -> Cast:
        found = self._batch.ray(origin, directions, geomgroup=VISIBLE_GROUPS, flg_static=static, normal=True)
        return Cast(*(part[0] for part in found))

    def blocked(self, start: Array, towards: Array, reach: Array, *, static: bool) -> Bools:
        distance = self._batch.ray(start, towards, geomgroup=VISIBLE_GROUPS, flg_static=static)[0][0]
        return (distance >= 0) & (distance < reach)


class Single:
    """By `mj_multiRay`, all rays from one point."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model, self._data = model, mujoco.MjData(model)
        self.pose(model.qpos0)

    def pose(self, qpos: Array) -> None:
        self._data.qpos[:] = qpos
        mujoco.mj_kinematics(self._model, self._data)

    def cast(self, origin: Array, directions: Array, *, static: bool) -> Cast:
        distance, geom = self._rays(origin, directions, static)
        normal = np.zeros_like(directions)
        met = np.flatnonzero(geom >= 0)
        normal[met] = self._normals(origin, directions[met], distance[met], geom[met], static)
        return Cast(distance, geom, normal)

    def _normals(self, origin: Array, along: Array, distance: Array, geom: Ints, static: bool) -> Array:
        """(n, 3) from the plane through three points; where a ray beside it misses the geom, the one opposite."""
        across = np.cross(along, np.eye(3)[np.argmin(np.abs(along), axis=1)])
        across = np.asarray(across / np.linalg.norm(across, axis=1)[:, None], float)
        sides = []
        for aside in (across, np.cross(along, across)):
            edge = np.zeros_like(along)
            left = np.ones(len(along), bool)
            for sign in (_ASIDE, -_ASIDE):
                which = np.flatnonzero(left)
                beside = along[which] + sign * aside[which]
                far, other = self._rays(origin, beside, static)
                same = other == geom[which]
                met = which[same]
                edge[met] = (far[same, None] * beside[same] - distance[met, None] * along[met]) / sign
                left[met] = False
            edge[left] = aside[left]  # thinner than a ray: it faces the eye
            sides.append(edge)
        normal = np.cross(sides[0], sides[1])
        return normal / np.maximum(np.linalg.norm(normal, axis=1), np.finfo(float).tiny)[:, None]

    def blocked(self, start: Array, towards: Array, reach: Array, *, static: bool) -> Bools:
        if not len(start):
            return np.zeros(0, bool)
        near = np.isfinite(reach)
        light = start[0] + towards[0] * (reach[0] if near[0] else _FAR)
        rays = start - light
        length = np.linalg.norm(rays, axis=1)
        distance, _ = self._rays(light, rays / length[:, None], static)
        return (distance >= 0) & (distance < length - _SLACK)

    def _rays(self, origin: Array, directions: Array, static: bool) -> tuple[Array, Ints]:
        """Distances (n,) [m] and geoms (n,) of rays from one point; -1 for nothing."""
        count = len(directions)
        geom, distance = np.full(count, -1, np.int32), np.full(count, -1.0)
        if count:
            rays = {"pnt": origin, "vec": np.ascontiguousarray(directions).ravel(), "geomgroup": VISIBLE_GROUPS}
            out = {"geomid": geom, "dist": distance, "nray": count, "cutoff": mujoco.mjMAXVAL}
            if "normal" in (mujoco.mj_multiRay.__doc__ or ""):  # since 3.5
                out["normal"] = None
            mujoco.mj_multiRay(m=self._model, d=self._data, flg_static=static, bodyexclude=-1, **rays, **out)
        return distance, geom
