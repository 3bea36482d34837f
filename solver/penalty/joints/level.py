"""Level: a trunk, a tray or a cup keeps upright. Beyond the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ..penalty import Scale
from ..squares import SumOfSquares


@dataclass(frozen=True, eq=False)
class Level(SumOfSquares):
    """Σ over bodies of |R axis − z|², nearly the squared angle [rad²] of an axis to the vertical.

    links  (B,) that the bodies are on;  axes  (3, B) unit vectors in the links' axes
    """

    links: Index
    axes: Array

    @classmethod
    def of(cls, figure: Figure, bodies: Sequence[int], axis: Sequence[float] | None = None) -> Level:
        """Bodies by index, and their axis (3,); without one what is up at rest. Raises ValueError for [0, 0, 0]."""
        links, rest = figure.body_link[np.array(bodies)], figure.to_state(figure.model.qpos0)[None]
        if axis is None:
            return cls(links, Samples.still(figure, rest).links.rotation[2][:, links, 0])
        size = np.linalg.norm(axis)
        if not size:
            raise ValueError("axis is [0, 0, 0], which points nowhere")
        return cls(links, np.array([quat.rotated(figure.body_turn[body], axis) for body in bodies]).T / size)

    @property
    def name(self) -> str:
        return "level"

    @property
    def scale(self) -> Scale:
        return Scale(float(np.radians(10) ** 2), is_violation=True)

    def residuals(self, samples: Samples) -> Array:
        away = self._turned(samples) - np.array([0.0, 0, 1])[:, None, None]
        return away.reshape(-1, samples.count)

    def pull_back(self, samples: Samples, into: Cotangent, bar: Array) -> None:
        turn = np.cross(self._turned(samples), bar.reshape(3, self.links.size, -1), axis=0)
        buffer = into.buffer("turn")
        for k, link in enumerate(self.links.tolist()):
            buffer[:, link] += turn[:, k]

    def _turned(self, samples: Samples) -> Array:
        """(3, B, S)"""
        return np.einsum("ijbs,jb->ibs", samples.links.rotation[:, :, self.links], self.axes)
