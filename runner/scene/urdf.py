"""URDF, which MuJoCo reads as well as MJCF: its root link."""

from __future__ import annotations

from pathlib import Path

import mujoco

from dynsplines.solver.figure.figure import JointKind

from .model_files import elements

ENDING = ".urdf"


def fixed_base(figure: str, model: mujoco.MjModel) -> str:
    """Return a line if the file's root link is fixed in the world, with advice to free it; "" for any other model."""
    path = Path(figure)
    if path.suffix.lower() != ENDING or (model.jnt_type == JointKind.FREE).any():
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
