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

from ..array import Array
from ..curve.frame import Timeline
from ..curve.spline import Path
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .block import Block, Dense, sum_of_blocks

# distances from a bound, a length [m] on an adult and an angle [rad], that one step of the search may cover
NEAR_LENGTH, NEAR_ANGLE = 0.03, float(np.radians(4))


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
