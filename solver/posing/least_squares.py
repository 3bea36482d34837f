"""Damped least squares, of one pose or of many at once (K. Levenberg 1944; D. W. Marquardt 1963).

Residuals are two-sided, or one-sided with a cost only where they are positive. A step is solved with the one-sided
residuals that are positive at its end. Where it reduces the cost by less than predicted, a second-order correction
follows the curvature of stiff residuals, such as those of soles on the ground (R. Fletcher 1982).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, Mask

# [1] damping relative to the squared weights of the unknowns: of the first step, smallest and largest
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 0.1, 1e-12, 1e8
# [1] divisor of damping after a step that reduces the cost; multiplier of damping after any other step
BOLDER, MORE_CAREFUL = 5, 6
POOR_GAIN = 0.7  # [1] ratio of actual and predicted reduction of the cost below which a step is corrected
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

    @property
    def cost(self) -> Array:
        """The cost of every pose, (T,)."""
        return self.squared(self.values) + self.constant

    def squared(self, values: Array) -> Array:
        """Return the sum of the squares of residuals of these values (T, r) that have a cost, (T,)."""
        active = values * self.active(values)
        return np.asarray(np.einsum("tr,tr->t", active, active), float)

    def predicted(self, step: Array) -> Array:
        """Return the predicted reduction of the cost by a step (T, n), (T,)."""
        return self.squared(self.values) - self.squared(self.values + _product(self.rows, step))

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
            poses, there, step = self._stepped(out[going], here, going, damping)
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

    def _stepped(self, poses: Array, here: Residuals, going: Index, damping: Array) -> tuple[Array, Residuals, Array]:
        """Return poses one step further, their residuals, and the step (T, n)."""
        step, active = self._step(here, damping)
        new = self.moved(poses, step)
        there = self.residuals(new, going)
        poor = here.cost - there.cost < POOR_GAIN * here.predicted(step)
        if poor.any():
            curved = np.where(active, there.values - here.values - _product(here.rows, step), 0.0)
            corrected = self.moved(new, self._limited(self._solved(here, active, curved, damping)))
            residuals = self.residuals(corrected, going)
            improved = poor & (residuals.cost < there.cost)
            if improved.any():
                new, there = np.where(improved[:, None], corrected, new), there.where(improved, residuals)
        return new, there, step

    def _step(self, here: Residuals, damping: Array) -> tuple[Array, Mask]:
        """Return a step (T, n), and the residuals (T, r) that it reduces."""
        active = here.active(here.values)
        step = np.zeros((len(active), self.weights.size))
        for _ in range(ACTIVE_SETS):
            step = self._limited(self._solved(here, active, here.values, damping))
            predicted = here.active(here.values + _product(here.rows, step))
            if np.array_equal(predicted, active):
                break
            active = predicted
        return step, active

    def _limited(self, step: Array) -> Array:
        longest = np.abs(step).max(axis=1, initial=0.0)
        return step * (self.longest / np.maximum(longest, self.longest))[:, None] if np.isfinite(self.longest) else step

    def _solved(self, here: Residuals, active: Mask, values: Array, damping: Array) -> Array:
        """Return the step (T, n) that minimises |values + rows · step|² + damping |weights · step|²."""
        rows = here.rows * active[:, :, None]
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


def _product(rows: Array, step: Array) -> Array:
    """Return rows (T, r, n) times a step (T, n), (T, r)."""
    return np.asarray((rows @ step[:, :, None])[:, :, 0], float)
