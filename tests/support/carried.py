"""How deep a figure is in what it carries, by MuJoCo."""

from __future__ import annotations

from typing import Any

import numpy as np
from paper.penetration import self_penetration

from dynsplines.clip.build import Clip
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import grasped_links
from dynsplines.solver.surface.touch import movers


def in_carried(clip: Clip, time: Array, qpos: Array) -> dict[str, Any]:
    """The deepest along qpos (T, nq), and where; empty if it holds nothing."""
    model, links = clip.figure.model, grasped_links(clip.figure, clip.context.schedule.grasps)
    if not links:
        return {}
    geoms = np.array(movers(model), np.intp)
    is_carried = np.isin(clip.figure.body_link[model.geom_bodyid[geoms]], links)
    pairs = np.array(np.meshgrid(geoms[~is_carried], geoms[is_carried])).reshape(2, -1)
    deepest, where = self_penetration(model, pairs, time, qpos)
    return {"deepest": deepest, "where": where}
