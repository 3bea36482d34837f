"""Speed: no joint turns faster than it can, or than its motor does. Beyond the paper."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at
from ...figure.figure import Figure, JointKind
from ...figure.kinematics import Samples
from ..curvature import Curvature, jacobian
from ..penalty import Penalty, Scale

STILL = 1e-12  # [rad/s] a turn that has no axis


@dataclass(frozen=True, eq=False)
class Speed(Penalty):
    """Σ over hinges and ball joints of max(0, |ω − ω_parent| − limit)² [rad²/s²].

    links  (J,) that the joints turn;  limits  (J,) [rad/s]
    """

    links: Index
    limits: Array

    @classmethod
    def of(cls, figure: Figure, limit: float) -> Speed:
        """All hinges and ball joints, none faster than limit [rad/s]."""
        turning = (JointKind.HINGE, JointKind.BALL)
        links = np.array([i for i, link in enumerate(figure.links) if i and link.kind in turning], np.intp)
        return cls(links, np.full(links.size, limit))

    @property
    def name(self) -> str:
        return "speed"

    @property
    def scale(self) -> Scale:
        return Scale(1.0, is_violation=True, time_power=2, is_sharp=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        way, beyond = self._beyond(samples)
        if into is not None:
            self._pull_back(samples, into, 2 * scale * beyond * way)
        return np.einsum("js,js->s", beyond, beyond)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        way, beyond = self._beyond(samples)
        at, joint = np.nonzero(beyond.T)

        def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
            bar = np.zeros((3, self.links.size, copies.count))
            bar[:, joint[rows], np.arange(rows.size)] = way[:, joint[rows], at[rows]]
            self._pull_back(copies, cotangent, bar)

        into.add_rows(at, scale[at], jacobian(samples, at, seeded)[:, :2], (0, 1))

    def speeds(self, samples: Samples) -> Array:
        """(J, S) [rad/s] how fast the joints turn."""
        return np.linalg.norm(self._relative(samples), axis=0)

    def _relative(self, samples: Samples) -> Array:
        """(3, J, S)"""
        omega, parents = samples.links.omega, samples.figure.tables.parents
        return omega[:, self.links] - omega[:, parents[self.links]]

    def _beyond(self, samples: Samples) -> tuple[Array, Array]:
        """Unit vectors (3, J, S) along which joints turn, and how much too fast (J, S) [rad/s]."""
        relative = self._relative(samples)
        size = np.linalg.norm(relative, axis=0)
        return relative / np.maximum(size, STILL), np.maximum(size - self.limits[:, None], 0.0)

    def _pull_back(self, samples: Samples, into: Cotangent, bar: Array) -> None:
        buffer = into.buffer("omega")
        add_at(buffer, self.links, bar)
        add_at(buffer, samples.figure.tables.parents[self.links], -bar)
