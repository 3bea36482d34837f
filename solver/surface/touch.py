"""Which geoms can touch which: what of a model is solid, and what is bolted together.

Models contain visual geoms (contype = conaffinity = 0) besides colliding ones. If any moving geom collides, only
colliding geoms of the figure are kept clear; if any geom collides, only colliding ones are obstacles. In a model
without colliding geoms all of them are used. Always included are planes of the world, which are floors and walls, and
the clip's floor, step and obstacles, which have a separate bit (`SCENERY`).

A limb that hangs on the world by its joints and is in a static geom at rest is meant to be there: an arm in its socket.
"""

from __future__ import annotations

from functools import lru_cache

import mujoco
import numpy as np

from ..array import Mask

SCENERY = 1 << 30  # the bit of conaffinity that marks what a clip adds to a model
LEVEL = 0.99  # of a plane's normal, how much of it goes up where one stands on it
TOUCHING = 0.001  # [m]
FAR = np.array([-0.5, 0.5])  # [m] that slides without bounds are tried to go


def moves(model: mujoco.MjModel) -> Mask:
    """(ngeom,) the geoms of bodies that joints move."""
    return np.asarray(model.body_weldid[model.geom_bodyid] != 0) & ~_on_mocap(model)


def collides(model: mujoco.MjModel) -> Mask:
    """(ngeom,) the geoms that MuJoCo lets collide with any."""
    out = (model.geom_contype | model.geom_conaffinity) != 0
    out[model.pair_geom1], out[model.pair_geom2] = True, True
    return out


def _on_mocap(model: mujoco.MjModel) -> Mask:
    """(ngeom,) the geoms of bodies that a programme moves: marks, as a rule."""
    mocap = np.asarray(model.body_mocapid >= 0)
    return mocap[model.body_rootid[model.geom_bodyid]]


def is_scenery(model: mujoco.MjModel) -> Mask:
    """(ngeom,) the geoms that a clip has added: floor, step and obstacles."""
    return np.asarray(model.geom_conaffinity & SCENERY) != 0


def counts_all(model: mujoco.MjModel) -> bool:
    """Whether nothing of a model's own collides, so that all of its geoms count, those too that are only to be seen."""
    return not np.any(collides(model) & ~is_scenery(model) & ~_on_mocap(model))


def movers(model: mujoco.MjModel) -> list[int]:
    """The moving geoms that count, those of what a clip adds among them."""
    moving, scenery = moves(model), is_scenery(model)
    figure_geoms = moving & ~scenery
    solid = figure_geoms & collides(model)
    return np.flatnonzero((solid if solid.any() else figure_geoms) | (moving & scenery)).tolist()


def solids(model: mujoco.MjModel) -> list[int]:
    """The static geoms that count."""
    still = ~moves(model) & ~_on_mocap(model)
    if counts_all(model):
        return np.flatnonzero(still).tolist()
    ground = (model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)) & (model.geom_bodyid == 0)
    return np.flatnonzero(still & (collides(model) | ground)).tolist()


def grounds(model: mujoco.MjModel) -> list[int]:
    """The level planes that do not move: floors."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    planes = ~moves(model) & ~_on_mocap(model) & (model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE))
    return np.flatnonzero(planes & (data.geom_xmat[:, 8] > LEVEL)).tolist()


@lru_cache(maxsize=8)
def bolted(model: mujoco.MjModel) -> frozenset[tuple[int, int]]:
    """Pairs of a moving body, the first of those welded together, and a static geom, that are in each other by design.

    A body without a free joint on its way from the world and in a static geom at rest, unless a slide leads it out;
    and a body beside the geoms of the fixed body that it turns on.
    """
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    weld, pairs = model.body_weldid, set()
    fixed = [geom for geom in movers(model) if _hangs(model, int(model.geom_bodyid[geom]))]
    for solid in solids(model):
        under = int(model.geom_bodyid[solid])
        for geom in fixed:
            body = int(weld[model.geom_bodyid[geom]])
            beside = under != 0 and int(model.body_parentid[body]) == under
            if beside or (
                (body, solid) not in pairs
                and _touches(model, data, geom, solid)
                and not _slides_out(model, geom, solid)
            ):
                pairs.add((body, solid))
    return frozenset(pairs)


def _way(model: mujoco.MjModel, body: int) -> list[int]:
    """The joints from a body to the world."""
    joints: list[int] = []
    while body:
        first = int(model.body_jntadr[body])
        joints += range(first, first + int(model.body_jntnum[body]))
        body = int(model.body_parentid[body])
    return joints


def _hangs(model: mujoco.MjModel, body: int) -> bool:
    """Whether a body hangs on the world by its joints."""
    return all(model.jnt_type[joint] != int(mujoco.mjtJoint.mjJNT_FREE) for joint in _way(model, body))


def _touches(model: mujoco.MjModel, data: mujoco.MjData, geom: int, solid: int) -> bool:
    return mujoco.mj_geomDistance(model, data, geom, solid, 2 * TOUCHING, None) < TOUCHING


def _slides_out(model: mujoco.MjModel, geom: int, solid: int) -> bool:
    """Whether a slide takes a moving geom out of one of the world: walkers off the floor, but no cart off its rail."""
    data = mujoco.MjData(model)
    for joint in _way(model, int(model.geom_bodyid[geom])):
        if model.jnt_type[joint] != int(mujoco.mjtJoint.mjJNT_SLIDE):
            continue
        column = int(model.jnt_qposadr[joint])
        ends = model.jnt_range[joint] if model.jnt_limited[joint] else model.qpos0[column] + FAR
        for end in ends:
            data.qpos[:] = model.qpos0
            data.qpos[column] = end
            mujoco.mj_kinematics(model, data)
            if not _touches(model, data, geom, solid):
                return True
    return False
