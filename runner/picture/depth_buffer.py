"""The nearest triangle in every pixel, and its depth, seen from a camera or a light."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.tolerances import TINY

AT_ONCE = 20_000  # faces or samples at once, few enough for the processor's cache


class Eye(NamedTuple):
    """A perspective projection, of a camera or a light.

    Attributes:
        position: (3,) [m].
        axes: Rows right, down, forward, (3, 3).
        focus: The distance from the middle of a ray at 45 degrees [pixels].
        width: [pixels].
        height: [pixels].
        near: The smallest visible depth [m].
    """

    position: Array
    axes: Array
    focus: float
    width: int
    height: int
    near: float

    def project(self, points: Array) -> Array:
        """Return pixels from the left and from the top, both times the depth, and the depth [m], (..., 3)."""
        out = (points - self.position) @ self.axes.T
        out[..., 0] = out[..., 0] * self.focus + out[..., 2] * (self.width / 2)
        out[..., 1] = out[..., 1] * self.focus + out[..., 2] * (self.height / 2)
        return out

    def rays(self, x: Array, y: Array) -> Array:
        """Return directions through pixels, with unit depth, (n, 3)."""
        across, down = (x - self.width / 2) / self.focus, (y - self.height / 2) / self.focus
        return np.stack([across, down, np.ones_like(across)], axis=-1) @ self.axes


class Faces:
    """Triangles in a projection: linear functions (m, 3) of pixels for their edges and for 1 / depth."""

    def __init__(self, eye: Eye, points: Array) -> None:
        """Project points (m, 3, 3), counterclockwise from outside. Back faces are hidden."""
        corners = eye.project(points)
        edges = np.cross(np.roll(corners, -2, axis=1), np.roll(corners, -1, axis=1))
        volume = np.einsum("mi,mi->m", corners[:, 0], edges[:, 0])
        self.number = np.flatnonzero((volume > TINY) & (corners[..., 2].max(axis=1) > eye.near))
        self.edges = edges[self.number]
        self.closeness = self.edges.sum(axis=1) / volume[self.number, None]
        self._low, self._high = _extent(corners[self.number], eye.near)
        self._size = np.array([eye.width, eye.height])

    def weights(self, face: Index, x: Array, y: Array) -> Array:
        """Return barycentric coordinates at pixels on faces, (n, 3)."""
        out = self.edges[face] @ np.stack([x, y, np.ones_like(x)], axis=-1)[..., None]
        return out[..., 0] / out.sum(axis=1)

    def cover(self, at: Array) -> tuple[Array, Index]:
        """Return 1 / depth and index of the nearest face at an offset (2,) in every pixel, (h, w); else 0 and −1."""
        width, height = self._size
        nearest, winner = np.zeros(width * height), np.full(width * height, -1)
        low = np.clip(np.ceil(self._low - at), 0, self._size).astype(int)
        high = np.clip(np.floor(self._high - at), -1, self._size - 1).astype(int)
        for start in range(0, len(self.edges), AT_ONCE):
            part = slice(start, start + AT_ONCE)
            face, row = _runs(high[part, 1] - low[part, 1] + 1)
            face += start
            row += low[face, 1]
            slope, rest = (
                self.edges[face, :, 0],
                self.edges[face, :, 1] * (row + at[1])[:, None] + self.edges[face, :, 2],
            )
            with np.errstate(divide="ignore", invalid="ignore"):
                place = -rest / slope - at[0]
            begin = np.ceil(np.where(slope > 0, place, -np.inf).max(axis=1, initial=0)).clip(low[face, 0])
            right = np.floor(np.where(slope < 0, place, np.inf).min(axis=1, initial=width)).clip(None, high[face, 0])
            right[((slope == 0) & (rest < 0)).any(axis=1)] = -1
            run, column = _runs((right - begin + 1).astype(int))
            column += begin.astype(int)[run]
            face, row = face[run], row[run]
            along, down, start_value = self.closeness[face].T
            closeness = along * (column + at[0]) + (down * (row + at[1]) + start_value)
            pixel = row * width + column
            np.maximum.at(nearest, pixel, closeness)
            won = closeness == nearest[pixel]
            winner[pixel[won]] = face[won]
        return nearest, winner


def _extent(corners: Array, near: float) -> tuple[Array, Array]:
    """Return the smallest and largest pixels of triangles in front of the near plane, (m, 2) each."""
    with np.errstate(divide="ignore", invalid="ignore"):
        places = np.where(corners[..., 2:] > near, corners[..., :2] / corners[..., 2:], np.nan)
        crossing = np.flatnonzero(np.isnan(places).any(axis=(1, 2)))
        a, b = corners[crossing], np.roll(corners[crossing], -1, axis=1)
        share = (near - a[..., 2:]) / (b[..., 2:] - a[..., 2:])
        cut = (a + share * (b - a))[..., :2] / near
    low, high = np.nanmin(places, axis=1), np.nanmax(places, axis=1)
    cut = np.where((share >= 0) & (share <= 1), cut, np.nan)
    low[crossing] = np.fmin(low[crossing], np.fmin.reduce(cut, axis=1))
    high[crossing] = np.fmax(high[crossing], np.fmax.reduce(cut, axis=1))
    return low, high


def _runs(lengths: Index) -> tuple[Index, Index]:
    """Return the index of the run and the position in it, for every item of runs of these lengths."""
    lengths = np.maximum(lengths, 0)
    run = np.repeat(np.arange(len(lengths)), lengths)
    return run, np.arange(len(run)) - np.repeat(np.cumsum(lengths) - lengths, lengths)
