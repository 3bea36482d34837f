"""The solid geoms of a model, and the pairs of geoms that overlap by design.

Models contain visual geoms (contype = conaffinity = 0) besides colliding ones. If any moving geom collides, only the
figure's colliding geoms count. If any geom collides, only colliding ones are obstacles. In a model without colliding
geoms all of them count. Two kinds always count: planes of the world, which are floors and walls, and the floor, step
and obstacles that a clip adds, which have a separate bit (`SCENERY`).

Mocap bodies do not move. Their geoms are obstacles if they collide; others are markers. Those that an equality
constraint attaches to the figure are handles, which drag it in a simulation, and never count.

A limb that its joints attach to the world, and that overlaps a static geom at rest, overlaps by design: an arm in its
socket.
"""

from __future__ import annotations

from functools import lru_cache

import mujoco
import numpy as np

from ..array import Mask
from ..figure.figure import JointKind
from ..figure.model import kinematics
from ..tolerances import NEGLIGIBLE

SCENERY = 1 << 30  # bit of conaffinity that marks geoms which a clip adds to a model
LEVEL = 0.99  # [1] minimum z of the unit normal of a floor
SITE = int(mujoco.mjtObj.mjOBJ_SITE)

FAR = np.array([-0.5, 0.5])  # [m] displacements tried for slides without bounds


def moves(model: mujoco.MjModel) -> Mask:
    """Return which geoms are of bodies that joints move, (ngeom,)."""
    return np.asarray(model.body_weldid[model.geom_bodyid] != 0) & ~_on_mocap(model)


def collides(model: mujoco.MjModel) -> Mask:
    """Return which geoms can collide in MuJoCo, (ngeom,)."""
    out = (model.geom_contype | model.geom_conaffinity) != 0
    out[model.pair_geom1], out[model.pair_geom2] = True, True
    return out


def _on_mocap(model: mujoco.MjModel) -> Mask:
    """Return which geoms are of mocap bodies and bodies welded to them, (ngeom,)."""
    return np.asarray(model.body_mocapid[model.body_weldid[model.geom_bodyid]] >= 0)


def _attach(model: mujoco.MjModel) -> Mask:
    """Return which geoms are of bodies that an equality constraint connects or welds to another body, (ngeom,)."""
    attached = np.zeros(model.nbody, bool)
    for kind in (mujoco.mjtEq.mjEQ_CONNECT, mujoco.mjtEq.mjEQ_WELD):
        rows = np.flatnonzero(model.eq_type == int(kind))
        ids, of_sites = np.stack([model.eq_obj1id[rows], model.eq_obj2id[rows]]), model.eq_objtype[rows] == SITE
        attached[model.body_weldid[ids[:, ~of_sites]]] = True
        attached[model.body_weldid[model.site_bodyid[ids[:, of_sites]]]] = True
    return attached[model.body_weldid[model.geom_bodyid]]


def is_scenery(model: mujoco.MjModel) -> Mask:
    """Return which geoms a clip has added: floor, step and obstacles, (ngeom,)."""
    return np.asarray(model.geom_conaffinity & SCENERY) != 0


def counts_all(model: mujoco.MjModel) -> bool:
    """Return whether no geom of the model itself collides, so that all of its geoms count, including visual ones."""
    return not np.any(collides(model) & ~is_scenery(model) & ~_on_mocap(model))


def movers(model: mujoco.MjModel) -> list[int]:
    """Return the moving geoms that count, including those that a clip adds."""
    moving, scenery = moves(model), is_scenery(model)
    figure_geoms = moving & ~scenery
    solid = figure_geoms & collides(model)
    return np.flatnonzero((solid if solid.any() else figure_geoms) | (moving & scenery)).tolist()


