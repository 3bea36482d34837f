"""A convex hull, MuJoCo's shape of a mesh. The distance is to its faces, and outside also to its edges."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import ENTRIES_AT_ONCE, Array, Index
from ..tolerances import SINGLE, TINY
from .solid import Solid, lengths
from .surface import GROUNDED, UPRIGHT


@dataclass(frozen=True)
class Hull(Solid):
    """A convex hull.

    Attributes:
        corners: The corners, (3, v) [m].
        faces: Indices of the triangles' corners, counterclockwise from outside, (f, 3).
        buried: Whether the faces on which it stands are no exits.
    """

    corners: Array
    faces: Index
    buried: bool = False

    def distance(self, points: Array) -> tuple[Array, Array]:
        normals, offsets = self._planes
        over = normals @ points - offsets[:, None]
        face = np.argmax(over, axis=0)
        distance, outward = over[face, np.arange(face.size)], normals[face].T
        foot = points - distance * outward
        # outside, if the foot on the plane is not on the face, an edge is nearest
        out = np.flatnonzero(distance > 0)
        aside = out[np.any(normals @ foot[:, out] - offsets[:, None] > SINGLE, axis=0)]
        outward = outward.copy()
        few = max(1, ENTRIES_AT_ONCE // len(self._edges))
        for run in (aside[i : i + few] for i in range(0, aside.size, few)):
            away = self._from_edges(points[:, run])
            distance[run] = lengths(away)
            outward[:, run] = away / np.maximum(distance[run], TINY)
        return distance, outward

    def least(self, points: Array) -> Array:
        normals, offsets = self._planes
        low, high = self.corners.min(axis=1)[:, None], self.corners.max(axis=1)[:, None]
        if self.buried:
            low = np.array([*low[:2], [-np.inf]])
        least = np.max(np.maximum(low - points, points - high), axis=0)
        close = np.flatnonzero(least < self._size)
        least[close] = np.maximum(least[close], np.max(normals @ points[:, close] - offsets[:, None], axis=0))
        return least

    def span(self, points: Array) -> tuple[Array, Array]:
        normals, offsets = self._planes
        gap = offsets[:, None] - normals[:, :2] @ points[:2]
        rise = normals[:, 2]
        up, down, upright = rise > TINY, rise < -TINY, np.abs(rise) <= TINY
        top = np.min(gap[up] / rise[up, None], axis=0)
        bottom = np.max(gap[down] / rise[down, None], axis=0, initial=-np.inf)
        hit = (bottom <= top) & np.all(gap[upright] >= 0, axis=0)
        return np.where(hit, bottom, np.nan), np.where(hit, top, np.nan)

    @cached_property
    def _size(self) -> float:
        return float(np.linalg.norm(self.corners.max(axis=1) - self.corners.min(axis=1)))

    @cached_property
    def _planes(self) -> tuple[Array, Array]:
        """Unique outward unit normals (f, 3) and offsets (f,) of half spaces, without faces that the hull rests on."""
        a, b, c = (self.corners[:, self.faces[:, k]].T for k in range(3))
        normals = np.cross(b - a, c - a)
        sizes = np.linalg.norm(normals, axis=1)
        is_exit = sizes > TINY
        if self.buried:
            bottom = self.corners[2].min() + GROUNDED
            is_exit &= (normals[:, 2] > -UPRIGHT * sizes) | (np.max([a[:, 2], b[:, 2], c[:, 2]], axis=0) > bottom)
        normals = normals[is_exit] / sizes[is_exit, None]
        planes = np.column_stack([normals, np.sum(normals * a[is_exit], axis=1)])
        _, first = np.unique(np.round(planes / SINGLE), axis=0, return_index=True)
        return planes[first, :3], planes[first, 3]

    @cached_property
    def _edges(self) -> Index:
        """Pairs of corners (e, 2), each edge once."""
        pairs = np.concatenate([self.faces[:, [0, 1]], self.faces[:, [1, 2]], self.faces[:, [2, 0]]])
        return pairs[pairs[:, 0] < pairs[:, 1]]  # two triangles have each edge, in opposite directions

    def _from_edges(self, points: Array) -> Array:
        """Return the vectors to points (3, p) from the nearest point of any edge."""
        start = self.corners[:, self._edges[:, 0]]
        along = self.corners[:, self._edges[:, 1]] - start
        away = points[:, None, :] - start[:, :, None]
        squared = np.maximum(np.einsum("ie,ie->e", along, along), TINY**2)
        share = np.clip(np.einsum("ie,iep->ep", along, away) / squared[:, None], 0, 1)
        away -= along[:, :, None] * share
        nearest = np.argmin(np.einsum("iep,iep->ep", away, away), axis=0)
        return away[:, nearest, np.arange(points.shape[1])]
