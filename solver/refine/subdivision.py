"""Subdivision: a variable frame at the middle of each badly approximated segment (step 5 of the paper's figure 5).

A criterion returns one number per segment between neighbouring frames; the segments with the largest are split.
"residual" is the paper's criterion: the residual of the Euler-Lagrange equation of E, eq. 4 of the paper. "weak", from
the weak form of this equation, predicts how much a split would reduce E.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..array import ENTRIES_AT_ONCE, Array, Index
from ..curve.frame import Frame, Timeline
from ..curve.quadrature import Quadrature, gauss_nodes
from ..curve.spline import REACH, Path, Sampling, Spline, path_of
from ..figure.kinematics import Samples
from ..objective import Objective
from ..penalty.block import one_sided_residuals
from ..penalty.curvature import Curvature
from ..search.quadratic import POINTS
from ..tolerances import ROUNDING, SMALLEST

# default initial number of variable frames per segment: FEW if the clip is solved as a whole, MORE if in windows
FEW, MORE = 2, 3
NODES = 8  # nodes per span of the strong form's integrals
WINDOW = 60  # maximum number of spans whose curvature is in memory


@dataclass(frozen=True)
class Residual:
    """R at Gauss nodes inside every knot span.

    Attributes:
        t: The nodes, (P, n) [s].
        weights: Their weights, (P, n) [s].
        value: R, (P, n, N).
    """

    t: Array
    weights: Array
    value: Array

    @property
    def size(self) -> Array:
        return np.linalg.norm(self.value, axis=2)

    def deviation(self) -> Array:
        """Return ∫ |R| dt over every span between neighbouring frames, (P,)."""
        return np.sum(self.weights * self.size, axis=1)


def residual(objective: Objective, path: Path) -> Residual:
    """Return the strong residual of any objective, with g₁ and g₂ differentiated as polynomials inside each span."""
    edges = np.asarray(path.spline.times)
    t, w = gauss_nodes(edges, NODES)
    samples = objective.samples(path, t)
    g0, g1, g2 = (g.reshape(edges.size - 1, NODES, -1) for g in objective.sample_gradients(samples))
    derive = _differentiation_matrix(np.polynomial.legendre.leggauss(NODES)[0])
    rate = (2 / np.diff(edges))[:, None, None]
    value = g0 - rate * (derive @ g1) + rate**2 * (derive @ (derive @ g2))
    return Residual(t.reshape(-1, NODES), w.reshape(-1, NODES), value)


def _differentiation_matrix(x: Array) -> Array:
    """Return D with (D f)(x_i) = f'(x_i) for polynomials through the nodes x (Berrut & Trefethen, SIAM Review 2004)."""
    gaps = x[:, None] - x[None, :] + np.eye(x.size)
    w = 1 / np.prod(gaps, axis=1)
    matrix = w[None, :] / w[:, None] / gaps
    np.fill_diagonal(matrix, 0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return matrix


def decrements(objective: Objective, path: Path, candidates: Array) -> Array:
    """Return ½ gᵀH⁻¹g, the predicted reduction of E by each variable frame at times (C,) [s] alone, (C,).

    g is the gradient of E in the new frame, and H the frame's own block of the Gauss-Newton curvature. The values rank
    candidates. Summed over the middles of all segments, they approximate the gap to the optimum. In a loop whose
    quaternions return as −q, the part of g from the seam is omitted.
    """
    spline = Spline(np.sort(np.append(path.spline.times, candidates)), path.spline.ends)
    place = np.searchsorted(spline.times, candidates)
    gradient, hessian = _gradients(objective, path, spline)[place], _hessians(objective, path, spline, place)
    width = gradient.shape[1]
    size = np.maximum(np.einsum("cnn->c", hessian) / width, SMALLEST)
    hessian += ROUNDING * size[:, None, None] * np.eye(width)  # so that it has an inverse
    return 0.5 * np.sum(gradient * np.linalg.solve(hessian, gradient[:, :, None])[:, :, 0], axis=1)


def _gradients(objective: Objective, path: Path, spline: Spline) -> Array:
    """Return dE/dY for the rows of a refined spline of a path, (M + 2, N)."""
    t, w = gauss_nodes(np.asarray(spline.times), Quadrature().points)
    gradients = objective.sample_gradients(objective.samples(path, t))
    return Sampling.of(spline, t).pulled_back([w[:, None] * g for g in gradients])


def _hessians(objective: Objective, path: Path, spline: Spline, place: Index) -> Array:
    """Return ∫ Σ φ⁽ᵃ⁾φ⁽ᵇ⁾ ∂²f/∂y⁽ᵃ⁾∂y⁽ᵇ⁾ dt for the frames' cardinal functions φ, window by window, (C, N, N)."""
    times = np.asarray(spline.times)
    out = np.zeros((place.size, path.rows.shape[1], path.rows.shape[1]))
    spans = max(1, min(WINDOW, ENTRIES_AT_ONCE // path.rows.shape[1] ** 2))
    for first in range(0, times.size - 1, spans):
        last = min(first + spans, times.size - 1)
        near = np.flatnonzero((place + REACH > first) & (place - REACH < last))
        if not near.size:
            continue
        nodes, shares = gauss_nodes(times[first : last + 1], POINTS)
        curvature = _curvature(objective, objective.samples(path, nodes), shares)
        unit = np.zeros((spline.size, near.size))
        unit[place[near], np.arange(near.size)] = 1
        coefficients = spline.coefficients(unit)
        phi = np.stack([spline.basis(nodes, order) @ coefficients for order in range(3)], axis=1)
        for k, c in enumerate(near):
            begin, end = (POINTS * (int(place[c]) + reach - first) for reach in (-REACH, REACH))
            out[c] += curvature.quadratic(phi[:, :, k], max(begin, 0), min(end, nodes.size))
    return out


def _curvature(objective: Objective, samples: Samples, shares: Array) -> Curvature:
    curvature = Curvature(samples)
    for term in objective.terms:
        scale, blocks = objective.factor(term, samples.t) * shares, tuple(term.penalty.residuals(samples))
        for block in blocks:
            block.add_to(curvature, scale)
        sides = one_sided_residuals(blocks, samples)
        if sides is not None:
            curvature.add_one_sided(sides, scale)
    return curvature


def midpoints(timeline: Timeline) -> Array:
    """Return the middle of every segment, (M − 1,) [s]."""
    times = timeline.times
    return (times[1:] + times[:-1]) / 2


def by_residual(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ |R| dt over every segment, (M − 1,), with R the residual of the Euler-Lagrange equation of E."""
    return residual(objective, path_of(timeline)).deviation()


def by_weak_form(objective: Objective, timeline: Timeline) -> Array:
    """Return the predicted reduction of E by a variable frame in the middle of every segment."""
    return decrements(objective, path_of(timeline), midpoints(timeline))


CRITERIA: dict[str, Callable[[Objective, Timeline], Array]] = {
    "weak": by_weak_form,
    "residual": by_residual,
}


def split(timeline: Timeline, times: Array) -> Timeline:
    """Return the timeline with variable frames at `times` [s], on its curve, which does not change."""
    states = path_of(timeline).at(times)
    return timeline.insert(Frame.many(times, states, np.zeros(states.shape, bool)))
