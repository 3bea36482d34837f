"""Grasps: a point of one link stays where it took hold of another body, while both may move."""

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
    """A place on a body where it is held: from `start` (3,) in the link's axes [m] at time `first` [s] to `end` at
    `last`, the same but for what keyframes drift.

    slack  [m] how far from it the point may be for nothing, at either end: where a keyframe puts the body out of the
           limb's reach, the nearest place is one for a stretched limb alone, which whips there and back
    """

    first: float
    last: float
    start: Array
    end: Array
    slack: tuple[float, float] = (0.0, 0.0)

    def at(self, t: Array) -> Array:
        """(3, S) at times t (S,)."""
        return self.start[:, None] + (self.end - self.start)[:, None] * self._share(t)

    def slack_at(self, t: Array) -> Array:
        """(S,) [m] at times t (S,)."""
        start, end = self.slack
        return start + (end - start) * self._share(t)

    def _share(self, t: Array) -> Array:
        return (t - self.first) / (self.last - self.first)


@dataclass(frozen=True, eq=False)
class Hold:
    """A point of one link that holds another from `first` to `last` [s].

    link   index of the link that is held;  body  its name
    spots  where on it, one after the other without gaps; none if unknown
    """

    point: Point
    link: int
    body: str
    first: float
    last: float
    spots: tuple[Spot, ...] = ()

    @property
    def name(self) -> str:
        """ "left_hand on crate" """
        return f"{self.point.name} on {self.body}"

    def spot(self, t: Array) -> Array | None:
        """(3, S) where on the link it is held at times t (S,) of the hold [m], or None if unknown."""
        if not self.spots:
            return None
        out = np.empty((3, t.size))
        for spot, during in self._during(t):
            out[:, during] = spot.at(t[during])
        return out

    def slack(self, t: Array) -> Array:
        """(S,) how far [m] from its spot the point may be for nothing at times t (S,) of the hold."""
        out = np.zeros(t.size)
        for spot, during in self._during(t):
            out[during] = spot.slack_at(t[during])
        return out

    def _during(self, t: Array) -> Iterator[tuple[Spot, Mask]]:
        """The spots, and which of the times t (S,) are theirs."""
        which = np.clip(np.searchsorted([spot.last for spot in self.spots], t), 0, len(self.spots) - 1)
        for i, spot in enumerate(self.spots):
            yield spot, which == i


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
