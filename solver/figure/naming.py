"""Names of geoms in messages: their names, or for unnamed ones those of their bodies."""

from __future__ import annotations

from functools import lru_cache

import mujoco


def geom_name(model: mujoco.MjModel, geom: int) -> str:
    """A geom's name; without one that of its body, counted where that has several such; of the world's own "geom 3"."""
    return _names(model)[geom]


@lru_cache(maxsize=8)
def _names(model: mujoco.MjModel) -> tuple[str, ...]:
    """The names of all geoms, each once."""
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
    """The name of the body of a geom; none for the world."""
    body = int(model.geom_bodyid[geom])
    return str(model.body(body).name) if body else ""
