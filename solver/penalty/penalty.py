"""The interface of soft constraints: functions f_j ≥ 0 of samples (y, y', y'') with exact gradients (eq. 1).

A penalty does not depend on unknowns, knots, masks or weights, so the same object serves the optimiser and the
Euler-Lagrange residual. A new soft constraint is one class here, one Taylor test, one row in the runner's table.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.spline import Path
from ..figure.adjoint import Cotangent
from ..figure.kinematics import Samples
from .block import Block, Dense, summed
from .curvature import Curvature, add_differences, jacobian
from .one_sided import OneSidedResiduals


@dataclass(frozen=True)
class Normalization:
    """The normalization of a soft constraint, also where it (nearly) vanishes on the raw spline.

    Attributes:
        reference: f_j of a violation of 1 cm or 1°, or of 8 rad (2 m) per squared key spacing at keyframes 1 s apart.
        is_violation: Whether f_j is zero wherever the constraint holds, like a depth, and not a cost of all motion.
        time_power: f_j of a clip played λ times slower falls by λ to this power: 4 for squared accelerations.
        normalize_by: The name of a term whose integral divides this one too, if it is present. `reference` of this term
            then weighs as much as one of the other.
        raw_cap: Upper limit of the mean of f_j over the raw spline in the normalization.
        is_sharp: Whether f_j begins, ends or peaks abruptly in time, so that the few samples that suffice for the
            curvature of other terms would miss it. Its curvature consists of rows only.
        by_tension: The power of `Objective.tension` by which f_j counts more between keyframes that are far apart.
    """

    reference: float
    is_violation: bool = False
    time_power: int = 0
    normalize_by: str | None = None
    raw_cap: float = np.inf
    is_sharp: bool = False
    by_tension: float = 0.0


class Role(Enum):
    """The purpose of a soft constraint.

    After a poor local minimum the search restarts without the roles that trap limbs: first contacts with their
    physics, then limits.
    """

    SMOOTHNESS = "what all motion costs"
    CONTACT = "feet and hands stay where they stand or hold"
    OBSTACLE = "nothing goes through a surface or a limb"
    LIMIT = "joints keep to their bounds"
    PHYSICS = "forces that the ground can supply, without impacts"
    EQUALITY = "joints and points that belong together"
    TRACKING = "target poses and positions"


class Penalty(ABC):
    """A soft constraint f_j. Subclasses define `name`, `role`, `normalization` and `residuals`.

    Value, gradient and the curvature of the search follow from the residuals.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """The name in reports."""

    @property
    @abstractmethod
    def role(self) -> Role:
        """The purpose of the constraint."""

    @property
    @abstractmethod
    def normalization(self) -> Normalization:
        """The scale of the constraint."""

    @property
    def obstructs(self) -> bool:
        """Whether it is an obstacle other than floors and steps, so that another route round it may exist."""
        return False

    def residuals(self, samples: Samples) -> Iterable[Block | Dense]:
        """Return the residuals whose sum of squares is f_j; of one-sided residuals the active ones.

        A penalty that is not a sum of squares overrides `evaluate` instead; its curvature uses finite differences of
        the gradient.

        Args:
            samples: S samples of the motion: the state y, y', y'' (S, N), and positions, velocities and accelerations
                of all links (3, L, S) in `samples.links`.

        Returns:
            Blocks of residuals with their derivatives.
        """
        raise NotImplementedError(
            f"penalty '{self.name}': give it residuals(samples), or evaluate if it is no sum of squares"
        )

    def nearby(self, samples: Samples) -> Iterable[Block | Dense]:
        """Return the residuals for a model of E, including one-sided ones that may become active in a step."""
        return self.residuals(samples)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        """Return f_j at every sample, (S,); with `into`, also add the gradient of Σ_s scale_s f_j(s) to it."""
        return summed(self.residuals(samples), samples, into, scale)

    def blocks(self, samples: Samples) -> tuple[Block | Dense, ...] | None:
        """The residuals, to be used for value, gradient and curvature; None of a penalty with an `evaluate` of its own,
        which is no sum of squares."""
        return tuple(self.residuals(samples)) if type(self).evaluate is Penalty.evaluate else None

    def model_blocks(self, samples: Samples, known: Sequence[Block | Dense] | None) -> Iterable[Block | Dense]:
        """`nearby`, with what is known of `residuals` at these samples."""
        return known if known is not None and type(self).nearby is Penalty.nearby else self.nearby(samples)

    def curvature(
        self, samples: Samples, into: Curvature, scale: Array, known: Sequence[Block | Dense] | None = None
    ) -> None:
        """Add the Gauss-Newton matrices of Σ_s scale_s f_j(s), scale (S,), to `into`, without those that are one-sided.

        known  what `blocks` gave at the same samples
        """
        if type(self).residuals is Penalty.residuals:
            add_differences(self.evaluate, samples, into, scale)
            return
        for k, block in enumerate(self.model_blocks(samples, known)):
            if isinstance(block, Block):
                block.add_to(into, scale)
            elif block.curved is not None:
                block.curved(into, scale)
            else:
                self._add_by_sweeps(k, len(block.value), samples, into, scale)

    def _add_by_sweeps(self, k: int, residuals: int, samples: Samples, into: Curvature, scale: Array) -> None:
        """The curvature of block k, which has so many residuals at every sample, by a sweep of the kinematics each."""
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
        """The part of f_j that is a sum of squares max(0, d)²: those that count or soon may. None: it has none ever."""
        if type(self).residuals is Penalty.residuals:
            return None
        blocks = [block for block in self.model_blocks(samples, known) if isinstance(block, Block) and block.one_sided]
        return OneSidedResiduals.joined([block.one_sided_residuals(samples) for block in blocks]) if blocks else None


class Momentary(Penalty):
    """A soft constraint of instants: E holds the sum of f_j over `instants`, not an integral.

    f_j is zero at all other times, depends on y alone, and its curvature has rows and nothing else.
    """

    @property
    @abstractmethod
    def times(self) -> Array:
        """(n,) [s] of all sampled times, one after the other, possibly with duplicates."""

    @property
    def instants(self) -> Array:
        """(I,) [s], rising."""
        return np.unique(self.times)

    def pairs(self, samples: Samples) -> tuple[Index, Index]:
        """The pairs of something that it looks at and a sample at its time, (p,) each, samples rising."""
        near = np.flatnonzero(np.isin(samples.t, self.instants))
        at, which = np.nonzero(samples.t[near, None] == self.times)
        return which, near[at]


class Guide(Penalty):
    """A soft constraint that provides an initial path, where the spline through the keyframes is a poor one."""

    @property
    def expected(self) -> Path | None:
        """The path that the whole motion should be close to; None without one."""
        return None

    @abstractmethod
    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with its variable frames on that path, and more of them, up to `most` in all."""
        ...


def instants_of(penalty: Penalty) -> Array:
    """Return the instants (I,) [s] of a momentary soft constraint; empty for others."""
    return penalty.instants if isinstance(penalty, Momentary) else np.zeros(0)
