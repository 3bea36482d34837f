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

from .curvature import Curvature
from .objective import Objective
from .quadrature import gauss_nodes
from .quaternion import Array
from .spline import Path, Spline

NODES = 8
GRADIENT_NODES, HESSIAN_NODES = 6, 2
WINDOW = 60
REACH = 5
FAINT = 1e-9


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
        t, w = gauss_nodes(halves, GRADIENT_NODES)
        return cls(objective, path, halves, t, w, objective.sample_gradients(objective.samples(path, t)))

    def decrements(self, candidates: Array) -> Array:
        """½ gᵀH⁻¹g of a variable frame inserted at each of the times (C,), its own block: how much E would fall.

        H is the Gauss-Newton curvature. Good for ranking; some times too small for the one frame, and about the whole
        gap to the optimum when summed over the middles of all segments. On a loop whose quaternions come back as −q the
        seam's share of g is left out.
        """
        width = self.gradients[0].shape[1]
        cardinals = [self._cardinal(float(tau)) for tau in candidates]
        gradient = np.zeros((len(cardinals), width))
        for row, cardinal in zip(gradient, cardinals, strict=True):
            phi = self._values(cardinal, self.t) * self.weights[:, None]
            row[:] = sum(phi[:, k] @ self.gradients[k] for k in range(3))
        hessian = self._hessians(candidates, cardinals, width)
        size = np.einsum("cnn->c", hessian) / width
        hessian += FAINT * np.maximum(size, 1e-300)[:, None, None] * np.eye(width)
        return 0.5 * np.sum(gradient * np.linalg.solve(hessian, gradient[:, :, None])[:, :, 0], axis=1)

    def _hessians(self, candidates: Array, cardinals: list[tuple[Spline, Array]], width: int) -> Array:
        """(C, N, N): ∫ Σ φ⁽ᵃ⁾φ⁽ᵇ⁾ ∂²f/∂y⁽ᵃ⁾∂y⁽ᵇ⁾ dt, window by window, each seen by the frames near it."""
        out = np.zeros((len(candidates), width, width))
        times = np.asarray(self.path.spline.times)
        place = np.searchsorted(times, candidates)
        begin, end = times[np.maximum(place - REACH, 0)], times[np.minimum(place + REACH, times.size) - 1]
        for first in range(0, self.halves.size - 1, WINDOW):
            edges = self.halves[first : first + WINDOW + 1]
            near = np.flatnonzero((begin < edges[-1]) & (end > edges[0]))
            if not near.size:
                continue
            nodes, shares = gauss_nodes(edges, HESSIAN_NODES)
            curvature = self._curvature(nodes, shares)
            for c in near:
                from_, to = np.searchsorted(nodes, [begin[c], end[c]])
                out[c] += curvature.quadratic(self._values(cardinals[c], nodes), int(from_), int(to))
        return out

    def _curvature(self, nodes: Array, shares: Array) -> Curvature:
        """The curvature of E at nodes with their weights."""
        samples = self.objective.samples(self.path, nodes)
        curvature = Curvature(samples)
        for term in self.objective.terms:
            term.penalty.curvature(samples, curvature, term.factor * shares)
            sides = term.penalty.sides(samples)
            if sides is not None:
                curvature.add_sides(sides, term.factor * shares)
        return curvature

    def _cardinal(self, tau: float) -> tuple[Spline, Array]:
        """The spline with a variable frame inserted at τ, and that frame's φ as coefficients (M + 3, 1)."""
        times = np.sort(np.append(self.path.spline.times, tau))
        spline = Spline(times, self.path.spline.ends)
        unit = np.zeros((spline.size, 1))
        unit[np.searchsorted(times, tau)] = 1
        return spline, spline.coefficients(unit)

    @staticmethod
    def _values(cardinal: tuple[Spline, Array], t: Array) -> Array:
        """φ, φ', φ'' (S, 3) at t."""
        spline, coefficients = cardinal
        return np.stack([(spline.basis(t, order) @ coefficients)[:, 0] for order in range(3)], axis=1)
