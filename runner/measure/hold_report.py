"""What a report says of a clip's holds: how far hands move on what they hold, and how deep the figure is in it."""

from __future__ import annotations

from typing import Any

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import carried_links, slipped

from ..clip.load import Clip
from ..motion import samples_at
from .penetration import moving_geoms, self_penetration


def hold_rows(clip: Clip, timeline: Timeline, rate: float) -> list[dict[str, Any]]:
    """Every hold that the clip gives: how far its site gets on the body from where it was when it took hold, on a grid
    of so many times a second."""
    out = []
    for hold in clip.context.holds:
        time = np.linspace(hold.first, hold.last, max(3, round((hold.last - hold.first) * rate)))
        track = slipped(samples_at(clip.figure, path_of(timeline), time), hold)
        moved = np.linalg.norm(track - track[:, :1], axis=0)
        told = {"hand": hold.point.name, "body": hold.body, "from, s": hold.first, "to, s": hold.last}
        out.append(told | {"moved, m": float(moved.max()), "at, s": float(time[int(moved.argmax())])})
    return out


def in_carried(clip: Clip, time: Array, qpos: Array) -> dict[str, Any]:
    """The deepest that the figure is in what it carries along qpos (T, nq), by MuJoCo; empty if it holds nothing."""
    model, links = clip.figure.model, carried_links(clip.figure, clip.context.holds)
    if not links:
        return {}
    movers = np.array(moving_geoms(model), np.intp)
    is_carried = np.isin(clip.figure.body_link[model.geom_bodyid[movers]], links)
    pairs = np.array(np.meshgrid(movers[~is_carried], movers[is_carried])).reshape(2, -1)
    deepest, where = self_penetration(model, pairs, time, qpos)
    return {"deepest": deepest, "where": where}
