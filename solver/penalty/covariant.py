"""Covariant acceleration: what the rotation itself feels of q''.

The paper's form (eq. 9): f₂ = |q'' − T q|², T = (q''·q)/(q·q): the acceleration of the rotation only while |q| = 1.
The intrinsic form is exact for q = ρu with any ρ(t) > 0: with s = (q·q')/b and P the projection off q,
w = P(q'' − 2 s q') and f₂* = |w|²/b = |ω'|²/4.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..algebra import dot
from ..curvature import Curvature, Sides
from ..kinematics import Cotangent, Samples
from ..quaternion import Array
from .penalty import Scale


def covariant_acceleration(q: Array, q_dd: Array) -> Array:
    """q'' without its component along q: the acceleration felt on the unit sphere (eq. 9).

    q     (..., 4)  quaternion, wxyz, any length > 0
    q_dd  (..., 4)  its second time derivative [1/s²]
    """
    along = np.sum(q_dd * q, axis=-1, keepdims=True) / np.sum(q * q, axis=-1, keepdims=True)
    return q_dd - along * q


@dataclass(frozen=True)
class CovariantAcceleration:
    """Σ over quaternion blocks of f₂* ("intrinsic") or f₂ ("paper") [rad²/s⁴ / 4], and of θ''²/4 over hinges."""

    form: str = "intrinsic"
    name: str = "covariant"

    def __post_init__(self) -> None:
        if self.form not in ("intrinsic", "paper"):
            raise ValueError(f"covariant acceleration: form = {self.form!r} is not one of 'intrinsic', 'paper'")

    @property
    def scale(self) -> Scale:
        return Scale(16.0, time_power=4)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        values = (
            self._intrinsic(samples, into, scale) if self.form == "intrinsic" else self._paper(samples, into, scale)
        )
        hinges = samples.figure.tables.hinge_columns
        if hinges.size:
            theta_dd = samples.y_dd[:, hinges]
            values = values + 0.25 * np.sum(theta_dd**2, axis=1)
            if into is not None:
                into.room("y_dd")[:, hinges] += 0.5 * np.reshape(scale, (-1, 1)) * theta_dd
        return values

    def _paper(self, samples: Samples, into: Cotangent | None, scale: Array | float) -> Array:
        q, q_dd = samples.q, samples.q_dd
        along = dot(q_dd, q) / dot(q, q)
        w = q_dd - along * q
        if into is not None:
            into.add("q", (2 * scale * along) * (along * q - q_dd))
            into.add("q_dd", (2 * scale) * w)
        return dot(w, w).sum(axis=0)

    def _intrinsic(self, samples: Samples, into: Cotangent | None, scale: Array | float) -> Array:
        q, q_d = samples.q, samples.q_d
        inverse = 1 / samples.q_dots[0]
        s, along = samples.q_dots[1:] * inverse
        rate, off = 2 * s, along - 2 * s * s
        w = samples.q_dd - rate * q_d
        w -= off * q
        values = dot(w, w) * inverse
        if into is not None:
            k = (2 * scale) * inverse
            by_q_dd = k * w
            c = dot(by_q_dd, q_d)
            c *= -2 * inverse
            by_q_d = c * q
            by_q_d -= rate * by_q_dd
            by_q = c * q_d
            by_q -= off * by_q_dd
            by_q -= (rate * c + k * values) * q
            for name, gradient in (("q", by_q), ("q_d", by_q_d), ("q_dd", by_q_dd)):
                into.hand(name, gradient)
        return np.add.reduce(values, axis=0)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        tables = samples.figure.tables
        q, q_d, q_dd = (part.transpose(2, 1, 0) for part in (samples.q, samples.q_d, samples.q_dd))
        parts = _residual_jacobians(q, q_d, q_dd, intrinsic=self.form == "intrinsic")
        into.add_blocks(tables.quaternion_columns.T, np.stack(parts, axis=3), scale)
        into.add_squares(tables.hinge_columns, 2, 0.25 * scale)

    def sides(self, samples: Samples) -> Sides | None:
        return None


def _residual_jacobians(q: Array, q_d: Array, q_dd: Array, *, intrinsic: bool) -> tuple[Array, Array, Array]:
    """Of w/√b ("paper": of q'' − T q) with respect to q, q', q'': (..., 4, 4) each, for blocks (..., 4)."""

    def inner(a: Array, b: Array) -> Array:
        return np.sum(a * b, axis=-1)[..., None, None]

    def outer(a: Array, b: Array) -> Array:
        return a[..., :, None] * b[..., None, :]

    b, one = inner(q, q), np.eye(4)
    along = inner(q, q_dd) / b
    by_acceleration = one - outer(q, q) / b
    by_value = -along * one - outer(q, q_dd - 2 * along[..., 0] * q) / b
    if not intrinsic:
        return by_value, np.zeros_like(by_value), by_acceleration
    s = inner(q, q_d) / b
    w = q_dd - (along - 2 * s * s)[..., 0] * q - 2 * s[..., 0] * q_d
    by_s = 4 * s[..., 0] * q - 2 * q_d
    by_rate = outer(by_s, q) / b - 2 * s * one
    by_value = by_value + 2 * s * s * one + outer(by_s, q_d - 2 * s[..., 0] * q) / b - outer(w, q) / b
    root = np.sqrt(b)
    return by_value / root, by_rate / root, by_acceleration / root
