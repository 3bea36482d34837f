"""Change of variables by the flat acceleration energy, for NLopt: x = x₀ + P z, P Pᵀ ≈ (∫ φ''φ''ᵀ + ε ∫ φφᵀ)⁻¹.

In z the acceleration energy of a flat space is a sphere, so a quasi-Newton method starts with the right metric. z moves
the B-splines' coefficients, among which the metric is banded: one factor serves every column and costs as much as the
clip is long. Frames of which something is fixed are held by stiff springs, so z has more entries than x; entries of
partial keyframes are scaled by their own diagonal.
"""

from __future__ import annotations

import numpy as np
from scipy import sparse

from . import banded
from .objective import Discretised
from .quaternion import Array
from .spline import DEGREE

SHARE_OF_POSITION = 0.3
STIFF = 1e6


class Preconditioner:
    """The linear map z -> x − x₀ of a discretised objective, and its transpose for gradients."""

    def __init__(self, problem: Discretised) -> None:
        unknowns, spline, weights = problem.unknowns, problem.spline, problem.weights
        self.width, self.count = problem.timeline.width, spline.size
        self.rows = sparse.csr_matrix(
            sparse.vstack([spline.basis(spline.times, 0), spline.basis(spline.times[[0, -1]], 1)])
        )
        bases = problem.sampling.bases
        spacing = (spline.times[-1] - spline.times[0]) / max(sum(not f.is_variable for f in problem.timeline.frames), 2)
        metric = _weighed(bases[2], weights) + SHARE_OF_POSITION / spacing**4 * _weighed(bases[0], weights)
        coefficients = spline.coefficients(problem.timeline.rows)
        metric = metric * (2 / max(float(np.sum(coefficients * (metric @ coefficients))), 1e-12))
        self.blocks, self.whole = unknowns.blocks, unknowns.whole
        self.loose = np.setdiff1d(np.arange(unknowns.size), self.blocks)
        self.scale = 1 / np.sqrt(np.maximum((self.rows @ metric.diagonal())[unknowns.row_of[self.loose]], 1e-300))
        held = np.ones(self.count)
        held[self.whole] = 0
        stiffness = STIFF * float(np.median(metric.diagonal()))
        sizes = np.asarray(self.rows.multiply(self.rows).sum(axis=1)).ravel()
        metric = metric + self.rows.T @ sparse.diags(stiffness * held / sizes) @ self.rows
        self.factor = _banded_factor(sparse.csr_matrix(metric))

    @property
    def size(self) -> int:
        """How many entries z has."""
        return self.count * self.width + self.loose.size

    def to_x(self, z: Array) -> Array:
        """P z, (n,)."""
        x = np.empty(self.blocks.size + self.loose.size)
        flat = self.count * self.width
        moved = banded.other_half_solved(self.factor, z[:flat].reshape(self.count, -1))
        x[self.blocks] = (self.rows @ moved)[self.whole]
        x[self.loose] = self.scale * z[flat:]
        return x

    def gradient(self, g: Array) -> Array:
        """Pᵀ g, of z's length."""
        rows = np.zeros((self.count, self.width))
        rows[self.whole] = g[self.blocks]
        moved = banded.half_solved(self.factor, self.rows.T @ rows)
        return np.concatenate([moved.ravel(), self.scale * g[self.loose]])


def _weighed(basis: sparse.csr_matrix, weights: Array) -> sparse.csr_matrix:
    """Bᵀ W B."""
    return sparse.csr_matrix(basis.T @ sparse.diags(weights) @ basis)


def _banded_factor(metric: sparse.csr_matrix) -> Array:
    """Cholesky's L of a banded matrix."""
    size = metric.get_shape()[0]
    band = np.zeros((size, DEGREE + 1))
    for k in range(min(DEGREE + 1, size)):
        band[: size - k, k] = metric.diagonal(-k)
    band[:, 0] *= 1 + 1e-12
    factor = banded.factored(band)
    if factor is None:
        raise ArithmeticError("the acceleration energy of these times has no factor; are frames too close?")
    return factor
