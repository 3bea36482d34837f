"""Names of joints and geoms, also of those without a name in the model."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import mujoco


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
    return _completed(model_names, bodies, "_", "joint")


def geom_name(model: mujoco.MjModel, geom: int) -> str:
    """Return a geom's name.

    An unnamed geom has the name of its body, numbered if the body has several unnamed geoms. An unnamed geom of the
    world is called "geom 3" by its index.
    """
    return _geom_names(model)[geom]


@lru_cache(maxsize=8)
def _geom_names(model: mujoco.MjModel) -> list[str]:
    bodies = [(model.body(i).name if i else "", int(model.body_geomnum[i])) for i in range(model.nbody)]
    return _completed([model.geom(i).name for i in range(model.ngeom)], bodies, " ", "geom")


def _completed(model_names: Sequence[str], bodies: Sequence[tuple[str, int]], separator: str, kind: str) -> list[str]:
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