def can_collide(model: mujoco.MjModel) -> Mask:
    """Return which pairs of geoms collide by the masks, <exclude> and <pair> of the model, (ngeom, ngeom); all pairs if
    all geoms count."""
    if counts_all(model):
        return np.ones((model.ngeom,) * 2, bool)
    reached = (model.geom_contype[:, None] & model.geom_conaffinity) != 0
    bodies = np.sort(np.stack(np.broadcast_arrays(model.geom_bodyid[:, None], model.geom_bodyid)), axis=0)
    out = (reached | reached.T) & ~np.isin((bodies[0] << 16) + bodies[1], model.exclude_signature)
    out[model.pair_geom1, model.pair_geom2] = out[model.pair_geom2, model.pair_geom1] = True
    return np.asarray(out)


def solids(model: mujoco.MjModel) -> list[int]:
    """Return the static geoms that count."""
    still = ~moves(model) & ~(_on_mocap(model) & (~collides(model) | _attach(model)))
    if counts_all(model):
        return np.flatnonzero(still).tolist()
    ground = (model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)) & (model.geom_bodyid == 0)
    return np.flatnonzero(still & (collides(model) | ground)).tolist()


def grounds(model: mujoco.MjModel) -> list[int]:
    """Return the static level planes, which are floors."""
    data = kinematics(model)
    planes = ~moves(model) & ~_on_mocap(model) & (model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE))
    return np.flatnonzero(planes & (data.geom_xmat[:, 8] > LEVEL)).tolist()


@lru_cache(maxsize=8)
def overlapping_pairs(model: mujoco.MjModel) -> frozenset[tuple[int, int]]:
    """Return pairs of a moving body (the first of those welded together) and a static geom that overlap by design.

    These are bodies without a free joint on their chain to the world that touch a static geom at rest, unless a slide
    separates them. Also included are bodies with the geoms of the fixed body on which they turn. Of obstacles that a
    clip adds, only bodies next to the fixed one count: an arm may stand on a table, but a hand at rest on it may leave.
    """
    data = kinematics(model)
    weld, pairs = model.body_weldid, set()
    obstacle = is_scenery(model) & (model.geom_type != int(mujoco.mjtGeom.mjGEOM_PLANE))
    fixed = [geom for geom in movers(model) if _hangs(model, int(model.geom_bodyid[geom]))]
    for solid in solids(model):
        under = int(model.geom_bodyid[solid])
        for geom in fixed:
            body = int(weld[model.geom_bodyid[geom]])
            beside = under != 0 and int(model.body_parentid[body]) == under
            is_first = weld[model.body_parentid[body]] == 0
            if beside or (
                (body, solid) not in pairs
                and (is_first or not obstacle[solid])
                and _touches(model, data, geom, solid)
                and not _slides_out(model, geom, solid)
            ):
                pairs.add((body, solid))
    return frozenset(pairs)


def _joints_to_world(model: mujoco.MjModel, body: int) -> list[int]:
    """Return the joints from a body to the world."""
    joints: list[int] = []
    while body:
        first = int(model.body_jntadr[body])
        joints += range(first, first + int(model.body_jntnum[body]))
        body = int(model.body_parentid[body])
    return joints


def _hangs(model: mujoco.MjModel, body: int) -> bool:
    """Return whether no free joint is between a body and the world."""
    return all(model.jnt_type[joint] != JointKind.FREE for joint in _joints_to_world(model, body))


def _touches(model: mujoco.MjModel, data: mujoco.MjData, geom: int, solid: int) -> bool:
    return mujoco.mj_geomDistance(model, data, geom, solid, 2 * NEGLIGIBLE, None) < NEGLIGIBLE


def _slides_out(model: mujoco.MjModel, geom: int, solid: int) -> bool:
    """Return whether a slide separates a moving geom from a static one: a walker's from the floor, no cart from its
    rail."""
    data = mujoco.MjData(model)
    for joint in _joints_to_world(model, int(model.geom_bodyid[geom])):
        if model.jnt_type[joint] != JointKind.SLIDE:
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
