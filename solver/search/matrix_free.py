"""Minimisation of E for figures with so many joints that Newton's matrices would not fit in memory.

The blocks of those matrices grow with the square of the number of joints. Here memory is linear in it: NLopt's
limited-memory BFGS uses variables whitened by the flat acceleration energy, with one banded Cholesky factor per column
of the state.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..array import Array
from ..curve import banded
from ..objective import Discretised
from .minimum import Improved, Minimum, Stop, StopSearch
from .newton import FIRST_DAMPING, Search
from .nlopt_methods import minimise
from .quadratic import STIFF, Layout

METHOD = "lbfgs"
SMALL = 1e-4  # [1] length of the step that probes E's curvature, relative to one that lowers E to zero at this slope
RESTART_GAIN = 4  # [1] multiple of the tolerance; the search ends when a restart gains less than this share of E


def matrix_free(
    problem: Discretised,
    *,
    max_evaluations: int,
    tolerance: float,
    improved: Improved | None = None,
) -> Minimum:
    """Minimise E like `GaussNewton`, in memory that is linear in the number of joints; see `Optimiser`."""
    search = Search(problem, max_evaluations, FIRST_DAMPING, improved)
    try:
        stop = search.start() or _run(search, tolerance)
    except (KeyboardInterrupt, StopSearch):
        stop = Stop.INTERRUPTED
    return search.minimum(stop)


def _run(search: Search, tolerance: float) -> Stop:
    """Restart from the best point, each time with a newly scaled metric, until a restart gains little."""
    metric = FlatMetric(search.layout)
    while search.count < search.budget:
        if search.is_negligible(_predicted_reduction(search, metric), tolerance):
            return Stop.CONVERGED
        if search.count >= search.budget:
            break
        before, around = search.value, search.x

        def fun(z: Array, around: Array = around) -> tuple[float, Array]:
            result = search.evaluate(around + metric.to_x(z))
            return result.value, metric.gradient(result.gradient)

        result = minimise(
            fun,
            np.zeros(metric.size),
            method=METHOD,
            max_evaluations=search.budget - search.count,
            tolerance=tolerance,
        )
        if result.stop is Stop.INTERRUPTED:
            raise StopSearch
        if search.is_negligible(before - search.value, RESTART_GAIN * tolerance):
            return Stop.CONVERGED
    return Stop.MAX_EVALUATIONS


def _predicted_reduction(search: Search, metric: FlatMetric) -> float:
    """Return the reduction of E that a probe along its gradient predicts, and set the metric's unit."""
    x, value, gradient = search.x, search.value, search.gradient
    metric.unit = 1.0
    direction = metric.gradient(gradient)
    squared_slope = float(direction @ direction)
    if squared_slope <= 0 or value <= 0:
        return 0.0
    step = SMALL * value / squared_slope
    trial = search.evaluate(x - metric.to_x(step * direction))
    curvature = float(direction @ (direction - metric.gradient(trial.gradient))) / (step * squared_slope)
    metric.unit = squared_slope / value  # in this unit, the first step of a search halves E
    return 0.5 * squared_slope / curvature if np.isfinite(curvature) and curvature > 0 else value


class FlatMetric:
    """The change of variables x = x₀ + P z with P Pᵀ = A⁻¹ / unit.

    A is the matrix of the flat acceleration energy, with springs on fixed degrees of freedom.

    Attributes:
        factors: The banded Cholesky factor for each column of the state, (N, M + 2, K + 1).
        unit: The ratio of A to the curvature of E.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout, self.unit = layout, 1.0
        flat = layout.flat + 0.0
        springs = layout.springs_by_column() * (STIFF * float(np.median(flat[layout.used, 0])))
        self.factors = np.empty((layout.width, *flat.shape))
        for column in range(layout.width):
            factor = banded.factored(flat + springs[:, :, column])
            if factor is None:
                factor = banded.factored(flat + 0.0)
            assert factor is not None, "the flat energy weighs positions too"
            self.factors[column] = factor

    @property
    def size(self) -> int:
        return self.layout.count * self.layout.width

    def to_x(self, z: Array) -> Array:
        """Return P z (n,) for z (size,)."""
        shape = (self.layout.width, self.layout.count)
        steps = np.empty(shape)
        for column, entries in enumerate(z.reshape(shape)):
            steps[column] = banded.other_half_solved(self.factors[column], entries[:, None])[:, 0]
        return self.layout.to_x(steps.T[self.layout.rank] / sqrt(self.unit))

    def gradient(self, g: Array) -> Array:
        """Return Pᵀ g (size,) for g (n,)."""
        pulled = self.layout.from_x(g)[self.layout.order].T / sqrt(self.unit)
        out = np.empty(pulled.shape)
        for column, entries in enumerate(pulled):
            out[column] = banded.half_solved(self.factors[column], entries[:, None])[:, 0]
        return out.ravel()
