"""Accelerations of roots and joints, their peaks, and the unit magnitude of the state's quaternions (eq. 9).

Covariant acceleration is the part of q'' that accelerates the rotation itself. For q = ρu with any ρ(t) > 0, with
b = q·q, s = (q·q')/b and the projection P orthogonal to q, it is w = P(q'' − 2 s q'), and f₂* = |w|²/b = |ω'|²/4. The
paper's f₂ = |q'' − T q|² with T = (q''·q)/b equals it only while |q| = 1.

Squares spread an effort over time, but leave a spike where a foot strikes or leaves the ground. The penalty of peaks, a
high power of them that the largest dominates, lowers it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ...array import Array
from ...figure.adjoint import Cotangent
from ...figure.algebra import dot
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches
from ...tolerances import NEGLIGIBLE, TINY
from ..block import Block, Dense, every
from ..curvature import Curvature
from ..penalty import Normalization, Penalty

POWER = 4  # [1] power of squared accelerations, hence the eighth power of accelerations
STEEPER = np.sqrt((2 * POWER - 1) / POWER)  # [1] factor that makes the model's second derivative that of |α|⁸


@dataclass(frozen=True)
class RootAcceleration(Penalty):
    """Σ of the squared accelerations of free roots' positions and of slides [m²/s⁴]."""

    name = "acceleration.linear"
    normalization = Normalization(4.0, length_power=2, time_power=4, by_tension=-1.0)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        tables = samples.figure.tables
        yield every(samples, np.concatenate([tables.position_columns.ravel(), tables.slide_columns]), 2)


@dataclass(frozen=True)
class CovariantAcceleration(Penalty):
    """Σ of f₂* over quaternion blocks [rad²/s⁴ / 4], and of θ''²/4 over hinges."""

    name = "acceleration.angular"
    normalization = Normalization(16.0, time_power=4, by_tension=-1.0)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        yield self._of_quaternions(samples)
        yield every(samples, samples.figure.tables.hinge_columns, 2, weight=0.25)

    def _of_quaternions(self, samples: Samples) -> Dense:
        q, q_d = samples.q, samples.q_d
        inverse = 1 / samples.q_dots[0]
        s, along = samples.q_dots[1:] * inverse
        rate, off, root = 2 * s, along - 2 * s * s, np.sqrt(inverse)
        w = samples.q_dd - rate * q_d
        w -= off * q
        w *= root

        def pulled_back(into: Cotangent, bar: Array) -> None:
            bar = bar.reshape(q.shape)
            by_q_dd = bar * root
            across = dot(by_q_dd, q) * inverse
            by_q_dd -= across * q  # w is orthogonal to q, but bar may not be
            c = dot(by_q_dd, q_d)
            c *= -2 * inverse
            by_q_d = c * q
            by_q_d -= rate * by_q_dd
            by_q = c * q_d
            by_q -= off * by_q_dd
            by_q -= (rate * c + dot(bar, w) * inverse) * q
            by_q -= across / root * w
            into.accumulate("q", by_q, donate=True)
            into.accumulate("q_d", by_q_d, donate=True)
            into.accumulate("q_dd", by_q_dd, donate=True)

        return Dense(w.reshape(-1, samples.count), pulled_back, partial(self._add_curvature, samples))

    def _add_curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        q, q_d, q_dd = (part.transpose(2, 1, 0) for part in (samples.q, samples.q_d, samples.q_dd))
        rows = _residual_jacobians(q, q_d, q_dd, samples.q_dots.transpose(0, 2, 1))
        into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)


