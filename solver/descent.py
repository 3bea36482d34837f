"""Steps 3 and 4 of the paper's figure 5 on one timeline: move its variable frames to the nearest minimum of E."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

from . import optimiser
from .frame import Timeline
from .gauss_newton import FIRST_DAMPING, gauss_newton
from .objective import Discretised, Evaluation, Objective
from .optimiser import Minimum, Stop, minimise
from .preconditioner import Preconditioner
from .quaternion import Array

NEWTON = "newton"
METHODS = {
    NEWTON: "Gauss-Newton steps on banded matrices",
    **{name: text for name, (_, text) in optimiser.METHODS.items()},
}


def check_method(method: str) -> None:
    """Raises ValueError for a name that is no method."""
    if method.lower() == NEWTON:
        return
    try:
        optimiser.algorithm(method)
    except ValueError:
        known = ", ".join(METHODS)
        raise ValueError(f"no optimiser '{method}'; there are: {known} (or any LD_ name of NLopt)") from None


class Descent:
    """The minimisation of E over one timeline's unknowns: by Gauss-Newton steps, or by NLopt's preconditioned ones.

    damping  of the Gauss-Newton steps, to begin with and as it was left
    """

    def __init__(self, objective: Objective, timeline: Timeline, *, damping: float = FIRST_DAMPING) -> None:
        self.problem: Discretised = objective.on(timeline)
        self.start = self.problem.unknowns.start
        self.damping = damping
        self.last: Evaluation | None = None

    @cached_property
    def preconditioner(self) -> Preconditioner:
        return Preconditioner(self.problem)

    def x(self, z: Array) -> Array:
        """The unknowns that z stands for."""
        return self.start + self.preconditioner.to_x(z)

    def __call__(self, z: Array) -> tuple[float, Array]:
        self.last = self.problem(self.x(z))
        return self.last.value, self.preconditioner.gradient(self.last.gradient)

    def run(
        self,
        *,
        method: str = NEWTON,
        max_evaluations: int = 300,
        tolerance: float = 1e-6,
        improved: Callable[[int, Evaluation, Array], None] | None = None,
    ) -> Minimum:
        """The Minimum, its x in the unknowns of the timeline; `improved` gets (evaluation, Evaluation, x)."""
        check_method(method)
        if method.lower() == NEWTON:
            found, self.damping = gauss_newton(
                self.problem,
                max_evaluations=max_evaluations,
                tolerance=tolerance,
                damping=self.damping,
                improved=improved,
            )
            return found

        def relay(count: int, _value: float, z: Array) -> None:
            assert self.last is not None
            if improved is not None:
                improved(count, self.last, self.x(z))

        start = 0 * self.preconditioner.gradient(self.start)
        found = minimise(
            self, start, method=method, max_evaluations=max_evaluations, tolerance=tolerance, improved=relay
        )
        return Minimum(self.x(found.x), found.value, found.evaluations, found.stop)


def optimised(
    objective: Objective, timeline: Timeline, *, max_evaluations: int = 300, tolerance: float = 1e-7
) -> Timeline:
    """The timeline with its variable frames at the nearest minimum of E. Ctrl-C goes on to the caller."""
    descent = Descent(objective, timeline)
    found = descent.run(max_evaluations=max_evaluations, tolerance=tolerance)
    if found.stop is Stop.ASKED:
        raise KeyboardInterrupt
    return timeline.with_rows(descent.problem.unknowns.rows(found.x))
