"""Peaks: no joint whips. Angular accelerations of links relative to their parents count above a limit only.

Squares spread an effort over time, but where a foot strikes or leaves they leave a spike; this one takes off its top.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..algebra import add_at
from ..curvature import Curvature, Sides, jacobian
from ..figure import JointKind
from ..kinematics import Cotangent, Samples
from ..quaternion import Array, Index
from .penalty import Scale

A_TENTH = 0.1


@dataclass(frozen=True)
class Peaks:
    """Σ over ball joints and hinges of max(0, |α − α_parent| − limit)² [rad²/s⁴]; limit [rad/s²]."""

    limit: float
    name: str = "peak"

    @property
    def scale(self) -> Scale:
        return Scale((A_TENTH * self.limit) ** 2, is_violation=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        ways, sizes = relative_accelerations(samples)
        excess = np.maximum(sizes - self.limit, 0)
        if into is not None and excess.any():
            _pull_back(into, 2 * scale * excess * ways)
        return np.einsum("ls,ls->s", excess, excess)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        excess = relative_accelerations(samples)[1] - self.limit
        at, link = np.nonzero(excess.T > 0)
        if not at.size:
            return

        def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
            here, ways = np.arange(rows.size), relative_accelerations(copies)[0]
            seeds = np.zeros_like(ways)
            seeds[:, link[rows], here] = ways[:, link[rows], here]
            _pull_back(cotangent, seeds)

        into.add_rows(at, scale[at], jacobian(samples, at, seeded))

    def sides(self, samples: Samples) -> Sides | None:
        return None


def relative_accelerations(samples: Samples) -> tuple[Array, Array]:
    """Angular acceleration of links relative to their parents: unit vectors (3, L, S) and sizes (L, S) [rad/s²].

    Zero for links that no ball joint or hinge turns.
    """
    links, figure = samples.links, samples.figure
    turned = np.array([i > 0 and link.kind in (JointKind.BALL, JointKind.HINGE) for i, link in enumerate(figure.links)])
    relative = (links.alpha - links.alpha[:, figure.tables.parents]) * turned[:, None]
    sizes = np.sqrt(np.einsum("ils,ils->ls", relative, relative))
    return relative / np.maximum(sizes, 1e-12), sizes


def _pull_back(into: Cotangent, gradient: Array) -> None:
    """Gradient of α − α_parent, (3, L, S)."""
    room = into.room("alpha")
    room += gradient
    add_at(room, into.samples.figure.tables.parents, -gradient)
