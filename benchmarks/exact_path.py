"""The exact covariant interpolation of unit quaternions, an oracle that shares no code with the solver.

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

from dynsplines.solver.array import Array

ORDER = 20
STEPS, MOST_STEPS = 4, 24
TURN = 3.0  # radians a Taylor step, which leaves a millionth of ω'' at most
CLOSED = 1e-12
TINY = 1e-30


def _cross(a: NDArray, b: NDArray) -> NDArray:
    """Cross product of (..., 3) arrays; NumPy's own takes several times as long."""
    (a1, a2, a3), (b1, b2, b3) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    return np.stack([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1], axis=-1)


def _product(p: NDArray, q: NDArray) -> NDArray:
    """Hamilton product of (..., 4) arrays, real or complex."""
    vector = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + _cross(p[..., 1:], q[..., 1:])
    scalar = p[..., :1] * q[..., :1] - np.sum(p[..., 1:] * q[..., 1:], axis=-1, keepdims=True)
    return np.concatenate([scalar, vector], axis=-1)


def _conjugate(q: NDArray) -> NDArray:
    return q * np.array([1, -1, -1, -1])


def _pure(v: NDArray) -> NDArray:
    return np.concatenate([np.zeros_like(v[..., :1]), v], axis=-1)


def _omega_series(state: NDArray) -> NDArray:
    """Taylor coefficients (ORDER + 1, ..., 3) of ω from ω''' = −ω × ω'', state (..., 9) = (ω, ω', ω'')."""
    a = np.zeros((ORDER + 1, *state.shape[:-1], 3), state.dtype)
    a[0], a[1], a[2] = state[..., :3], state[..., 3:6], state[..., 6:] / 2
    second = np.zeros_like(a)  # coefficients of ω''
    second[0] = state[..., 6:]
    for n in range(ORDER - 2):
        total = _cross(a[: n + 1], second[n::-1]).sum(axis=0)
        a[n + 3] = -total / ((n + 3) * (n + 2) * (n + 1))
        second[n + 1] = (n + 3) * (n + 2) * a[n + 3]
    return a


def _orientation_series(q: NDArray, omega: NDArray) -> NDArray:
    """Taylor coefficients (ORDER + 1, ..., 4) of Q from Q' = ½ Q ω."""
    c = np.zeros((ORDER + 1, *q.shape), np.result_type(q, omega))
    c[0] = q
    pure = _pure(omega)
    for n in range(ORDER):
        c[n + 1] = _product(c[: n + 1], pure[n::-1]).sum(axis=0) / (2 * (n + 1))
    return c


def _series_at(coefficients: NDArray, t: NDArray, order: int = 0) -> NDArray:
    """The order-th derivative at t (...) of series (ORDER + 1, ..., n), by Horner's rule."""
    value = np.zeros_like(coefficients[0])
    for k in range(coefficients.shape[0] - 1, order - 1, -1):
        value = value * t[..., None] + coefficients[k] * (factorial(k) / factorial(k - order))
    return value


def _advanced(q: NDArray, state: NDArray, h: NDArray) -> tuple[NDArray, NDArray]:
    """Orientation and (ω, ω', ω'') after a time h (...), in Taylor steps, more of them the further it turns."""
    count = _steps(state, h)
    for _ in range(count):
        omega = _omega_series(state)
        q = _series_at(_orientation_series(q, omega), h / count)
        state = np.concatenate([_series_at(omega, h / count, k) for k in range(3)], axis=-1)
    return q, state


def _steps(state: NDArray, h: NDArray) -> int:
    """How many Taylor steps it takes for a time h (...), by the most that ω with its slopes may turn."""
    first, second, third = (np.linalg.norm(np.real(state[..., k : k + 3]), axis=-1) for k in (0, 3, 6))
    turn = float(np.max(h * (first + h * (second / 2 + h * third / 6))))
    return int(np.clip(np.ceil(turn / TURN), STEPS, MOST_STEPS)) if np.isfinite(turn) else STEPS


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
        shortened = _shortened(times, keys, states, step)
        if shortened is None:
            raise ArithmeticError(f"multiple shooting is stuck with a gap of {np.linalg.norm(gap):.2g}")
        states, gap = shortened
    return ExactPath(times, keys, states)


def _shortened(times: Array, keys: Array, states: Array, step: Array) -> tuple[Array, Array] | None:
    """States and gaps after the longest of step, step / 2, … that closes the gaps enough, if one does."""
    gap = np.linalg.norm(_gaps(times, keys, states))
    for share in 0.5 ** np.arange(14):
        tried = states + share * step
        remaining = _gaps(times, keys, tried)
        if np.linalg.norm(remaining) < (1 - 0.1 * share) * gap:
            return tried, remaining
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
    """d gaps / d states, by complex steps: all segments' end values at once, each beside its neighbour's start."""
    count = len(states)
    moved = states[None] + 1j * TINY * np.eye(9)[:, None, :]
    first = np.broadcast_to(keys[:-1], (9, count, 4)).astype(complex)
    q, end = _advanced(first, moved, np.diff(times))
    miss = 2 * np.imag(_product(_conjugate(keys[1:]), q)[..., 1:]) / TINY
    rates = np.imag(end[..., :6]) / TINY
    out = np.zeros((9 * count, count, 9))
    for i in range(count):
        out[3 * i : 3 * i + 3, i] = miss[:, i].T
        jumps = 3 * count + 6 * i
        if i < count - 1:
            out[jumps : jumps + 6, i] = rates[:, i].T
            out[jumps : jumps + 6, i + 1] = -np.eye(6, 9)
    out[-6:-3, 0, 3:6] = np.eye(3)
    out[-3:, -1] = rates[:, -1, 3:].T
    return out.reshape(9 * count, 9 * count)
