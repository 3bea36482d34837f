"""What a soft constraint is: a function f_j of samples (y, y', y''), never negative, with its exact gradient (eq. 1).

A penalty never sees unknowns, knots, masks or weights, so the same object feeds the optimiser and the Euler-Lagrange
residual. A new soft constraint is one class here, one Taylor test, one row in the runner's table.
"""

from __future__ import annotations

from typing import Protocol

from ..kinematics import Cotangent, Samples
from ..quaternion import Array


class Penalty(Protocol):
    """A soft constraint f_j."""

    @property
    def name(self) -> str:
        """How the report calls it."""
        ...

    @property
    def reference(self) -> float:
        """f_j of a violation of 1 cm or 1°, or of 8 rad (2 m) per squared key spacing: the scale of a term that starts
        at zero. Accelerations are given for keyframes 1 s apart."""
        ...

    @property
    def is_violation(self) -> bool:
        """Whether f_j is zero wherever a constraint is kept, like a depth, and not a cost of all motion."""
        ...

    @property
    def time_power(self) -> int:
        """f_j of a clip played λ times slower falls by λ to this power: 4 for squared accelerations."""
        ...

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        """f_j at every sample, (S,); with `into`, also adds the gradient of Σ_s scale_s f_j(s) to it."""
        ...
