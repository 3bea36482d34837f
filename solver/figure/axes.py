"""What each coordinate of a figure does to its links, as a function of time: axes that they turn about or shift along.

A coordinate that grows by φ(t) turns all that is beyond its joint by φ w about the anchor a, or shifts it by φ s; w, a
and s move with the figure. Three such turns, about axes through its anchor, make one of a quaternion: φ = E η for a
change η of it. A quaternion that is its link's orientation in the world turns only what lies before the next such links
on the way out; these and what is beyond them go along with their anchors, shifted by w × (their anchor − a).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from ..array import Array, Index
from .algebra import applied, cross, dot, hamilton, rotation_matrix, turned, vector_product
from .figure import Figure
from .kinematics import LinkMotion


@dataclass(frozen=True, eq=False)
class Axes:
    """n axes of one kind, with two derivatives each.

    turn    (3, 3, n, S) w, w', w'', world axes; None for axes that shift
    place   (3, 3, n, S) the anchor a, a', a''; or s, s', s''
    moved   (n, L) 1 for the links that it moves
    column  (n,) state columns of the coordinates; of axes of quaternions, the blocks' (4,) first
    ways    (3, 3, 4, n/3, S) E, E', E'', three axes of a block one after another; None where φ is the coordinate's own
    """

    turn: Array | None
    place: Array
    moved: Array
    column: Index
    ways: Array | None = None

    def taken(self, at: Index) -> Axes:
        """As they are at these of the samples, which may repeat."""
        turn, ways = (part if part is None else part[..., at] for part in (self.turn, self.ways))
        return replace(self, turn=turn, place=self.place[..., at], ways=ways)

    def add(self, rows: Array, out: Array) -> None:
        """Adds rows (3, C, n, S), by φ, φ', φ'', to those by the state, out (S, C, 3, N)."""
        if self.ways is None:
            for order, part in enumerate(rows):
                out[:, :, order, self.column] += part.transpose(2, 0, 1)
            return
        rows = rows.reshape(*rows.shape[:2], -1, 3, rows.shape[-1])

        ways = self.ways

        def by(order: int, derivative: int) -> Array:
            return np.einsum("cnas,aqns->scnq", rows[order], ways[derivative])

        total = (by(0, 0) + by(1, 1) + by(2, 2), by(1, 0) + 2 * by(2, 1), by(2, 0))
        for order, part in enumerate(total):
            for block, column in enumerate(self.column[::3]):
                out[:, :, order, column : column + 4] += part[:, :, block]


def axes_of(links: LinkMotion) -> Iterator[Axes]:
    """All of a figure."""
    yield from _single(links)
    yield from _free(links)
    yield from _quaternions(links)


def anchors(links: LinkMotion, chosen: Index) -> Array:
    """Where the joints of some links turn, with two derivatives, (3, 3, n, S)."""
    place = np.array([links.x[:, chosen], links.x_d[:, chosen], links.x_dd[:, chosen]])
    if links.hang is not None:
        hang = links.hang[:, chosen]
        place += np.array([hang, cross(links.omega[:, chosen], hang), applied(links.swing[:, :, chosen], hang)])
    return place


def _single(links: LinkMotion) -> Iterator[Axes]:
    """Hinges and slides."""
    tables = links.figure.tables
    for chosen, columns, turns in (
        (tables.hinge_links, tables.hinge_columns, True),
        (tables.slide_links, tables.slide_columns, False),
    ):
        if chosen.size:
            axis = turned(links.rotation[:, :, chosen], tables.axis[:, chosen])
            axis = _carried(links, axis, chosen)
            yield Axes(
                axis if turns else None, anchors(links, chosen) if turns else axis, tables.beyond[chosen], columns
            )


def _carried(links: LinkMotion, vectors: Array, owners: Index) -> Array:
    """Vectors (3, n, S) that turn with links, with two derivatives."""
    return np.array([vectors, cross(links.omega[:, owners], vectors), applied(links.swing[:, :, owners], vectors)])


def _free(links: LinkMotion) -> Iterator[Axes]:
    """Positions of free links."""
    tables, count = links.figure.tables, links.x.shape[2]
    for free, columns in zip(tables.free_links, tables.position_columns.T, strict=True):
        direction = np.zeros((3, 3, 3, count))
        direction[0] = np.eye(3)[:, :, None]
        yield Axes(None, direction, np.repeat(tables.beyond[[free]], 3, axis=0), columns)


