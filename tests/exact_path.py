"""The exact covariant interpolation of unit quaternions: an oracle that shares no code with `solver`.

A path of least ¼∫|ω'|² through unit quaternions obeys, for the body's angular velocity ω = 2 vec(Q⁻¹Q'),

    ω''' + ω × ω'' = 0   between keyframes,   ω and ω' continuous at keyframes,   ω' = 0 at both ends

(L. Noakes, G. Heinzinger, B. Paden, "Cubic splines on curved spaces", IMA J. Math. Control Inf. 6, 1989). It is solved
here by multiple shooting: every segment starts with its own ω, ω', ω'' and is integrated by its Taylor series; Newton's
method closes the gaps, its derivatives exact by complex steps.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import factorial

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]

ORDER = 20
STEPS = 4
CLOSED = 1e-12
TINY = 1e-30


def _product(p: NDArray, q: NDArray) -> NDArray:
    """Hamilton product of (..., 4) arrays, real or complex."""
    vector = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    scalar = p[..., :1] * q[..., :1] - np.sum(p[..., 1:] * q[..., 1:], axis=-1, keepdims=True)
    return np.concatenate([scalar, vector], axis=-1)


def _conjugate(q: NDArray) -> NDArray:
    return q * np.array([1, -1, -1, -1])


def _pure(v: NDArray) -> NDArray:
    return np.concatenate([np.zeros_like(v[..., :1]), v], axis=-1)


def _omega_series(state: NDArray) -> NDArray:
    """Taylor coefficients (ORDER + 1, ..., 3) of ω from ω''' = −ω × ω'', state (..., 9) = (ω, ω', ω'')."""
    a = [state[..., :3], state[..., 3:6], state[..., 6:] / 2]
    for n in range(ORDER - 2):
        total = sum(np.cross(a[k], (n - k + 2) * (n - k + 1) * a[n - k + 2]) for k in range(n + 1))
        a.append(-np.asarray(total) / ((n + 3) * (n + 2) * (n + 1)))
    return np.stack(a)


def _orientation_series(q: NDArray, omega: NDArray) -> NDArray:
    """Taylor coefficients (ORDER + 1, ..., 4) of Q from Q' = ½ Q ω."""
    c = [q]
    for n in range(ORDER):
        total = sum(_product(c[k], _pure(omega[n - k])) for k in range(n + 1))
        c.append(np.asarray(total) / (2 * (n + 1)))
    return np.stack(c)


def _series_at(coefficients: NDArray, t: NDArray, order: int = 0) -> NDArray:
    """The order-th derivative at t (...) of series (ORDER + 1, ..., n), by Horner's rule."""
    value = np.zeros_like(coefficients[0])
    for k in range(coefficients.shape[0] - 1, order - 1, -1):
        value = value * t[..., None] + coefficients[k] * (factorial(k) / factorial(k - order))
    return value


def _advanced(q: NDArray, state: NDArray, h: NDArray) -> tuple[NDArray, NDArray]:
    """Orientation and (ω, ω', ω'') after a time h (...), in STEPS Taylor steps."""
    for _ in range(STEPS):
        omega = _omega_series(state)
        q = _series_at(_orientation_series(q, omega), h / STEPS)
        state = np.concatenate([_series_at(omega, h / STEPS, k) for k in range(3)], axis=-1)
    return q, state


@dataclass(frozen=True)
class Faults:
    """What is wrong with a path, each the largest magnitude: all near rounding for a solution.

    equation    of ω''' + ω × ω'', by differencing sampled orientations [rad/s³]
    keyframes   distance of the orientation from the keyframes
    continuity  jumps of ω and ω' at the keyframes
    ends        ω' at both ends [rad/s²]
    """

    equation: float
    keyframes: float
    continuity: float
    ends: float


@dataclass(frozen=True)
class ExactPath:
    """Unit quaternions (K, 4) at times (K,) and the (ω, ω', ω'') (K − 1, 9) with which every segment starts."""

    times: Array
    keys: Array
    states: Array

    def _located(self, t: Array) -> tuple[Array, Array]:
        """Q (S, 4) and (ω, ω', ω'') (S, 9) at times t (S,), each integrated from its segment's start."""
        i = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.states) - 1)
        return _advanced(self.keys[i], self.states[i], t - self.times[i])

    def at(self, t: Array, order: int = 0) -> Array:
        """The order-th derivative (0-4) of the unit quaternion at times t (S,): (S, 4)."""
        q, state = self._located(np.asarray(t, float))
        return _orientation_series(q, _omega_series(state))[order] * factorial(order)

    def omega(self, t: Array, order: int = 0) -> Array:
        """The order-th derivative of the body's angular velocity at times t (S,): (S, 3)."""
        return _omega_series(self._located(np.asarray(t, float))[1])[order] * factorial(order)

    @property
    def energy(self) -> float:
        """¼ ∫ |ω'|² dt, by 20-point Gauss-Legendre quadrature in every segment."""
        x, w = np.polynomial.legendre.leggauss(20)
        half = np.diff(self.times)[:, None] / 2
        t = (self.times[:-1, None] + half * (1 + x)).ravel()
        return float(0.25 * (half * w).ravel() @ np.sum(self.omega(t, 1) ** 2, axis=1))

    def faults(self) -> Faults:
        """Checks the solution by means that it was not made by."""
        h = np.diff(self.times)
        q, state = _advanced(self.keys[:-1], self.states, h)
        miss = np.minimum(np.linalg.norm(q - self.keys[1:], axis=1), np.linalg.norm(q + self.keys[1:], axis=1))
        jumps = state[:-1, :6] - self.states[1:, :6]
        ends = np.concatenate([self.states[0, 3:6], state[-1, 3:6]])
        return Faults(self._equation_fault(), float(miss.max()), float(abs(jumps).max()), float(abs(ends).max()))

    def _equation_fault(self) -> float:
        """ω and its derivatives from a Chebyshev fit of 2 vec(Q⁻¹Q'), with Q' from a fit of the sampled Q."""
        worst = 0.0
        for a, b in pairwise(self.times):
            t = (a + b) / 2 - (b - a) / 2 * np.cos((np.arange(28) + 0.5) * np.pi / 28)
            q = self.at(t)
            fits = [np.polynomial.Chebyshev.fit(t, column, 22, domain=[a, b]) for column in q.T]
            q_d = np.stack([fit.deriv()(t) for fit in fits], axis=1)
            omega = 2 * _product(_conjugate(q), q_d)[:, 1:]
            rates = [np.polynomial.Chebyshev.fit(t, column, 18, domain=[a, b]) for column in omega.T]
            inner = np.linspace(a, b, 12)[1:-1]
            w, w_dd, w_ddd = (np.stack([f.deriv(k)(inner) for f in rates], axis=1) for k in (0, 2, 3))
            worst = max(worst, float(abs(w_ddd + np.cross(w, w_dd)).max()))
        return worst


