"""Names of geoms in messages."""

from __future__ import annotations

from functools import lru_cache

import mujoco


def geom_name(model: mujoco.MjModel, geom: int) -> str:
    """Return a geom's name.

    An unnamed geom has the name of its body, numbered if the body has several unnamed geoms. An unnamed geom of the
    world is called "geom 3" by its index.
    """
    return _names(model)[geom]


@lru_cache(maxsize=8)
def _names(model: mujoco.MjModel) -> tuple[str, ...]:
    names = [str(model.geom(geom).name) for geom in range(model.ngeom)]
    nameless: dict[str, list[int]] = {}
    for geom in range(model.ngeom):
        if not names[geom]:
            nameless.setdefault(_of_body(model, geom), []).append(geom)
    used = set(names)
    for body, geoms in nameless.items():
        for number, geom in enumerate(geoms, start=1):
            name = body if len(geoms) == 1 else f"{body} {number}"
            names[geom] = name if body and name not in used else f"geom {geom}"
            used.add(names[geom])
    return tuple(names)


def _of_body(model: mujoco.MjModel, geom: int) -> str:
    body = int(model.geom_bodyid[geom])
    return str(model.body(body).name) if body else ""
