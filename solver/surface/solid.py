"""Solids by their signed distance. A sphere inside is moved out the nearest way, in any direction."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..array import Array, Index
from ..tolerances import TINY
from .surface import DEEP

LEAST_RISE = 0.05  # minimum z of a normal of a surface to stand on


@dataclass(frozen=True)
class Solid(ABC):
    """A surface by its signed distance. The depth of a sphere is its radius minus the distance of its centre."""

    name: str

    @abstractmethod
    def distance(self, points: Array) -> tuple[Array, Array]:
        """Return the signed distance of points (3, p) [m], negative inside, (p,), and its unit gradient (3, p)."""

    @abstractmethod
    def least(self, points: Array) -> Array:
        """Return a lower bound of the distance that is cheap to compute, (p,) [m], for points (3, p)."""

    @abstractmethod
    def span(self, points: Array) -> tuple[Array, Array]:
        """Return where vertical lines through points (3, p) enter the solid from below and leave it, z [m], (p,) each.

        It is NaN if the line misses the solid.
        """

    def depth(self, points: Array, radius: Array, margin: float = 0.0) -> tuple[Array, Array]:
        flat, radii = points.reshape(3, -1), np.repeat(radius, points.shape[2])
        depth, gradient = np.full(radii.size, -np.inf if margin else 0.0), np.zeros(flat.shape)
        which = self._candidates(flat, radii + margin)
        distance, outward = self.distance(flat[:, which])
        over = radii[which] - distance
        deep = over > -margin
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
        return np.where(flat[2] >= np.fmax(bottom, top - DEEP), flat[2] - top, np.inf).reshape(points.shape[1:])

    def up(self, points: Array) -> Array:
        _, top = self.span(points)
        _, normal = self.distance(np.array([*points[:2], top]))
        return normal / np.maximum(normal[2], LEAST_RISE)

    def _candidates(self, points: Array, radii: Array) -> Index:
        return np.flatnonzero(self.least(points) < radii)


def lengths(vectors: Array) -> Array:
    """Return |v| (p,) for vectors (3, p)."""
    return np.sqrt(np.einsum("ip,ip->p", vectors, vectors))


def directions(vectors: Array, size: Array, otherwise: Array) -> Array:
    """Return v / |v| for vectors (3, p) of lengths (p,), and `otherwise` (3,) for vectors of length zero."""
    return np.where(size > TINY, vectors / np.maximum(size, TINY), otherwise[:, None])


def roots(a: float, b: Array, c: Array) -> tuple[Array, Array]:
    """Return both roots of a t² + 2 b t + c = 0 with a > 0, the smaller first; NaN if there are none."""
    inner = b * b - a * c
    root = np.sqrt(np.where(inner >= 0, inner, np.nan))
    return (-b - root) / a, (-b + root) / a
