"""Solids known by their signed distance: a sphere leaves them the nearest way, whatever side that is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..array import Array, Index

TINY = 1e-12  # [m]: no direction at all
LEAST_RISE = 0.05  # minimum z of a normal of a surface to stand on


@dataclass(frozen=True)
class Solid(ABC):
    """A surface by its signed distance: spheres are as deep as their radius exceeds the distance of their centres."""

    name: str

    @abstractmethod
    def distance(self, points: Array) -> tuple[Array, Array]:
        """Signed distance of points (3, p) [m], negative inside, (p,), and its gradient, of length 1, (3, p)."""

    @abstractmethod
    def least(self, points: Array) -> Array:
        """A lower bound of the distance that costs little: points (3, p) -> (p,) [m]."""

    @abstractmethod
    def span(self, points: Array) -> tuple[Array, Array]:
        """Entry and exit of the vertical line through points (3, p) from below, z [m], (p,) each.

        NaN where the line misses it.
        """

    def depth(self, points: Array, radius: Array) -> tuple[Array, Array]:
        flat, radii = points.reshape(3, -1), np.repeat(radius, points.shape[2])
        depth, gradient = np.zeros(radii.size), np.zeros(flat.shape)
        which = self._candidates(flat, radii)
        distance, outward = self.distance(flat[:, which])
        over = radii[which] - distance
        deep = over > 0
        depth[which[deep]] = over[deep]
        gradient[:, which[deep]] = -outward[:, deep]
        return depth.reshape(points.shape[1:]), gradient.reshape(points.shape)

    def near(self, points: Array, radius: Array) -> NDArray[np.bool_]:
        flat, radii = points.reshape(3, -1), np.broadcast_to(radius, points.shape[1:]).ravel()
        near = np.zeros(radii.size, bool)
        which = self._candidates(flat, radii)
        near[which] = self.distance(flat[:, which])[0] < radii[which]
        return near.reshape(points.shape[1:])

    def inside(self, points: Array) -> Array:
        return np.maximum(-self.distance(points.reshape(3, -1))[0], 0).reshape(points.shape[1:])

    def height(self, points: Array) -> Array:
        flat = points.reshape(3, -1)
        bottom, top = self.span(flat)
        return np.where(flat[2] >= bottom, flat[2] - top, np.inf).reshape(points.shape[1:])

    def up(self, points: Array) -> Array:
        _, top = self.span(points)
        _, normal = self.distance(np.array([*points[:2], top]))
        return normal / np.maximum(normal[2], LEAST_RISE)

    def _candidates(self, points: Array, radii: Array) -> Index:
        return np.flatnonzero(self.least(points) < radii)


def lengths(vectors: Array) -> Array:
    """|v|: (3, p) -> (p,)."""
    return np.sqrt(np.einsum("ip,ip->p", vectors, vectors))


def directions(vectors: Array, size: Array, otherwise: Array) -> Array:
    """v / |v| of vectors (3, p) and their lengths (p,); a direction (3,) that will do where there is none."""
    return np.where(size > TINY, vectors / np.maximum(size, TINY), otherwise[:, None])


def roots(a: float, b: Array, c: Array) -> tuple[Array, Array]:
    """Both roots of a t² + 2 b t + c = 0, the smaller first, NaN where there are none; a > 0."""
    inner = b * b - a * c
    root = np.sqrt(np.where(inner >= 0, inner, np.nan))
    return (-b - root) / a, (-b + root) / a
