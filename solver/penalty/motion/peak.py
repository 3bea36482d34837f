"""Peaks of joints' angular accelerations: a high power of them, for which the largest is all but all that counts.

Squares spread an effort over time, but where a foot strikes or leaves they leave a spike; this takes off its top.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at
from ...figure.figure import JointKind
from ...figure.jacobian_rows import relative_spin_rows
from ...figure.joint_spin import any_relative_spin_rows
from ...figure.kinematics import Samples
from ..curvature import Curvature
from ..penalty import Penalty, Scale

POWER = 4  # of squared accelerations: eighth powers of accelerations
NEGLIGIBLE = 1e-3  # of the largest residual's gradient
STILL = 1e-12  # [rad/s²] a turn that has no axis


@dataclass(frozen=True)
class PeakAcceleration(Penalty):
    """Σ over ball joints and hinges of |α − α_parent|⁸ [rad⁸/s¹⁶]."""

    @property
    def name(self) -> str:
        return "peak"

    @property
    def scale(self) -> Scale:
        return Scale(8.0 ** (2 * POWER), time_power=4 * POWER, is_sharp=True)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        ways, sizes = relative_accelerations(samples)
        powers = sizes ** (2 * POWER - 1)
        if into is not None:
            _pull_back(into, 2 * POWER * scale * powers * ways)
        return np.einsum("ls,ls->s", powers, sizes)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        """Of residuals |α|⁴; times 7/4, which along α makes the second derivative exact."""
        ways, sizes = relative_accelerations(samples)
        joints = _turning(samples)
        at, k = np.divmod(np.arange(samples.count * joints.size), joints.size)
        link = joints[k]
        size = POWER * sizes[link, at] ** (POWER - 1) * np.sqrt((2 * POWER - 1) / POWER)
        large = np.flatnonzero(size > NEGLIGIBLE * size.max(initial=0.0))
        at, link, size = at[large], link[large], size[large]

        spin_rows = relative_spin_rows if samples.figure.is_world else any_relative_spin_rows
        rows = spin_rows(samples, at, link, ways[:, link, at])
        into.add_rows(at, scale[at], rows * size[:, None, None])


def relative_accelerations(samples: Samples) -> tuple[Array, Array]:
    """Angular acceleration of links relative to their parents: unit vectors (3, L, S) and sizes (L, S) [rad/s²].

    Zero for links that no ball joint or hinge turns.
    """
    links, joints = samples.links, _turning(samples)
    relative = np.zeros_like(links.alpha)
    relative[:, joints] = links.alpha[:, joints] - links.alpha[:, samples.figure.tables.parents[joints]]
    sizes = np.sqrt(np.einsum("ils,ils->ls", relative, relative))
    return relative / np.maximum(sizes, STILL), sizes


def _turning(samples: Samples) -> Index:
    """The links that a ball joint or a hinge turns."""
    links = samples.figure.links
    return np.array([i for i, k in enumerate(links) if i and k.kind in (JointKind.BALL, JointKind.HINGE)], np.intp)


def _pull_back(into: Cotangent, gradient: Array) -> None:
    """Gradient of α − α_parent, (3, L, S)."""
    buffer = into.buffer("alpha")
    buffer += gradient
    add_at(buffer, into.samples.figure.tables.parents, -gradient)
