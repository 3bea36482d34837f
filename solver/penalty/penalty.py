"""The interface of soft constraints: functions f_j ≥ 0 of samples (y, y', y'') with exact gradients (eq. 1).

A penalty depends only on samples, not on the parameters of the path, on which entries are fixed, or on weights. The
optimiser and the Euler-Lagrange residual therefore use the same object. A new soft constraint needs one subclass, one
Taylor test, and one row in the runner's table of penalties.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.spline import Path
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .block import Block, Dense, summed
from .curvature import Curvature, OneSidedResiduals, jacobian


@dataclass(frozen=True)
class Normalization:
    """Numbers by which the solver scales a soft constraint, so that constraints are comparable.

    The solver divides f_j by its integral over the raw spline, the spline through the keyframes. `reference` limits
    this divisor, see `Objective.renormalised`.

    Attributes:
        reference: The value of f_j for a violation of 1 cm or 1°, on a figure of an adult's size. For speeds and
            accelerations: the value for 1 m/s, 2 m/s² or 8 rad/s² if keyframes are 1 s apart. The solver divides it
            by T to the power `time_power` if they are T seconds apart.
        is_violation: Whether f_j is zero wherever the constraint is satisfied, as for a depth. Otherwise almost
            every motion has a cost, as for an acceleration.
        length_power: The exponent p: on a figure λ times as large, f_j is λ^p times as large; 2 for squared lengths.
        time_power: The exponent p: in a clip slowed by a factor λ, f_j is divided by λ^p; 4 for squared accelerations.
        normalize_by: The name of another term. If the objective contains it, the integral of that term is used.
        raw_cap: The largest divisor per second of the clip, for terms that measure no violation.
        is_sharp: Whether f_j changes abruptly in time. The search then computes its curvature at all samples instead
            of a few. This affects only a `Block` with `Wrenches`, and a `Dense` that uses `Curvature.add_rows`.
        by_tension: The weight of f_j is multiplied by `Objective.tension` to this power. The tension rises with the
            time between keyframes.
    """

    reference: float
    is_violation: bool = False
    time_power: int = 0
    normalize_by: str | None = None
    raw_cap: float = np.inf
    is_sharp: bool = False
    by_tension: float = 0.0
    length_power: int = 0


class Role(Enum):
    """The purpose of a soft constraint.

    If the search ends in a poor local minimum, the solver restarts, also from minima without LIMIT, which may trap a
    limb. Violations of PHYSICS are no sign of such a minimum. Collisions with an OBSTACLE may get more samples.
    """

    GOAL = "the motion is smooth, and near its targets"
    OBSTACLE = "surfaces and limbs do not penetrate each other"
    LIMIT = "joints stay within their bounds"
    PHYSICS = "the ground can supply the forces, without impacts"


class Penalty(ABC):
    """A soft constraint f_j. Subclasses define `name`, `normalization` and `residuals`, and a `role` other than GOAL.

    Value, gradient and curvature are computed from the residuals.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """The name in reports."""

    @property
    def role(self) -> Role:
        """The purpose of the constraint."""
        return Role.GOAL

    @property
    @abstractmethod
    def normalization(self) -> Normalization:
        """The normalization of the constraint."""

    @property
    def obstructs(self) -> bool:
        """Whether the constraint is an obstacle that the figure can go around. False for a floor or a step."""
        return False

    @property
    def instants(self) -> Array:
        """The instants at which alone the constraint is evaluated, ascending, (I,) [s]; empty: an integral is.

        E contains Σ f_j over the instants instead of the integral. f_j is zero at all other times and depends on y
        only. Of its curvature, only what `Curvature.add_rows` adds is used.
        """
        return np.zeros(0)

    @abstractmethod
    def residuals(self, samples: Samples) -> Iterable[Block | Dense]:
        """Return the residuals. f_j is the weighted sum of their squares.

        Of one-sided residuals, only positive ones count. The others may be omitted.

        Args:
            samples: S samples of the motion: the state y and its time derivatives y', y'', each (S, N), and in
                `samples.links` the positions, velocities and accelerations of all links, each (3, L, S).

        Returns:
            Blocks of residuals with their derivatives.
        """

    def nearby(self, samples: Samples) -> Iterable[Block | Dense]:
        """Return the residuals for the quadratic model of the objective E.

        They include one-sided residuals that may become positive in the next step of the optimiser.
        """
        return self.residuals(samples)

    def watching(self, parts: Iterable[Samples]) -> Penalty:
        """Return the constraint without the parts that are zero in all samples, until it is called with others."""
        return self

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        """Return f_j at every sample, (S,). If `into` is given, add the gradient of Σ_s scale_s f_j(s) to `into`."""
        return summed(self.residuals(samples), samples, into, scale)

    def model_blocks(self, samples: Samples, known: Sequence[Block | Dense] | None) -> Iterable[Block | Dense]:
        """Return the result of `nearby`, or `known` if the class does not override `nearby`."""
        return known if known is not None and type(self).nearby is Penalty.nearby else self.nearby(samples)

    def curvature(
        self, samples: Samples, into: Curvature, scale: Array, known: Sequence[Block | Dense] | None = None
    ) -> None:
        """Add the Gauss-Newton matrices of Σ_s scale_s f_j(s) to `into`, without one-sided residuals.

        Args:
            samples: S samples of the motion.
            into: The matrices to which those of f_j are added.
            scale: The weights of the samples, (S,).
            known: The `residuals` at the same samples; None: they are computed.
        """
        self._add_two_sided(self.model_blocks(samples, known), samples, into, scale)

    def active_curvature(self, samples: Samples, into: Curvature, scale: Array, one_sided_scale: Array) -> None:
        """Add what `curvature` adds, and the matrices of the active one-sided residuals.

        Args:
            samples: S samples of the motion.
            into: The matrices to which those of f_j are added.
            scale: The weights of the samples for two-sided residuals, (S,).
            one_sided_scale: The weights of the samples for one-sided residuals, (S,).
        """
        blocks = tuple(self.nearby(samples))
        self._add_two_sided(blocks, samples, into, scale)
        sides = _one_sided(blocks, samples)
        if sides is not None:
            into.add_one_sided(sides, one_sided_scale)

    def _add_two_sided(self, blocks: Iterable[Block | Dense], samples: Samples, into: Curvature, scale: Array) -> None:
        for k, block in enumerate(blocks):
            if isinstance(block, Block):
                block.add_to(into, scale)
            elif block.curved is not None:
                block.curved(into, scale)
            else:
                self._add_by_sweeps(k, len(block.value), samples, into, scale)

    def _add_by_sweeps(self, k: int, residuals: int, samples: Samples, into: Curvature, scale: Array) -> None:
        """Add the curvature of block k with an adjoint sweep of the kinematics for each residual of a sample."""
        at, which = np.repeat(np.arange(samples.count), residuals), np.tile(np.arange(residuals), samples.count)

        def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
            block = list(self.nearby(copies))[k]
            assert isinstance(block, Dense)
            bar = np.zeros((residuals, copies.count))
            bar[which[rows], np.arange(rows.size)] = 1.0
            block.pulled_back(cotangent, bar)

        into.add_rows(at, scale[at], jacobian(samples, at, seeded))

    def one_sided_residuals(
        self, samples: Samples, known: Sequence[Block | Dense] | None = None
    ) -> OneSidedResiduals | None:
        """Return the one-sided residuals d that are positive or nearly so. Each adds max(0, d)² to f_j.

        None if the penalty has no one-sided residuals.
        """
        return _one_sided(self.model_blocks(samples, known), samples)


def _one_sided(blocks: Iterable[Block | Dense], samples: Samples) -> OneSidedResiduals | None:
    """Return the one-sided residuals among blocks; None if there are none."""
    chosen = [block for block in blocks if isinstance(block, Block) and block.one_sided]
    return OneSidedResiduals.joined([block.one_sided_residuals(samples) for block in chosen]) if chosen else None


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
    term_name: str

    @property
    def name(self) -> str:
        return self.term_name

    @property
    def role(self) -> Role:
        return self.parts[0].role

    @property
    def obstructs(self) -> bool:
        return any(part.obstructs for part in self.parts)

    @property
    def normalization(self) -> Normalization:
        return self.parts[0].normalization

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.residuals(samples)

    def nearby(self, samples: Samples) -> Iterator[Block | Dense]:
        for part in self.parts:
            yield from part.nearby(samples)