def _residual_jacobians(q: Array, q_d: Array, q_dd: Array, dots: Array) -> Array:
    """Return the derivatives of w/√b with respect to q, q', q'', (..., 4, 3, 4).

    Every Jacobian is a sum of a multiple of the identity, and of products of q, 4 s q − 2 q' and w with row vectors.

    Args:
        q: Quaternion blocks, (..., 4), with derivatives q_d and q_dd.
        dots: q·q, q·q', q·q'', (3, ...).
    """
    inverse = 1 / dots[0][..., None]
    along = dots[2][..., None] * inverse
    s = dots[1][..., None] * inverse
    by_s = 4 * s * q - 2 * q_d
    q_inverse = q * inverse
    factor, right = np.empty((*q.shape, 3)), np.zeros((*q.shape[:-1], 3, 3, 4))
    factor[..., 0], factor[..., 1] = q, by_s
    factor[..., 2] = q_dd - (along - 2 * s * s) * q - 2 * s * q_d
    right[..., 0, 0, :] = 2 * along * q_inverse - q_dd * inverse
    right[..., 0, 2, :] = -q_inverse
    right[..., 1, 0, :] = q_d * inverse - 2 * s * q_inverse
    right[..., 1, 1, :] = q_inverse
    right[..., 2, 0, :] = -q_inverse
    out = np.matmul(factor, right.reshape(*q.shape[:-1], 3, 12)).reshape(*q.shape, 3, 4)
    diagonal = np.einsum("...aka->...ak", out)
    diagonal[..., 0] += 2 * s * s - along
    diagonal[..., 1] -= 2 * s
    diagonal[..., 2] += 1
    out *= np.sqrt(inverse)[..., None, None]
    return out


@dataclass(frozen=True)
class PeakAcceleration(Penalty):
    """Σ over ball joints and hinges of |α − α_parent|⁸ [rad⁸/s¹⁶]."""

    name = "peak"
    is_sharp = True
    normalization = Normalization(8.0 ** (2 * POWER), time_power=4 * POWER)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        yield replace(self._larger(samples, 0.0, 1.0), curved=self._add_curvature)

    def _add_curvature(self, into: Curvature, scale: Array) -> None:
        self._larger(into.samples, NEGLIGIBLE, STEEPER).add_to(into, scale)

    def _larger(self, samples: Samples, least: float, steeper: float) -> Block:
        """Return residuals |α|⁴ whose gradients exceed `least` times the largest, with gradients times `steeper`."""
        directions, sizes = relative_accelerations(samples)
        slopes = POWER * sizes ** (POWER - 1)
        at, link = np.nonzero(least * slopes.max(initial=0.0) < slopes.T)
        size, axis = sizes[link, at], steeper * slopes[link, at] * directions[:, link, at]
        parent = samples.figure.tables.parents[link]
        changes = Wrenches(at, link, torque_dd=axis), Wrenches(at, parent, torque_dd=-axis)
        return Block(at, size**POWER, changes)


def relative_accelerations(samples: Samples) -> tuple[Array, Array]:
    """Return angular accelerations of links relative to their parents: unit vectors (3, L, S) and sizes (L, S)
    [rad/s²].

    They are zero for links without a ball joint or hinge.
    """
    links, joints = samples.links, samples.figure.tables.rotary_links
    relative = np.zeros_like(links.alpha)
    relative[:, joints] = links.alpha[:, joints] - links.alpha[:, samples.figure.tables.parents[joints]]
    sizes = np.sqrt(np.einsum("ils,ils->ls", relative, relative))
    return relative / np.maximum(sizes, TINY), sizes


@dataclass(frozen=True)
class UnitMagnitude(Penalty):
    """Σ over quaternion blocks of (1 − b)² with b = q·q.

    Attributes:
        most: The upper limit of the raw spline's mean value in the normalization. A raw spline that swings far out
            between distant keyframes therefore does not let quaternions vanish.
    """

    most: float = 1.0

    name = "unit"

    @property
    def normalization(self) -> Normalization:
        return Normalization(4e-4, raw_cap=self.most)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        excess = samples.q_dots[0] - 1

        def pulled_back(into: Cotangent, bar: Array) -> None:
            into.accumulate("q", (2 * bar) * samples.q, donate=True)

        def curved(into: Curvature, scale: Array) -> None:
            rows = np.zeros((samples.count, excess.shape[0], 1, 3, 4))
            rows[:, :, 0, 0] = (2 * samples.q).transpose(2, 1, 0)
            into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)

        yield Dense(excess, pulled_back, curved)
