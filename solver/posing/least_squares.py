"""Damped least squares, of one pose or of many at once (K. Levenberg 1944; D. W. Marquardt 1963).

Residuals are two-sided, or one-sided with a cost only where they are positive. A step is solved with the one-sided
residuals that are positive at its end.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..array import Array, Index, Mask
from ..tolerances import TINY

# [1] damping relative to the squared weights of the unknowns: of the first step, smallest and largest
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 0.1, 1e-12, 1e8
# [1] divisor of damping after a step that reduces the cost; multiplier of damping after any other step
BOLDER, MORE_CAREFUL = 5, 6
ACTIVE_SETS = 4  # [1] largest number of solves of a step, until the positive one-sided residuals no longer change
SQUARED = 1e4  # [1] largest weight, relative to that of the unknowns, for which normal equations are accurate enough


@dataclass(frozen=True, eq=False)
class Residuals:
    """Weighted residuals of T poses and their Jacobian.

    Attributes:
        values: The residuals, (T, r).
        rows: The Jacobian with respect to the n unknowns, (T, r, n).
        two_sided: The number of two-sided residuals, which are first; all others are one-sided.
        constant: The part of the cost that is no square, such as that of a Huber loss, (T,) or 0.
    """

    values: Array
    rows: Array
    two_sided: int
    constant: Array | float = 0.0

    @classmethod
    def of_one(cls, values: Array, rows: Array, two_sided: int, constant: float = 0.0) -> Residuals:
        """Return the residuals (r,) of one pose, with their Jacobian (r, n)."""
        return cls(values[None], rows[None], two_sided, constant)

    def active(self, values: Array) -> Mask:
        """Return whether residuals of these values (T, r) have a cost, (T, r)."""
        active = values > 0
        active[:, : self.two_sided] = True
        return active

    @cached_property
    def cost(self) -> Array:
        """The cost of every pose, (T,)."""
        values = self.values * self.active(self.values)
        return np.asarray(np.einsum("tr,tr->t", values, values) + self.constant, float)

    def where(self, mask: Mask, other: Residuals) -> Residuals:
        """Return the residuals of other poses where a mask (T,) is true."""
        if mask.all():
            return other
        values, rows = np.where(mask[:, None], other.values, self.values), self.rows.copy()
        rows[mask] = other.rows[mask]
        return Residuals(values, rows, self.two_sided, np.where(mask, other.constant, self.constant))

    def select(self, mask: Mask) -> Residuals:
        """Return the residuals of the poses where a mask (T,) is true."""
        if mask.all():
            return self
        constant = np.broadcast_to(self.constant, mask.shape)[mask]
        return Residuals(self.values[mask], self.rows[mask], self.two_sided, constant)


@dataclass(frozen=True, eq=False)
class LeastSquares:
    """A least-squares problem over n unknowns, of each of several poses.

    Attributes:
        residuals: Returns the residuals of T poses (T, nq), given also the indices of these poses (T,).
        moved: Returns poses (T, nq), moved by steps (T, n) from others (T, nq).
        weights: The weights of the unknowns, with which the damping is scaled, (n,).
        steps: The largest number of steps.
        longest: The largest change of an unknown in one step [rad or m].
        settled: The relative decrease of the cost at which a descent ends [1].
        smallest: The largest change of an unknown by a step at which a descent ends [rad or m].
    """

    residuals: Callable[[Array, Index], Residuals]
    moved: Callable[[Array, Array], Array]
    weights: Array
    steps: int
    longest: float = np.inf
    settled: float = 0.0
    smallest: float = 1e-11

    def descended(self, qpos: Array) -> tuple[Array, Array]:
        """Return the poses (T, nq) of least cost near others (T, nq), and their costs (T,)."""
        out = np.array(qpos, float)
        costs, going, damping = np.empty(len(out)), np.arange(len(out)), np.full(len(out), FIRST_DAMPING)
        here = self.residuals(out, going)
        costs[:] = here.cost
        for _ in range(self.steps):
            step = self._step(here, damping)
            poses = self.moved(out[going], step)
            there = self.residuals(poses, going)
            cost = there.cost
            better = cost < costs[going]
            ends = better & (costs[going] - cost <= self.settled * costs[going]) & (damping <= FIRST_DAMPING)
            out[going[better]], costs[going[better]] = poses[better], cost[better]
            here = here.where(better, there) if better.any() else here
            damping = np.where(better, np.maximum(damping / BOLDER, LEAST_DAMPING), damping * MORE_CAREFUL)
            goes_on = ~ends & (np.abs(step).max(axis=1, initial=0.0) >= self.smallest) & (damping <= MOST_DAMPING)
            if not goes_on.all():
                going, damping, here = going[goes_on], damping[goes_on], here.select(goes_on)
                if not going.size:
                    break
        return out, costs

    def _step(self, here: Residuals, damping: Array) -> Array:
        """Return a step (T, n) from poses with these residuals."""
        active = here.active(here.values)
        step = np.zeros((len(active), self.weights.size))
        for _ in range(ACTIVE_SETS):
            step = self._solved(here, active, damping)
            longest = np.abs(step).max(axis=1, initial=0.0)
            step *= np.minimum(1.0, self.longest / np.maximum(longest, TINY))[:, None]
            predicted = here.active(here.values + (here.rows @ step[:, :, None])[:, :, 0])
            if np.array_equal(predicted, active):
                break
            active = predicted
        return step

    def _solved(self, here: Residuals, active: Mask, damping: Array) -> Array:
        """Return the step (T, n) that minimises |values + rows · step|² + damping |weights · step|²."""
        if len(active) == 1:
            rows, values = here.rows[:, active[0]], here.values[:, active[0]]
        else:
            rows, values = here.rows * active[:, :, None], here.values
        squares = damping[:, None] * self.weights**2
        if np.abs(rows).max(initial=0.0) <= SQUARED * self.weights.min(initial=np.inf):
            across = np.swapaxes(rows, 1, 2)
            normal = across @ rows
            diagonal = np.arange(self.weights.size)
            normal[:, diagonal, diagonal] += squares
            return np.asarray(-np.linalg.solve(normal, across @ values[:, :, None])[:, :, 0], float)
        system = np.concatenate([rows, np.sqrt(squares)[:, :, None] * np.eye(self.weights.size)], axis=1)
        q, r = np.linalg.qr(system)
        right = np.swapaxes(q[:, : values.shape[1]], 1, 2) @ values[:, :, None]
        return np.asarray(-np.linalg.solve(r, right)[:, :, 0], float)
