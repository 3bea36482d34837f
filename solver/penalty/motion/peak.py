"""Peaks of joints' angular accelerations: a high power of them, which the largest dominates.

Squares spread an effort over time, but leave a spike where a foot strikes or leaves the ground. This term lowers it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches
from ..block import Block
from ..penalty import Normalization, Penalty, Role

POWER = 4  # [1] power of squared accelerations, hence the eighth power of accelerations
NEGLIGIBLE = 1e-3  # [1] gradient relative to the largest below which a residual is omitted from the model
STEEPER = np.sqrt((2 * POWER - 1) / POWER)  # [1] factor that makes the model's second derivative that of |α|⁸
STILL = 1e-12  # [rad/s²] smallest divisor, against division by zero


@dataclass(frozen=True)
class PeakAcceleration(Penalty):
    """Σ over ball joints and hinges of |α − α_parent|⁸ [rad⁸/s¹⁶]."""

    name = "peak"
    role = Role.PHYSICS
    normalization = Normalization(8.0 ** (2 * POWER), time_power=4 * POWER, is_sharp=True)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        return self._larger(samples, 0.0, 1.0)

    def nearby(self, samples: Samples) -> Iterator[Block]:
        return self._larger(samples, NEGLIGIBLE, STEEPER)

    def _larger(self, samples: Samples, least: float, steeper: float) -> Iterator[Block]:
        """Yield residuals |α|⁴ whose gradients exceed `least` times the largest, with gradients times `steeper`."""
        directions, sizes = relative_accelerations(samples)
        slopes = POWER * sizes ** (POWER - 1)
        at, link = np.nonzero(least * slopes.max(initial=0.0) < slopes.T)
        size, axis = sizes[link, at], steeper * slopes[link, at] * directions[:, link, at]
        parent = samples.figure.tables.parents[link]
        changes = Wrenches(at, link, torque_dd=axis), Wrenches(at, parent, torque_dd=-axis)
        yield Block(at, size**POWER, changes)


def relative_accelerations(samples: Samples) -> tuple[Array, Array]:
    """Return angular accelerations of links relative to their parents: unit vectors (3, L, S) and sizes (L, S)
    [rad/s²].

    They are zero for links without a ball joint or hinge.
    """
    links, joints = samples.links, samples.figure.tables.rotary_links
    relative = np.zeros_like(links.alpha)
    relative[:, joints] = links.alpha[:, joints] - links.alpha[:, samples.figure.tables.parents[joints]]
    sizes = np.sqrt(np.einsum("ils,ils->ls", relative, relative))
    return relative / np.maximum(sizes, STILL), sizes
