"""The check of a soft constraint: exact gradients pass, of whatever kind; what is wrong is named."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import pytest
from figures import BALL_TREE, figure_of

from dynsplines.solver.array import Array
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    CovariantAcceleration,
    Normalization,
    Penalty,
    RootAcceleration,
    Torque,
    UnitMagnitude,
)
from dynsplines.solver.penalty.block import Block, Dense, Entries
from dynsplines.solver.penalty.check import check

FIGURE = figure_of(BALL_TREE)


@dataclass(frozen=True)
class Power(Penalty):
    """Height to a power of the root's x', its gradient too large by a share."""

    power: int
    error: float = 0.0
    worth: float = 1.0

    @property
    def name(self) -> str:
        return "power"

    @property
    def normalization(self) -> Normalization:
        return Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        x = samples.y_d[:, 0]
        height = np.sqrt(self.worth * (x**self.power + 20.0))

        def pulled_back(cotangent: Cotangent, bar: Array) -> None:
            if self.power:
                rate = self.worth * self.power * x ** (self.power - 1) / (2 * height)
                cotangent.buffer("y_d")[:, 0] += (1 + self.error) * bar[0] * rate

        yield Dense(height[None], pulled_back)


class Odd(Power):
    """The same, and what is wrong with it by `power`."""

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        values = np.ones(samples.count)
        values[1 + self.power] = (np.nan, -1e-9)[self.power]
        yield Dense(np.zeros((1, samples.count)), lambda cotangent, bar: None, more=values)


@pytest.mark.parametrize("penalty", [CovariantAcceleration(), RootAcceleration(), Torque(), UnitMagnitude()])
def test_soft_constraints_that_ship_pass(penalty):
    check(penalty, FIGURE)


@pytest.mark.parametrize("power", [0, 1, 3, 4])
@pytest.mark.parametrize("worth", [1e-6, 1e6])
def test_an_exact_gradient_passes_even_of_what_is_flat_or_linear_and_in_any_unit(power, worth):
    for seed in range(2):
        check(Power(power, 0.0, worth), FIGURE, seed=seed)


@pytest.mark.parametrize("power", [1, 2, 3])
@pytest.mark.parametrize("error", [-0.02, 1.0])
def test_a_gradient_that_is_off_by_a_share_is_refused_with_its_slope_of_about_one(power, error):
    with pytest.raises(ValueError, match=r"^penalty 'power': its gradient is not that .* slope [01]\.\d\d, not 2$"):
        check(Power(power, error), FIGURE)
    with pytest.raises(ValueError, match=r"slope 1\.0\d, not 2"):
        check(Power(1, error), FIGURE)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (0, r"a value is nan; finite ones from 0 on are penalties"),
        (1, r"a value is -1e-09; finite"),
    ],
)
def test_values_that_are_none_are_refused(wrong, words):
    with pytest.raises(ValueError, match=words):
        check(Odd(wrong), FIGURE)


@dataclass(frozen=True)
class Excess(Power):
    """The excess of the root's x' over a bound, one-sided."""

    bound: float = 0.0

    def residuals(self, samples: Samples) -> Iterator[Block]:
        at = np.arange(samples.count)
        slope = Entries(at, 1, np.zeros_like(at), 1 + self.error)
        yield Block(at, samples.y_d[:, 0] - self.bound, (slope,), one_sided=True)


class Early(Excess):
    """The same during the first second alone."""

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for block in super().residuals(samples):
            yield replace(block, weight=((samples.t > 0) & (samples.t < 1)).astype(float))


def test_samples_lie_at_several_times_of_the_first_second():
    check(Early(1, bound=-1.0), FIGURE)


def test_a_one_sided_penalty_is_checked_only_where_a_residual_is_positive():
    check(Excess(1, bound=-1.0), FIGURE)
    with pytest.raises(ValueError, match=r"its gradient is not that"):
        check(Excess(1, error=1.0, bound=-1.0), FIGURE)
    for error in (0.0, 1.0):
        with pytest.raises(
            ValueError, match=r"^penalty 'power': no residual was positive .* nothing was checked; pass"
        ):
            check(Excess(1, error=error, bound=100.0), FIGURE)
