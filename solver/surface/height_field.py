"""A height field: ground with heights on a grid, two triangles per cell as in MuJoCo.

The distance is that to the nearest triangle, so it is continuous, and its gradient has length 1 even at creases. The
ground extends infinitely downwards, without an exit there, and its sides are vertical walls.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..array import Array, Index
from ..tolerances import TINY
from .solid import lengths
from .surface import UPRIGHT

WINDOW = 8  # cells in each direction that are searched for the nearest triangle


@dataclass(frozen=True)
class HeightField:
    """A height field.

    Attributes:
        centre: The centre at elevation 0, (3,) [m].
        axes: The axes as columns, (3, 3).
        half: Half sizes, (2,) [m].
        elevation: Elevations (rows, columns) [m], with rows along the second axis.
    """

    name: str
    centre: Array
    axes: Array
    half: Array
    elevation: Array

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        local, radii = self._local(points.reshape(3, -1)), np.repeat(radius, points.shape[2])
        depth, gradient = np.full(radii.size, -np.inf if margin else 0.0), np.zeros(local.shape)
        which = np.flatnonzero(self._least(local) < radii + margin)
        distance, outward = self._distance(local[:, which], np.maximum(radii[which] + margin, 0))
        over = radii[which] - distance
        deep = over > -margin
        depth[which[deep]] = over[deep]
        gradient[:, which[deep]] = self.axes @ -outward[:, deep]
        return depth.reshape(points.shape[1:]), gradient.reshape(points.shape)

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        local = self._local(points.reshape(3, -1))
        return self._least(local).reshape(points.shape[1:]) < radius

    def inside(self, points: Array) -> Array:
        local = self._local(points.reshape(3, -1))
        inside, under = np.zeros(local.shape[1]), np.flatnonzero(self._least(local) <= 0)
        inside[under] = np.maximum(-self._distance(local[:, under], np.zeros(under.size))[0], 0)
        return inside.reshape(points.shape[1:])

    def height(self, points: Array) -> Array:
        local = self._local(points.reshape(3, -1))
        over = np.all(np.abs(local[:2]) <= self.half[:, None], axis=0) & (self.axes[2, 2] > UPRIGHT)
        return np.where(over, local[2] - self._ground(local), np.inf).reshape(points.shape[1:])

    def up(self, points: Array) -> Array:
        column, row, u, v = self._place(self._local(points))
        z = self.elevation
        low, high = z[row, column], z[row + 1, column + 1]
        corner = np.where(u >= v, z[row, column + 1], z[row + 1, column])
        first, second = (corner - low), (high - corner)
        slope = np.array([np.where(u >= v, first, second), np.where(u >= v, second, first)]) / self._cell[:, None]
        return self.axes @ np.array([*-slope, np.ones(u.size)])

    def _local(self, points: Array) -> Array:
        return self.axes.T @ (points - self.centre[:, None])

    @cached_property
    def _cell(self) -> Array:
        rows, columns = self.elevation.shape
        return 2 * self.half / np.array([columns - 1, rows - 1])

    @cached_property
    def _steepest(self) -> float:
        """The largest slope of any triangle [1]."""
        across, along = (np.diff(self.elevation, axis=axis) / self._cell[1 - axis] for axis in (0, 1))
        return float(np.hypot(np.abs(across).max(), np.abs(along).max()))

    def _place(self, local: Array) -> tuple[Index, Index, Array, Array]:
        """Return the cells (column, row) below points, at most the border, and the positions in them, 0 to 1."""
        rows, columns = self.elevation.shape
        u, v = (np.clip(local[:2], -self.half[:, None], self.half[:, None]) + self.half[:, None]) / self._cell[:, None]
        column, row = np.minimum(u.astype(np.intp), columns - 2), np.minimum(v.astype(np.intp), rows - 2)
        return column, row, u - column, v - row

    def _ground(self, local: Array) -> Array:
        """Return the ground's height below points, (p,). Outside the field, use its border."""
        column, row, u, v = self._place(local)
        z = self.elevation
        low, high = z[row, column], z[row + 1, column + 1]
        lower = low + u * (z[row, column + 1] - low) + v * (high - z[row, column + 1])
        upper = low + v * (z[row + 1, column] - low) + u * (high - z[row + 1, column])
        return np.where(u >= v, lower, upper)

    def _least(self, local: Array) -> Array:
        """Return a lower bound of the distance outside, and a negative number below the ground, (p,)."""
        beside = np.hypot(*np.maximum(np.abs(local[:2]) - self.half[:, None], 0))
        over = (local[2] - self._ground(local)) / np.hypot(1, self._steepest)
        over = np.minimum(over, local[2] - self.elevation.min())
        return np.where(beside > 0, np.maximum(beside, over), over)

    def _distance(self, local: Array, within: Array) -> tuple[Array, Array]:
        """Return the signed distance of points (3, p), and its gradient in field axes; exact up to `within` (p,)
        outside. Beside the field, it is the distance to its walls below their top, else to the nearest triangle.
        Inside, it is the distance to the nearest triangle or wall."""
        nearest = np.clip(local[:2], -self.half[:, None], self.half[:, None])
        beside = local[:2] - nearest
        gap = local[2] - self._ground(local)
        sideways = np.hypot(*beside)
        walled = (gap <= 0) & (sideways > TINY)
        below = (gap <= 0) & ~walled
        reach = np.where(below, -gap, np.minimum(np.hypot(gap, sideways), within))
        away = self._from_triangles(local, np.where(walled, 0.0, reach))
        size = lengths(away)
        sign = np.where(below, -1.0, 1.0)
        steep = size > TINY
        outward = np.where(steep, sign * away / np.where(steep, size, 1.0), np.array([[0.0], [0], [1]]))
        distance = sign * size
        distance[walled] = sideways[walled]
        outward[:, walled] = np.concatenate([beside, np.zeros((1, gap.size))])[:, walled] / sideways[walled]
        to_wall = np.abs(local[:2]) - self.half[:, None]
        axis = np.argmax(to_wall, axis=0)
        wall = to_wall[axis, np.arange(axis.size)]
        out = np.flatnonzero(below & (wall > distance))
        distance[out] = wall[out]
        outward[:, out] = 0
        outward[axis[out], out] = np.sign(local[axis[out], out])
        return distance, outward

    def _from_triangles(self, local: Array, reach: Array) -> Array:
        """Return vectors to points (3, p) from the nearest triangle within `reach` (p,), at most WINDOW cells away."""
        rows, columns = self.elevation.shape
        column, row, _, _ = self._place(local)
        cells = np.minimum(np.ceil(reach[None] / self._cell[:, None]).astype(np.intp), WINDOW)
        best, squared = np.zeros(local.shape), np.full(reach.size, np.inf)
        across, along = cells.max(axis=1, initial=0)
        offsets = [(i, j) for i in range(-across, across + 1) for j in range(-along, along + 1)]
        for i, j in offsets:
            c, r = column + i, row + j
            reached = (cells[0] >= abs(i)) & (cells[1] >= abs(j))
            nearby = np.flatnonzero(reached & (c >= 0) & (c < columns - 1) & (r >= 0) & (r < rows - 1))
            if not nearby.size:
                continue
            for corners in self._triangles(c[nearby], r[nearby]):
                away = from_triangle(local[:, nearby], *corners)
                squares = np.einsum("ip,ip->p", away, away)
                closer = squares < squared[nearby]
                squared[nearby[closer]] = squares[closer]
                best[:, nearby[closer]] = away[:, closer]
        return best

    def _triangles(self, column: Index, row: Index) -> list[tuple[Array, Array, Array]]:
        """Return both triangles of cells: corners (3, p), counterclockwise from above, the diagonal first."""

        def corner(c: Index, r: Index) -> Array:
            x, y = c * self._cell[0] - self.half[0], r * self._cell[1] - self.half[1]
            return np.array([x, y, self.elevation[r, c]])

        low, high = corner(column, row), corner(column + 1, row + 1)
        return [(low, corner(column + 1, row), high), (high, corner(column, row + 1), low)]


def from_triangle(points: Array, a: Array, b: Array, c: Array) -> Array:
    """Return the vectors to points from the nearest points of triangles with corners a, b, c, all (3, p)."""
    normal = np.cross(b - a, c - a, axis=0)
    edges = [(a, b - a), (b, c - b), (c, a - c)]
    within = np.ones(points.shape[1], bool)
    best, squared = np.empty(points.shape), np.full(points.shape[1], np.inf)
    for start, along in edges:
        away = points - start
        within &= np.einsum("ip,ip->p", np.cross(normal, along, axis=0), away) >= 0
        share = np.einsum("ip,ip->p", along, away) / np.einsum("ip,ip->p", along, along)
        away = away - along * np.clip(share, 0, 1)
        squares = np.einsum("ip,ip->p", away, away)
        closer = squares < squared
        best[:, closer], squared[closer] = away[:, closer], squares[closer]
    over = np.einsum("ip,ip->p", normal, points - a) / np.einsum("ip,ip->p", normal, normal)
    return np.where(within, over * normal, best)
