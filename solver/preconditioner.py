"""Change of variables by the flat acceleration energy: x = x₀ + P z with P = L⁻ᵀ, L Lᵀ = ∫ φ''φ''ᵀ + ε ∫ φφᵀ.

In z the acceleration energy of a flat space is a sphere, so a quasi-Newton method starts with the right metric. The
same factor serves every column; entries of partial keyframes are scaled by their own diagonal.
"""

from __future__ import annotations

import numpy as np
from scipy import linalg, sparse

from .objective import Discretised
from .quaternion import Array
from .spline import Spline

SHARE_OF_POSITION = 0.3


class Preconditioner:
    """The linear map z -> x − x₀ of a discretised objective, and its transpose for gradients."""

    def __init__(self, problem: Discretised) -> None:
        unknowns, sampling = problem.unknowns, problem.sampling
        self.width = problem.timeline.width
        spline = problem.spline
        weights = problem.weights
        energy = _mass(spline, sampling.bases[2], weights)
        position = _mass(spline, sampling.bases[0], weights)
        spacing = (spline.times[-1] - spline.times[0]) / max(sum(not f.is_variable for f in problem.timeline.frames), 2)
        metric = energy + SHARE_OF_POSITION / spacing**4 * position
        rows = problem.timeline.rows
        metric *= 2 / max(float(np.sum(rows * (metric @ rows))), 1e-12)
        self.blocks = unknowns.blocks
        self.scale = 1 / np.sqrt(np.maximum(np.diag(metric)[unknowns.row_of], 1e-300))
        whole = metric[np.ix_(unknowns.whole, unknowns.whole)]
        self.factor = linalg.cholesky(whole, lower=True) if whole.size else whole

    def to_x(self, z: Array) -> Array:
        """P z, (n,)."""
        x = self.scale * z
        if self.blocks.size:
            block = linalg.solve_triangular(self.factor, z[self.blocks], lower=True, trans=1, check_finite=False)
            x[self.blocks] = block
        return x

    def gradient(self, g: Array) -> Array:
        """Pᵀ g, (n,)."""
        out = self.scale * g
        if self.blocks.size:
            out[self.blocks] = linalg.solve_triangular(self.factor, g[self.blocks], lower=True, check_finite=False)
        return out


def _mass(spline: Spline, basis: sparse.csr_matrix, weights: Array) -> Array:
    """∫ φ φᵀ dt of the cardinal functions' derivatives, (M + 2, M + 2)."""
    inner = (basis.T @ basis.multiply(weights[:, None])).toarray()
    return spline.coefficients_transposed(spline.coefficients_transposed(inner).T)
