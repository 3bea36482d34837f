"""Notes on models: their vertical, floor, equality constraints, and the root link of a URDF file.

The solver's vertical is z, and a floor is added where a model has none.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver.figure.figure import WEIGHTLESS, JointKind
from dynsplines.solver.figure.model import boxes, geom_name, kinematics
from dynsplines.solver.surface.touch import collides, grounds, is_scenery, solids
from dynsplines.solver.tolerances import NEGLIGIBLE

from ..errors import list_names
from .compose import PREFIX
from .file_access import elements

TILTED = 0.02  # [1] sine of the angle between gravity and -z from which a note is printed, about 1°


def model_notes(model: mujoco.MjModel) -> list[str]:
    """Return all notes on a model."""
    return [*_unsupported_equalities(model), *vertical_notes(model)]


def vertical_notes(model: mujoco.MjModel) -> list[str]:
    """Return notes on gravity that is not along -z, and on static geoms below a floor that `compose` added."""
    return [*_tilted_gravity(model), *_below_added_floor(model)]


def _unsupported_equalities(model: mujoco.MjModel) -> Iterator[str]:
    """Yield notes on active constraints of tendons, and on those that hold a link to a mocap body."""
    attached, names = (int(mujoco.mjtEq.mjEQ_CONNECT), int(mujoco.mjtEq.mjEQ_WELD)), dict[str, list[str]]()
    for i in np.flatnonzero(model.eq_active0).tolist():
        kind, ends = int(model.eq_type[i]), np.array([model.eq_obj1id[i], model.eq_obj2id[i]])
        name = f"'{model.equality(i).name or i}'"
        bodies = model.site_bodyid[ends] if model.eq_objtype[i] == int(mujoco.mjtObj.mjOBJ_SITE) else ends
        if kind in attached and (model.body_mocapid[bodies] >= 0).any():
            names.setdefault("to mocap bodies, which do not move, are ignored", []).append(name)
        elif kind not in (*attached, int(mujoco.mjtEq.mjEQ_JOINT)):
            names.setdefault("of tendons are not looked at", []).append(name)
    yield from (f"equality constraints {what}: {', '.join(listed_names)}" for what, listed_names in names.items())


def _tilted_gravity(model: mujoco.MjModel) -> Iterator[str]:
    gravity = np.array(model.opt.gravity)
    sideways = float(np.linalg.norm(gravity[:2]))
    if model.opt.disableflags & WEIGHTLESS or (gravity[2] <= 0 and sideways <= TILTED * np.linalg.norm(gravity)):
        return
    axes = ", ".join(f"{axis:g}" for axis in gravity)
    yield (
        f"gravity is [{axes}] m/s², not along -z; floors, heights of feet, headings and the camera assume that z "
        "points up, while forces and flights follow gravity; rotate the model so that z points up"
    )


def _below_added_floor(model: mujoco.MjModel) -> Iterator[str]:
    data = kinematics(model)
    added = [geom for geom in grounds(model) if _is_added(model, geom)]
    others = [
        i for i in solids(model) if model.geom_type[i] != mujoco.mjtGeom.mjGEOM_PLANE and not is_scenery(model)[i]
    ]
    if not added or not others:
        return
    floor = float(data.geom_xpos[added[0], 2])
    centre, reach = boxes(model, data, np.array(others))
    tops = centre[:, 2] + reach[:, 2]
    below = [geom_name(model, geom) for geom, top in zip(others, tops, strict=True) if top < floor - NEGLIGIBLE]
    if below:
        yield (
            f"the model has no level plane, so a floor was added at z = {floor:g} m, above {list_names(below)}; for "
            'another height, add it to the model: <geom type="plane" size="0 0 1" pos="0 0 HEIGHT"/>'
        )


def _is_added(model: mujoco.MjModel, geom: int) -> bool:
    """Return whether a level plane is the floor of the stage, which does not collide in MuJoCo."""
    material = int(model.geom_matid[geom])
    is_staged = material >= 0 and model.material(material).name == PREFIX + "floor"
    return is_staged and model.geom(geom).name in ("floor", PREFIX + "floor") and not collides(model)[geom]


def fixed_base(figure: str, model: mujoco.MjModel) -> str:
    """Return a line if the file's root link is fixed in the world, with advice to free it; "" for any other model."""
    path = Path(figure)
    if path.suffix.lower() != ".urdf" or (model.jnt_type == JointKind.FREE).any():
        return ""
    root = _root_link(path.read_text(encoding="utf-8-sig", errors="replace"))
    return (
        f"the root link '{root}' is fixed in the world; to let it move add to the URDF: <link name=\"world\"/> "
        f'<joint name="root" type="floating"><parent link="world"/><child link="{root}"/></joint>'
    )


def _root_link(text: str) -> str:
    links = list(elements(text))
    children = {attributes.get("link") for tag, attributes in links if tag == "child"}
    return next(
        (attributes["name"] for tag, attributes in links if tag == "link" and attributes.get("name") not in children),
        "",
    )
