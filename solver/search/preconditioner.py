"""Change of variables by the curvature of E, for NLopt: x = x₀ + P z with P Pᵀ = c (H + λF + 2 Σ c_p r_p r_pᵀ)⁻¹.

The sum is over the one-sided residuals that count at the model's minimum (model.py has H, F and r).

In z the Gauss-Newton model is a sphere, so a quasi-Newton method starts with the right metric. z moves the B-splines'
coefficients by the model's banded Cholesky factor L, P = √c L⁻ᵀ seen in the unknowns; what is fixed is held by the
model's stiff springs, so z has more entries than x.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

from ..array import Array
from .quadratic import Layout


@dataclass(frozen=True, eq=False)
class Preconditioner:
    """The linear map z -> x − x₀, and its transpose for gradients.

    factor  ((M + 2) N, band) Cholesky's factor of a model's curvature
    value   c, the size of E, so that E / c has the curvature 1 in z
    """

    layout: Layout
    factor: Array
    value: float

    @property
    def size(self) -> int:
        """How many entries z has."""
        return self.layout.count * self.layout.width

    def to_x(self, z: Array) -> Array:
        """P z, (n,)."""
        return self.layout.to_x(self.layout.coloured(self.factor, sqrt(self.value) * z))

    def gradient(self, g: Array) -> Array:
        """Pᵀ g, of z's length."""
        return sqrt(self.value) * self.layout.whitened(self.factor, self.layout.from_x(g))
