"""Materials for a model without any: a grid on the floor, and alternating light and dark limbs, which show bends."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.surface.touch import grounds, moves

from .mujoco_versions import geoms_by_number

GREY = (0.5, 0.5, 0.5, 1.0)  # MuJoCo's default colour of a geom
HIDDEN = 3  # first group of geoms that is not drawn


def dress(spec: mujoco.MjSpec, bare: mujoco.MjModel, prefix: str) -> None:
    """Assign the stage's materials to the geoms that have neither a colour nor a material.

    Args:
        bare: The figure compiled without the stage.
        prefix: The prefix of the stage's names.
    """
    floors, moving, depth = set(grounds(bare)), moves(bare), _depths(bare)
    for index, geom in enumerate(geoms_by_number(spec)):
        if geom.material or not np.allclose(geom.rgba, GREY) or bare.geom_group[index] >= HIDDEN:
            continue
        if index in floors:
            geom.material = prefix + "floor"
        elif moving[index]:
            geom.material = prefix + ("dark" if depth[bare.geom_bodyid[index]] % 2 else "light")
        elif bare.geom_type[index] != int(mujoco.mjtGeom.mjGEOM_PLANE):
            geom.material = prefix + "step"


def _depths(model: mujoco.MjModel) -> list[int]:
    """Return the number of moving bodies on the chain from the world to each body, 0 for static ones."""
    depth = [0] * model.nbody
    for body in range(1, model.nbody):
        depth[body] = depth[model.body_parentid[body]] + int(model.body_jntnum[body] > 0)
    return depth
