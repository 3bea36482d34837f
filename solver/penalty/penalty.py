"""The interface of soft constraints: functions f_j ≥ 0 of samples (y, y', y'') with exact gradients (eq. 1).

A penalty depends only on samples, not on the parameters of the path, on which entries are fixed, or on weights. The
optimiser and the Euler-Lagrange residual therefore use the same object. A new soft constraint needs one subclass, one
Taylor test, and one row in the runner's table of penalties.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ..array import Array, Index, Mask, segments_at
from ..curve.frame import Timeline
from ..curve.spline import Path
from ..figure.adjoint import Cotangent
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from .block import Block, Dense, sum_of_blocks

# distances from a bound, a length [m] on an adult and an angle [rad], that one step of the search may cover
NEAR_LENGTH, NEAR_ANGLE = 0.03, float(np.radians(4))
SAMPLES = 5  # number of random samples
STEPS = np.array([1e-3, 1e-4])  # [1] steps h of the Taylor test


@dataclass(frozen=True)
class Normalization:
    """Numbers by which the solver scales a soft constraint, so that constraints are comparable.

    The solver divides f_j by its integral over the raw spline, the spline through the keyframes. `reference` limits
    this divisor, see `Objective.renormalise`.

    Attributes:
        reference: The value of f_j for a violation of 1 cm or 1°, on a figure of an adult's size. For speeds and
            accelerations: the value for 1 m/s, 2 m/s² or 8 rad/s² if keyframes are 1 s apart. The solver divides it
            by T to the power `time_power` if they are T seconds apart.
        time_power: The exponent p: in a clip slowed by a factor λ, f_j is divided by λ^p; 4 for squared accelerations.
        length_power: The exponent p: on a figure λ times as large, f_j is λ^p times as large; 2 for squared lengths.
        normalize_by: The name of another term. If the objective contains it, the integral of that term is used.
        raw_cap: The largest divisor per second of the clip, for terms of `Role.COST`.
        by_tension: The weight of f_j is multiplied by `Objective.tension` to this power. The tension rises with the
            time between keyframes.
    """

    reference: float
    time_power: int = 0
    length_power: int = 0
    normalize_by: str | None = None
    raw_cap: float = np.inf
    by_tension: float = 0.0


class Role(Enum):
    """The purpose of a soft constraint. All but COST measure violations: they are zero if the constraint is satisfied.

    If the search ends in a poor local minimum, the solver restarts, also from minima without LIMIT, which may trap a
    limb. Violations of PHYSICS are no sign of such a minimum. COLLISION and OBSTACLE may get more samples.
    """

    COST = "the motion is smooth; almost every motion costs something"
    TARGET = "the motion reaches its targets"
    LIMIT = "joints stay within their bounds"
    COLLISION = "surfaces and limbs do not penetrate each other"
    OBSTACLE = "the same, for a surface that the figure can go around, unlike a floor or a step"
    PHYSICS = "the ground can supply the forces, without impacts"

    @property
    def is_violation(self) -> bool:
        """Whether the constraint is zero if it is satisfied, as for a depth."""
        return self is not Role.COST


class Penalty(ABC):
    """A soft constraint f_j. Subclasses define `name`, `normalization` and `residuals`, and a `role` other than COST.

    Value, gradient and curvature are computed from the residuals.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """The name in reports."""

    @property
    @abstractmethod
    def normalization(self) -> Normalization:
        """The normalization of the constraint."""

    @property
    def role(self) -> Role:
        """The purpose of the constraint."""
        return Role.COST

    @property
    def is_sharp(self) -> bool:
        """Whether the search computes the curvature of f_j at all samples of E instead of a few nodes.

        This is for constraints that change abruptly in time. Of the curvature, only what `Curvature.add_rows` adds is
        used. If all residuals are one-sided, it saves the evaluation at the nodes.
        """
        return False

    @abstractmethod
    def residuals(self, samples: Samples) -> Iterable[Block | Dense]:
        """Return the residuals. f_j is the weighted sum of their squares.

        Of one-sided residuals, only positive ones count. The optimiser uses the others, too, if a step may make them
        positive; those farther from their bounds than NEAR_LENGTH or NEAR_ANGLE may be omitted.

        Args:
            samples: S samples of the motion: the state y and its time derivatives y', y'', each (S, N), and in
                `samples.links` the positions, velocities and accelerations of all links, each (3, L, S).

        Returns:
            Blocks of residuals with their derivatives.
        """

    def watching(self, parts: Iterable[Samples]) -> Penalty:
        """Return the constraint without the parts that are zero in all samples, until it is called with others."""
        return self

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        """Return f_j at every sample, (S,). If `into` is given, add the gradient of Σ_s scale_s f_j(s) to `into`."""
        return sum_of_blocks(self.residuals(samples), samples, into, scale)


