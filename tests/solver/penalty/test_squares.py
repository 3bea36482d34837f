"""A sum of squares, of residuals and their pull-back: its value, gradient and curvature by differences of residuals."""

from dataclasses import dataclass

import numpy as np
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver.array import Array
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Scale, SumOfSquares
from dynsplines.solver.penalty.curvature import Curvature


@dataclass(frozen=True)
class Going(SumOfSquares):
    """The velocities of all bodies' origins, and their heights."""

    @property
    def name(self) -> str:
        return "going"

    @property
    def scale(self) -> Scale:
        return Scale(1.0)

    def residuals(self, samples: Samples) -> Array:
        links = samples.links
        return np.concatenate([links.x_d[:, 1:].reshape(-1, samples.count), links.x[2, 1:]])

    def pull_back(self, samples: Samples, into: Cotangent, bar: Array) -> None:
        speeds, heights = np.split(bar, [3 * (len(samples.figure.links) - 1)])
        into.buffer("x_d")[:, 1:] += speeds.reshape(3, -1, samples.count)
        into.buffer("x")[2, 1:] += heights


def test_its_value_is_the_sum_of_squares_and_its_gradient_has_taylor_slope_two(
    figure: Figure, rng: np.random.Generator
) -> None:
    samples = random_samples(figure, rng, 4)
    np.testing.assert_allclose(Going().evaluate(samples), np.sum(Going().residuals(samples) ** 2, axis=0))
    assert penalty_slope(Going(), samples, rng) > 1.95


def test_its_curvature_is_twice_the_jacobians_product_with_itself(figure: Figure, rng: np.random.Generator) -> None:
    """J by differences, along a function of time for every entry of the state."""
    samples, h = random_samples(figure, rng, 3), 1e-6
    scale, phi, made = rng.uniform(1, 2, 3), rng.normal(size=(3, 3)), Curvature(samples)
    Going().curvature(samples, made, scale)

    def moved(direction: Array) -> Array:
        steps = (direction * phi[:, order, None] for order in range(3))
        parts = (samples.y, samples.y_d, samples.y_dd)
        return Going().residuals(Samples(figure, *(part + step for part, step in zip(parts, steps, strict=True))))

    jacobian = np.array([(moved(h * entry) - moved(-h * entry)) / (2 * h) for entry in np.eye(figure.width)])
    wanted = 2 * np.einsum("s,mrs,nrs->mn", scale, jacobian, jacobian)
    np.testing.assert_allclose(made.quadratic(phi, 0, 3), wanted, atol=1e-7 * np.abs(wanted).max())
