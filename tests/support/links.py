"""Links of a figure by the names of their joints and bodies."""

from __future__ import annotations

import mujoco

from dynsplines.solver.figure.figure import Figure


def link_named(figure: Figure, name: str) -> int | None:
    """The index of the link that a joint or a body of this name moves, or None."""
    by_joint = next((i for i, link in enumerate(figure.links) if i and link.name == name), None)
    body = mujoco.mj_name2id(figure.model, mujoco.mjtObj.mjOBJ_BODY, name)
    return int(figure.body_link[body]) if by_joint is None and body > 0 else by_joint
