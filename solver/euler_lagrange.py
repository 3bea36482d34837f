"""The Euler-Lagrange residual of a path (eqs. 8, 10, 11, 24), its deviation per segment, and the weak form.

Strong form: R(t) = g₀ − dg₁/dt + d²g₂/dt² from any penalty's sample gradients; for the paper's quaternion objective
also in closed form, which is *half* of R. Inside a cubic span q'''' = 0; at a knot q''' jumps, so nothing is ever
differenced across one.

Weak form (beyond the paper): a variable frame inserted at τ on the curve has the gradient g = ∫ (g₀φ + g₁φ' + g₂φ'') dt
for its cardinal function φ. No strong derivative is needed, the jumps at the knots are in it, and it goes to zero.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .kinematics import Samples
from .objective import Objective
from .quadrature import gauss_nodes
from .quaternion import Array
from .spline import Path, Spline

NODES = 8
DIFFERENCE = 1e-6
BATCH = 1000
WINDOW = 60
REACH = 8


def covariant_residual(path: Path, t: Array, unit_weight: float) -> Array:
    """X + Y'' + Z of eq. 10 for f = f₂ + λ f₁ on one quaternion, λ = unit_weight: (S, 4). Half of eq. 24's left."""
    q, q_d, q_dd, q_ddd = (path.at(t, order) for order in range(4))

    def inner(a: Array, b: Array) -> Array:
        return np.sum(a * b, axis=1, keepdims=True)

    b = inner(q, q)
    b_d, b_dd = 2 * inner(q, q_d), 2 * (inner(q_d, q_d) + inner(q, q_dd))
    a = inner(q, q_dd)
    a_d = inner(q_d, q_dd) + inner(q, q_ddd)
    a_dd = inner(q_dd, q_dd) + 2 * inner(q_d, q_ddd)
    big_t = a / b
    t_d = (a_d - big_t * b_d) / b
    t_dd = (a_dd - 2 * t_d * b_d - big_t * b_dd) / b
    x = q * big_t**2 - q_dd * big_t
    y_dd = -(q_dd * big_t + 2 * q_d * t_d + q * t_dd)
    return x + y_dd + 2 * unit_weight * (b - 1) * q


def tangential(residual: Array, q: Array) -> Array:
    """The part of a residual (S, 4) that the rotation feels: off q (S, 4)."""
    along = np.sum(residual * q, axis=1, keepdims=True) / np.sum(q * q, axis=1, keepdims=True)
    return residual - along * q


@dataclass(frozen=True)
class Residual:
    """R at Gauss nodes inside every knot span: t (P, n) [s], weights (P, n) [s], value (P, n, N)."""

    t: Array
    weights: Array
    value: Array

    @property
    def size(self) -> Array:
        """|R| (P, n)."""
        return np.linalg.norm(self.value, axis=2)

    def deviation(self) -> Array:
        """∫ |R| dt over every span between neighbouring frames, (P,)."""
        return np.sum(self.weights * self.size, axis=1)

    def shares(self, count: int = 10) -> Array:
        """∫ |R| dt over equal parts of the clip (figure 10), (count,)."""
        # a node stands for a cell as wide as its weight; cells that reach over an edge of a part are divided there
        edges = np.concatenate([[0.0], np.cumsum(self.weights)])
        total = np.concatenate([[0.0], np.cumsum(self.weights * self.size)])
        return np.diff(np.interp(np.linspace(0, edges[-1], count + 1), edges, total))


def residual(objective: Objective, path: Path) -> Residual:
    """The strong residual of any objective, by differentiating g₁ and g₂ as polynomials inside each span."""
    edges = np.asarray(path.spline.times)
    t, w = gauss_nodes(edges, NODES)
    samples = objective.samples(path, t)
    g0, g1, g2 = (g.reshape(edges.size - 1, NODES, -1) for g in objective.sample_gradients(samples))
    derive = _differentiation_matrix(np.polynomial.legendre.leggauss(NODES)[0])
    rate = (2 / np.diff(edges))[:, None, None]
    value = g0 - rate * (derive @ g1) + rate**2 * (derive @ (derive @ g2))
    return Residual(t.reshape(-1, NODES), w.reshape(-1, NODES), value)