def exact_path(times: Array, keys: Array) -> ExactPath:
    """The solution nearest to the normalised natural cubic through keys (K, 4), which are taken by shortest arcs."""
    times = np.asarray(times, float)
    keys = np.array(keys, float) / np.linalg.norm(keys, axis=1, keepdims=True)
    for i in range(1, len(keys)):
        keys[i] *= np.sign(keys[i] @ keys[i - 1]) or 1.0
    states = _start(times, keys)
    gap = _gaps(times, keys, states)
    for _ in range(60):
        if np.linalg.norm(gap) < CLOSED:
            break
        step = np.asarray(np.linalg.solve(_jacobian(times, keys, states), -gap), float).reshape(states.shape)
        found = _shortened(times, keys, states, step)
        if found is None:
            raise ArithmeticError(f"multiple shooting is stuck with a gap of {np.linalg.norm(gap):.2g}")
        states, gap = found
    return ExactPath(times, keys, states)


def _shortened(times: Array, keys: Array, states: Array, step: Array) -> tuple[Array, Array] | None:
    """States and gaps after the longest of step, step / 2, … that closes the gaps enough, if one does."""
    gap = np.linalg.norm(_gaps(times, keys, states))
    for share in 0.5 ** np.arange(14):
        tried = states + share * step
        left = _gaps(times, keys, tried)
        if np.linalg.norm(left) < (1 - 0.1 * share) * gap:
            return tried, left
    return None


def _start(times: Array, keys: Array) -> Array:
    """(ω, ω', ω'') (K − 1, 9) of parabolas fitted to the body's angular velocity along the natural cubic."""
    curve = CubicSpline(times, keys, bc_type="natural")
    rows = []
    for a, b in pairwise(times):
        t = np.linspace(a, b, 9)
        q, q_d = curve(t), curve(t, 1)
        omega = 2 * (_product(_conjugate(q), q_d) / np.sum(q * q, axis=1, keepdims=True))[:, 1:]
        second, first, level = np.polyfit(t - a, omega, 2)
        rows.append(np.concatenate([level, first, 2 * second]))
    return np.array(rows)


def _gaps(times: Array, keys: Array, states: NDArray) -> NDArray:
    """(9 (K − 1),) what is not closed: the segments' end orientations, jumps of ω and ω', ω' at both ends."""
    q, state = _advanced(keys[:-1].astype(states.dtype), states, np.diff(times))
    return _closing(keys, states, q, state)


def _closing(keys: Array, states: NDArray, q: NDArray, state: NDArray) -> NDArray:
    miss = 2 * _product(_conjugate(keys[1:]), q)[..., 1:]
    jumps = state[:-1, :6] - states[1:, :6]
    return np.concatenate([miss.ravel(), jumps.ravel(), states[0, 3:6], state[-1, 3:6]])


def _jacobian(times: Array, keys: Array, states: Array) -> Array:
    """d gaps / d states, by complex steps: all segments' end values at once, then put together."""
    count = len(states)
    moved = states[None] + 1j * TINY * np.eye(9)[:, None, :]
    first = np.broadcast_to(keys[:-1], (9, count, 4)).astype(complex)
    q, end = _advanced(first, moved, np.diff(times))
    columns = []
    for segment in range(count):
        for entry in range(9):
            own, own_q, own_end = states.astype(complex), q[entry].real + 0j, end[entry].real + 0j
            own[segment], own_q[segment], own_end[segment] = (
                moved[entry, segment],
                q[entry, segment],
                end[entry, segment],
            )
            columns.append(np.imag(_closing(keys, own, own_q, own_end)) / TINY)
    return np.stack(columns, axis=1)
