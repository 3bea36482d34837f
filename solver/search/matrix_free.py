"""Minimisation of E for figures of so many joints that the matrices of Newton's steps would fill the memory.

Their blocks grow with the square of the joints. Here nothing does: NLopt's limited-memory BFGS searches in variables
that the flat acceleration energy of each column of the state whitens, a banded factor a column.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..array import Array
from ..curve import banded
from ..objective import Discretised
from .minimum import Improved, Minimum, Stop, StopSearch
from .newton import FIRST_DAMPING, Search
from .quadratic import STIFF, Layout
from .refinement import minimise

METHOD = "lbfgs"
SMALL = 1e-4  # of the step that would bring E to nought: along the gradient, to see how E curves
MEND = 4  # times the tolerance: a start over that lowers E by less is the last


def matrix_free(
    problem: Discretised,
    *,
    max_evaluations: int,
    tolerance: float,
    improved: Improved | None = None,
) -> Minimum:
    """As `GaussNewton`, in memory that is linear in the number of joints."""
    search = Search(problem, max_evaluations, FIRST_DAMPING, improved)
    try:
        stop = search.begun() or _run(search, tolerance)
    except (KeyboardInterrupt, StopSearch):
        stop = Stop.ASKED
    return search.minimum(stop)


def _run(search: Search, tolerance: float) -> Stop:
    """Searches on from the best point, with a metric of a new size, until that gains little."""
    metric = FlatMetric(search.layout)
    while search.count < search.budget:
        if search.is_negligible(_promised(search, metric), tolerance):
            return Stop.CONVERGED
        if search.count >= search.budget:
            break
        before, around = search.value, search.x

        def fun(z: Array, around: Array = around) -> tuple[float, Array]:
            found = search.evaluated(around + metric.to_x(z))
            return found.value, metric.gradient(found.gradient)

        found = minimise(
            fun,
            np.zeros(metric.size),
            method=METHOD,
            max_evaluations=search.budget - search.count,
            tolerance=tolerance,
        )
        if found.stop is Stop.ASKED:
            raise StopSearch
        if search.is_negligible(before - search.value, MEND * tolerance):
            return Stop.CONVERGED
    return Stop.BUDGET


def _promised(search: Search, metric: FlatMetric) -> float:
    """How far E would fall along its gradient, by how that changes on a small part of the way; sets the unit."""
    x, value, gradient = search.x, search.value, search.gradient
    metric.unit = 1.0
    direction = metric.gradient(gradient)
    steep = float(direction @ direction)
    if steep <= 0 or value <= 0:
        return 0.0
    step = SMALL * value / steep
    there = search.evaluated(x - metric.to_x(step * direction))
    curvature = float(direction @ (direction - metric.gradient(there.gradient))) / (step * steep)
    metric.unit = steep / value  # the first step of a search brings E half-way to nought, by the metric
    return 0.5 * steep / curvature if np.isfinite(curvature) and curvature > 0 else value


class FlatMetric:
    """The change of variables x = x₀ + P z with P Pᵀ = A⁻¹ / unit: A the flat energy, what is fixed held by springs.

    factors  (N, M + 2, K + 1) Cholesky's factor of every column of the state
    unit     A's size beside E's curvature
    """

    def __init__(self, layout: Layout) -> None:
        self.layout, self.unit = layout, 1.0
        flat = layout.flat + 0.0
        springs = layout.springs_by_column() * (STIFF * float(np.median(flat[:, 0])))
        self.factors = np.empty((layout.width, *flat.shape))
        for column in range(layout.width):
            factor = banded.factored(flat + springs[:, :, column])
            if factor is None:
                factor = banded.factored(flat + 0.0)
            assert factor is not None, "the flat energy weighs positions too"
            self.factors[column] = factor

    @property
    def size(self) -> int:
        """How many entries z has."""
        return self.layout.count * self.layout.width

    def to_x(self, z: Array) -> Array:
        """P z, (n,)."""
        shape = (self.layout.width, self.layout.count)
        steps = np.empty(shape)
        for column, own in enumerate(z.reshape(shape)):
            steps[column] = banded.other_half_solved(self.factors[column], own[:, None])[:, 0]
        return self.layout.to_x(steps.T[self.layout.rank] / sqrt(self.unit))

    def gradient(self, g: Array) -> Array:
        """Pᵀ g, of z's length."""
        pulled = self.layout.from_x(g)[self.layout.order].T / sqrt(self.unit)
        out = np.empty(pulled.shape)
        for column, own in enumerate(pulled):
            out[column] = banded.half_solved(self.factors[column], own[:, None])[:, 0]
        return out.ravel()
