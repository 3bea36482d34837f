"""MuJoCo's model: names of joints and geoms, kinematics of single configurations, and bounding boxes of geoms."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import mujoco
import numpy as np

from ..array import Array, Index


def joint_names(model: mujoco.MjModel) -> list[str]:
    """Return the names of all joints: the joint's, else its body's; `body_1` and so on for several unnamed ones.

    If that name is already used, the joint is named by its number.
    """
    bodies = [(model.body(i).name, int(model.body_jntnum[i])) for i in range(model.nbody)]
    return names_of_joints([model.joint(i).name for i in range(model.njnt)], bodies)


def names_of_joints(model_names: Sequence[str], bodies: Sequence[tuple[str, int]]) -> list[str]:
    """Return unique names of joints.

    Args:
        model_names: The joints' names in the model, "" for none.
        bodies: Each body's name and number of joints, in order.
    """
    return _complete(model_names, bodies, "_", "joint")


def geom_name(model: mujoco.MjModel, geom: int) -> str:
    """Return a geom's name.

    An unnamed geom has the name of its body, numbered if the body has several unnamed geoms. An unnamed geom of the
    world is called "geom 3" by its index.
    """
    return _geom_names(model)[geom]


@lru_cache(maxsize=8)
def _geom_names(model: mujoco.MjModel) -> list[str]:
    bodies = [(model.body(i).name if i else "", int(model.body_geomnum[i])) for i in range(model.nbody)]
    return _complete([model.geom(i).name for i in range(model.ngeom)], bodies, " ", "geom")


def _complete(model_names: Sequence[str], bodies: Sequence[tuple[str, int]], separator: str, kind: str) -> list[str]:
    """Return unique names of the joints or geoms of bodies; a separator precedes their numbers."""
    names, used, first = list(model_names), set(model_names), 0
    for called, count in bodies:
        nameless = [i for i in range(first, first + count) if not names[i]]
        first += count
        for number, index in enumerate(nameless, start=1):
            name = called if len(nameless) == 1 else f"{called}{separator}{number}"
            names[index] = name if called and name not in used else f"{kind} {index}"
            used.add(names[index])
    return names


def kinematics(model: mujoco.MjModel, qpos: Array | None = None) -> mujoco.MjData:
    """Return the positions of bodies, geoms and sites in a configuration (nq,), by default at rest."""
    data = mujoco.MjData(model)
    set_qpos(model, data, model.qpos0 if qpos is None else qpos)
    return data


def set_qpos(model: mujoco.MjModel, data: mujoco.MjData, qpos: Array) -> None:
    """Compute the same in existing data, together with what Jacobians and collisions need."""
    data.qpos[:] = qpos
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)


def boxes(model: mujoco.MjModel, data: mujoco.MjData, geoms: Index) -> tuple[Array, Array]:
    """Return the centres and half the extents of the bounding boxes of geoms, along the world's axes, (n, 3) [m]."""
    middle, half = np.split(model.geom_aabb[geoms], 2, axis=1)
    turn = data.geom_xmat[geoms].reshape(-1, 3, 3)
    centre = data.geom_xpos[geoms] + np.einsum("nij,nj->ni", turn, middle)
    return centre, np.einsum("nij,nj->ni", np.abs(turn), half)
