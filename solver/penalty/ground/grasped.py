"""What is carried: the links of another tree that a figure holds, and their geoms as surfaces that move with them.

A figure stays out of what it carries as out of a wall (`Contact`, with a carrier), and pushes it away as much.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ... import quaternion as quat
from ...figure.figure import Figure
from ...surface import Surface, moving_surface
from ...surface.touch import movers
from .hold import Hold


def tree_of(figure: Figure, link: int) -> int:
    """The link that a link's tree begins with: 0 for the world."""
    while figure.links[link].parent:
        link = figure.links[link].parent
    return link


def grasped_links(figure: Figure, holds: Sequence[Hold]) -> tuple[int, ...]:
    """The links, rising, of the trees that are held by a point of another one and hold nothing themselves."""
    holders = {tree_of(figure, hold.point.link) for hold in holds}
    trees = {tree_of(figure, hold.link) for hold in holds} - holders
    return tuple(i for i in range(1, len(figure.links)) if tree_of(figure, i) in trees)


def surfaces_on(figure: Figure, link: int) -> tuple[Surface, ...]:
    """The solid geoms of a link as surfaces in its axes."""
    surfaces: list[Surface] = []
    for geom in movers(figure.model):
        body = int(figure.model.geom_bodyid[geom])
        if figure.body_link[body] != link:
            continue
        _, centre = figure.point_on_link(body, figure.model.geom_pos[geom])
        turn = quat.product(figure.body_turn[body], figure.model.geom_quat[geom])
        surface = moving_surface(figure.model, geom, np.asarray(centre), quat.matrices(turn))
        if surface is not None:
            surfaces.append(surface)
    return tuple(surfaces)