def _quaternions(links: LinkMotion) -> Iterator[Axes]:
    tables = links.figure.tables
    chosen, columns = tables.quaternion_links, tables.quaternion_columns[0]
    if not chosen.size:
        return
    ways, world = _ways(links), tables.in_world[chosen]
    for some, is_world in ((np.flatnonzero(world), True), (np.flatnonzero(~world), False)):
        if some.size:
            own = chosen[some]
            turn = _still(own.size, links.x.shape[2]) if is_world else _bases(links, own)
            place, moved = np.repeat(anchors(links, own), 3, axis=2), np.repeat(turning(links.figure)[own], 3, axis=0)
            yield Axes(turn, place, moved, np.repeat(columns[some], 3), ways[:, :, :, some])
    block = np.zeros(len(links.figure.links), np.intp)
    block[chosen] = np.arange(chosen.size)
    for link, next_links in _next_links(links.figure):
        apart = anchors(links, next_links) - anchors(links, np.array([link]))
        shift = np.stack([cross(e[:, None, None, None], apart.swapaxes(0, 1)) for e in np.eye(3)], axis=3)
        shift = shift.swapaxes(0, 1).reshape(3, 3, -1, links.x.shape[2])
        own = np.full(next_links.size, block[link])
        moved = np.repeat(tables.beyond[next_links], 3, axis=0)
        yield Axes(None, shift, moved, np.repeat(columns[own], 3), ways[:, :, :, own])


def _still(count: int, samples: int) -> Array:
    """The world's three axes, for each of some links: (3, 3, 3 n, S)."""
    out = np.zeros((3, 3, count, 3, samples))
    out[0] = np.eye(3)[:, None, :, None]
    return out.reshape(3, 3, -1, samples)


def _bases(links: LinkMotion, chosen: Index) -> Array:
    """The axes that relative rotations are in, which turn with the parents: (3, 3, 3 n, S)."""
    tables = links.figure.tables
    parents = tables.parents[chosen]
    base = hamilton(links.Q[:, parents], tables.turn[:, chosen, None])
    axes = rotation_matrix(base, 2 / dot(base, base)).transpose(0, 2, 1, 3).reshape(3, -1, base.shape[2])
    return _carried(links, axes, np.repeat(parents, 3))


def ways(links: LinkMotion) -> Array:
    """The quaternions p of E η = vec(η ⊗ conj(p)), and two derivatives: (3, 4, n, S)."""
    (q, q_d, q_dd), dots = links.states.quaternions[:, :, 1:], links.states.dots[:, 1:]
    scale = 2 / dots[0]
    stretch = dots[1] * scale
    stretch_d = (dot(q_d, q_d) + dots[2]) * scale - stretch**2
    return np.array([q, q_d - stretch * q, q_dd - 2 * stretch * q_d + (stretch**2 - stretch_d) * q]) * scale


def _ways(links: LinkMotion) -> Array:
    """E with φ = E η, the small turn of a small change of a quaternion, and two derivatives: (3, 3, 4, n, S)."""
    return np.array([vector_product(part) for part in ways(links)])


@lru_cache(maxsize=8)
def turning(figure: Figure) -> Array:
    """(L, L) 1 for the links (columns) that the joint of a link (row) turns."""
    out = figure.tables.beyond.copy()
    for link, next_links in _next_links(figure):
        out[link] -= figure.tables.beyond[next_links].sum(axis=0)
    return out


@lru_cache(maxsize=8)
def followers(figure: Figure) -> Index:
    """(L, L): on the way to a link (row) the next after another (column) whose orientation is in the state, or 0."""
    path, tables = figure.tables.path > 0, figure.tables
    out = np.zeros(path.shape, np.intp)
    for link in range(len(path)):
        direction = [i for i in tables.quaternion_links if path[link, i] and tables.in_world[i]]
        out[link, direction[:-1]] = direction[1:]
    return out


def _next_links(figure: Figure) -> Iterator[tuple[int, Index]]:
    """Links whose orientation is in the state and the next such links on the ways out, where there are any."""
    after = followers(figure)
    for link in np.flatnonzero(after.any(axis=0)):
        yield int(link), np.unique(after[after[:, link] > 0, link])