def _differentiation_matrix(x: Array) -> Array:
    """D with (D f)(x_i) = f'(x_i) for polynomials through the nodes x (Berrut & Trefethen, SIAM Review 2004)."""
    gaps = x[:, None] - x[None, :] + np.eye(x.size)
    w = 1 / np.prod(gaps, axis=1)
    matrix = w[None, :] / w[:, None] / gaps
    np.fill_diagonal(matrix, 0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return matrix


def sample_hessians(objective: Objective, samples: Samples) -> Array:
    """∂²f/∂(y, y', y'')² at every sample, (S, 3N, 3N), by differencing the exact gradients; for ranking, not for E.

    Columns are moved several at a time, on copies of the samples, to keep the batches long.
    """
    base = [samples.y, samples.y_d, samples.y_dd]
    count, width = base[0].shape
    out = np.empty((count, 3 * width, 3 * width))
    here = np.hstack(objective.sample_gradients(samples))
    together = max(1, BATCH // count)
    for order in range(3):
        h = DIFFERENCE * max(np.sqrt(np.mean(base[order] ** 2)), 1.0)
        for first in range(0, width, together):
            columns = np.arange(first, min(first + together, width))
            moved = [np.tile(part, (columns.size, 1)) for part in base]
            for k, column in enumerate(columns):
                moved[order][k * count : (k + 1) * count, column] += h
            stacked = Samples(samples.figure, *moved, t=np.tile(samples.t, columns.size))
            there = np.hstack(objective.sample_gradients(stacked)).reshape(columns.size, count, -1)
            out[:, order * width + columns] = (there - here).transpose(1, 0, 2) / h
    return (out + out.transpose(0, 2, 1)) / 2


@dataclass(frozen=True)
class WeakForm:
    """What it takes to try variable frames anywhere on a path: g₀, g₁, g₂ (S, N) of f at Gauss points t (S,) [s]."""

    objective: Objective
    path: Path
    halves: Array
    t: Array
    weights: Array
    gradients: tuple[Array, Array, Array]

    @classmethod
    def of(cls, objective: Objective, path: Path) -> WeakForm:
        times = np.asarray(path.spline.times)
        halves = np.sort(np.concatenate([times, (times[1:] + times[:-1]) / 2]))
        t, w = gauss_nodes(halves, 6)
        return cls(objective, path, halves, t, w, objective.sample_gradients(objective.samples(path, t)))

    def decrements(self, candidates: Array) -> Array:
        """½ gᵀH⁻¹g of a variable frame inserted at each of the times (C,), its own block: how much E would fall.

        Good for ranking; 1.3-5.8 times too small for the one frame, and 0.55-1.4 times the whole gap when summed over
        the middles of all segments. On a loop whose quaternions come back as −q the seam's share of g is left out.
        """
        width = self.gradients[0].shape[1]
        cardinals = [self._cardinal(float(tau)) for tau in candidates]
        phi = np.array([self._values(cardinal, self.t) for cardinal in cardinals]) * self.weights
        gradient = sum((phi[:, k] @ self.gradients[k] for k in range(3)), np.zeros((len(phi), width)))
        hessian = self._hessians(candidates, cardinals, width)
        return np.array([newton_decrement(g, h) for g, h in zip(gradient, hessian, strict=True)])

    def _hessians(self, candidates: Array, cardinals: list[tuple[Spline, Array]], width: int) -> Array:
        """(C, N, N): ∫ Σ φ⁽ᵃ⁾φ⁽ᵇ⁾ ∂²f/∂y⁽ᵃ⁾∂y⁽ᵇ⁾ dt, window by window, each seen by the frames near it."""
        out = np.zeros((len(candidates), width * width))
        times = np.asarray(self.path.spline.times)
        for first in range(0, self.halves.size - 1, WINDOW):
            edges = self.halves[first : first + WINDOW + 1]
            nodes, shares = gauss_nodes(edges, 2)
            place = np.searchsorted(times, candidates)
            left, right = np.searchsorted(times, edges[[0, -1]])
            near = np.flatnonzero((place >= left - REACH) & (place <= right + REACH))
            if not near.size:
                continue
            samples = self.objective.samples(self.path, nodes)
            blocks = sample_hessians(self.objective, samples).reshape(nodes.size, 3, width, 3, width)
            phi = np.array([self._values(cardinals[c], nodes) for c in near])
            for a in range(3):
                for b in range(3):
                    flat = np.ascontiguousarray(blocks[:, a, :, b]).reshape(nodes.size, -1)
                    out[near] += (phi[:, a] * phi[:, b] * shares) @ flat
        return out.reshape(-1, width, width)

    def _cardinal(self, tau: float) -> tuple[Spline, Array]:
        """The spline with a variable frame inserted at τ, and that frame's φ as coefficients (M + 3, 1)."""
        times = np.sort(np.append(self.path.spline.times, tau))
        spline = Spline(times, self.path.spline.ends)
        unit = np.zeros((spline.size, 1))
        unit[np.searchsorted(times, tau)] = 1
        return spline, spline.coefficients(unit)

    @staticmethod
    def _values(cardinal: tuple[Spline, Array], t: Array) -> Array:
        """φ, φ', φ'' (3, S) at t."""
        spline, coefficients = cardinal
        return np.array([(spline.basis(t, order) @ coefficients)[:, 0] for order in range(3)])


def newton_decrement(gradient: Array, hessian: Array) -> float:
    """½ gᵀ|H|⁻¹g, with |H| from the eigenvalues' absolute values, small ones raised to 10⁻⁶ of the largest."""
    eigenvalues, vectors = np.linalg.eigh(hessian)
    size = np.maximum(np.abs(eigenvalues), 1e-6 * max(np.abs(eigenvalues).max(), 1e-300))
    return float(0.5 * np.sum((vectors.T @ gradient) ** 2 / size))
