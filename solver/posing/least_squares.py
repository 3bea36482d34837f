"""Damped least squares (K. Levenberg 1944; D. W. Marquardt 1963).

Residuals are two-sided, or one-sided with a cost only where they are positive. A step is solved with the one-sided
residuals that are positive at its end.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array, Mask
from ..tolerances import TINY

# [1] damping relative to the squared weights of the unknowns: of the first step, smallest and largest
FIRST_DAMPING, MOST_DAMPING = 0.1, 1e8
# [1] divisor of damping after a step that reduces the cost; multiplier of damping after any other step
BOLDER, MORE_CAREFUL = 5, 6
ACTIVE_SETS = 4  # [1] largest number of solves of a step, until the positive one-sided residuals no longer change
Part = tuple[Array, Array]  # residuals (k,) and their Jacobian (k, n)
SQUARED = 1e4  # [1] largest weight, relative to that of the unknowns, for which normal equations are accurate enough


def join(parts: Sequence[Part]) -> Part:
    """Return the concatenated residuals and Jacobians of several parts."""
    return np.concatenate([values for values, _ in parts]), np.concatenate([rows for _, rows in parts])


@dataclass(frozen=True, eq=False)
class Residuals:
    """Weighted residuals of a pose and their Jacobian.

    Attributes:
        values: The residuals, (r,).
        rows: The Jacobian with respect to the n unknowns, (r, n).
        two_sided: The number of two-sided residuals, which are first; all others are one-sided.
        constant: The part of the cost that is no square, such as that of a Huber loss.
    """

    values: Array
    rows: Array
    two_sided: int
    constant: float = 0.0

    def active(self, values: Array) -> Mask:
        """Return whether residuals of these values (r,) have a cost, (r,)."""
        active = values > 0
        active[: self.two_sided] = True
        return active

    @cached_property
    def cost(self) -> float:
        """The sum of the squares of active residuals, and the constant."""
        values = self.values[self.active(self.values)]
        return float(values @ values) + self.constant


def minimise(
    residuals: Callable[[Array], Residuals],
    move: Callable[[Array, Array], Array],
    weights: Array,
    qpos: Array,
    steps: int,
    *,
    longest: float = np.inf,
    settled: float = 0.0,
    smallest: float = 1e-11,
) -> tuple[Array, float]:
    """Return the pose (nq,) of least cost near another (nq,), and its cost.

    Args:
        residuals: Returns the residuals of a pose (nq,).
        move: Returns a pose (nq,), moved by a step (n,) from another (nq,).
        weights: The weights of the n unknowns, with which the damping is scaled, (n,).
        qpos: The pose from which the descent starts.
        steps: The largest number of steps.
        longest: The largest change of an unknown in one step [rad or m].
        settled: The relative decrease of the cost at which the descent ends [1].
        smallest: The largest change of an unknown by a step at which the descent ends [rad or m].
    """
    here, damping = residuals(qpos), FIRST_DAMPING
    for _ in range(steps):
        step = _step(here, weights, damping, longest)
        pose = move(qpos, step)
        there = residuals(pose)
        decrease = here.cost - there.cost
        ends = np.abs(step).max(initial=0.0) < smallest
        if decrease > 0:
            ends |= decrease <= settled * here.cost and damping <= FIRST_DAMPING
            qpos, here, damping = pose, there, max(damping / BOLDER, TINY)
        else:
            damping *= MORE_CAREFUL
        if ends or damping > MOST_DAMPING:
            break
    return qpos, here.cost


def _step(here: Residuals, weights: Array, damping: float, longest: float) -> Array:
    """Return a step (n,) from a pose with these residuals."""
    active, step = here.active(here.values), np.zeros(weights.size)
    for _ in range(ACTIVE_SETS):
        step = _solve(here.rows[active], here.values[active], weights, damping)
        step *= min(1.0, longest / max(float(np.abs(step).max(initial=0.0)), TINY))
        predicted = here.active(here.values + here.rows @ step)
        if np.array_equal(predicted, active):
            break
        active = predicted
    return step


def _solve(rows: Array, values: Array, weights: Array, damping: float) -> Array:
    """Return the step (n,) that minimises |values + rows · step|² + damping |weights · step|²."""
    squares = damping * weights**2
    if np.abs(rows).max(initial=0.0) <= SQUARED * weights.min(initial=np.inf):
        return np.asarray(-np.linalg.solve(rows.T @ rows + np.diag(squares), rows.T @ values), float)
    q, r = np.linalg.qr(np.concatenate([rows, np.diag(np.sqrt(squares))]))
    return np.asarray(-np.linalg.solve(r, q[: values.size].T @ values), float)
