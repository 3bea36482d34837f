"""Grasps: a point of one link stays where it grasped another body, while both may move."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask
from ..figure.figure import Figure
from ..surface import Surface, moving_surface
from ..surface.points import Point
from ..surface.touch import movers


@dataclass(frozen=True, eq=False)
class Spot:
    """A grasped position on a body, which may drift as keyframes do: `start` (3,) [m] at `first` [s], `end` at `last`.

    slack  [m] distance from the spot without cost, at either end of the interval. If a keyframe puts the body out of
           the limb's reach, only a stretched limb approaches the spot; without slack it would whip to this pose and
           back.
    """

    first: float
    last: float
    start: Array
    end: Array
    slack: tuple[float, float] = (0.0, 0.0)

    def at(self, t: Array) -> Array:
        """Return the position (3, S) in the link's axes at times t (S,)."""
        return self.start[:, None] + (self.end - self.start)[:, None] * self._share(t)

    def slack_at(self, t: Array) -> Array:
        start, end = self.slack
        return start + (end - start) * self._share(t)

    def _share(self, t: Array) -> Array:
        return (t - self.first) / (self.last - self.first)


@dataclass(frozen=True, eq=False)
class Grasp:
    """A grasp of one link by a point of another from `first` to `last` [s].

    link   index of the grasped link;  body  its name
    spots  positions on the link, consecutive without gaps; none if unknown
    position  the specified position (3,) on the link [m], from which keyframes may differ a little; None without one
    """

    point: Point
    link: int
    body: str
    first: float
    last: float
    spots: tuple[Spot, ...] = ()
    position: Array | None = None

    @property
    def name(self) -> str:
        """ "left_hand on crate" """
        return f"{self.point.name} on {self.body}"

    def spot(self, t: Array) -> Array | None:
        """Return the grasped positions (3, S) [m] on the link at times t (S,) of the grasp, None if unknown."""
        if not self.spots:
            return None
        out = np.empty((3, t.size))
        for spot, during in self._during(t):
            out[:, during] = spot.at(t[during])
        return out

    def slack(self, t: Array) -> Array:
        """Return the distances (S,) [m] from the spot without cost, at times t (S,) of the grasp."""
        out = np.zeros(t.size)
        for spot, during in self._during(t):
            out[during] = spot.slack_at(t[during])
        return out

    def _during(self, t: Array) -> Iterator[tuple[Spot, Mask]]:
        """Yield the spots, each with the mask of its times among t (S,)."""
        which = np.searchsorted([spot.last for spot in self.spots[:-1]], t)
        for i, spot in enumerate(self.spots):
            yield spot, which == i


def tree_of(figure: Figure, link: int) -> int:
    """Return the first link of a link's tree: 0 for the world."""
    while figure.links[link].parent:
        link = figure.links[link].parent
    return link


def grasped_links(figure: Figure, grasps: Sequence[Grasp]) -> tuple[int, ...]:
    """Return the links, in order, of trees that are held by a point of another tree and hold nothing."""
    holders = {tree_of(figure, grasp.point.link) for grasp in grasps}
    trees = {tree_of(figure, grasp.link) for grasp in grasps} - holders
    return tuple(i for i in range(1, len(figure.links)) if tree_of(figure, i) in trees)


def surfaces_on(figure: Figure, link: int) -> tuple[Surface, ...]:
    """Return the solid geoms of a link as surfaces in its axes."""
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