class Guide(Penalty):
    """A soft constraint that provides an initial path, for clips whose raw spline is a poor initial guess."""

    @property
    def expected(self) -> Path | None:
        """The path that the whole motion should be close to; None if there is none."""
        return None

    @abstractmethod
    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with its variable frames on the initial path, extended to at most `most` frames."""
        ...


@dataclass(frozen=True)
class Sum(Penalty):
    """The sum of at least one soft constraint, all of the same unit."""

    parts: tuple[Penalty, ...]
    name: str = "sum"

    @property
    def role(self) -> Role:
        roles = [part.role for part in self.parts]
        return Role.OBSTACLE if Role.OBSTACLE in roles else roles[0]

    @property
    def is_sharp(self) -> bool:
        return self.parts[0].is_sharp

    @property
    def normalization(self) -> Normalization:
        return self.parts[0].normalization

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.residuals(samples)


@dataclass(frozen=True)
class Allowance:
    """Tolerated excesses of one-sided residuals, linear between keyframes.

    Attributes:
        times: The times of the keyframes, (K,) [s].
        excess: The excess in each keyframe, at least 0, (..., K), in the unit of the residual.
    """

    times: Array
    excess: Array

    @classmethod
    def in_keys(cls, keys: Timeline, excess: Array, is_fixed: Mask) -> Allowance | None:
        """Return the tolerance of positive excesses (..., K) that keyframes fix, (..., K); None without any."""
        excess = np.maximum(excess, 0) * is_fixed
        return cls(keys.times, excess) if excess.any() else None

    def at(self, t: Array) -> Array:
        """Return the tolerated excesses, constant outside the range of the keyframes.

        Args:
            t: Times (S,) [s].

        Returns:
            The excesses (..., S).
        """
        span, share = self._place(t)
        return self.excess[..., span] * (1 - share) + self.excess[..., span + 1] * share

    def of(self, index: Index, t: Array) -> Array:
        """Return the tolerated excesses (..., P) at times t (P,) [s] for entries (P,) of the second-last axis."""
        span, share = self._place(t)
        return self.excess[..., index, span] * (1 - share) + self.excess[..., index, span + 1] * share

    def _place(self, t: Array) -> tuple[Index, Array]:
        """Return the keyframe before each time, and the share of the segment from it to the time."""
        span = segments_at(self.times, t)
        return span, np.clip((t - self.times[span]) / (self.times[span + 1] - self.times[span]), 0, 1)


def check(penalty: Penalty, figure: Figure, *, seed: int = 0) -> None:
    """Check values and gradient of a soft constraint on random samples of a figure.

    By a Taylor test, |f(x + h d) − f(x) − h g·d| must be proportional to h² along a random direction d of y, y' and
    y''.

    Args:
        penalty: The soft constraint.
        figure: A figure, such as `load("run_and_step").figure`.
        seed: Seed of the random samples.

    Raises:
        ValueError: A value is negative, infinite or NaN; the gradient is not that of the values; or all values are 0,
            so that nothing was checked.
    """
    rng, name = np.random.default_rng(seed), penalty.name
    samples = _random(figure, rng)
    scale, cotangent = rng.uniform(0.5, 2, SAMPLES), Cotangent(samples)
    values = penalty.evaluate(samples, cotangent, scale)
    if not np.all(np.isfinite(values)) or np.any(values < 0):
        raise ValueError(f"penalty '{name}': a value is {float(np.min(values)):g}; finite ones from 0 on are penalties")
    slope = _taylor_slope(penalty, samples, scale, np.stack(cotangent.gradients()), rng)
    if slope < 1.9:  # 2 for an exact gradient, 1 for a wrong one
        raise ValueError(f"penalty '{name}': its gradient is not that of its values: Taylor slope {slope:.2f}, not 2")
    if not np.any(values):
        raise ValueError(
            f"penalty '{name}': no residual was positive on the samples, at 0 to {samples.t[-1]:g} s, so nothing was "
            "checked; pass another seed, or check the penalty with a bound that random poses violate, or at these times"
        )


def _random(figure: Figure, rng: np.random.Generator) -> Samples:
    """Return samples with poses far from rest and random derivatives of every entry."""
    y = figure.to_state(rng.normal(size=(SAMPLES, figure.width)))
    return Samples(figure, y, rng.normal(size=y.shape), rng.normal(size=y.shape), np.arange(SAMPLES) / SAMPLES)


def _taylor_slope(penalty: Penalty, samples: Samples, scale: Array, gradient: Array, rng: np.random.Generator) -> float:
    """Return the slope of log remainder over log step; 2 if the remainder is only rounding."""
    point = np.stack([samples.y, samples.y_d, samples.y_dd])
    direction = rng.normal(size=point.shape)
    direction /= np.linalg.norm(direction)

    def value(step: float) -> float:
        return float(scale @ penalty.evaluate(Samples(samples.figure, *(point + step * direction), t=samples.t)))

    first, rise = value(0.0), float(np.sum(gradient * direction))
    remainders = np.array([abs(value(step) - first - step * rise) for step in STEPS])
    if np.all(remainders < 1e-10 * max(abs(first), abs(rise), 1.0)):
        return 2.0
    return float(np.diff(np.log(remainders + np.finfo(float).tiny))[0] / np.diff(np.log(STEPS))[0])
